"""
Cooperative scheduler of the work that messages cause on the event loop.

Work is done in turns, each some milliseconds long, one after the other. When the turns of one iteration of the loop
have taken long, the others wait for the next: the steps of runs and the answers of the worker are served in between.
Client addresses take turns, and so do the pages of an address. An address has a share of the loop, however many pages
it has.
"""

from __future__ import annotations

import asyncio
import inspect
import math
import time
from collections import deque
from collections.abc import AsyncIterator, Callable, Coroutine, Generator, Iterator
from contextlib import asynccontextmanager
from functools import partial
from typing import Any, Generic, TypeVar

from ...token_bucket import TokenBucket

__all__ = ["REQUEST", "LoopScheduler", "PageTurns"]

_RATE, _BURST = 0.25, 0.5
"""Share of the loop for one address, and s of computing at once: thirty pupils behind one address open their rooms."""

_ITERATION = 0.002
"""Computing time of turns in one iteration of the loop, s, after which the others wait for the next iteration."""

_MESSAGE, _CHARACTER = 1e-4, 8e-9
"""Computing time that is not measured: a message and a character of it, read from the socket and answered, s."""

REQUEST = 5e-4
"""Computing time of a request over HTTP, which is not measured, s. A page is some 40 of them."""

_SLOWEST = 4.0
"""Most s that count for a second of processor time. A machine that stands still for a while is no page's fault."""


class _Address:
    """A client address: its share, and its turns that wait, in their order."""

    def __init__(self, now: float) -> None:
        self.share = TokenBucket(_RATE, _BURST, now)
        # When its next turn may begin, on the loop's clock.
        self.ready = now
        self.waiting: deque[asyncio.Future[None]] = deque()


class LoopScheduler:
    """
    Gives turns to client addresses.

    Args:
        computed: the processor time of this thread, s.
        clock: the time, s.
    """

    def __init__(
        self, computed: Callable[[], float] = time.thread_time, clock: Callable[[], float] = time.perf_counter
    ) -> None:
        self.computed = computed
        self.clock = clock
        # In the order of their turns; those that have not computed for a while are forgotten.
        self._addresses: dict[str, _Address] = {}
        # The address that was given a turn which has not ended.
        self._busy: _Address | None = None
        # Computing time of the turns since the last call of _begin_iteration(), s.
        self._spent = 0.0
        self._timer: asyncio.TimerHandle | None = None

    async def begin(self, name: str) -> None:
        """Wait for the turn of an address, which is followed by end() before anything else is waited for."""
        turn: asyncio.Future[None] = asyncio.get_running_loop().create_future()
        self._address(name).waiting.append(turn)
        self._dispatch()
        try:
            await turn
        except asyncio.CancelledError:
            if not turn.cancelled():
                # The turn had come already.
                self.end(name, 0.0)
            raise

    def end(self, name: str, spent: float) -> None:
        """The turn of an address is over, which computed for so many s."""
        now = self._now()
        # Behind the other addresses.
        address = self._addresses[name] = self._addresses.pop(name)
        address.ready = now + address.share.overdraw(spent, now)
        self._busy = None
        was_over = self._spent >= _ITERATION
        self._spent += spent
        if self._spent >= _ITERATION and not was_over:
            asyncio.get_running_loop().call_soon(self._begin_iteration)
        self._dispatch()

    def charge(self, name: str, spent: float) -> None:
        """An address has computed for so many s outside its turns: the next one comes later."""
        now = self._now()
        address = self._address(name)
        address.ready = max(address.ready, now + address.share.overdraw(spent, now))

    def _address(self, name: str) -> _Address:
        found = self._addresses.get(name)
        if found is None:
            now = self._now()
            # Those that have their whole share again are as good as unknown.
            self._addresses = {
                other: address
                for other, address in self._addresses.items()
                if address is self._busy or address.waiting or address.ready + _BURST / _RATE > now
            }
            found = self._addresses[name] = _Address(now)
        return found

    def _begin_iteration(self) -> None:
        self._spent = 0.0
        self._dispatch()

    def _dispatch(self) -> None:
        """Give the next turn, if there may be one."""
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None
        if self._busy is not None or self._spent >= _ITERATION:
            return
        now = self._now()
        earliest = math.inf
        for address in self._addresses.values():
            while address.waiting and address.waiting[0].cancelled():
                address.waiting.popleft()
            if address.waiting and address.ready <= now:
                self._busy = address
                address.waiting.popleft().set_result(None)
                return
            if address.waiting:
                earliest = min(earliest, address.ready)
        if earliest < math.inf:
            self._timer = asyncio.get_running_loop().call_at(earliest, self._dispatch)

    def _now(self) -> float:
        return asyncio.get_running_loop().time()


_T = TypeVar("_T")


class _Remainder(Generic[_T]):
    """What is left of a coroutine that waits for something; its computing time is charged piece by piece."""

    def __init__(
        self,
        work: Coroutine[Any, Any, _T],
        awaited: Any,
        computed: Callable[[], float],
        charge: Callable[[float], None],
    ) -> None:
        self._work = work
        self._awaited = awaited
        self._computed = computed
        self._charge = charge

    def __await__(self) -> Generator[Any, Any, _T]:
        awaited = self._awaited
        while True:
            go_on: Callable[[], Any]
            try:
                go_on = partial(self._work.send, (yield awaited))
            except BaseException as error:  # noqa: BLE001 (also a cancellation belongs to the coroutine)
                go_on = partial(self._work.throw, error)
            begun = self._computed()
            try:
                awaited = go_on()
            except StopIteration as done:
                return done.value  # type: ignore[no-any-return]
            finally:
                self._charge(self._computed() - begun)


class PageTurns:
    """The turns of one page, which waits for one at a time."""

    def __init__(self, scheduler: LoopScheduler, address: str) -> None:
        self._scheduler = scheduler
        self._address = address
        # Time of all turns, s.
        self.spent = 0.0

    @asynccontextmanager
    async def turn(self, characters: int = 0) -> AsyncIterator[None]:
        """
        Wait for a turn, and have it until the end of the block, which does not wait for anything.

        Args:
            characters: of a message that is served.
        """
        computed, clock = self._scheduler.computed, self._scheduler.clock
        await self._scheduler.begin(self._address)
        begun, then = computed(), clock()
        try:
            yield
        finally:
            # On a busy machine the others wait for the whole time.
            spent = min(clock() - then, _SLOWEST * (computed() - begun)) + _MESSAGE + _CHARACTER * characters
            self.spent += spent
            self._scheduler.end(self._address, spent)

    async def serve(self, work: Coroutine[Any, Any, _T], characters: int = 0) -> _T:
        """
        Serve a message whose service may wait: in a turn until it waits first; what follows is charged.

        Args:
            work: not begun yet.
            characters: of the message.
        """
        try:
            async with self.turn(characters):
                try:
                    awaited = work.send(None)
                except StopIteration as done:
                    return done.value  # type: ignore[no-any-return]
        finally:
            # Cancelled before its turn; otherwise it has begun.
            if inspect.getcoroutinestate(work) == inspect.CORO_CREATED:
                work.close()
        return await _Remainder(work, awaited, self._scheduler.computed, self._charge)

    def _charge(self, spent: float) -> None:
        self.spent += spent
        self._scheduler.charge(self._address, spent)

    async def complete(self, pieces: Iterator[object]) -> None:
        """Do the pieces of a computation, as many in a turn as there is time for."""
        computed = self._scheduler.computed
        while True:
            async with self.turn():
                begun = computed()
                for _ in pieces:
                    if computed() - begun >= _ITERATION:
                        break
                else:
                    return
