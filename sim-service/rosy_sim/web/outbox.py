"""
Outbox: bounded queue of the messages for one page.

A page that reads slowly gets fewer frames; one that reads nothing is disconnected. Neither delays other pages.
"""

from __future__ import annotations

import asyncio
from collections import deque

from ..wire.page import Answer, Frame

__all__ = ["Outbox"]

_MAX_FIRED = 200
"""Firings remembered for one frame; a page shows the latest."""


class Outbox:
    """A queue in which a frame that has not been sent yet is replaced by the next."""

    def __init__(self, limit: int) -> None:
        self._limit = limit
        self._waiting: deque[Answer] = deque()
        self._not_empty = asyncio.Event()
        # Set when the queue is full, so the page has stopped reading.
        self.overflowed = asyncio.Event()

    def put(self, answer: Answer) -> None:
        """Add an answer; never blocks."""
        waiting = self._waiting
        if isinstance(answer, Frame) and waiting:
            last = waiting[-1]
            if isinstance(last, Frame) and last.run == answer.run:
                answer.fired = (last.fired + answer.fired)[-_MAX_FIRED:]
                answer.sensed = (last.sensed + answer.sensed)[-_MAX_FIRED:]
                answer.channels = {**last.channels, **answer.channels}
                if last.firings:
                    answer.firings = (last.firings + (answer.firings or []))[-_MAX_FIRED:]
                answer.boxes = answer.boxes or last.boxes
                answer.memory = last.memory if answer.memory is None else answer.memory
                waiting.pop()
        if len(waiting) >= self._limit:
            self.overflowed.set()
        else:
            waiting.append(answer)
        self._not_empty.set()

    async def get(self) -> Answer:
        """The next answer."""
        while not self._waiting:
            self._not_empty.clear()
            await self._not_empty.wait()
        return self._waiting.popleft()
