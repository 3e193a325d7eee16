"""
Rehearsal process: runs attempts at the steps of one lesson, one after the other, with a worker of its own.

In: one line of JSON, ``Rehearsals``. Out: one line per attempt, ``Rehearsed``. It ends after the last attempt, or when
its input ends, so nothing is left of it when its owner is gone.
"""

from __future__ import annotations

import contextlib
import os
import queue
from typing import Any, Literal

import msgspec

from ..errors import RosyError
from ..wire.problem import Problem, Sentence, to_wire
from ..wire.user_input import TimedInput
from ..wire.verdict import Verdict
from ..worker.background_process import WorkerSetup, begin_reading, write_line
from ..worker.blocking_worker import BlockingWorker
from ..world.arena import read_arena
from .lesson_watch import CheckedStep
from .rehearsal import attempt

__all__ = ["Rehearsals", "Rehearsed", "RehearsedAttempt", "main"]

_SEED = 1
"""As in the page, where a run that checks judge has this seed, and in the tests of the lessons."""


class RehearsedAttempt(msgspec.Struct, frozen=True):
    """A program, the step that it is an attempt at, and what hands do meanwhile."""

    source: str
    step: CheckedStep
    hands: list[TimedInput] = []


class Rehearsals(msgspec.Struct, frozen=True):
    """All attempts in a room, and how the worker is started."""

    world: dict[str, Any]
    attempts: list[RehearsedAttempt]
    setup: WorkerSetup


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
    begin_reading(lines.put)
    task = msgspec.json.decode(lines.get(), type=Rehearsals)
    os.nice(task.setup.nice)
    with contextlib.suppress(BrokenPipeError):
        try:
            with BlockingWorker(task.setup.config()) as worker:
                worker.ready()
                for one in task.attempts:
                    write_line(msgspec.json.encode(_rehearsed(worker, task, one)))
        except RosyError as error:
            write_line(msgspec.json.encode(Rehearsed(failure=to_wire(error.sentence))))
            return error.exit_status
    return 0


def _rehearsed(worker: BlockingWorker, task: Rehearsals, one: RehearsedAttempt) -> Rehearsed:
    did = attempt(worker, one.source, one.step, one.hands, read_arena(task.world), _SEED, task.setup.limits)
    return Rehearsed(did.run.ended, did.is_passed, did.verdicts, did.run.problems)
