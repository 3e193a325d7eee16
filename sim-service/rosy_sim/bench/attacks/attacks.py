"""
Attacks of one client on the service: heavy rooms, compile bombs, guessed codes, taken places, paused runs, half-open
requests, floods of frames and of requests. Each goes on until its process is killed.
"""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import Awaitable, Callable
from dataclasses import dataclass
from typing import Any

from websockets.asyncio.client import connect
from websockets.exceptions import ConnectionClosed
from websockets.frames import Frame, Opcode

from .page_client import PageClient, opened

__all__ = ["ATTACKER", "ATTACKS", "Attack"]

ATTACKER = "127.0.0.2"
"""Address of the client; that of the other pages is 127.0.0.1."""

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


Begun = Callable[[], None]
"""Called by a client when its attack has begun."""


@dataclass(frozen=True, slots=True)
class Attack:
    """So many clients of one address, each of which attacks the service at a port until it is let go."""

    title: str
    clients: int
    client: Callable[[int, Begun], Awaitable[None]]

    async def run(self, port: int, on_begun: Begun) -> None:
        """Attack without end; ``on_begun`` is called when all clients have begun or were refused."""
        waiting = set(range(self.clients))

        def begun(number: int) -> None:
            if waiting:
                waiting.discard(number)
                if not waiting:
                    on_begun()

        async def again_and_again(number: int) -> None:
            while True:
                with contextlib.suppress(ConnectionClosed, OSError, TimeoutError):
                    await self.client(port, lambda: begun(number))
                begun(number)
                await asyncio.sleep(1)

        await asyncio.gather(*map(again_and_again, range(self.clients)))


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


def _page(attack: Callable[[PageClient], Awaitable[None]]) -> Callable[[int, Begun], Awaitable[None]]:
    """A client that is a page."""

    async def client(port: int, begun: Begun) -> None:
        async with opened(port, ATTACKER) as page:
            reading = asyncio.create_task(page.drain())
            begun()
            try:
                await attack(page)
                # An attack that has done all it can holds what it has.
                await reading
            finally:
                reading.cancel()

    return client


def _in_room(room: dict[str, Any]) -> Callable[[int, Begun], Awaitable[None]]:
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


async def _stay(_page: PageClient) -> None:
    """Take a place."""


async def _pause(page: PageClient) -> None:
    """Start a run and pause it."""
    await page.send("run", run=1, source=_PROGRAM, seed=1, speed=1)
    await page.send("pause")


async def _half_open(port: int, begun: Begun) -> None:
    """Open a connection whose request is never complete."""
    reader, writer = await asyncio.open_connection("127.0.0.1", port, local_addr=(ATTACKER, 0))
    try:
        writer.write(b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nX-Long: ")
        begun()
        await reader.read()
    finally:
        writer.close()


async def _send_frames(port: int, begun: Begun) -> None:
    """Send empty frames that are no messages, thousands in a packet."""
    async with connect(f"ws://127.0.0.1:{port}/api/session", local_addr=(ATTACKER, 0), ping_interval=None) as socket:
        frames = Frame(Opcode.PING, b"").serialize(mask=True) * 40_000
        begun()
        while True:
            socket.transport.write(frames)
            # Waits until the transport has room.
            await socket.pong(b"")


async def _ask(port: int, begun: Begun) -> None:
    """Ask for a page again and again, on a connection that stays."""
    reader, writer = await asyncio.open_connection("127.0.0.1", port, local_addr=(ATTACKER, 0))
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
    Attack("a room of 2,000 movable things on each other", 1, _in_room(_pile(2000, movable=True))),
    Attack("fifty of them", 50, _in_room(_pile(2000, movable=True))),
    Attack("200 movable things, fifty pages", 50, _in_room(_posts(200))),
    Attack("2,000 fixed things on each other, fifty pages", 50, _in_room(_pile(2000, movable=False))),
    Attack("20,000 walls, fifty pages", 50, _in_room(_checkerboard(200))),
    Attack("compile bombs, checked and completed", 1, _page(_bomb)),
    Attack("wrong codes for the robots", 1, _page(_guess)),
    Attack("400 pages from one address", 400, _page(_stay)),
    Attack("20 paused runs, of 20 at once", 20, _page(_pause)),
    Attack("300 half-open requests", 300, _half_open),
    Attack("empty frames, 20 pages", 20, _send_frames),
    Attack("requests over HTTP, 50 connections", 50, _ask),
]
