"""
Outbox: bounded queue of the messages for one page.

A page that reads slowly gets fewer frames; one that reads nothing is disconnected. Neither delays other pages.

An answer to a page that reads is written at once, where the connection allows it: waking a task for each frame costs
more than the frame.
"""

from __future__ import annotations

import asyncio
from collections import deque
from collections.abc import Callable
from itertools import islice

from ...wire.page import Answer, Frame, encode_bytes

__all__ = ["Outbox"]

_MAX_FIRED = 200
"""Firings remembered for one frame; a page shows the latest."""

_MOST_RUNS = 2
"""Runs that one page is shown at the same time: that of a real robot, and its twin."""


class Outbox:
    """A queue in which a frame that has not been sent yet is replaced by the next."""

    def __init__(self, limit: int) -> None:
        self._limit = limit
        self._waiting: deque[Answer] = deque()
        self._not_empty = asyncio.Event()
        # Set while nothing waits.
        self._empty = asyncio.Event()
        self._empty.set()
        # Set when the queue is full, so the page has stopped reading.
        self.overflowed = asyncio.Event()
        # Writes a text at once, or answers that it cannot.
        self._write: Callable[[bytes], bool] | None = None
        # Whether all that was taken out has been sent: the sender waits in get().
        self._is_drained = False

    def write_with(self, write: Callable[[bytes], bool]) -> None:
        """Write answers at once with this function, as long as it answers that it has written them."""
        self._write = write

    def put(self, answer: Answer) -> None:
        """Add an answer, or send it at once; never blocks."""
        waiting = self._waiting
        if self._write is not None and self._is_drained and not waiting and self._write(encode_bytes(answer)):
            return
        if isinstance(answer, Frame):
            last = self._take_unsent_frame(answer.run)
            if last is not None:
                answer.fired = (last.fired + answer.fired)[-_MAX_FIRED:]
                answer.sensed = (last.sensed + answer.sensed)[-_MAX_FIRED:]
                answer.times = ((last.times or []) + (answer.times or []))[-_MAX_FIRED:] or None
                answer.channels = {**last.channels, **answer.channels}
                if last.firings:
                    answer.firings = (last.firings + (answer.firings or []))[-_MAX_FIRED:]
                answer.boxes = answer.boxes or last.boxes
                answer.memory = last.memory if answer.memory is None else answer.memory
        if len(waiting) >= self._limit:
            self.overflowed.set()
        else:
            waiting.append(answer)
            self._empty.clear()
        self._not_empty.set()

    def _take_unsent_frame(self, run: int) -> Frame | None:
        """
        Take out the frame of a run that waits with only frames behind it: those of a real robot and of its twin
        alternate.
        """
        for place, answer in enumerate(islice(reversed(self._waiting), _MOST_RUNS)):
            if not isinstance(answer, Frame):
                return None
            if answer.run == run:
                del self._waiting[-1 - place]
                return answer
        return None

    async def is_sent(self) -> None:
        """Return when all answers have been sent: the sender waits for the next one."""
        await self._empty.wait()

    async def get(self) -> Answer:
        """The next answer."""
        while not self._waiting:
            self._not_empty.clear()
            self._empty.set()
            self._is_drained = True
            await self._not_empty.wait()
        self._is_drained = False
        return self._waiting.popleft()
