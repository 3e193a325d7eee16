"""
Recovery time of the worker: from its death or wedging until another one has answered a check.

By itself, and together with the fork server that would replace it.

Two cores: 60 ms after a killed worker, 0.8 s after a stopped one (goal 1 s), 1.5 to 1.7 s together with the fork
server.
"""

from __future__ import annotations

import asyncio
import contextlib
import os
import signal
import statistics
import time

from ..config import Config
from ..worker.supervisor import WorkerSupervisor

__all__ = ["measure"]

_SOURCE = "main = simulate (Velocity 0.1 0)\n"

_DEATHS = {"killed": signal.SIGKILL, "wedged (stopped)": signal.SIGSTOP}


async def measure(config: Config, rounds: int) -> None:
    """Print a row for each way to fail."""
    print(f"{'the worker was':44}{'median':>9}{'worst':>9}    s until another answers")
    for name, how in _DEATHS.items():
        for alone in (True, False):
            took = [await _once(config, how, alone=alone) for _ in range(rounds)]
            title = f"{name}{'' if alone else ', and its fork server killed'}"
            print(f"{title:44}{statistics.median(took):9.2f}{max(took):9.2f}", flush=True)


async def _once(config: Config, how: signal.Signals, *, alone: bool) -> float:
    ready = asyncio.Event()
    worker = WorkerSupervisor(config, lambda state: ready.set() if state == "ready" else ready.clear())
    keeper = asyncio.create_task(worker.run())
    try:
        await worker.check(_SOURCE)
        assert worker.pid is not None
        assert worker.fork_server_pid is not None
        began = time.perf_counter()
        ready.clear()
        os.kill(worker.pid, how)
        if not alone:
            os.killpg(worker.fork_server_pid, signal.SIGKILL)
        await ready.wait()
        await worker.check(_SOURCE)
        return time.perf_counter() - began
    finally:
        keeper.cancel()
        with contextlib.suppress(asyncio.CancelledError):
            await keeper
