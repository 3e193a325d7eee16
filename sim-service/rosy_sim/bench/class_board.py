"""
Cost of the teacher's board: a class of pupils whose programs all drive, without a board and with one.

The service runs here with the worker; pupils and the board are protocol clients in another process, so that their work
does not count as ours.
"""

from __future__ import annotations

import asyncio
import multiprocessing
import tempfile
import time
from dataclasses import replace
from multiprocessing.connection import Connection
from pathlib import Path

import psutil
import uvloop

from ..classroom.store.class_folder import open_class
from ..classroom.store.class_store import ClassStore
from ..config import Config
from ..web.service import Service
from .class_pupils import PROGRAM, run_class
from .serving import serving

__all__ = ["report"]


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
            target=run_class,
            args=(f"127.0.0.1:{port}", pupils, admission.code, admission.teacher_key, program, theirs),
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
    counted = await asyncio.to_thread(clients.recv)
    cost = after.user + after.system - before.user - before.system
    late = service.lateness.summary()
    to_board = (
        f"; to the board {counted.messages / took:.0f} messages and {counted.received / took / 1e3:.1f} kB a second"
    )
    print(
        f"  {pupils:>3} pupils, {'one board' if board else 'no board '}: service {cost / took * 100:.0f} % of a core; "
        f"a step begins late by {late['p50'] * 1e3:.1f} ms (median), {late['p99'] * 1e3:.1f} (p99)"
        f"{to_board if board else ''}",
        flush=True,
    )
    return float(late["p99"])
