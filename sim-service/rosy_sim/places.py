"""
Places for running programs: as many as the machine can drive on time, and a queue for everybody else.

Whoever waits is told where in the queue, and again whenever that changes.
"""

from __future__ import annotations

import asyncio
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass

__all__ = ["Places"]


@dataclass(slots=True, eq=False)
class _Waiting:
    turn: asyncio.Future[None]
    told: Callable[[int], None]
    # What was told last; 0 before that.
    position: int = 0


class Places:
    """Each enter() that returns is followed by one leave()."""

    def __init__(self, limit: int) -> None:
        self.limit = limit
        # Places that are taken, or promised to somebody whose turn it is.
        self.taken = 0
        # Programs that have had to wait, since the beginning.
        self.queued = 0
        self._queue: deque[_Waiting] = deque()

    async def enter(self, told: Callable[[int], None]) -> None:
        """Take a place, waiting for one if need be; ``told`` hears the position in the queue, 1 for the next."""
        if self.taken < self.limit:
            self.taken += 1
            return
        self.queued += 1
        waiting = _Waiting(asyncio.get_running_loop().create_future(), told)
        self._queue.append(waiting)
        self._tell()
        try:
            await waiting.turn
        except asyncio.CancelledError:
            if waiting in self._queue:
                self._queue.remove(waiting)
                self._tell()
            elif not waiting.turn.cancelled():
                # Its turn had come just now.
                self.leave()
            raise

    def leave(self) -> None:
        """Give the place to the next, or back."""
        while self._queue:
            waiting = self._queue.popleft()
            if not waiting.turn.done():
                waiting.turn.set_result(None)
                self._tell()
                return
        self.taken -= 1

    def _tell(self) -> None:
        for position, waiting in enumerate(self._queue, 1):
            if position != waiting.position:
                waiting.position = position
                waiting.told(position)
