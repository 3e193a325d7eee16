"""
Processor time of commands and of everything below them, for comparisons on a machine that others use, too.

The time of a process that has ended is in its parent's, but only if the parent waits for its end; Ray's parents do not.
So processes are looked at again and again: what was seen of each counts, and of those too short to be seen what their
parent was told.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from pathlib import Path
from types import TracebackType

import psutil

__all__ = ["Identity", "ProcessTimes", "Seen", "TimeMeter", "exact_time", "spent"]

Identity = tuple[int, float]
"""Number of a process and when it began: numbers are used again."""

_LOOK = 0.5
"""Between two looks, s."""

_FIGURES = ["ppid", "create_time", "cpu_times"]


def exact_time(processes: Iterable[psutil.Process]) -> float:
    """
    Processor time that processes have used, s, without those below them. The scheduler counts nanoseconds of each
    thread, in the first number of ``schedstat``; ``psutil`` counts hundredths of a second, in which a program makes
    fifty steps.
    """
    threads = [file for process in processes for file in Path(f"/proc/{process.pid}/task").glob("*/schedstat")]
    return sum(int(file.read_text().split()[0]) for file in threads) / 1e9


@dataclass(slots=True)
class Seen:
    """What was seen of a process last: times in s, ``waited`` of those below it whose ends it was told."""

    own: float
    waited: float
    parent: Identity | None


def spent(seen: dict[Identity, Seen], alive: set[Identity]) -> float:
    """The processor time of all processes, s, each counted once."""
    told = dict.fromkeys(seen, 0.0)
    for process, times in seen.items():
        if process not in alive and times.parent in told:
            told[times.parent] += times.own + times.waited
    return sum(times.own + max(0.0, times.waited - told[process]) for process, times in seen.items())


@dataclass
class ProcessTimes:
    """The times of the processes below some others, and of these. One thread may look while others read."""

    _found: tuple[dict[Identity, Seen], set[Identity]] = field(default_factory=lambda: ({}, set()))
    """What was seen of each, and which of them are alive: replaced as a whole."""

    def look(self, roots: Iterable[int]) -> None:
        """Look at all that there are now."""
        # One pass for all: each has a file of its own.
        now = {process.pid: process.info for process in psutil.process_iter(_FIGURES)}
        below: dict[int, list[int]] = {}
        for pid, figures in now.items():
            below.setdefault(figures["ppid"], []).append(pid)
        seen, alive = dict(self._found[0]), set[Identity]()
        todo: list[tuple[int, Identity | None]] = [(root, None) for root in roots]
        while todo:
            pid, parent = todo.pop()
            figures = now.get(pid)
            if figures is None or figures["cpu_times"] is None:
                continue
            identity, times = (pid, figures["create_time"]), figures["cpu_times"]
            alive.add(identity)
            waited = times.children_user + times.children_system
            seen[identity] = Seen(times.user + times.system, waited, parent)
            todo += [(child, identity) for child in below.get(pid, [])]
        self._found = seen, alive

    @property
    def total(self) -> float:
        """Of all that were seen, s."""
        return spent(*self._found)


class TimeMeter:
    """Looks in a thread of its own while the block lasts; ``roots`` gives the processes above all others."""

    def __init__(self, roots: Callable[[], Iterable[int]]) -> None:
        self._roots, self._times = roots, ProcessTimes()
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._before = 0.0

    def __enter__(self) -> TimeMeter:
        self._times.look(self._roots())
        self._before = self._times.total
        self._thread.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None
    ) -> None:
        self._ended.set()
        self._thread.join()

    @property
    def spent(self) -> float:
        """Processor time since the block began, s."""
        return self._times.total - self._before

    def _run(self) -> None:
        while not self._ended.wait(_LOOK):
            self._times.look(self._roots())
