"""
Run queue: limits how many programs run at once; further runs wait in order of arrival.

Each waiting run is told its position in the queue, and again whenever the position changes.
"""

from __future__ import annotations

import asyncio
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass

__all__ = ["RunQueue"]


@dataclass(slots=True, eq=False)
class _Waiter:
    turn: asyncio.Future[None]
    on_position: Callable[[int], None]
    # The position that was reported last; 0 before that.
    position: int = 0


class RunQueue:
    """Each acquire() that returns is followed by one release()."""

    def __init__(self, limit: int) -> None:
        self.limit = limit
        # Slots in use, including those of waiters whose turn has come.
        self.running = 0
        # Runs that have had to wait since the service started.
        self.queued = 0
        self._waiters: deque[_Waiter] = deque()

    async def acquire(self, on_position: Callable[[int], None]) -> None:
        """Take a slot; while none is free, wait and report the position in the queue, 1 for the next."""
        if self.running < self.limit:
            self.running += 1
            return
        self.queued += 1
        waiter = _Waiter(asyncio.get_running_loop().create_future(), on_position)
        self._waiters.append(waiter)
        self._report_positions()
        try:
            await waiter.turn
        except asyncio.CancelledError:
            if waiter in self._waiters:
                self._waiters.remove(waiter)
                self._report_positions()
            elif not waiter.turn.cancelled():
                # The slot had been handed over already.
                self.release()
            raise

    def release(self) -> None:
        """Hand the slot to the next waiter, or free it."""
        while self._waiters:
            waiter = self._waiters.popleft()
            if not waiter.turn.done():
                waiter.turn.set_result(None)
                self._report_positions()
                return
        self.running -= 1

    def _report_positions(self) -> None:
        for position, waiter in enumerate(self._waiters, 1):
            if position != waiter.position:
                waiter.position = position
                waiter.on_position(position)
