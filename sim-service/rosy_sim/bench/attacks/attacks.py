"""
Attacks on the service, from one address or several: one at least on each resource that ``accounting/resources.py``
grants, and on the event loop. Each goes on until its process is killed.
"""

from __future__ import annotations

import asyncio
import contextlib
import itertools
from collections.abc import Awaitable, Callable
from dataclasses import dataclass
from typing import Any

from websockets.asyncio.client import connect
from websockets.exceptions import ConnectionClosed
from websockets.frames import Frame, Opcode

from .page_client import PageClient, opened

__all__ = ["ATTACKS", "Attack", "Target"]

_BOMB = """f0 x = (x, x)
f1 = f0 . f0
f2 = f1 . f1
f3 = f2 . f2
f4 = f3 . f3
f5 = f4 . f4
f6 = f5 . f5
f7 = f6 . f6
main = f7 ()
"""
"""Its type has 2^64 parts: nine lines that keep a compiler busy until a limit ends it."""

_PROGRAM = "main = simulate (Velocity 0.1 0)\n"

_SIDE = 42
"""Side of the rooms, m."""


_SPIN = "main = simulate (\\(Velocity v w) -> Velocity (sum [sin (v + k) | k <- [1 .. 20000]] / 1e9) w)\n"
"""Computes for milliseconds in each step."""

_ROOM_TEST = {"family": "obstacles", "rooms": 200, "seed": 1, "seconds": 120, "properties": "never-pushes"}


@dataclass(frozen=True, slots=True)
class Target:
    """The service at a port of this machine, and the code of its class."""

    port: int
    code: str


Begun = Callable[[], None]
"""Called by a client when its attack has begun."""

Client = Callable[[Target, str, Begun], Awaitable[None]]
"""Attacks from an address until it is let go."""


@dataclass(frozen=True, slots=True)
class Attack:
    """So many clients, shared out to the addresses that they come from."""

    title: str
    clients: int
    client: Client

    async def run(self, target: Target, addresses: int, most: int, on_begun: Begun) -> None:
        """
        Attack without end; ``on_begun`` is called when all clients have begun or were refused.

        Args:
            addresses: from which the clients come: 127.0.0.2 and the following ones. Honest pages have 127.0.0.1.
            most: clients.
        """
        clients = min(self.clients, most)
        waiting = set(range(clients))

        def begun(number: int) -> None:
            if waiting:
                waiting.discard(number)
                if not waiting:
                    on_begun()

        async def again_and_again(number: int) -> None:
            address = f"127.0.0.{2 + number % addresses}"
            while True:
                with contextlib.suppress(ConnectionClosed, OSError, TimeoutError, EOFError):
                    await self.client(target, address, lambda: begun(number))
                begun(number)
                await asyncio.sleep(1)

        await asyncio.gather(*map(again_and_again, range(clients)))


def _room(**things: Any) -> dict[str, Any]:
    return {"name": "attack", "size": [_SIDE, _SIDE], "start": {"x": 0.9, "y": 41, "theta": 0}, **things}


def _pile(count: int, *, movable: bool) -> dict[str, Any]:
    """A room in which all things overlap."""
    return _room(boxes=[{"x": 20 + 1e-4 * i, "y": 20, "w": 0.3, "h": 0.3, "movable": movable} for i in range(count)])


def _posts(count: int) -> dict[str, Any]:
    """A room of movable things that stand apart."""
    places = [(0.5 + 0.8 * (i % 50), 0.5 + 0.9 * (i // 50)) for i in range(count)]
    return _room(rounds=[{"x": x, "y": y, "r": 0.15, "movable": True} for x, y in places])


def _checkerboard(side: int) -> dict[str, Any]:
    """A room of so many tiles a side whose wall tiles have no neighbours, so each is a wall of its own."""
    rows = ["".join("#" if (x + y) % 2 and (x > 9 or y > 9) else "." for x in range(side)) for y in range(side)]
    return {"name": "attack", "tiles": rows, "start": {"x": 2.5, "y": side / 2 - 2.5, "theta": 0}}


def _page(attack: Callable[[PageClient], Awaitable[None]]) -> Client:
    """A client that is a page."""

    async def client(target: Target, address: str, begun: Begun) -> None:
        async with opened(target.port, address) as page:
            reading = asyncio.create_task(page.drain())
            begun()
            try:
                await attack(page)
                # An attack that has done all it can holds what it has.
                await reading
            finally:
                reading.cancel()

    return client


def _in_room(room: dict[str, Any]) -> Client:
    """Choose a heavy room and push a thing in it, again and again."""

    async def attack(page: PageClient) -> None:
        turn = 0
        while True:
            turn += 1
            await page.send("world", world=room)
            await page.send("input", move={"thing": 0, "x": 2 + turn % 2, "y": 2, "theta": 0})

    return _page(attack)


async def _bomb(page: PageClient) -> None:
    """Check and complete a compile bomb, another one every second: a newer question replaces the older one."""
    turn = 0
    while True:
        turn += 1
        source = f"{_BOMB}-- {turn}\n"
        await page.send("check", id=turn, source=source)
        await page.send("complete", id=turn, source=source, line=1, column=8)
        await asyncio.sleep(1)


async def _guess(page: PageClient) -> None:
    """Guess the code of the robots."""
    guess = 0
    while True:
        guess += 1
        await page.send("unlock", code=f"{guess:06}")
        # The other pages of this process begin, too.
        await asyncio.sleep(0)


async def _stay(_page: PageClient) -> None:
    """Take a place."""


async def _pause(page: PageClient) -> None:
    """Start a run and pause it."""
    await page.send("run", run=1, source=_PROGRAM, seed=1, speed=1)
    await page.send("pause")


async def _spin(page: PageClient) -> None:
    """Start a run that computes."""
    await page.send("run", run=1, source=_SPIN, seed=1, speed=1)


async def _compile(page: PageClient) -> None:
    """Start a run of a compile bomb, another one every second."""
    for turn in itertools.count(1):
        await page.send("run", run=turn, source=f"{_BOMB}-- {turn}\n", seed=1, speed=1)
        await asyncio.sleep(1)


async def _preview(page: PageClient) -> None:
    """Ask for the longest preview of a program that computes, again and again."""
    for turn in itertools.count(1):
        await page.send("preview", id=turn, source=f"{_SPIN}-- {turn}\n", seconds=300)
        await asyncio.sleep(2)


async def _test(target: Target, address: str, begun: Begun) -> None:
    """Test a program in as many rooms as a page may."""
    async with opened(target.port, address) as page:
        session = (await page.answer("hello", "refusal")).get("session", "")
        reading = asyncio.create_task(page.drain())
        try:
            async with opened(target.port, address, f"room-tests/{session}") as test:
                await test.send("test", source=_SPIN, **_ROOM_TEST)
                begun()
                await test.drain()
        finally:
            reading.cancel()


async def _join(target: Target, address: str, begun: Begun) -> None:
    """Join the class as a new pupil, again and again."""
    async with opened(target.port, address, "class") as page:
        for turn in itertools.count(1):
            name = f"{address} {id(page):x} {turn}"[-24:]
            await page.send("join", code=target.code, nickname=name, language="en")
            if (await page.answer("entered", "refused"))["op"] == "entered":
                await page.send("forget")
            begun()


async def _save(target: Target, address: str, begun: Begun) -> None:
    """Join and store the longest versions without a pause."""
    async with opened(target.port, address, "class") as page:
        await page.send("join", code=target.code, nickname=f"{address} {id(page):x}"[-24:], language="en")
        await page.answer("entered", "refused")
        begun()
        for turn in itertools.count(1):
            saved = {"program": f"p{turn % 7}", "name": "x", "text": f"{turn:06}" * 60_000, "reason": "change"}
            await page.send("save", **saved, base=0, mark=f"m{turn}")
            await page.answer("saved", "conflict", "save-failed", "refused")


async def _upload(target: Target, address: str, begun: Begun) -> None:
    """Send the largest file that is kept, and hold it."""
    async with opened(target.port, address) as page:
        session = (await page.answer("hello", "refusal")).get("session", "")
        reader, writer = await asyncio.open_connection("127.0.0.1", target.port, local_addr=(address, 0))
        try:
            path = f"/api/recordings/{session}?name=a"
            writer.write(f"POST {path} HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: 50000000\r\n\r\n".encode())
            begun()
            for _ in range(50):
                writer.write(b"x" * 1_000_000)
                await writer.drain()
            await reader.readline()
            await page.drain()
        finally:
            writer.close()


async def _half_open(target: Target, address: str, begun: Begun) -> None:
    """Open a connection whose request is never complete."""
    reader, writer = await asyncio.open_connection("127.0.0.1", target.port, local_addr=(address, 0))
    try:
        writer.write(b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nX-Long: ")
        begun()
        await reader.read()
    finally:
        writer.close()


async def _locked(target: Target, address: str, begun: Begun) -> None:
    """Open a board and try keys."""
    async with opened(target.port, address, "board") as board:
        begun()
        for turn in itertools.count(1):
            await board.send("unlock", key=f"key {turn}")
            await board.answer("refused")


async def _send_frames(target: Target, address: str, begun: Begun) -> None:
    """Send empty frames that are no messages, thousands in a packet."""
    url = f"ws://127.0.0.1:{target.port}/api/session"
    async with connect(url, local_addr=(address, 0), ping_interval=None) as socket:
        frames = Frame(Opcode.PING, b"").serialize(mask=True) * 40_000
        begun()
        while True:
            socket.transport.write(frames)
            # Waits until the transport has room.
            await socket.pong(b"")


async def _ask(target: Target, address: str, begun: Begun) -> None:
    """Ask for a page again and again, on a connection that stays."""
    reader, writer = await asyncio.open_connection("127.0.0.1", target.port, local_addr=(address, 0))
    try:
        begun()
        while True:
            writer.write(b"GET /api/examples HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n")
            head = await reader.readuntil(b"\r\n\r\n")
            length = next(line for line in head.lower().split(b"\r\n") if line.startswith(b"content-length:"))
            await reader.readexactly(int(length.split(b":")[1]))
    finally:
        writer.close()


ATTACKS = [
    Attack("places: 60 runs that compute", 60, _page(_spin)),
    Attack("places: 60 paused runs", 60, _page(_pause)),
    Attack("compiling: 20 runs of compile bombs", 20, _page(_compile)),
    Attack("checks: 20 pages of compile bombs", 20, _page(_bomb)),
    Attack("previews: 20 pages of long ones", 20, _page(_preview)),
    Attack("room tests: 20 of 200 rooms", 20, _test),
    Attack("rooms: 2,000 movable things, 50 pages", 50, _in_room(_pile(2000, movable=True))),
    Attack("rooms: 200 movable things, 50 pages", 50, _in_room(_posts(200))),
    Attack("rooms: 2,000 fixed things, 50 pages", 50, _in_room(_pile(2000, movable=False))),
    Attack("rooms: 20,000 walls, 50 pages", 50, _in_room(_checkerboard(200))),
    Attack("sockets: 500 pages", 500, _page(_stay)),
    Attack("sockets: 300 half-open requests", 300, _half_open),
    Attack("sockets: 100 boards with wrong keys", 100, _locked),
    Attack("sockets: empty frames, 20 pages", 20, _send_frames),
    Attack("sockets: 50 connections of requests", 50, _ask),
    Attack("codes: wrong ones for the robots, 20 pages", 20, _page(_guess)),
    Attack("uploads: 20 of 50 MB", 20, _upload),
    Attack("saves: 20 pupils store 360 kB each time", 20, _save),
    Attack("joins: 20 pages join without end", 20, _join),
]
"""The last ones leave pupils and versions in the class."""
