"""Lateness of simulation steps: by how much each began after it was due, as a summary over the latest ones."""

from __future__ import annotations

from collections import deque

__all__ = ["Lateness"]


class Lateness:
    """Samples in s; the oldest are forgotten beyond ``size``."""

    def __init__(self, size: int = 50_000) -> None:
        self._samples: deque[float] = deque(maxlen=size)
        # Steps since the last clear().
        self._steps = 0

    def add(self, late: float) -> None:
        """Record one step."""
        self._steps += 1
        self._samples.append(late)

    def summary(self) -> dict[str, float]:
        """Count, median, 99th percentile and maximum."""
        samples = sorted(self._samples)
        if not samples:
            return {"steps": 0, "p50": 0.0, "p99": 0.0, "worst": 0.0}
        n = len(samples)
        return {
            "steps": self._steps,
            "p50": samples[n // 2],
            "p99": samples[min(n - 1, n * 99 // 100)],
            "worst": samples[-1],
        }

    def clear(self) -> None:
        """Forget all samples."""
        self._steps = 0
        self._samples.clear()
