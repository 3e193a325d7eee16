"""
Monitor of an event loop: how long it computes without serving its timers, in processor time, which other processes of
the machine do not make longer.
"""

from __future__ import annotations

import asyncio
import time
from dataclasses import dataclass

__all__ = ["LoopMonitor", "LoopUse"]

_PERIOD = 0.001
"""Between two looks, s."""


@dataclass(frozen=True, slots=True)
class LoopUse:
    """What the thread of a loop computed."""

    # Of the time.
    share: float
    # Processor time between two looks, s.
    p99: float
    most: float


class LoopMonitor:
    """Looks at the current loop until cancel()."""

    def __init__(self) -> None:
        self._stretches: list[float] = []
        self._begun = (time.monotonic(), time.thread_time())
        self._task = asyncio.create_task(self._look())

    async def _look(self) -> None:
        while True:
            before = time.thread_time()
            await asyncio.sleep(_PERIOD)
            self._stretches.append(time.thread_time() - before)

    def clear(self) -> None:
        """Forget what was seen."""
        self._stretches.clear()
        self._begun = (time.monotonic(), time.thread_time())

    def use(self) -> LoopUse:
        """What was seen since the last clear()."""
        clock, computed = self._begun
        ordered = sorted(self._stretches) or [0.0]
        return LoopUse(
            (time.thread_time() - computed) / (time.monotonic() - clock),
            ordered[min(len(ordered) - 1, len(ordered) * 99 // 100)],
            ordered[-1],
        )

    def cancel(self) -> None:
        """Look no more."""
        self._task.cancel()
