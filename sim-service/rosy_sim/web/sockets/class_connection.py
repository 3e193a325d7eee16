"""
Connection of a socket of class mode: requests one after the other at a limited rate, answers from a bounded queue.
"""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import AsyncIterator, Callable, Coroutine
from typing import Any

import msgspec
from starlette.status import WS_1000_NORMAL_CLOSURE, WS_1008_POLICY_VIOLATION, WS_1013_TRY_AGAIN_LATER
from starlette.websockets import WebSocket, WebSocketDisconnect

from ...accounting.client import network_of
from ...accounting.resources import LOCKED_SECONDS
from ...accounting.slots import Evictions, Slots
from ...classroom.classroom import Classroom
from ...classroom.messages.board_messages import ProgramShown
from ...classroom.messages.message_fields import PING, BadRequest, Pong, Refused, encode
from ...token_bucket import TokenBucket
from ..pacing.loop_scheduler import LoopScheduler, PageTurns
from .first_completed import first_completed

__all__ = ["ClassConnection", "connected", "locked"]

_RATE, _BURST = 20.0, 400.0
"""Messages that a page may send, a second and at once."""

_CHARACTERS_PER_MESSAGE = 2000
"""Characters that count as one more message."""

_QUEUE = 500
"""Messages waiting for a slow page before it is disconnected."""


class ClassConnection:
    """
    The two directions of a socket: requests one after the other, in the turns of the client's address; answers from a
    bounded queue.
    """

    def __init__(self, socket: WebSocket, scheduler: LoopScheduler) -> None:
        self._socket = socket
        self._turns = PageTurns(scheduler, self.address)
        self._queue: asyncio.Queue[str] = asyncio.Queue(_QUEUE)
        self._overflowed = asyncio.Event()
        # Set when the page has given the teacher's key.
        self._unlocked = asyncio.Event()
        self.on_unlocked: Callable[[], None] = lambda: None
        # Set to end the connection.
        self.ended = asyncio.Event()
        # The task whose results a board shows.
        self.results_of: int | None = None
        # The program that a board opened last, as it was told.
        self.followed: ProgramShown | None = None
        # The pupil whose comments a board shows.
        self.comments_of: int | None = None

    @property
    def address(self) -> str:
        return self._socket.client.host if self._socket.client is not None else ""

    @property
    def is_idle(self) -> bool:
        """Whether all answers are on their way."""
        return self._queue.empty()

    def put(self, answer: msgspec.Struct) -> None:
        try:
            self._queue.put_nowait(encode(answer))
        except asyncio.QueueFull:
            self._overflowed.set()

    @property
    def is_unlocked(self) -> bool:
        """Whether the page has given the teacher's key."""
        return self._unlocked.is_set()

    def unlock(self, classroom: Classroom, key: str) -> bool:
        """Whether this is the teacher's key; if not, the page is refused."""
        admitted = classroom.authenticator.admits_teacher(key, self.address)
        if admitted:
            self._unlocked.set()
            self.on_unlocked()
            return True
        self.put(Refused("attempts" if admitted is None else "key"))
        return False

    async def complete(
        self,
        serve: Callable[[str | bytes], Coroutine[Any, Any, None]],
        watch: Callable[[ClassConnection], Coroutine[Any, Any, None]] | None = None,
    ) -> None:
        """Serve requests until the page disconnects or stops reading; ``watch`` begins with the teacher's key."""
        works = [] if watch is None else [self._watch(watch)]
        await first_completed(self._receive(serve), self._send(), self._overflowed.wait(), self.ended.wait(), *works)

    async def _watch(self, watch: Callable[[ClassConnection], Coroutine[Any, Any, None]]) -> None:
        try:
            async with asyncio.timeout(LOCKED_SECONDS):
                await self._unlocked.wait()
        except TimeoutError:
            return
        await watch(self)

    async def _receive(self, serve: Callable[[str | bytes], Coroutine[Any, Any, None]]) -> None:
        """Serve requests until the page disconnects; one that exceeds its rate is read more slowly."""
        now = asyncio.get_running_loop().time
        limit = TokenBucket(_RATE, _BURST, now())
        while True:
            message = await self._socket.receive()
            if message["type"] == "websocket.disconnect":
                return
            text = message.get("text") or message.get("bytes") or ""
            try:
                if text == PING:
                    self.put(Pong())
                else:
                    await self._turns.serve(serve(text), len(text))
            except BadRequest:
                self.put(Refused("request"))
            if wait := limit.overdraw(1 + len(text) / _CHARACTERS_PER_MESSAGE, now()):
                await asyncio.sleep(wait)

    async def _send(self) -> None:
        with contextlib.suppress(WebSocketDisconnect, RuntimeError):
            # The page may disconnect during a send; the receiver notices as well.
            while True:
                await self._socket.send_text(await self._queue.get())


@contextlib.asynccontextmanager
async def connected(socket: WebSocket, scheduler: LoopScheduler, slots: Slots) -> AsyncIterator[ClassConnection | None]:
    """Accept a socket, with a slot of its address; ``None`` when there is none left: the socket is closed then."""
    await socket.accept()
    connection = ClassConnection(socket, scheduler)
    if not slots.take(network_of(connection.address)):
        await socket.close(WS_1013_TRY_AGAIN_LATER)
        yield None
        return
    try:
        yield connection
    finally:
        slots.free(network_of(connection.address))


@contextlib.asynccontextmanager
async def locked(socket: WebSocket, scheduler: LoopScheduler, slots: Evictions) -> AsyncIterator[ClassConnection]:
    """Accept a socket that is told nothing before it has given the key; until then it has one of these slots."""
    await socket.accept()
    connection = ClassConnection(socket, scheduler)
    end = connection.ended.set
    slots.take(network_of(connection.address), end)
    connection.on_unlocked = lambda: slots.free(end)
    try:
        yield connection
    finally:
        slots.free(end)
        with contextlib.suppress(WebSocketDisconnect, RuntimeError):
            # The page may have closed it.
            await socket.close(WS_1008_POLICY_VIOLATION if not connection.is_unlocked else WS_1000_NORMAL_CLOSURE)
