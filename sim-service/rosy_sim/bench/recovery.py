"""
Recovery time of the worker: from its death or wedging until another one has answered a check.

With a warm worker waiting, as a service has seconds after its start, and without, as when two die at once.
"""

from __future__ import annotations

import asyncio
import contextlib
import os
import signal
import statistics
import time

from ..config import Config
from ..worker.liveness import sandboxed_pid
from ..worker.supervisor import WorkerSupervisor

__all__ = ["measure"]

_SOURCE = "main = simulate (Velocity 0.1 0)\n"

_DEATHS = {"killed": signal.SIGKILL, "wedged (stopped)": signal.SIGSTOP}


async def measure(config: Config, rounds: int) -> None:
    """Print a row for each way to fail."""
    print(f"{'the worker was':44}{'median':>9}{'worst':>9}    s until another answers")
    for name, how in _DEATHS.items():
        for spare in (True, False):
            took = [await _once(config, how, spare=spare) for _ in range(rounds)]
            title = f"{name}, {'a warm one waits' if spare else 'none waits'}"
            print(f"{title:44}{statistics.median(took):9.2f}{max(took):9.2f}", flush=True)


async def _once(config: Config, how: signal.Signals, *, spare: bool) -> float:
    ready = asyncio.Event()
    worker = WorkerSupervisor(config, lambda state: ready.set() if state == "ready" else ready.clear())
    keeper = asyncio.create_task(worker.run())
    try:
        await worker.check(_SOURCE)
        if spare:
            await worker.standby_ready()
        assert worker.pid is not None
        began = time.perf_counter()
        ready.clear()
        os.kill(sandboxed_pid(worker.pid), how)
        await ready.wait()
        await worker.check(_SOURCE)
        return time.perf_counter() - began
    finally:
        keeper.cancel()
        with contextlib.suppress(asyncio.CancelledError):
            await keeper
