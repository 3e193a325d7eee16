"""
Rehearsal process: runs attempts at the steps of one lesson, one after the other, with a worker of its own.

In: one line of JSON, ``Rehearsals``. Out: one line per attempt, ``Rehearsed``. It ends after the last attempt, or when
its input ends, so nothing is left of it when its owner is gone.
"""

from __future__ import annotations

import contextlib
import os
import queue
import sys
import threading
from pathlib import Path
from typing import Any, Literal

import msgspec

from ..config import Config, Limits
from ..errors import RosyError
from ..wire.problem import Problem, Sentence, to_wire
from ..wire.user_input import TimedInput
from ..worker.blocking_worker import BlockingWorker
from ..world.arena import read_arena
from .lesson_watch import CheckedStep
from .rehearsal import attempt
from .verdicts import Verdict

__all__ = ["Rehearsals", "Rehearsed", "RehearsedAttempt", "main"]

_SEED = 1
"""As in the page, where a run that checks judge has this seed, and in the tests of the lessons."""


class RehearsedAttempt(msgspec.Struct, frozen=True):
    """A program, the step that it is an attempt at, and what hands do meanwhile."""

    source: str
    step: CheckedStep
    hands: list[TimedInput] = []


class Rehearsals(msgspec.Struct, frozen=True):
    """All attempts in a room, and how the worker is started, as in ``Config``."""

    world: dict[str, Any]
    attempts: list[RehearsedAttempt]
    worker: tuple[str, ...]
    sandbox: bool
    visible: list[str]
    limits: Limits
    # Added to the priority of the process; 19 is the lowest there is.
    nice: int = 0


class Rehearsed(msgspec.Struct, frozen=True, omit_defaults=True):
    """How an attempt did, or why the worker could not be used."""

    ended: Literal["time", "done", "error", "stuck", "refused"] = "error"
    passed: bool = False
    checks: list[Verdict] = []
    problems: list[Problem] = []
    failure: Sentence | None = None


def main() -> int:
    """Serve one line of standard input."""
    lines: queue.SimpleQueue[bytes] = queue.SimpleQueue()
    threading.Thread(target=_read_input, args=(lines,), daemon=True).start()
    task = msgspec.json.decode(lines.get(), type=Rehearsals)
    os.nice(task.nice)
    nowhere = Path("/")
    visible = tuple(Path(folder) for folder in task.visible)
    config = Config(nowhere, nowhere, nowhere, task.worker, task.sandbox, visible, limits=task.limits)
    with contextlib.suppress(BrokenPipeError):
        try:
            with BlockingWorker(config) as worker:
                worker.ready()
                for one in task.attempts:
                    _answer(_rehearsed(worker, task, one))
        except RosyError as error:
            _answer(Rehearsed(failure=to_wire(error.sentence)))
            return error.exit_status
    return 0


def _read_input(lines: queue.SimpleQueue[bytes]) -> None:
    # Unbuffered: the interpreter cannot end while a thread holds the lock of a buffer.
    with open(sys.stdin.fileno(), "rb", buffering=0, closefd=False) as file:
        for line in file:
            lines.put(line)
    # The owner is gone or wants no more. The sandbox of the worker dies with this process.
    os._exit(0)


def _answer(answer: Rehearsed) -> None:
    sys.stdout.buffer.write(msgspec.json.encode(answer) + b"\n")
    sys.stdout.buffer.flush()


def _rehearsed(worker: BlockingWorker, task: Rehearsals, one: RehearsedAttempt) -> Rehearsed:
    did = attempt(worker, one.source, one.step, one.hands, read_arena(task.world), _SEED, task.limits)
    return Rehearsed(did.run.ended, did.is_passed, did.verdicts, did.run.problems)
