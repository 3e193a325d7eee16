"""
Preview process: computes one preview after the other at the lowest priority, with a worker of its own.

In: lines of JSON, the first a ``WorkerSetup``, each other one a ``PreviewTask``; an empty line cancels the task that is
computed. Out: an empty line when the worker is warm, and one line per task: its ``Previewed``.
"""

from __future__ import annotations

import contextlib
import gc
import os
import queue
import socket
import sys
import threading
from collections.abc import Callable

import msgspec

from ..config import Limits
from ..errors import RosyError, WorkerLost
from ..garbage_collection import keep_what_is_loaded
from ..wire.page import Previewed
from ..wire.worker import Refused
from ..worker.background_process import LOWEST_PRIORITY, WorkerSetup, begin_reading, write_line
from ..worker.blocking_worker import BlockingWorker
from .computing_budget import ComputingBudget
from .preview import PreviewTask, RoomCache, preview_over_link, preview_settings, refused_preview

__all__ = ["main"]


_PAUSE = 0.03
"""Between two tasks while a number is dragged, at most, s: the page draws the one and asks for the other."""

_IN_A_ROW = 20
"""Tasks after which there is a rest in any case: each counts in the budget of the next ones, as does its garbage."""


class _Input:
    """Lines of standard input, read by a thread."""

    def __init__(self) -> None:
        # Each with whether it is cancelled, which may be so before it is taken.
        self.tasks: queue.SimpleQueue[tuple[bytes, threading.Event]] = queue.SimpleQueue()
        self._cancelled = threading.Event()
        # Tasks since the last rest.
        self._in_a_row = 0
        # Ends the program at work; set while there is one.
        self.worker: BlockingWorker | None = None
        begin_reading(self._on_line)

    def next_task(self, rest: Callable[[], None]) -> tuple[bytes, threading.Event]:
        """The next task; what takes time between two is done when none comes soon, and after many in a row."""
        self._in_a_row += 1
        if self._in_a_row < _IN_A_ROW:
            with contextlib.suppress(queue.Empty):
                return self.tasks.get(timeout=_PAUSE)
        self._in_a_row = 0
        gc.collect()
        rest()
        return self.tasks.get()

    def _on_line(self, line: bytes) -> None:
        if line.strip():
            self._cancelled = threading.Event()
            self.tasks.put((line, self._cancelled))
        else:
            self._cancel()

    def _cancel(self) -> None:
        self._cancelled.set()
        if self.worker is not None:
            # A worker that is lost is noticed by the other thread.
            with contextlib.suppress(WorkerLost):
                self.worker.kill()


def main() -> int:
    """Serve standard input until it ends."""
    lines = _Input()
    setup = msgspec.json.decode(lines.tasks.get()[0], type=WorkerSetup)
    os.nice(LOWEST_PRIORITY)
    with contextlib.suppress(BrokenPipeError):
        try:
            with BlockingWorker(setup.config()) as worker:
                worker.ready()
                lines.worker = worker
                rooms, budget = RoomCache(), ComputingBudget(setup.limits.preview)
                # Between two previews nobody waits for a collection.
                keep_what_is_loaded()
                gc.disable()
                write_line(b"")
                while True:
                    line, cancelled = lines.next_task(budget.rest)
                    budget.begin()
                    task = msgspec.json.decode(line, type=PreviewTask)
                    write_line(msgspec.json.encode(_preview(worker, rooms, budget, task, setup.limits, cancelled)))
        except RosyError as error:
            sys.stderr.write(f"rosy: a preview process ends: {error}\n")
            return error.exit_status
    return 0


def _preview(
    worker: BlockingWorker,
    rooms: RoomCache,
    budget: ComputingBudget,
    task: PreviewTask,
    limits: Limits,
    cancelled: threading.Event,
) -> Previewed:
    def is_over() -> bool:
        return cancelled.is_set() or budget.is_used_up()

    ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_STREAM)
    settings = preview_settings(task, limits)
    with ours, settings.open_mailbox() as mailbox:
        started = worker.run(task.source, theirs, cancelled.is_set, mailbox, plain=True)
        if isinstance(started, Refused):
            return refused_preview(task.id, started.problems)
        world = rooms.world(task.world, task.seed)
        found = preview_over_link(task, settings, world, ours, worker, is_over, mailbox)
    # Answers about a run that is over are passed over by the next one.
    worker.kill()
    return found
