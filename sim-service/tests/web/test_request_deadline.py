"""Requests that are never complete: their connections end, the others stay."""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import AsyncIterator, Awaitable, Callable

import pytest
import uvicorn
from starlette.applications import Starlette
from starlette.responses import PlainTextResponse
from starlette.routing import Route, WebSocketRoute
from starlette.websockets import WebSocket
from websockets.asyncio.client import connect

from rosy_sim.web.pacing.request_deadline import RequestDeadline

from ..conftest import PATIENCE, UNHURRIED

Asking = tuple[asyncio.StreamReader, asyncio.StreamWriter]


@contextlib.asynccontextmanager
async def serving() -> AsyncIterator[int]:
    """An application with one page and one WebSocket that answers; yields its port."""

    async def echo(socket: WebSocket) -> None:
        await socket.accept()
        async for text in socket.iter_text():
            await socket.send_text(text)

    async def page(_request: object) -> PlainTextResponse:
        return PlainTextResponse("here")

    app = Starlette(routes=[Route("/", page), WebSocketRoute("/echo", echo)])
    settings = uvicorn.Config(app, port=0, log_level="error", ws="websockets-sansio", http=RequestDeadline)
    server = uvicorn.Server(settings)
    settings.load()
    server.lifespan = settings.lifespan_class(settings)
    await server.startup()
    try:
        yield server.servers[0].sockets[0].getsockname()[1]
    finally:
        await server.shutdown()


def story(play: Callable[[int], Awaitable[None]]) -> None:
    async def tell() -> None:
        async with asyncio.timeout(PATIENCE), serving() as port:
            await play(port)

    asyncio.run(tell())


async def asked(port: int, text: bytes) -> Asking:
    reader, writer = await asyncio.open_connection("127.0.0.1", port)
    writer.write(text)
    return reader, writer


async def ends(connection: Asking) -> None:
    """Wait until the service has closed a connection."""
    reader, writer = connection
    with contextlib.suppress(ConnectionError):
        assert await reader.read() == b""
    writer.close()


REQUEST = b"GET / HTTP/1.1\r\nHost: x\r\n"


@pytest.fixture(autouse=True)
def brief(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(RequestDeadline, "seconds", 0.2)


@pytest.mark.parametrize("sent", [b"", b"GET", REQUEST])
def test_a_connection_without_a_whole_request_ends(sent: bytes) -> None:
    async def play(port: int) -> None:
        await ends(await asked(port, sent))

    story(play)


def test_a_request_that_comes_byte_by_byte_is_not_waited_for() -> None:
    async def play(port: int) -> None:
        reader, writer = await asked(port, REQUEST + b"X-Long: ")

        async def drip() -> None:
            with contextlib.suppress(ConnectionError):
                while True:
                    writer.write(b"x")
                    await writer.drain()
                    await asyncio.sleep(0)

        dripping = asyncio.create_task(drip())
        await ends((reader, writer))
        await dripping

    story(play)


def test_answered_requests_and_open_sockets_are_not_concerned() -> None:
    async def play(port: int) -> None:
        async with connect(f"ws://127.0.0.1:{port}/echo", **UNHURRIED) as socket:
            # Its time is over when that of a later connection is.
            await ends(await asked(port, b"GET"))
            await socket.send("still there")
            assert await socket.recv() == "still there"
        reader, writer = await asked(port, REQUEST + b"\r\n")
        assert b"200" in await reader.readline()
        writer.close()

    story(play)


def test_a_client_that_sends_requests_without_waiting_for_answers_is_not_served() -> None:
    async def play(port: int) -> None:
        reader, writer = await asked(port, (REQUEST + b"\r\n") * 10_000)
        with contextlib.suppress(ConnectionError):
            answers = await reader.read()
            assert answers.count(b"HTTP/1.1 200") < 500
        writer.close()
        # Some are.
        reader, writer = await asked(port, (REQUEST + b"\r\n") * 8)
        for _ in range(8):
            assert (await reader.readuntil(b"here")).count(b"HTTP/1.1 200") == 1
        writer.close()

    story(play)
