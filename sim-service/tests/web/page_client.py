"""Server and page of a test: a real server on a free port, and a page that remembers all it was told."""

from __future__ import annotations

import asyncio
import contextlib
import json
import socket
from collections.abc import AsyncIterator, Awaitable, Callable
from contextlib import asynccontextmanager
from typing import Any

import uvicorn
from websockets.asyncio.client import ClientConnection, connect
from websockets.exceptions import ConnectionClosed

from rosy_sim.classroom.store.class_store import ClassStore
from rosy_sim.config import Config
from rosy_sim.web.app import build_app
from rosy_sim.web.pacing.paced_frames import paced_frames
from rosy_sim.web.service import Service

from ..conftest import PATIENCE, UNHURRIED

__all__ = ["Message", "Page", "opened", "serving", "story"]

Message = dict[str, Any]


class Page:
    """A page that remembers all it was told."""

    def __init__(self, socket: ClientConnection) -> None:
        self.run = -1
        self.channels: Message = {}
        self.socket = socket
        self.seen: list[Message] = []
        # The number of the latest answer to a heartbeat.
        self.answered = 0
        # What was received while nobody waited for it; None while it is read on demand.
        self._received: asyncio.Queue[str | bytes | Exception] | None = None
        self._turn = asyncio.Lock()
        self._looking = 0

    async def send(self, op: str, **fields: Any) -> None:
        await self.socket.send(json.dumps({"op": op, **fields}))

    async def look(self) -> None:
        """Say that a person looks at the robot, ten times a second, and read as a page does, all the time."""
        received = self._received = self._received or asyncio.Queue()
        self._looking += 1

        async def read() -> None:
            try:
                while True:
                    async with self._turn:
                        text = await self.socket.recv()
                    message = json.loads(text)
                    if message["op"] == "seen":
                        self.answered = message["number"]
                    received.put_nowait(text)
            except (ConnectionClosed, OSError) as ended:
                received.put_nowait(ended)

        reading = asyncio.create_task(read())
        try:
            while True:
                await self.send("alive", seen=self.answered)
                await asyncio.sleep(0.1)
        finally:
            self._looking -= 1
            reading.cancel()
            with contextlib.suppress(asyncio.CancelledError):
                await reading

    async def _receive(self) -> str | bytes:
        if self._received is not None and not (self._received.empty() and self._looking == 0):
            text = await self._received.get()
            if isinstance(text, Exception):
                raise text
            return text
        async with self._turn:
            return await self.socket.recv()

    async def until(self, wanted: Callable[[Message], bool], within: float = PATIENCE) -> Message:
        """The next message that fits, waited for at most ``within`` s; a failure names the latest ones that did not."""
        try:
            async with asyncio.timeout(within):
                return await self._next(wanted)
        except TimeoutError:
            latest = [message for message in self.seen if message["op"] != "frame"][-5:] + self.seen[-1:]
            raise TimeoutError(f"no message fits within {within:g} s; the latest: {latest}") from None

    async def _next(self, wanted: Callable[[Message], bool]) -> Message:
        while True:
            message: Message = json.loads(await self._receive())
            if message["op"] == "frame":
                # What has not changed is not told again.
                if message["run"] != self.run:
                    self.run, self.channels = message["run"], {}
                self.channels = {**self.channels, **message["channels"]}
                message = {**message, "channels": self.channels}
            self.seen.append(message)
            if wanted(message):
                return message

    async def op(self, op: str, **fields: Any) -> Message:
        return await self.until(_like({"op": op, **fields}))

    async def all_of(self, *wanted: Message) -> list[Message]:
        """The next message that matches each of ``wanted``; they may arrive in any order, within `PATIENCE` in all."""
        found: list[Message | None] = [None] * len(wanted)

        def is_last(message: Message) -> bool:
            fits = [_like(one)(message) and found[i] is None for i, one in enumerate(wanted)]
            if True in fits:
                found[fits.index(True)] = message
            return None not in found

        await self.until(is_last)
        return [message for message in found if message is not None]

    async def ended(self, run: int) -> Message:
        return await self.op("state", run=run, state="ended")


def _like(wanted: Message) -> Callable[[Message], bool]:
    """Whether a message has these fields."""
    return lambda message: all(message.get(key) == value for key, value in wanted.items())


class _Server(uvicorn.Server):
    """Sets an event when it listens."""

    def __init__(self, config: uvicorn.Config) -> None:
        super().__init__(config)
        self.listening = asyncio.Event()

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        await super().startup(sockets)
        self.listening.set()


@asynccontextmanager
async def serving(config: Config, class_store: ClassStore | None = None) -> AsyncIterator[tuple[str, Service]]:
    """A server on a free port of this machine."""
    app = build_app(config, class_store)
    server = _Server(uvicorn.Config(app, port=0, log_level="error", ws=paced_frames(), timeout_graceful_shutdown=1))
    task = asyncio.create_task(server.serve())
    async with asyncio.timeout(PATIENCE):
        await server.listening.wait()
    port = server.servers[0].sockets[0].getsockname()[1]
    try:
        yield f"127.0.0.1:{port}", app.state.service
    finally:
        server.should_exit = True
        _, unfinished = await asyncio.wait([task], timeout=PATIENCE)
        if unfinished:
            for running in asyncio.all_tasks():
                running.print_stack()
            raise TimeoutError(f"the server has not ended within {PATIENCE:g} s; its tasks stand above")
        await task


@asynccontextmanager
async def opened(address: str, **options: Any) -> AsyncIterator[Page]:
    # A page that has stopped reading cannot say goodbye; the wait for it is short.
    socket = await connect(f"ws://{address}/api/session", **{**UNHURRIED, "close_timeout": 1, **options})
    try:
        yield Page(socket)
    finally:
        try:
            await socket.close()
        finally:
            # A cancellation during the goodbye would leave the connection open.
            socket.transport.abort()


def story(play: Callable[[Page, Service], Awaitable[None]], config: Config) -> None:
    """Tell a story of one page."""

    async def tell() -> None:
        async with serving(config) as (address, service), opened(address) as page:
            await play(page, service)

    asyncio.run(tell())
