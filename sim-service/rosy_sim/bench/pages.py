"""
Many pages at once, each with a program at real time: how late their steps begin, and what they cost.

The service runs here with the real worker; the pages are bare sockets in another process, so that their work does
not count as ours.

A page is in time when 99 % of its steps begin less than 20 ms late. Two cores, in time: 200 pages with tasks (11 to 17
ms late, 12 to 15 frames a second; the goal), 150 with the default rate (15 to 23 ms), 60 at 50 Hz (8 to 11 ms). A step
at 50 Hz costs the service some 230 µs there and the program 140; on a faster machine 55 and 62 (150 pages: nine tenths
of a core for the service, as much for the programs). A hundred programs for 75 s took 7.4 MB each.
"""

from __future__ import annotations

import asyncio
import base64
import contextlib
import cProfile
import json
import multiprocessing
import os
import pstats
import selectors
import socket
import statistics
import time
from collections.abc import AsyncIterator, Mapping
from dataclasses import dataclass, replace
from multiprocessing.connection import Connection
from typing import Any

import psutil
import uvicorn
import uvloop

from ..config import Config
from ..garbage_collection import keep_what_is_loaded
from ..web.app import build_app
from ..web.pacing.paced_frames import paced_frames
from ..web.service import Service
from ..world.time_step import STEP
from .processor_time import exact_time
from .programs import SPEED_UP

__all__ = ["IN_TIME", "Cost", "Drivers", "Turn", "drive", "report", "take_turns"]

IN_TIME = STEP
"""A step that begins later than the next one was due is late, s."""

_CATCHING_UP = 3.0
"""From the moment in which the last page drives to the measurement, s. While the programs of all pages are compiled the
first ones fall behind, and then they catch up."""

_SHOWN = 12
"""Lines of a profile."""


@dataclass(frozen=True, slots=True)
class Drivers:
    """Pages that run the same program at real time, for so many seconds; ``requests`` are sent before."""

    count: int
    seconds: float
    program: str = SPEED_UP
    requests: tuple[Mapping[str, Any], ...] = ()


@dataclass(frozen=True, slots=True)
class Cost:
    """What pages cost. Times are in s; ``service`` and ``programs`` are processor time."""

    lateness: Mapping[str, float]
    took: float
    service: float
    programs: float
    # Received by all pages.
    frames: int
    received: int
    # Bytes of each program.
    memory: list[int]
    queued: int

    @property
    def steps(self) -> float:
        """Steps of all pages."""
        return self.lateness["steps"]


def report(config: Config, count: int, runs: int, seconds: float, profile: bool, program: str = SPEED_UP) -> float:
    """
    Print a row: so many pages with a program, of which so many may drive at once. With ``profile`` also where the
    service's time went. Answers how late steps began, s (p99).
    """
    limits = replace(config.limits, runs=runs, sessions=max(count, config.limits.sessions))
    profiler = cProfile.Profile(time.process_time) if profile else None
    cost = drive(config.with_limits(limits), Drivers(count, seconds, program), profiler)
    if profiler is not None:
        pstats.Stats(profiler).sort_stats("tottime").print_stats(_SHOWN)
    late, took, steps = cost.lateness, cost.took, cost.steps
    print(
        f"  {count:>3} pages: {steps / took / min(count, runs):5.1f} steps/s each; "
        f"a step begins late by {late['p50'] * 1e3:.1f} ms (median), "
        f"{late['p99'] * 1e3:.1f} (p99), {late['worst'] * 1e3:.1f} (worst); "
        f"{cost.frames / took / count:.0f} frames/s and {cost.received / took / count / 1e3:.1f} kB/s to each; "
        f"service {cost.service / took * 100:.0f} % of a core, programs {cost.programs / took * 100:.0f} %: "
        f"{cost.service / steps * 1e6:.0f} and {cost.programs / steps * 1e6:.0f} µs a step; "
        f"{statistics.median(cost.memory) / 1e6:.1f} MB of memory to each program "
        f"(proportional; {len(cost.memory)} alive); "
        f"{cost.queued} waited for a place, none was refused",
        flush=True,
    )
    return late["p99"]


def drive(config: Config, drivers: Drivers, profiler: cProfile.Profile | None = None) -> Cost:
    """Let pages run a program on a service of their own, and measure."""
    with asyncio.Runner(loop_factory=uvloop.new_event_loop) as runner:
        return runner.run(_measure(config, drivers, profiler))


async def _measure(config: Config, drivers: Drivers, profiler: cProfile.Profile | None) -> Cost:
    async with _driving(config, drivers) as driving:
        await asyncio.sleep(min(_CATCHING_UP, drivers.seconds))
        await driving.received()
        driving.service.lateness.clear()
        before, theirs_before = driving.processor_time()
        began = time.perf_counter()
        if profiler is not None:
            profiler.enable()
        await asyncio.sleep(drivers.seconds)
        if profiler is not None:
            profiler.disable()
        took = time.perf_counter() - began
        lateness = driving.service.lateness.summary()
        after, theirs_after = driving.processor_time()
        frames, received = await driving.received()
        # Proportional set size: the bytes of a shared page are divided by the number of processes that map it. Reading
        # it takes milliseconds for each process, in which no step begins: outside of what is measured.
        memory = [process.memory_full_info().pss for process in driving.programs]
        return Cost(
            lateness=lateness,
            took=took,
            service=after - before,
            programs=theirs_after - theirs_before,
            frames=frames,
            received=received,
            memory=memory,
            queued=driving.service.budgets.runs.queued,
        )


@dataclass(frozen=True, slots=True)
class Turn:
    """What a step of a turn cost, s of processor time, and what each page received, bytes a second."""

    service: float
    programs: float
    received: float

    @property
    def step(self) -> float:
        """Service and program."""
        return self.service + self.programs


def take_turns(
    config: Config, drivers: Drivers, kinds: Mapping[str, Mapping[str, Any]], rounds: int
) -> list[dict[str, Turn]]:
    """
    Let the same pages run a program, with a request of each kind in turn, and measure each turn of ``drivers.seconds``.

    What a machine does besides changes in seconds; the turns of a round follow each other at once, and every other
    round has them in the opposite order.
    """
    with asyncio.Runner(loop_factory=uvloop.new_event_loop) as runner:
        return runner.run(_turns(config, drivers, kinds, rounds))


SETTLE = 0.1
"""From a request to the measurement of what it changes, s: five steps."""


async def _turns(
    config: Config, drivers: Drivers, kinds: Mapping[str, Mapping[str, Any]], rounds: int
) -> list[dict[str, Turn]]:
    measured: list[dict[str, Turn]] = []
    async with _driving(config, drivers) as driving:
        for number in range(rounds):
            turns: dict[str, Turn] = {}
            for kind in list(kinds) if number % 2 == 0 else reversed(list(kinds)):
                driving.talk.send(kinds[kind])
                await asyncio.sleep(SETTLE)
                await driving.received()
                driving.service.lateness.clear()
                before, theirs_before = driving.processor_time()
                began = time.perf_counter()
                await asyncio.sleep(drivers.seconds)
                after, theirs_after = driving.processor_time()
                steps = driving.service.lateness.summary()["steps"]
                took = time.perf_counter() - began
                _, received = await driving.received()
                turns[kind] = Turn(
                    service=(after - before) / steps,
                    programs=(theirs_after - theirs_before) / steps,
                    received=received / took / drivers.count,
                )
            measured.append(turns)
    return measured


@dataclass(frozen=True, slots=True)
class _Driving:
    """A service and pages whose programs drive."""

    service: Service
    programs: list[psutil.Process]
    talk: Connection

    def processor_time(self) -> tuple[float, float]:
        """Of the service and of the programs, s."""
        return exact_time([psutil.Process()]), exact_time(self.programs)

    async def received(self) -> tuple[int, int]:
        """Frames and bytes that all pages have received since the last call."""
        self.talk.send("count")
        counted: tuple[int, int] = await asyncio.to_thread(self.talk.recv)
        return counted


@contextlib.asynccontextmanager
async def _driving(config: Config, drivers: Drivers) -> AsyncIterator[_Driving]:
    app = build_app(config)
    service: Service = app.state.service
    settings = uvicorn.Config(
        app,
        port=0,
        log_level="error",
        ws=paced_frames(),
        ws_per_message_deflate=False,
        # The pages here are bare sockets; they would be let go for not answering.
        ws_ping_interval=None,
        timeout_graceful_shutdown=1,
    )
    server = uvicorn.Server(settings)
    serving = asyncio.create_task(server.serve())
    while not (server.started and service.worker.state == "ready"):  # noqa: ASYNC110 (nothing to wait on)
        await asyncio.sleep(0.02)
    # As the service does when it is started.
    keep_what_is_loaded()
    port = server.servers[0].sockets[0].getsockname()[1]
    ours, theirs = multiprocessing.Pipe()
    pages = multiprocessing.get_context("spawn").Process(
        target=_simulate_pages, args=(port, drivers, min(drivers.count, config.limits.runs), theirs), daemon=True
    )
    pages.start()
    await asyncio.to_thread(ours.recv)
    driving = _Driving(service, _programs(service.worker.pid), ours)
    await driving.received()
    yield driving
    ours.send("stop")
    pages.join(5)
    pages.kill()
    server.should_exit = True
    await serving


def _programs(worker: int | None) -> list[psutil.Process]:
    """The processes of programs: the innermost ones below the worker's, except those that only check."""
    found: list[psutil.Process] = []
    level = [psutil.Process(worker)] if worker is not None else []
    while level:
        found = level
        level = [child for process in level for child in process.children()]
    return [process for process in found if process.name() != "rosy-check"]


def _simulate_pages(port: int, drivers: Drivers, active_drivers: int, talk: Connection) -> None:
    """Open the pages, wait until as many of them drive as may, count what they are sent, and send what is wanted."""
    count = drivers.count
    pages = [_open(port) for _ in range(count)]
    run = {"op": "run", "run": 1, "source": drivers.program, "seed": 1, "speed": 1}
    for page in pages:
        for request in (*drivers.requests, run):
            page.sendall(_masked(json.dumps(request).encode()))
    waiting = set(pages)
    seen = dict.fromkeys(pages, b"")
    with selectors.DefaultSelector() as selector:
        for page in pages:
            page.setblocking(False)
            selector.register(page, selectors.EVENT_READ, page)
        while len(waiting) > count - active_drivers:
            for key, _ in selector.select(1):
                page = key.data
                data = page.recv(1 << 16)
                seen[page] = (seen[page] + data)[-4096:]
                if b'"step":1' in seen[page]:
                    waiting.discard(page)
        talk.send("driving")
        frames = received = 0
        while True:
            for key, _ in selector.select(0.05):
                data = key.data.recv(1 << 16)
                received += len(data)
                frames += data.count(b'"op":"frame"')
            if not talk.poll():
                continue
            wanted = talk.recv()
            if wanted == "stop":
                return
            if wanted == "count":
                talk.send((frames, received))
                frames = received = 0
            else:
                for page in pages:
                    page.sendall(_masked(json.dumps(wanted).encode()))


def _open(port: int) -> socket.socket:
    """A WebSocket by hand. RFC 6455, section 4.1."""
    page = socket.create_connection(("127.0.0.1", port))
    key = base64.b64encode(os.urandom(16)).decode()
    page.sendall(
        f"GET /api/session HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
        f"Sec-WebSocket-Key: {key}\r\nSec-WebSocket-Version: 13\r\n\r\n".encode()
    )
    assert b" 101 " in page.recv(1000)
    return page


def _masked(data: bytes) -> bytes:
    """A text frame with a zero mask. RFC 6455, section 5.2; a request here is shorter than 65536 bytes."""
    size = bytes([0x80 | len(data)]) if len(data) < 126 else b"\xfe" + len(data).to_bytes(2, "big")
    return b"\x81" + size + b"\0\0\0\0" + data
