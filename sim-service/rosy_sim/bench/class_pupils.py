"""
Pupils of a class whose programs all drive, and the teacher's board: clients of the protocol in a process of their own.
"""

from __future__ import annotations

import asyncio
import json
import re
from contextlib import AsyncExitStack
from dataclasses import dataclass, field
from multiprocessing.connection import Connection
from typing import Any

from websockets.asyncio.client import ClientConnection, connect

__all__ = ["PROGRAM", "Counted", "run_class"]

PROGRAM = """accelerate :: Velocity -> Velocity
accelerate (Velocity v w) = Velocity (v + 0.3) 0.4

main = simulate accelerate
"""

_STEP = re.compile(r'"step":(\d+)')


@dataclass(slots=True)
class Counted:
    """What the board was told, and the steps of all pupils together."""

    messages: int = 0
    received: int = 0
    steps: int = 0

    def since(self, before: Counted) -> Counted:
        """What was added."""
        return Counted(self.messages - before.messages, self.received - before.received, self.steps - before.steps)


@dataclass(slots=True)
class _Seen:
    board: Counted = field(default_factory=Counted)
    # The last step of each pupil.
    steps: list[int] = field(default_factory=list)

    def now(self) -> Counted:
        return Counted(self.board.messages, self.board.received, sum(self.steps))


def run_class(address: str, pupils: int, code: str, key: str, program: str, talk: Connection) -> None:
    """
    Pupils join the class at HOST:PORT and run the program; says ``driving``. Then ``board``, ``count`` and ``counted``
    are obeyed, which is answered by ``Counted`` since then, until ``stop``.
    """
    asyncio.run(_run(f"ws://{address}/api", pupils, code, key, program, talk))


async def _run(base: str, pupils: int, code: str, key: str, program: str, talk: Connection) -> None:
    async with AsyncExitStack() as stack:

        async def opened(path: str) -> ClientConnection:
            url = f"{base}/{path}"
            return await stack.enter_async_context(
                connect(url, open_timeout=None, ping_interval=None, compression=None, max_size=None)
            )

        tasks = []
        seen = _Seen(steps=[0] * pupils)
        for number in range(pupils):
            page, member = await opened("session"), await opened("class")
            session = (await _answer(page, "hello"))["session"]
            await _send(member, "join", code=code, nickname=f"pupil {number}", language="en")
            await _answer(member, "entered")
            await _send(member, "here", session=session)
            await _send(page, "run", run=1, source=program, seed=1, speed=1)
            await _answer(page, "frame")
            tasks += [asyncio.create_task(_watch(page, seen, number)), asyncio.create_task(_drain(member))]
        talk.send("driving")
        before = Counted()
        while (asked := await asyncio.to_thread(talk.recv)) != "stop":
            if asked == "board":
                board = await opened("board")
                await _send(board, "unlock", key=key)
                await _answer(board, "places")
                tasks.append(asyncio.create_task(_count(board, seen)))
                talk.send("open")
            elif asked == "count":
                before = seen.now()
            else:
                talk.send(seen.now().since(before))
        for task in tasks:
            task.cancel()
        await asyncio.gather(*tasks, return_exceptions=True)


async def _send(socket: ClientConnection, op: str, **fields: Any) -> None:
    await socket.send(json.dumps({"op": op, **fields}))


async def _answer(socket: ClientConnection, op: str) -> dict[str, Any]:
    """The next message of this kind."""
    while True:
        message: dict[str, Any] = json.loads(await socket.recv())
        if message["op"] == op:
            return message


async def _drain(socket: ClientConnection) -> None:
    async for _ in socket:
        continue


async def _watch(page: ClientConnection, seen: _Seen, number: int) -> None:
    """Reads on; keeps the step of the newest frame."""
    async for message in page:
        found = _STEP.search(str(message))
        if found is not None:
            seen.steps[number] = int(found[1])


async def _count(board: ClientConnection, seen: _Seen) -> None:
    async for message in board:
        seen.board.messages += 1
        seen.board.received += len(message)
