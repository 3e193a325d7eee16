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
import resource
import selectors
import socket
import statistics
import time
from dataclasses import replace
from multiprocessing.connection import Connection
from pathlib import Path

import uvicorn
import uvloop

from ..app import Service, build_app
from ..config import Config
from ..world.facts import STEP

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
        ws="websockets-sansio",
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
    crowd = multiprocessing.get_context("spawn").Process(
        target=_crowd, args=(port, count, min(count, config.limits.runs), theirs), daemon=True
    )
    crowd.start()
    await asyncio.to_thread(ours.recv)
    service.late.clear()
    programs = _programs(service.worker.pid)
    before, theirs_before, began = _cpu(), _used(programs), time.perf_counter()
    if profiler is not None:
        profiler.enable()
    ours.send("count")
    await asyncio.sleep(seconds)
    if profiler is not None:
        profiler.disable()
    memory = [_proportional(pid) for pid in programs]
    ours.send("stop")
    frames, octets = await asyncio.to_thread(ours.recv)
    took, cost, spent = time.perf_counter() - began, _cpu() - before, _used(programs) - theirs_before
    late = service.late.summary()
    driving = min(count, config.limits.runs)
    rate = late["steps"] / took / driving
    print(
        f"  {count:>3} pages: {rate:5.1f} steps/s each; a step begins late by {late['p50'] * 1e3:.1f} ms (median), "
        f"{late['p99'] * 1e3:.1f} (p99), {late['worst'] * 1e3:.1f} (worst); "
        f"{frames / took / count:.0f} frames/s and {octets / took / count / 1e3:.1f} kB/s to each; "
        f"service {cost / took * 100:.0f} % of a core, programs {spent / took * 100:.0f} %: "
        f"{cost / late['steps'] * 1e6:.0f} and {spent / late['steps'] * 1e6:.0f} µs a step; "
        f"{statistics.median(memory) / 1024:.1f} MB of memory to each program (proportional; {len(memory)} alive); "
        f"{service.places.queued} waited for a place, none was refused",
        flush=True,
    )
    crowd.join(5)
    crowd.kill()
    server.should_exit = True
    await serving
    return late["p99"]


def _programs(worker: int | None) -> list[int]:
    """The processes of programs: the last below the worker's own, but for those that only check."""
    found: list[int] = []
    level = [worker] if worker is not None else []
    while level:
        found = level
        level = [int(pid) for one in level for pid in Path(f"/proc/{one}/task/{one}/children").read_text().split()]
    return [pid for pid in found if Path(f"/proc/{pid}/comm").read_text() != "rosy-check\n"]


def _proportional(pid: int) -> int:
    """Memory of a process, shared parts divided among those who share them, kB. proc(5)."""
    lines = Path(f"/proc/{pid}/smaps_rollup").read_text().splitlines()
    return next(int(line.split()[1]) for line in lines if line.startswith("Pss:"))


def _cpu() -> float:
    used = resource.getrusage(resource.RUSAGE_SELF)
    return used.ru_utime + used.ru_stime


def _used(pids: list[int]) -> float:
    """CPU time of processes, s. proc(5): fields 14 and 15 of /proc/PID/stat, in clock ticks."""
    ticks = 0
    for pid in pids:
        fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
        ticks += int(fields[11]) + int(fields[12])
    return ticks / os.sysconf("SC_CLK_TCK")


def _crowd(port: int, count: int, drivers: int, talk: Connection) -> None:
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
        while len(waiting) > count - drivers:
            for key, _ in selector.select(1):
                page = key.data
                data = page.recv(1 << 16)
                seen[page] = (seen[page] + data)[-4096:]
                if b'"step":1' in seen[page]:
                    waiting.discard(page)
        talk.send("driving")
        frames = octets = 0
        while not (talk.poll() and talk.recv() == "stop"):
            for key, _ in selector.select(0.05):
                data = key.data.recv(1 << 16)
                octets += len(data)
                frames += data.count(b'"op":"frame"')
    talk.send((frames, octets))


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
