"""A watched run on a machine that stands still for a while: the time is not held against the program."""

from __future__ import annotations

import asyncio
import json
import socket
import time
from collections.abc import Callable

from rosy_sim.config import Limits
from rosy_sim.run.lateness import Lateness
from rosy_sim.run.realtime_runner import Ending, RealTimeRunner
from rosy_sim.run.step_phases import StepPhases
from rosy_sim.run.steps.lockstep import Lockstep

from ..conftest import hall


class Watched:
    """Remembers how the run went."""

    def __init__(self) -> None:
        self.steps = 0
        self.ended: asyncio.Future[Ending] = asyncio.get_running_loop().create_future()

    def on_step(self, lockstep: Lockstep) -> None:
        self.steps = lockstep.step

    def on_end(self, _lockstep: Lockstep, ending: Ending, _detail: str) -> None:
        self.ended.set_result(ending)


class Clock:
    """Runs on while the machine is asleep."""

    def __init__(self) -> None:
        self.asleep = 0.0
        self.on_look: Callable[[], object] = lambda: None

    def monotonic(self) -> float:
        self.on_look()
        return time.monotonic() + self.asleep


def test_a_machine_that_was_asleep_does_not_end_a_program_that_has_answered(limits: Limits, impatient: Limits) -> None:
    clock = Clock()

    async def looked_at(ended: asyncio.Future[Ending]) -> None:
        loop, looked = asyncio.get_running_loop(), asyncio.Event()
        clock.on_look = lambda: loop.call_soon_threadsafe(looked.set)
        ended.add_done_callback(lambda _: looked.set())
        await looked.wait()
        clock.on_look = lambda: None

    async def tell() -> None:
        loop, watched = asyncio.get_running_loop(), Watched()
        ours, theirs = socket.socketpair()
        with theirs:
            theirs.setblocking(False)
            RealTimeRunner(
                ours, Lockstep(hall(), 1), impatient, Lateness(), StepPhases(), watched, clock=clock.monotonic
            )
            unread = b""

            async def heard(op: str) -> None:
                nonlocal unread
                while f'"op":"{op}"'.encode() not in unread:
                    unread += await loop.sock_recv(theirs, 65536)
                unread = b""

            await heard("start")
            clock.asleep += 1000
            await looked_at(watched.ended)
            await loop.sock_sendall(theirs, b'{"op":"ready"}\n')
            for step in range(3):
                await heard("step")
                clock.asleep += 1000
                await looked_at(watched.ended)
                settled = {"op": "settled", "step": step, "fired": []}
                await loop.sock_sendall(theirs, json.dumps(settled).encode() + b"\n")
            # Awake, and without an answer: that is held against it.
            async with asyncio.timeout(limits.settle):
                assert await watched.ended == "stuck"
            assert watched.steps == 3

    asyncio.run(tell())
