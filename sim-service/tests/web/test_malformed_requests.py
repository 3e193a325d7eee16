"""
Malformed headers, paths, bodies and messages at every route of the application: each is answered or refused, none ends
with status 500 or a traceback, and the service answers afterwards.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
import random
from collections.abc import AsyncIterator, Iterator, Sequence

import pytest
import uvicorn
from starlette.applications import Starlette
from starlette.routing import BaseRoute, Mount, Route, WebSocketRoute
from websockets.asyncio.client import connect
from websockets.exceptions import ConnectionClosed, InvalidHandshake

from rosy_sim.classroom.store.class_folder import open_class
from rosy_sim.cluster.class_routes import class_routes
from rosy_sim.config import Config
from rosy_sim.web.app import build_app
from rosy_sim.web.server import _settings

from ..conftest import PATIENCE, UNHURRIED
from ..extent import NIGHTLY, SEED

_LONG = "x" * 20_000

_SEGMENTS = [
    "x",
    "%",
    "%zz",
    "%00",
    "a%00b",
    "%ff%fe",
    "%c3%28",
    "%2e%2e",
    "%2e%2e%2f%2e%2e%2fetc%2fpasswd",
    "..",
    "....//",
    "%5c..%5c",
    "%0d%0aX-Evil:%201",
    "%u0041",
    "\xff\xfe",
    "-1",
    "0",
    "9" * 30,
    "9" * 5_000,
    "1e9",
    "NaN",
    "con",
    "x" * 300,
    _LONG,
    "%e2%80%ae",
    "?",
    "?%ff=%00&=&embed=%ff",
    "#",
]
"""In place of a parameter of a path, or after the path."""

_HEADERS = [
    *(f"Origin: {value}" for value in ("http://[", "null", "\xff", "://", "http://[::1", f"http://{_LONG}", "a b")),
    *(f"Cookie: {value}" for value in ("=;=", "\xff=\xff", "a" * 5_000, ";;;;", '"')),
    *(f"Range: {value}" for value in ("x", "bytes=-", "bytes=9-1", "bytes=" + "0-1," * 500, "bytes=99999999999999-")),
    *(f"X-Rosy-Key: {value}" for value in ("", "\xff", "k" * 5_000, "\u00b2")),
    *(f"X-Forwarded-For: {value}" for value in (",,[", "\xff", "1.2.3.4" * 500)),
    *(f"Accept-Encoding: {value}" for value in ("gzip;q=x", ";;,,", "gzip;" * 500)),
    *(f"If-Modified-Since: {value}" for value in ("x", "Thu, 99 Jan 99999 99:99:99 GMT", "\xff")),
    *(f"If-None-Match: {value}" for value in ('"', "\xff", "*")),
    *(f"Upgrade: {value}" for value in ("x", "websocket, x", "\xff", "h2c")),
    *(f"Content-Type: {value}" for value in ("x", "multipart/form-data", "application/json; charset=\xff")),
    "Sec-WebSocket-Extensions: permessage-deflate; client_max_window_bits=99",
    "Sec-WebSocket-Protocol: \xff,,",
    "Expect: 100-continue",
    "Connection: \xff",
    "Transfer-Encoding: x",
    "Authorization: \xff",
    "No-Colon",
    ": no name",
    "\xff: x",
]

_HOSTS = ["Host: [", "Host: \xff", "Host: a b", "Host:", f"Host: {_LONG}", "Host: 127.0.0.1:x", "Host: ]:80", ""]

_LENGTHS = ["Content-Length: x", "Content-Length: -1", "Content-Length: 99999999999999999999", "Content-Length: 1, 2"]

_BODIES = [
    b"",
    b"\xff{[",
    b"null",
    b"[]",
    b"NaN",
    b'{"op": NaN}',
    b'{"op": 1}',
    b'{"op": "run", "run": "x", "source": {}, "seed": 1e400, "speed": []}',
    b'{"op": "check", "id": 99999999999999999999999999, "source": null}',
    b'{"op": "input", "move": {"thing": -1, "x": 1e999, "y": "", "theta": null}}',
    b'{"op": "world", "world": {"size": [1e308, -0.0], "start": 3}}',
    b'{"op": "unlock", "key": "\xed\xa0\x80", "code": 5}',
    b'{"op": "\\ud800"}',
    b'{"op": "x", "op": "y"}',
    b"[" * 100_000,
    b'{"a":' * 50_000,
    b"1" * 200_000,
    b"x" * 1_100_000,
    b"\x00" * 1_000,
]
"""Of requests, and messages on sockets."""

_UPGRADE = (
    "Connection: Upgrade\r\nUpgrade: websocket\r\n"
    "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA=="
)

_MUTATIONS = 300 if NIGHTLY else 10
"""Random requests at each route."""


@contextlib.asynccontextmanager
async def _serving(config: Config) -> AsyncIterator[tuple[Starlette, int, str]]:
    """A class with the settings of ``./rosy start``; the application, its port and the teacher's key."""
    for folder in (config.page, config.api_docs, config.examples / "lessons"):
        folder.mkdir(parents=True)
    (config.page / "index.html").write_text("page")
    (config.page / "index.html.gz").write_bytes(b"packed")
    with open_class(config.classes, "7b") as store:
        # Those of the page of a cluster, too.
        more = class_routes(_place, _services)
        app = build_app(config, store, names=["localhost"], more=more)
        settings = _settings(app, config)
        settings.port = 0
        settings.timeout_graceful_shutdown = 0
        settings.load()
        server = uvicorn.Server(settings)
        server.lifespan = settings.lifespan_class(settings)
        await server.startup()
        try:
            port = server.servers[0].sockets[0].getsockname()[1]
            yield app, port, store.admission().teacher_key
        finally:
            await server.shutdown()


async def _place(name: str) -> str | None:
    return "127.0.0.1:1" if name == "7b" else None


async def _services() -> dict[str, str]:
    return {"7b": "127.0.0.1:1"}


def _paths(route: BaseRoute) -> Iterator[str]:
    """The route's path with each of the segments in place of its parameter, or behind it."""
    assert isinstance(route, Route | WebSocketRoute | Mount), route
    head, parameter, rest = route.path.partition("{")
    if parameter and not isinstance(route, Mount):
        tail = rest.partition("}")[2]
        for segment in _SEGMENTS:
            yield f"{head}{segment}{tail}"
    else:
        yield route.path or "/"
        for segment in _SEGMENTS:
            yield f"{route.path}{'' if segment[:1] in '?#' else '/'}{segment}"


def _requests(route: BaseRoute, key: str) -> Iterator[bytes]:
    """Malformed requests, also to open a socket."""
    chance = random.Random(f"{SEED} {route}")
    paths = list(_paths(route))
    host, close, admitted = "Host: 127.0.0.1", "Connection: close", f"X-Rosy-Key: {key}"
    kind = _UPGRADE if isinstance(route, WebSocketRoute) else close
    method = "POST" if isinstance(route, Route) and "POST" in (route.methods or ()) else "GET"
    for path in paths:
        yield _request(f"{method} {path} HTTP/1.1", [host, kind, admitted])
    for header in (*_HEADERS, *_HOSTS, *_LENGTHS):
        own = () if header in _HOSTS else (host,)
        yield _request(f"{method} {paths[0]} HTTP/1.1", [*own, kind, admitted, header])
    for body in _BODIES:
        yield _request(f"POST {paths[0]} HTTP/1.1", [host, close, admitted, f"Content-Length: {len(body)}"], body)
    for _ in range(_MUTATIONS):
        lines = [host, chance.choice([close, _UPGRADE]), *chance.sample(_HEADERS, 3)]
        method = chance.choice(["GET", "HEAD", "POST", "PUT", "OPTIONS", "PATCH", "TRACE", "X" * 50, ""])
        request = bytearray(_request(f"{method} {chance.choice(paths)[:500]} HTTP/1.1", lines))
        for _ in range(chance.randrange(4)):
            request[chance.randrange(len(request) - 4)] = chance.randrange(256)
        yield bytes(request)


def _request(first: str, headers: Sequence[str], body: bytes = b"") -> bytes:
    return "\r\n".join([first, *filter(None, headers)]).encode("latin-1") + b"\r\n\r\n" + body


async def _status(port: int, request: bytes, is_whole: bool = False) -> bytes:
    """The first line of the answer; nothing when the connection was closed or the request is not complete."""
    reader, writer = await asyncio.open_connection("127.0.0.1", port)
    try:
        with contextlib.suppress(ConnectionError):
            writer.write(request)
            await writer.drain()
            # Answers, or ends, what a broken head has left incomplete; the server may then close without an answer.
            if not is_whole:
                writer.write_eof()
            async with asyncio.timeout(PATIENCE):
                return await reader.readline()
        return b""
    finally:
        writer.close()


async def _talk(port: int, path: str, first: str | None, message: bytes, is_text: bool) -> None:
    """Send a message on a socket, after one that opens the class, and read until it ends or another is answered."""
    with contextlib.suppress(ConnectionClosed, InvalidHandshake, ConnectionError):
        async with connect(f"ws://127.0.0.1:{port}{path}", max_size=None, **UNHURRIED) as socket:
            if first is not None:
                await socket.send(first)
            await socket.send(message, text=is_text)
            await asyncio.wait_for(await socket.ping(), PATIENCE)
            socket.transport.abort()


def test_every_route_answers_malformed_requests_and_messages(config: Config, capfd: pytest.CaptureFixture[str]) -> None:
    async def tell() -> None:
        async with _serving(config) as (app, port, key):
            health = _request("GET /api/health HTTP/1.1", ["Host: 127.0.0.1", "Connection: close"])
            for route in app.routes:
                for request in _requests(route, key):
                    answer = await _status(port, request)
                    assert not answer.startswith(b"HTTP/1.1 500"), request[:300]
                assert "Traceback" not in capfd.readouterr().err, route
                assert (await _status(port, health, is_whole=True)).startswith(b"HTTP/1.1 200"), route
            async with connect(f"ws://127.0.0.1:{port}/api/session", **UNHURRIED) as page:
                hello = json.loads(await page.recv())
                opening = {
                    "/api/board": json.dumps({"op": "unlock", "key": key}),
                    "/api/projector": json.dumps({"op": "unlock", "key": key}),
                }
                for route in app.routes:
                    if isinstance(route, WebSocketRoute):
                        path = route.path.replace("{session}", hello["session"])
                        for body in _BODIES:
                            for is_text in (True, False):
                                await _talk(port, path, opening.get(path), body, is_text)
                                said = capfd.readouterr().err
                                assert "Traceback" not in said, (path, body[:100], is_text, said)
                assert (await _status(port, health, is_whole=True)).startswith(b"HTTP/1.1 200")

    asyncio.run(tell())
    assert "Traceback" not in capfd.readouterr().err
