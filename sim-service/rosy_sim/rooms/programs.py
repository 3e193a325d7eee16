"""
Tests of several programs at once, on a pool of trial processes of this machine or of a cluster.

The reports come in the order of the programs, whichever was ready first. Several are tested at the same time, so
that the rooms of one keep the pool busy while the smallest failing room of another is searched.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from types import TracebackType
from typing import Protocol

from ..interruptible import results
from .room_test import Report, RoomTest, shrunk_report, try_rooms
from .trial import Outcome
from .trial_pool import Trials
from .trial_process import Task

__all__ = ["Pool", "Progress", "Tested", "test_programs"]

_MOST_PROGRAMS = 64
"""Programs that are tested at the same time; each waits in a thread."""


class Pool(Protocol):
    """Where trials are made: ``TrialPool``, or the nodes of a cluster."""

    @property
    def processes(self) -> int:
        """How many rooms are tried at once."""

    def program(self, task: Task) -> Trials:
        """The trials of one program."""

    def close(self) -> None:
        """End all trials at once."""

    def __enter__(self) -> Pool: ...

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None
    ) -> None: ...


@dataclass(frozen=True, slots=True)
class Tested:
    """The report of a program, and how long its smallest failing room was looked for, s of a wall clock."""

    report: Report
    shrink_seconds: float


class Progress:
    """Counts of rooms over all programs; may be used from several threads."""

    def __init__(self, on_change: Callable[[int, int, int], None]) -> None:
        """``on_change`` gets the rooms that are done, those that passed, and the rooms tried while shrinking."""
        self._on_change = on_change
        self._lock = threading.Lock()
        self._done = self._passed = self._shrunk = 0

    def outcome(self, outcome: Outcome) -> None:
        """Count a room."""
        with self._lock:
            self._done += 1
            self._passed += outcome.has_passed
            self._on_change(self._done, self._passed, self._shrunk)

    def shrink(self, count: int) -> None:
        """Count rooms that were tried for a smallest one."""
        with self._lock:
            self._shrunk += count
            self._on_change(self._done, self._passed, self._shrunk)


def test_programs(test: RoomTest, sources: Sequence[str], pool: Pool, progress: Progress) -> Iterator[Tested]:
    """
    Test programs in all rooms of a test; what a program is refused or lost for is in its report.

    Raises:
        RosyError: a worker could not start.
    """
    at_once = max(1, min(len(sources), pool.processes, _MOST_PROGRAMS))
    threads = ThreadPoolExecutor(at_once)
    try:
        yield from results(
            [threads.submit(_test, test, pool.program(test.task(source)), progress) for source in sources]
        )
    except BaseException:
        # The threads wait for trials.
        pool.close()
        raise
    finally:
        threads.shutdown(cancel_futures=True)


def _test(test: RoomTest, trials: Trials, progress: Progress) -> Tested:
    counted = 0

    def on_shrink(tried: int) -> None:
        nonlocal counted
        progress.shrink(tried - counted)
        counted = tried

    report = try_rooms(test, trials, progress.outcome)
    began = time.monotonic()
    shrunk = report if report.lost is not None else shrunk_report(test, trials, report, on_shrink)
    return Tested(shrunk, time.monotonic() - began)
