"""Runs that are prepared: of the same text, one of each page, a bounded number, and what becomes of them."""

from __future__ import annotations

import asyncio
import os
import signal
import socket
from collections.abc import Awaitable, Callable
from dataclasses import replace
from typing import Literal

from rosy_sim.accounting.resources import Budgets
from rosy_sim.config import Config
from rosy_sim.run.frame_rate import FrameRate
from rosy_sim.run.lateness import Lateness
from rosy_sim.run.worker_session import RunServices, WorkerSession
from rosy_sim.wire.problem import Problem
from rosy_sim.wire.worker import Started
from rosy_sim.worker.prepared_runs import PreparedRuns
from rosy_sim.worker.supervisor import WorkerSupervisor

from ..conftest import PATIENCE


def keeping(play: Callable[[WorkerSupervisor], Awaitable[None]], config: Config) -> None:
    """Keep a worker while a story is told."""

    async def tell() -> None:
        worker = WorkerSupervisor(config, lambda _: None)
        keeper = asyncio.create_task(worker.run())
        try:
            async with asyncio.timeout(PATIENCE):
                await worker.wait_ready()
                await play(worker)
        finally:
            keeper.cancel()
            await asyncio.gather(keeper, return_exceptions=True)

    asyncio.run(tell())


def test_only_the_page_that_prepared_it_takes_it_and_only_for_the_same_text(config: Config) -> None:
    async def play(worker: WorkerSupervisor) -> None:
        runs = PreparedRuns(worker, 4)
        runs.prepare("one", "drive:0.5")
        assert runs.take("one", "drive:0.6") is None
        assert runs.take("two", "drive:0.5") is None
        prepared = runs.take("one", "drive:0.5")
        assert prepared is not None
        assert runs.take("one", "drive:0.5") is None
        worker.begin(prepared.program, prepared.source)
        assert isinstance(await prepared.program.started, Started)
        worker.kill(prepared.program)
        assert (await prepared.program.gone).signal == signal.SIGKILL
        prepared.link.close()

    keeping(play, config)


def test_a_page_has_one_and_all_pages_a_bounded_number(config: Config) -> None:
    async def play(worker: WorkerSupervisor) -> None:
        runs = PreparedRuns(worker, 2)
        runs.prepare("one", "a")
        first = runs.take("one", "a")
        assert first is not None
        runs.prepare("one", "a")
        runs.prepare("one", "b")
        assert len(runs) == 1
        runs.prepare("two", "a")
        runs.prepare("three", "a")
        assert len(runs) == 2
        assert runs.take("one", "b") is None
        two, three = runs.take("two", "a"), runs.take("three", "a")
        assert two is not None
        assert three is not None
        for prepared in (first, two, three):
            prepared.link.close()

    keeping(play, config)


def test_what_is_discarded_is_gone(config: Config) -> None:
    async def play(worker: WorkerSupervisor) -> None:
        runs = PreparedRuns(worker, 2)
        runs.prepare("one", "a")
        prepared = runs.take("one", "a")
        assert prepared is not None
        worker.kill(prepared.program)
        assert (await prepared.program.gone).signal == signal.SIGKILL
        prepared.link.close()
        runs.prepare("one", "a")
        runs.discard("one")
        runs.discard("one")
        assert (len(runs), runs.take("one", "a")) == (0, None)

    keeping(play, config)


class Silent:
    """A listener of a session that may not be told anything."""

    def on_queued(self, place: int) -> None:
        raise AssertionError(place)

    def on_turn(self) -> None:
        raise AssertionError

    def on_started(self, link: socket.socket, started: Started) -> None:
        raise AssertionError(link, started)

    def on_failed(self, ended: Literal["refused", "error"], problems: list[Problem]) -> None:
        raise AssertionError(ended, problems)


def test_what_a_session_was_given_ends_when_it_is_cancelled_before_its_first_step(config: Config) -> None:
    async def play(worker: WorkerSupervisor) -> None:
        runs = PreparedRuns(worker, 2)
        runs.prepare("one", "a")
        prepared = runs.take("one", "a")
        assert prepared is not None
        services = RunServices(
            worker,
            Budgets(config.limits),
            config.limits,
            Lateness(),
            FrameRate(60.0, Lateness()),
        )
        WorkerSession("a", services, Silent(), prepared).cancel()
        assert prepared.link.fileno() == -1
        assert (await prepared.program.gone).signal == signal.SIGKILL

    keeping(play, config)


def test_what_was_prepared_in_a_worker_that_died_is_not_taken(config: Config) -> None:
    async def play(worker: WorkerSupervisor) -> None:
        runs = PreparedRuns(worker, 2)
        runs.prepare("one", "a")
        assert worker.pid is not None
        os.kill(worker.pid, signal.SIGKILL)
        while worker.state == "ready":
            await asyncio.sleep(0)
        assert runs.take("one", "a") is None
        # While no worker is warm nothing is prepared.
        runs.prepare("two", "a")
        assert len(runs) == 0
        await worker.wait_ready()
        runs.prepare("one", "a")
        prepared = runs.take("one", "a")
        assert prepared is not None
        prepared.link.close()

    keeping(play, config)


def test_none_is_prepared_where_none_may_be(config: Config) -> None:
    limits = replace(config.limits, prepared=0)

    async def play(worker: WorkerSupervisor) -> None:
        runs = PreparedRuns(worker, limits.prepared)
        runs.prepare("one", "a")
        assert len(runs) == 0

    keeping(play, config)
