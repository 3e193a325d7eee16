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
import time

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
"""For how long the next task is awaited before the process does its idle work, s: while a number is dragged, the page
draws one preview and asks for the next."""

_MAX_BUSY = 0.5
"""Time spent on previews after which the idle work is done in any case, s: the budget of a preview is too small by what
the previews since then have used."""


class _Input:
    """Lines of standard input, read by a thread."""

    def __init__(self) -> None:
        # Each with whether it is cancelled, which may be so before it is taken.
        self.tasks: queue.SimpleQueue[tuple[bytes, threading.Event]] = queue.SimpleQueue()
        self._cancelled = threading.Event()
        # Ends the program at work; set while there is one.
        self.worker: BlockingWorker | None = None
        begin_reading(self._on_line)

    def next_task(self, timeout: float) -> tuple[bytes, threading.Event] | None:
        """The next task, if it arrives within so many seconds."""
        try:
            return self.tasks.get(timeout=timeout)
        except queue.Empty:
            return None

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
                # Garbage is collected between previews only.
                keep_what_is_loaded()
                gc.disable()
                write_line(b"")
                # Time spent on previews since the last idle work, s.
                busy = 0.0
                following = lines.tasks.get()
                while True:
                    line, cancelled = following
                    began = time.monotonic()
                    budget.begin()
                    task = msgspec.json.decode(line, type=PreviewTask)
                    write_line(msgspec.json.encode(_preview(worker, rooms, budget, task, setup.limits, cancelled)))
                    busy += time.monotonic() - began
                    soon = lines.next_task(_PAUSE) if busy < _MAX_BUSY else None
                    if soon is None:
                        gc.collect()
                        budget.measure_baseline()
                        busy = 0.0
                    following = soon or lines.tasks.get()
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
