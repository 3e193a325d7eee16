"""
What a class of thirty notices of an attack, from one address and from ten: 95th percentiles of checks, of Run until the
robot drives, of previews, of saves and of the board's answers, each beside the same without an attack; how late the
steps of all runs begin; and what was refused or not answered.

The service runs here with the worker. The attacker and the class are two more processes, so that neither computes for
the other. The attacker, whose computer is another one, has the lowest priority on this machine. How busy the machine
is with all else stands beside: the times mean little where its load is far above the number of its cores.

Goal: at most twice as long as without the attack, checks and Run below 250 ms, steps late by less than 20 ms (99th
percentile), nothing of the class refused.
"""

from __future__ import annotations

import asyncio
import multiprocessing
import os
import tempfile
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from dataclasses import dataclass, replace
from multiprocessing.connection import Connection
from pathlib import Path

import uvloop

from ...classroom.store.class_folder import open_class
from ...classroom.store.class_store import ClassStore
from ...config import Config
from ...web.server import raise_priority
from ...web.service import Service
from ..serving import serving
from .attacks import ATTACKS, Target
from .honest_class import KINDS, Class, Round, run_honest_class
from .loop_monitor import LoopMonitor

__all__ = ["report"]

_PUPILS, _RUNS = 30, 40
"""Pages of the class, and programs at once: those of the class and of a new page, and few enough for an attacker to
take all of them."""

_ADDRESSES = (1, 10)
"""From which an attack comes."""

_WARM_UP = 6.0
"""Of the first round, whose times do not count, s."""

_LOWEST_PRIORITY = 19
"""Of a process; ``nice``(2)."""

_SMALL_PUPILS, _SMALL_CLIENTS = 3, 10
"""Pages of the class and of an attack in the small form."""


@dataclass(frozen=True, slots=True)
class _Extent:
    """How much is measured."""

    seconds: float
    pupils: int
    # Most clients of an attack.
    clients: int
    addresses: tuple[int, ...]
    # By their numbers.
    attacks: tuple[int, ...]


def report(config: Config, seconds: float, only: str = "", small: bool = False) -> bool:
    """
    Print a row without an attack and two for each attack; whether all that the class asked for was done.

    Args:
        config: of the service.
        seconds: for each row.
        only: what the titles of the attacks have in them.
        small: few pages and clients, and one attack on each resource, from ten addresses.
    """
    chosen = [number for number, attack in enumerate(ATTACKS) if only in attack.title]
    extent = (
        _Extent(0.1, _SMALL_PUPILS, _SMALL_CLIENTS, _ADDRESSES[-1:], _first_of_each(chosen))
        if small
        else _Extent(seconds, _PUPILS, max(one.clients for one in ATTACKS), _ADDRESSES, tuple(chosen))
    )
    config = replace(config, robots={"Bench": "ws://127.0.0.1:9"}, records=False)
    config = config.with_limits(replace(config.limits, runs=_RUNS))
    with (
        tempfile.TemporaryDirectory() as folder,
        open_class(Path(folder), "bench") as store,
        asyncio.Runner(loop_factory=uvloop.new_event_loop) as runner,
    ):
        return runner.run(_measure(config, store, extent))


def _first_of_each(numbers: list[int]) -> tuple[int, ...]:
    """One attack of each resource, which is the first word of its title."""
    return tuple(sorted({ATTACKS[number].title.partition(":")[0]: number for number in reversed(numbers)}.values()))


async def _measure(config: Config, store: ClassStore, extent: _Extent) -> bool:
    # As in ./rosy start. Those that the class is played by wait for the service, and must not wait for the attacker.
    raise_priority()
    admission = store.admission()
    failed = 0
    async with serving(config, store) as (service, port):
        place = Class(port, extent.pupils, admission.code, admission.teacher_key, service.robots.code)
        target = Target(port, admission.code)
        monitor = LoopMonitor()
        try:
            async with _process(run_honest_class, place) as pupils:
                await asyncio.to_thread(pupils.recv)
                table = _Table(service, pupils, monitor)
                await table.play(min(_WARM_UP, extent.seconds))
                failed += await table.row("no attack", 2 * extent.seconds)
                for number in extent.attacks:
                    for addresses in extent.addresses:
                        async with _process(_attack, number, target, addresses, extent.clients) as attacker:
                            await asyncio.to_thread(attacker.recv)
                            failed += await table.row(f"{ATTACKS[number].title}, {addresses} addr.", extent.seconds)
                pupils.send(0.0)
        finally:
            monitor.cancel()
    return not failed


@asynccontextmanager
async def _process(play: object, *arguments: object) -> AsyncIterator[Connection]:
    """A process that is killed at the end of the block; yields its connection."""
    ours, theirs = multiprocessing.Pipe()
    process = multiprocessing.get_context("spawn").Process(target=play, args=(*arguments, theirs), daemon=True)  # type: ignore[arg-type]
    process.start()
    # Its end is noticed.
    theirs.close()
    try:
        yield ours
    finally:
        process.kill()
        await asyncio.to_thread(process.join)


class _Table:
    """Rows, of which the first one is what the others are compared with."""

    def __init__(self, service: Service, pupils: Connection, monitor: LoopMonitor) -> None:
        self._service = service
        self._pupils = pupils
        self._monitor = monitor
        self._usual: dict[str, float] = {}

    async def play(self, seconds: float) -> Round:
        """A round of the class."""
        self._pupils.send(seconds)
        found: Round = await asyncio.to_thread(self._pupils.recv)
        return found

    async def row(self, title: str, seconds: float) -> int:
        """Print a row; how many requests failed."""
        self._service.lateness.clear()
        self._monitor.clear()
        found = await self.play(seconds)
        late, use = self._service.lateness.summary(), self._monitor.use()
        times = {kind: _p95(found.times[kind]) for kind in KINDS}
        self._usual = self._usual or times
        shown = "; ".join(
            f"{kind} {took * 1e3:4.0f} ms ({took / self._usual[kind]:4.1f})" for kind, took in times.items()
        )
        print(
            f"  {title:<52} {shown}; "
            f"steps late by {late['p50'] * 1e3:4.1f} ms (median) {late['p99'] * 1e3:5.1f} (p99); "
            f"the loop computes {use.share:4.0%}, {use.p99 * 1e3:4.1f} ms at a stretch (p99); "
            f"a new page is let in after {found.entered:.2f} s and drives after {found.drove:.2f}; "
            f"{sum(map(len, found.times.values()))} requests, {len(found.failed)} failed; "
            f"load {os.getloadavg()[0]:.1f}",
            flush=True,
        )
        for failure in found.failed[:3]:
            print(f"      failed: {failure}", flush=True)
        return len(found.failed)


def _p95(times: list[float]) -> float:
    ordered = sorted(times)
    return ordered[min(len(ordered) - 1, len(ordered) * 95 // 100)]


def _attack(number: int, target: Target, addresses: int, clients: int, talk: Connection) -> None:
    os.nice(_LOWEST_PRIORITY)
    asyncio.run(ATTACKS[number].run(target, addresses, clients, lambda: talk.send("under way")))
