"""
What others notice of an attack: how long the checks of a page take, how late the steps of a run begin, how long the
service computes at a stretch, and whether a new page is let in, may drive the robots and gets its program started.
Beside the same without the attack.

The service runs here with the worker. The attacker and the others are two more processes, so that neither computes for
the other. The attacker, whose computer is another one, has the lowest priority on this machine. How busy the machine
is with all else stands beside: the times mean little where its load is far above the number of its cores.
"""

from __future__ import annotations

import asyncio
import multiprocessing
import os
import statistics
import time
from dataclasses import replace
from multiprocessing.connection import Connection
from typing import Any

import uvloop

from ...config import Config
from ...web.server import raise_priority
from ...web.service import Service
from ..serving import serving
from .attacks import ATTACKS, Attack
from .loop_monitor import LoopMonitor
from .page_client import PageClient, opened

__all__ = ["report"]

_RUNS = 20
"""Programs at once: few enough for one client to take them all."""

_PAUSE = 0.1
"""Between two checks of a page, s: a person types."""

_LOWEST_PRIORITY = 19
"""Of a process; ``nice``(2)."""

_PROGRAM = """accelerate :: Velocity -> Velocity
accelerate (Velocity v w) = Velocity (v + 0.3) 0.4

main = simulate accelerate
"""


def report(config: Config, seconds: float, only: str = "") -> None:
    """
    Print a row without an attack and one for each attack.

    Args:
        config: of the service.
        seconds: for each row.
        only: what the titles of the attacks have in them.
    """
    config = replace(config, robots={"Bench": "ws://127.0.0.1:9"}).with_limits(replace(config.limits, runs=_RUNS))
    with asyncio.Runner(loop_factory=uvloop.new_event_loop) as runner:
        runner.run(_measure(config, seconds, only))


async def _measure(config: Config, seconds: float, only: str) -> None:
    # As in ./rosy start. Those that the others are played by wait for the service, and must not wait for the attacker.
    raise_priority()
    ours, theirs = multiprocessing.Pipe()
    spawning = multiprocessing.get_context("spawn")
    async with serving(config) as (service, port):
        others = spawning.Process(target=_run_others, args=(port, service.robots.code, theirs), daemon=True)
        others.start()
        # Its end is noticed.
        theirs.close()
        monitor = LoopMonitor()
        try:
            await asyncio.to_thread(ours.recv)
            await _print_row(service, ours, monitor, "no attack", seconds)
            for number, attack in enumerate(ATTACKS):
                if only not in attack.title:
                    continue
                attacker_ours, attacker_theirs = multiprocessing.Pipe()
                attacker = spawning.Process(target=_attack, args=(number, port, attacker_theirs), daemon=True)
                attacker.start()
                attacker_theirs.close()
                try:
                    await asyncio.to_thread(attacker_ours.recv)
                    await _print_row(service, ours, monitor, attack.title, seconds)
                finally:
                    attacker.kill()
                    attacker.join()
            ours.send(0.0)
        finally:
            monitor.cancel()
            others.join(5)
            others.kill()


async def _print_row(service: Service, others: Connection, monitor: LoopMonitor, title: str, seconds: float) -> None:
    service.lateness.clear()
    monitor.clear()
    others.send(seconds)
    checks, entered, started, unlocked = await asyncio.to_thread(others.recv)
    late = service.lateness.summary()
    use = monitor.use()
    ordered = sorted(checks)
    p95 = ordered[min(len(ordered) - 1, len(ordered) * 95 // 100)]
    print(
        f"  {title:<46} "
        f"checks {statistics.median(ordered) * 1e3:5.0f} ms (median) {p95 * 1e3:5.0f} (p95); "
        f"steps late by {late['p50'] * 1e3:5.1f} ms (median) {late['p99'] * 1e3:6.1f} (p99); "
        f"the loop computes {use.share:4.0%} of the time, at a stretch {use.p99 * 1e3:4.1f} ms (p99) "
        f"{use.most * 1e3:5.1f} (most); "
        f"a new page is let in {'' if entered else 'NOT '}after {entered or 0.0:.2f} s, "
        f"its program drives after {started:.2f} s, "
        f"its code for the robots is {'accepted' if unlocked else 'REFUSED'}; "
        f"load {os.getloadavg()[0]:.1f}",
        flush=True,
    )


def _attack(number: int, port: int, talk: Connection) -> None:
    os.nice(_LOWEST_PRIORITY)
    asyncio.run(_endless(ATTACKS[number], port, talk))


async def _endless(attack: Attack, port: int, talk: Connection) -> None:
    await attack.run(port, lambda: talk.send("under way"))


def _run_others(port: int, code: str, talk: Connection) -> None:
    asyncio.run(_others(port, code, talk))


async def _others(port: int, code: str, talk: Connection) -> None:
    """One page drives, one checks; for each number of seconds asked for, tell what they and a new page notice."""
    async with opened(port) as driving, opened(port) as checking:
        await driving.send("run", run=1, source=_PROGRAM, seed=1, speed=1)
        await driving.answer("frame")
        reading = asyncio.create_task(driving.drain())
        await _check(checking, 0)
        talk.send("ready")
        number = 0
        while seconds := await asyncio.to_thread(talk.recv):
            newcomer = asyncio.create_task(_newcomer(port, code))
            took: list[float] = []
            end = time.monotonic() + seconds
            while not took or time.monotonic() < end:
                number += 1
                took.append(await _check(checking, number))
                await asyncio.sleep(_PAUSE)
            talk.send((took, *await newcomer))
        reading.cancel()


async def _check(page: PageClient, number: int) -> float:
    """How long a check takes, s."""
    begun = time.monotonic()
    # Another text each time, with names of its own: no answer can be one that was given before.
    await page.send("check", id=number, source=_PROGRAM.replace("accelerate", f"accelerate{number}"))
    while (await page.answer("checked"))["id"] != number:
        pass
    return time.monotonic() - begun


async def _newcomer(port: int, code: str) -> tuple[float | None, float, bool]:
    """When a new page is let in (``None``: never) and its program drives, s, and whether it may drive the robots."""
    begun = time.monotonic()
    async with opened(port) as page:
        if (await page.answer("hello", "refusal"))["op"] == "refusal":
            return None, 0.0, False
        entered = time.monotonic() - begun
        begun = time.monotonic()
        await page.send("run", run=1, source=_PROGRAM, seed=1, speed=1)
        await page.answer("frame")
        while not (await page.answer("frame"))["step"]:
            pass
        started = time.monotonic() - begun
        await page.send("unlock", code=code)
        answer: dict[str, Any] = await page.answer("robots", "refusal")
        return entered, started, answer["op"] == "robots"
