"""Lateness of simulation steps: by how much each began after it was due, as a summary over the latest ones."""

from __future__ import annotations

from collections import deque

from ..world.time_step import STEP

__all__ = ["LATE", "Lateness"]

LATE = STEP / 2
"""A step that begins later than this counts in ``late``, s: the next one is nearer than the moment when it was due."""


class Lateness:
    """Samples in s; the oldest are forgotten beyond ``size``."""

    def __init__(self, size: int = 50_000) -> None:
        self._samples: deque[float] = deque(maxlen=size)
        # Steps of all runs, and those of them that were late.
        self.steps = self.late = 0
        # The former at the last clear().
        self._cleared = 0

    def add(self, lateness: float) -> None:
        """Record one step."""
        self.steps += 1
        if lateness > LATE:
            self.late += 1
        self._samples.append(lateness)

    def summary(self) -> dict[str, float]:
        """Count, median, 99th percentile and maximum."""
        samples = sorted(self._samples)
        if not samples:
            return {"steps": 0, "p50": 0.0, "p99": 0.0, "worst": 0.0}
        n = len(samples)
        return {
            "steps": self.steps - self._cleared,
            "p50": samples[n // 2],
            "p99": samples[min(n - 1, n * 99 // 100)],
            "worst": samples[-1],
        }

    def clear(self) -> None:
        """Forget all samples."""
        self._cleared = self.steps
        self._samples.clear()
