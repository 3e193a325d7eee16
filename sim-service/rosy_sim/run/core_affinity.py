"""
Core affinity of a lockstep: where the thread of a run and the process of its program compute.

The pair shares one core: of the two one computes while the other waits, and waking a process on the same core costs
least. With a mailbox, a program that is asked often, or has just begun, is put on a core of its own, and both
busy-wait: then neither has to be woken, and each keeps its cache. That takes two cores for the work of one. While other
work keeps their cores busy the pair is free to move, as the scheduler decides. The affinity that this thread and the
program were given is never exceeded, and is restored at the end.
"""

from __future__ import annotations

import os
import time
from pathlib import Path
from types import TracebackType
from typing import Literal

from .program_link import ProgramLink

__all__ = ["CoreAffinity"]

REVIEW_STEPS = 100
"""Steps after which ``review`` is called."""

REVIEW_INTERVAL = 0.05
"""Between two looks at how long the pair waited for its core, s: several turns of the scheduler."""

BUSY = 1 / 3
"""A core is busy when the pair waited for it for a larger share of the time. Choice of ours: alone, one of both waits
for the last microseconds of the other's turn, some tenth; beside one busy process they wait half of the time."""

FIRST_PAUSE = 0.02
"""Until the pair that could not use two cores tries them again, s; the next pauses are twice as long each."""

SELDOM = 5
"""A program that is asked in fewer than every fifth step is asked seldom. At the default rate, 10 Hz, it is asked in
each fifth."""

Placement = Literal["free", "shared", "separate"]
"""On any core, on one core, or each on its own and busy-waiting."""


class CoreAffinity:
    """
    Of one run. A context manager for the thread that drives it. On a system without these calls, or with one core, it
    does nothing.
    """

    def __init__(self, link: ProgramLink, wanted: bool = True) -> None:
        self._link = link
        self.placement: Placement = "free"
        # When two cores are tried again, and the pause after that, s.
        self._separate_from = 0.0
        self._pause = FIRST_PAUSE
        # The process of the program; 0 when it is not known or there is nothing to pin.
        self._program = 0
        # The cores that this thread and the program were given.
        self._ours: set[int] = set()
        self._theirs: set[int] = set()
        # When the waiting time was looked at last, and what it was, s.
        self._reviewed = self._waited = 0.0
        self._is_wanted = wanted and hasattr(os, "sched_setaffinity") and len(os.sched_getaffinity(0)) > 1
        if self._is_wanted:
            link.ask_for_program()

    def __enter__(self) -> CoreAffinity:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None
    ) -> None:
        # The program ends with the run.
        if self.placement != "free":
            self.placement = "free"
            _assign(0, self._ours)

    def begin(self) -> None:
        """Give both their cores. Call when the link has been read for the first time."""
        program = self._link.program
        # A program in a thread of this process, as in tests, has nothing to be pinned to.
        if not self._is_wanted or program in (0, os.getpid()):
            return
        try:
            self._ours, self._theirs = os.sched_getaffinity(0), os.sched_getaffinity(program)
        except OSError:
            return
        self._program = program
        self._reviewed, self._waited = time.perf_counter(), self._waiting_time()
        self._place("separate" if self._link.has_mailbox else "shared")

    def review(self) -> None:
        """Give up cores that others keep busy, and take them again later. Call every ``REVIEW_STEPS`` steps."""
        link = self._link
        reads, slept = link.reads, link.slept
        link.reads = link.slept = 0
        is_asked_often = reads * SELDOM >= REVIEW_STEPS
        now = time.perf_counter()
        goes_separate = (
            link.has_mailbox and self.placement != "separate" and is_asked_often and now >= self._separate_from
        )
        # A short run gains nothing from waiting for the first interval.
        is_early = now - self._reviewed < REVIEW_INTERVAL and not goes_separate
        if not self._program or is_early:
            return
        waited = self._waiting_time()
        is_busy = waited - self._waited > BUSY * (now - self._reviewed)
        self._reviewed, self._waited = now, waited
        if self.placement == "separate" and (is_busy or 2 * slept > reads):
            self._separate_from, self._pause = now + self._pause, 2 * self._pause
            self._place("shared")
        elif self.placement == "separate" and not is_asked_often:
            self._place("shared")
        elif self.placement != "separate":
            self._place("free" if is_busy else "separate" if goes_separate else "shared")

    def _place(self, placement: Placement) -> None:
        """Give both their cores: this thread stays where it is if it can."""
        if placement == self.placement:
            return
        common = self._ours & self._theirs
        here = _current_core()
        core = here if here in common else min(common, default=-1)
        others = self._theirs - {core}
        if placement == "free" or not common:
            self._assign_both("free", self._ours, self._theirs)
        elif placement == "separate" and others:
            self._assign_both("separate", {core}, others)
        else:
            self._assign_both("shared", {core}, {core})

    def _assign_both(self, placement: Placement, ours: set[int], theirs: set[int]) -> None:
        if not (_assign(0, ours) and _assign(self._program, theirs)) and placement != "free":
            self._assign_both("free", self._ours, self._theirs)
            return
        self.placement = placement
        self._link.busy_waits = placement == "separate"

    def _waiting_time(self) -> float:
        """How long this thread and the program were ready and waited for a core, s; 0 where that is not known."""
        return _waited("thread-self") + _waited(str(self._program))


def _assign(process: int, cores: set[int]) -> bool:
    """Whether a process, 0 for this thread, could be assigned to these cores. A failure costs only speed."""
    try:
        os.sched_setaffinity(process, cores)
    except OSError:
        # It has ended, or the cores were taken away meanwhile.
        return False
    return True


def _waited(process: str) -> float:
    # Time on a core, time of waiting for one, both ns, and turns. Documentation/scheduler/sched-stats.rst.
    try:
        return int(Path(f"/proc/{process}/schedstat").read_bytes().split()[1]) / 1e9
    except (OSError, IndexError):
        return 0.0


def _current_core() -> int:
    # The 39th field; the name of the process, in parentheses, may have spaces. proc_pid_stat(5).
    try:
        return int(Path("/proc/thread-self/stat").read_text().rpartition(")")[2].split()[36])
    except (OSError, IndexError, ValueError):
        return -1
