"""
Many pages at once, each with a program at real time: how late their steps begin, and what they cost.

The service runs here with the real worker; the pages are bare sockets in another process, so that their work does
not count as ours.
"""

from __future__ import annotations

import asyncio
import base64
import cProfile
import json
import multiprocessing
import os
import pstats
import selectors
import socket
import statistics
import time
from dataclasses import replace
from multiprocessing.connection import Connection

import psutil
import uvicorn
import uvloop

from ..config import Config
from ..web.app import Service, build_app
from ..web.paced_frames import paced_frames
from ..world.time_step import STEP

__all__ = ["IN_TIME", "report"]

IN_TIME = STEP
"""A step that begins later than the next one was due is late, s."""

_SHOWN = 12
"""Lines of a profile."""

_PROGRAM = """accelerate :: Velocity -> Velocity
accelerate (Velocity v w) = Velocity (v + 0.3) 0.4

main = simulate accelerate
"""


def report(config: Config, count: int, runs: int, seconds: float, profile: bool) -> float:
    """
    Print a row: so many pages, of which so many may drive at once. With ``profile`` also where the service's time
    went. Answers how late steps began, s (p99).
    """
    limits = replace(config.limits, runs=runs, sessions=max(count, config.limits.sessions))
    profiler = cProfile.Profile(time.process_time) if profile else None
    with asyncio.Runner(loop_factory=uvloop.new_event_loop) as runner:
        late = runner.run(_measure(config.with_limits(limits), count, seconds, profiler))
    if profiler is not None:
        pstats.Stats(profiler).sort_stats("tottime").print_stats(_SHOWN)
    return late


async def _measure(config: Config, count: int, seconds: float, profiler: cProfile.Profile | None) -> float:
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
    port = server.servers[0].sockets[0].getsockname()[1]
    ours, theirs = multiprocessing.Pipe()
    pages = multiprocessing.get_context("spawn").Process(
        target=_simulate_pages, args=(port, count, min(count, config.limits.runs), theirs), daemon=True
    )
    pages.start()
    await asyncio.to_thread(ours.recv)
    service.lateness.clear()
    programs = _programs(service.worker.pid)
    service_process = psutil.Process()
    before, theirs_before = _processor_time([service_process]), _processor_time(programs)
    began = time.perf_counter()
    if profiler is not None:
        profiler.enable()
    ours.send("count")
    await asyncio.sleep(seconds)
    if profiler is not None:
        profiler.disable()
    # Shared parts are divided among those who share them.
    memory = [process.memory_full_info().pss for process in programs]
    ours.send("stop")
    frames, received = await asyncio.to_thread(ours.recv)
    took = time.perf_counter() - began
    cost, spent = _processor_time([service_process]) - before, _processor_time(programs) - theirs_before
    late = service.lateness.summary()
    driving = min(count, config.limits.runs)
    rate = late["steps"] / took / driving
    print(
        f"  {count:>3} pages: {rate:5.1f} steps/s each; a step begins late by {late['p50'] * 1e3:.1f} ms (median), "
        f"{late['p99'] * 1e3:.1f} (p99), {late['worst'] * 1e3:.1f} (worst); "
        f"{frames / took / count:.0f} frames/s and {received / took / count / 1e3:.1f} kB/s to each; "
        f"service {cost / took * 100:.0f} % of a core, programs {spent / took * 100:.0f} %: "
        f"{cost / late['steps'] * 1e6:.0f} and {spent / late['steps'] * 1e6:.0f} µs a step; "
        f"{statistics.median(memory) / 1e6:.1f} MB of memory to each program (proportional; {len(memory)} alive); "
        f"{service.run_queue.queued} waited for a place, none was refused",
        flush=True,
    )
    pages.join(5)
    pages.kill()
    server.should_exit = True
    await serving
    return late["p99"]


def _programs(worker: int | None) -> list[psutil.Process]:
    """The processes of programs: the innermost ones below the worker's, except those that only check."""
    found: list[psutil.Process] = []
    level = [psutil.Process(worker)] if worker is not None else []
    while level:
        found = level
        level = [child for process in level for child in process.children()]
    return [process for process in found if process.name() != "rosy-check"]


def _processor_time(processes: list[psutil.Process]) -> float:
    """Processor time that processes have used, s."""
    return float(sum(times.user + times.system for times in (process.cpu_times() for process in processes)))


def _simulate_pages(port: int, count: int, active_drivers: int, talk: Connection) -> None:
    """Open the pages, wait until as many of them drive as may, then count what they are sent."""
    pages = [_open(port) for _ in range(count)]
    request = json.dumps({"op": "run", "run": 1, "source": _PROGRAM, "seed": 1, "speed": 1}).encode()
    for page in pages:
        page.sendall(_masked(request))
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
        while not (talk.poll() and talk.recv() == "stop"):
            for key, _ in selector.select(0.05):
                data = key.data.recv(1 << 16)
                received += len(data)
                frames += data.count(b'"op":"frame"')
    talk.send((frames, received))


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
    """A text frame with a zero mask. RFC 6455, section 5.2; a request here is between 126 and 65535 bytes."""
    return b"\x81\xfe" + len(data).to_bytes(2, "big") + b"\0\0\0\0" + data
