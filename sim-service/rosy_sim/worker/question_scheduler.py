"""
Round-robin scheduler of the checks and completions that pages ask of the worker.

A page has one question in progress, and pages take turns, so a page with many questions delays the others by one. A
page whose question was in progress for long is penalised: for a while all such pages together leave one slot free. A
reload does not end the penalty: pages that open from the same client address until then have it too. The worker's own
limits end a question.
"""

from __future__ import annotations

import asyncio
from collections import deque
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager

__all__ = ["QuestionScheduler"]

_SLOTS = 2
"""Questions in progress. As many compile at once in the worker (``Options.hs``, ``checkLimit``)."""

_LONG = 5.0
"""Question in progress that leads to a penalty, s: half of the worker's limit; learners' programs take some 50 ms."""

_PENALTY = 60.0
"""Time of the penalty, s."""


class QuestionScheduler:
    """
    Gives turns to pages.

    Args:
        now: a clock in s that only goes forward.
    """

    def __init__(self, now: Callable[[], float]) -> None:
        self._now = now
        # Questions that wait, by page; the page whose turn is next comes first.
        self._waiting: dict[object, deque[asyncio.Future[None]]] = {}
        # Pages with a question in progress.
        self._asking: set[object] = set()
        # When the penalties of pages end.
        self._penalties: dict[object, float] = {}
        # When those of pages that have gone end, by the addresses of their clients.
        self._inherited: dict[str, float] = {}

    def join(self, page: object, address: str) -> None:
        """A page of this client address has opened."""
        end = self._inherited.get(address, 0.0)
        if end > self._now():
            self._penalties[page] = end

    @asynccontextmanager
    async def turn(self, page: object) -> AsyncIterator[None]:
        """Wait for the turn of a page, and have it until the end of the block."""
        mine: asyncio.Future[None] = asyncio.get_running_loop().create_future()
        self._waiting.setdefault(page, deque()).append(mine)
        self._dispatch()
        try:
            await mine
        except asyncio.CancelledError:
            if mine.cancelled():
                self._forget(page, mine)
            else:
                # The turn had come already.
                self._end(page)
            raise
        begun = self._now()
        try:
            yield
        finally:
            if self._now() - begun > _LONG:
                self._penalties[page] = self._now() + _PENALTY
            self._end(page)

    def leave(self, page: object, address: str) -> None:
        """A page has gone; its penalty goes to the pages that open from its address."""
        now = self._now()
        end = max(self._penalties.pop(page, 0.0), self._inherited.get(address, 0.0))
        self._inherited = {other: until for other, until in self._inherited.items() if until > now}
        if end > now:
            self._inherited[address] = end

    def _end(self, page: object) -> None:
        self._asking.discard(page)
        if page in self._waiting:
            # Behind the other pages.
            self._waiting[page] = self._waiting.pop(page)
        self._dispatch()

    def _forget(self, page: object, question: asyncio.Future[None]) -> None:
        waiting = self._waiting.get(page)
        if waiting is not None and question in waiting:
            waiting.remove(question)
            if not waiting:
                del self._waiting[page]

    def _dispatch(self) -> None:
        while len(self._asking) < _SLOTS and (page := self._next()) is not None:
            waiting = self._waiting.pop(page)
            question = waiting.popleft()
            if waiting:
                self._waiting[page] = waiting
            if not question.done():
                self._asking.add(page)
                question.set_result(None)

    def _next(self) -> object | None:
        """The page whose turn it is; ``None`` when those that wait have to wait on."""
        ready = [page for page in self._waiting if page not in self._asking]
        free = [page for page in ready if not self._is_penalised(page)]
        if free:
            return free[0]
        has_slot = sum(self._is_penalised(page) for page in self._asking) < _SLOTS - 1
        return ready[0] if ready and has_slot else None

    def _is_penalised(self, page: object) -> bool:
        return self._penalties.get(page, 0.0) > self._now()
