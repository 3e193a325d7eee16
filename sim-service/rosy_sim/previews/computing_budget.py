"""
Computing budget of one preview: processor time of this process and all below it, the worker and its program included.

Previews have the lowest priority, so on a busy machine the clock says little about them. It is the limit of a preview
that waits.
"""

from __future__ import annotations

import contextlib
import time
from collections.abc import Callable, Mapping

import psutil

__all__ = ["PATIENCE", "ComputingBudget", "processor_times"]

PATIENCE = 10.0
"""Seconds on the clock for each second of processor time."""

_SHORTEST_PAUSE = 0.25
"""Between two looks, s: each reads the whole process table."""


def processor_times() -> dict[psutil.Process, float]:
    """Processor time that this process and each below it have used, s."""
    own = psutil.Process()
    times = {}
    for process in (own, *own.children(recursive=True)):
        with contextlib.suppress(psutil.Error):
            used = process.cpu_times()
            times[process] = used.user + used.system
    return times


class ComputingBudget:
    """Of ``seconds`` from each ``begin``; the clock and the processor times count s and only go forward."""

    def __init__(
        self,
        seconds: float,
        now: Callable[[], float] = time.monotonic,
        computed: Callable[[], Mapping[psutil.Process, float]] = processor_times,
    ) -> None:
        self._seconds = seconds
        self._now = now
        self._computed = computed
        self._before: Mapping[psutil.Process, float] = {}
        # When the preview has waited for too long, and when the processor times are looked at again.
        self._expires = self._review = 0.0
        self.measure_baseline()
        self.begin()

    def measure_baseline(self) -> None:
        """Read the processor times that do not count for the next preview. Takes some milliseconds; call while idle."""
        self._before = self._computed()

    def begin(self) -> None:
        """A preview begins, soon after ``measure_baseline``."""
        now = self._now()
        self._expires = now + PATIENCE * self._seconds
        self._review = now + self._seconds

    def is_used_up(self) -> bool:
        """Whether the preview has computed, or waited, for too long. Cheap enough for every step."""
        now = self._now()
        if now < self._review:
            return False
        used = sum(seconds - self._before.get(process, 0.0) for process, seconds in self._computed().items())
        left = self._seconds - used
        if left <= 0 or now >= self._expires:
            return True
        self._review = now + max(_SHORTEST_PAUSE, left)
        return False
