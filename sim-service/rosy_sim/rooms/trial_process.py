"""
Trial process: runs programs in one room after another, with a worker of its own that stays warm.

In: lines of JSON, the first a ``WorkerSetup``, each other one a ``Request``. Out: one line per request, an ``Answer``.
"""

from __future__ import annotations

import contextlib
import os
import queue
import socket
from typing import Any

import msgspec

from ..config import Limits
from ..errors import RosyError
from ..run.steps.velocity_guard import OFF, SafetySettings
from ..wire.problem import Sentence, to_wire
from ..wire.worker import Refused
from ..worker.background_process import WorkerSetup, begin_reading, write_line
from ..worker.blocking_worker import BlockingWorker
from ..world.properties import read_properties
from .generation.families import Family, generate_room
from .trial import Outcome, judge_run, refused

__all__ = ["Answer", "Request", "Task", "Trial", "main"]


class Task(msgspec.Struct, frozen=True):
    """What all trials of a program share. ``base`` is the room of ``like:ROOM``; ``seconds`` are simulated."""

    source: str
    properties: str
    seconds: float
    family: str
    base: dict[str, Any] | None
    seed: int
    safety: SafetySettings = OFF


class Trial(msgspec.Struct, frozen=True, omit_defaults=True):
    """A room of the family by its number, or a room of its own with the seed of its run."""

    room: int
    world: dict[str, Any] | None = None
    seed: int = 0


class Request(msgspec.Struct, frozen=True, omit_defaults=True):
    """A trial of a task; without one, of the task of the request before."""

    trial: Trial
    task: Task | None = None


class Answer(msgspec.Struct, frozen=True, omit_defaults=True):
    """
    The outcome of a trial and the world it was in, or why the worker could not be used.

    A process that has answered with a failure ends. ``was_ready`` tells whether its worker had been ready before.
    """

    outcome: Outcome | None = None
    world: dict[str, Any] | None = None
    was_ready: bool = False
    failure: str = ""
    failure_sentence: Sentence | None = None


def main() -> int:
    """Serve standard input until it ends."""
    lines: queue.SimpleQueue[bytes] = queue.SimpleQueue()
    begin_reading(lines.put)
    setup = msgspec.json.decode(lines.get(), type=WorkerSetup)
    os.nice(setup.nice)
    is_ready = False
    with contextlib.suppress(BrokenPipeError):
        try:
            with BlockingWorker(setup.config()) as worker:
                worker.ready()
                is_ready = True
                _serve(worker, setup.limits, lines)
        except RosyError as error:
            failure = to_wire(error.sentence)
            write_line(msgspec.json.encode(Answer(was_ready=is_ready, failure=str(error), failure_sentence=failure)))
            return error.exit_status
    return 0


def _serve(worker: BlockingWorker, limits: Limits, lines: queue.SimpleQueue[bytes]) -> None:
    task: Task | None = None
    while True:
        request = msgspec.json.decode(lines.get(), type=Request)
        task = request.task if request.task is not None else task
        assert task is not None
        write_line(msgspec.json.encode(_try(worker, limits, task, request.trial)))


def _try(worker: BlockingWorker, limits: Limits, task: Task, trial: Trial) -> Answer:
    number, world, seed = trial.room, trial.world, trial.seed
    if world is None:
        room = generate_room(Family(task.family, task.base), task.seed, number)
        world, seed = room.world, room.seed
    ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_STREAM)
    with ours:
        started = worker.run(task.source, theirs)
        if isinstance(started, Refused):
            return Answer(refused(number, seed, started.problems), world)
        properties = read_properties(task.properties)
        outcome = judge_run(ours, worker, (number, world, seed), task.seconds, properties, limits, task.safety)
    worker.kill()
    worker.gone()
    return Answer(outcome, world)
