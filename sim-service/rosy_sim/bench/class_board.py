"""
Cost of the teacher's board: a class of pupils whose programs all drive, without a board and with one.

The service runs here with the worker; pupils and the board are protocol clients in another process, so that their work
does not count as ours.
"""

from __future__ import annotations

import asyncio
import json
import multiprocessing
import tempfile
import time
from contextlib import AsyncExitStack
from dataclasses import replace
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

import psutil
import uvloop
from websockets.asyncio.client import ClientConnection, connect

from ..classroom.class_folder import open_class
from ..classroom.class_store import ClassStore
from ..config import Config
from ..web.app import Service
from .serving import serving

__all__ = ["PROGRAM", "report"]

PROGRAM = """accelerate :: Velocity -> Velocity
accelerate (Velocity v w) = Velocity (v + 0.3) 0.4

main = simulate accelerate
"""


def report(config: Config, pupils: int, seconds: float, program: str = PROGRAM) -> float:
    """Print a row without a board and one with it; returns how late steps began with it, s (p99)."""
    limits = replace(config.limits, runs=pupils, sessions=max(pupils, config.limits.sessions), address_sessions=pupils)
    with (
        tempfile.TemporaryDirectory() as folder,
        open_class(Path(folder), "bench") as store,
        asyncio.Runner(loop_factory=uvloop.new_event_loop) as runner,
    ):
        return runner.run(_measure(config.with_limits(limits), store, pupils, seconds, program))


async def _measure(config: Config, store: ClassStore, pupils: int, seconds: float, program: str) -> float:
    ours, theirs = multiprocessing.Pipe()
    admission = store.admission()
    async with serving(config, store) as (service, port):
        clients = multiprocessing.get_context("spawn").Process(
            target=_run_clients,
            args=(port, pupils, admission.code, admission.teacher_key, program, theirs),
            daemon=True,
        )
        clients.start()
        # Its end is noticed.
        theirs.close()
        try:
            # Until all drive.
            await asyncio.to_thread(ours.recv)
            late = 0.0
            for board in (False, True):
                if board:
                    ours.send("board")
                    await asyncio.to_thread(ours.recv)
                late = await _print_row(service, ours, pupils, seconds, board=board)
            ours.send("stop")
        finally:
            clients.join(5)
            clients.kill()
    return late


async def _print_row(service: Service, clients: Connection, pupils: int, seconds: float, *, board: bool) -> float:
    process = psutil.Process()
    service.lateness.clear()
    clients.send("count")
    before, began = process.cpu_times(), time.perf_counter()
    await asyncio.sleep(seconds)
    after, took = process.cpu_times(), time.perf_counter() - began
    clients.send("counted")
    messages, received = await asyncio.to_thread(clients.recv)
    cost = after.user + after.system - before.user - before.system
    late = service.lateness.summary()
    to_board = f"; to the board {messages / took:.0f} messages and {received / took / 1e3:.1f} kB a second"
    print(
        f"  {pupils:>3} pupils, {'one board' if board else 'no board '}: service {cost / took * 100:.0f} % of a core; "
        f"a step begins late by {late['p50'] * 1e3:.1f} ms (median), {late['p99'] * 1e3:.1f} (p99)"
        f"{to_board if board else ''}",
        flush=True,
    )
    return float(late["p99"])


def _run_clients(port: int, pupils: int, code: str, key: str, program: str, talk: Connection) -> None:
    asyncio.run(_clients(f"ws://127.0.0.1:{port}/api", pupils, code, key, program, talk))


async def _clients(base: str, pupils: int, code: str, key: str, program: str, talk: Connection) -> None:
    """Joins pupils who run the program; then obeys ``board``, ``count`` and ``counted``, until ``stop``."""
    async with AsyncExitStack() as stack:

        async def opened(path: str) -> ClientConnection:
            url = f"{base}/{path}"
            return await stack.enter_async_context(
                connect(url, open_timeout=None, ping_interval=None, compression=None, max_size=None)
            )

        tasks = []
        for number in range(pupils):
            page, member = await opened("session"), await opened("class")
            session = (await _answer(page, "hello"))["session"]
            await _send(member, "join", code=code, nickname=f"pupil {number}", language="en")
            await _answer(member, "entered")
            await _send(member, "here", session=session)
            await _send(page, "run", run=1, source=program, seed=1, speed=1)
            await _answer(page, "frame")
            tasks += [asyncio.create_task(_drain(page)), asyncio.create_task(_drain(member))]
        talk.send("driving")
        seen = [0, 0]
        counted = (0, 0)
        while (asked := await asyncio.to_thread(talk.recv)) != "stop":
            if asked == "board":
                board = await opened("board")
                await _send(board, "unlock", key=key)
                await _answer(board, "places")
                tasks.append(asyncio.create_task(_drain(board, seen)))
                talk.send("open")
            elif asked == "count":
                counted = (seen[0], seen[1])
            else:
                talk.send((seen[0] - counted[0], seen[1] - counted[1]))
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


async def _drain(socket: ClientConnection, seen: list[int] | None = None) -> None:
    """Reads on; counts messages and bytes."""
    async for message in socket:
        if seen is not None:
            seen[0] += 1
            seen[1] += len(message)
