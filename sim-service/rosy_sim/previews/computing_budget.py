"""
Computing budget of one preview: processor time of this process and all below it, the worker and its program included.

Previews have the lowest priority, so on a busy machine the clock says little about them. It is the limit of a preview
that waits.
"""

from __future__ import annotations

import contextlib
import time
from collections.abc import Callable

import psutil

__all__ = ["ComputingBudget", "computed_time"]

PATIENCE = 10.0
"""Seconds on the clock for each second of processor time."""

_SHORTEST_PAUSE = 0.25
"""Between two looks, s: each reads the whole process table."""


def computed_time() -> float:
    """Processor time that this process and all below it have used, s."""
    own = psutil.Process()
    total = 0.0
    for process in (own, *own.children(recursive=True)):
        with contextlib.suppress(psutil.Error):
            used = process.cpu_times()
            total += used.user + used.system
    return total


class ComputingBudget:
    """Of ``seconds`` from now on; both clocks count s and only go forward."""

    def __init__(
        self,
        seconds: float,
        now: Callable[[], float] = time.monotonic,
        computed: Callable[[], float] = computed_time,
    ) -> None:
        self._seconds = seconds
        self._now = now
        self._computed = computed
        self._began = computed()
        self._expires = now() + PATIENCE * seconds
        # When the processor time is looked at again.
        self._review = now() + seconds

    def is_used_up(self) -> bool:
        """Whether the preview has computed, or waited, for too long. Cheap enough for every step."""
        now = self._now()
        if now < self._review:
            return False
        left = self._seconds - (self._computed() - self._began)
        if left <= 0 or now >= self._expires:
            return True
        self._review = now + max(_SHORTEST_PAUSE, left)
        return False
