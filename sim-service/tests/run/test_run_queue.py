"""A class that is larger than the room: who waits, who is told what, and whose turn it is."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable
from dataclasses import replace

from rosy_sim.config import Config
from rosy_sim.web.service import Service

from ..conftest import PATIENCE
from ..web.page_client import Page, opened, serving

DRIVE = "drive:0.5"


def room_for(config: Config, runs: int) -> Config:
    return config.with_limits(replace(config.limits, runs=runs))


def played(config: Config, pages: int, play: Callable[[list[Page], Service], Awaitable[None]]) -> None:
    """Several pages of one service."""

    async def tell() -> None:
        async with serving(config) as (address, service):
            opening = [opened(address) for _ in range(pages)]
            here = [await one.__aenter__() for one in opening]
            try:
                await play(here, service)
            finally:
                for one in opening:
                    await one.__aexit__(None, None, None)
            async with asyncio.timeout(PATIENCE):
                while service.budgets.runs.running:
                    await asyncio.sleep(0.005)

    asyncio.run(tell())


def test_a_program_that_has_no_place_waits_its_turn(config: Config) -> None:
    async def play(pages: list[Page], service: Service) -> None:
        first, second, third = pages
        await first.send("run", run=1, source=DRIVE)
        await first.op("state", state="running")
        await second.send("run", run=1, source=DRIVE)
        assert (await second.op("state", state="queued"))["place"] == 1
        await third.send("run", run=1, source=DRIVE)
        assert (await third.op("state", state="queued"))["place"] == 2
        await first.send("stop")
        await second.op("state", state="compiling", place=None)
        await second.op("state", state="running")
        assert (await third.op("state", state="queued"))["place"] == 1
        assert service.budgets.runs.running == 1
        await second.send("stop")
        await third.op("state", state="running")

    played(room_for(config, 1), 3, play)


def test_a_paused_program_gives_its_place_to_another_and_waits_for_one_to_go_on(config: Config) -> None:
    async def play(pages: list[Page], service: Service) -> None:
        first, second = pages
        await first.send("run", run=1, source=DRIVE)
        await first.op("state", state="running")
        await second.send("run", run=1, source=DRIVE)
        await second.op("state", state="queued", place=1)
        await first.send("pause")
        await second.op("state", state="running")
        assert service.budgets.runs.running == 1
        await first.send("resume")
        await first.op("state", state="queued", place=1)
        # A pause leaves the queue.
        await first.send("pause")
        await first.send("resume")
        await first.op("state", state="queued", place=1)
        await second.send("stop")
        await second.ended(1)
        await first.op("state", state="running")
        step = (await first.op("frame", run=1))["step"]
        await first.until(lambda message: message["op"] == "frame" and message["step"] > step + 5)
        # With a place to spare a run goes on at once.
        await first.send("pause")
        await first.send("resume")
        await first.send("stop")
        await first.ended(1)

    played(room_for(config, 1), 2, play)


def test_a_program_that_is_paused_at_its_start_takes_no_place_and_one_that_waits_to_go_on_can_be_stopped(
    config: Config,
) -> None:
    async def play(pages: list[Page], service: Service) -> None:
        first, second = pages
        await first.send("run", run=1, source=DRIVE)
        await first.send("pause")
        await first.op("state", state="running")
        await second.send("run", run=1, source=DRIVE)
        await second.op("state", state="running")
        await first.send("resume")
        await first.op("state", state="queued", place=1)
        await first.send("stop")
        await first.ended(1)
        assert service.budgets.runs.running == 1
        await first.send("run", run=2, source=DRIVE)
        await first.op("state", state="queued", place=1)
        await second.socket.close()
        await first.op("state", run=2, state="running")

    played(room_for(config, 1), 2, play)


def test_who_gives_up_waiting_lets_the_others_move_up(config: Config) -> None:
    async def play(pages: list[Page], _: Service) -> None:
        first, second, third = pages
        await first.send("run", run=1, source=DRIVE)
        await first.op("state", state="running")
        for page in (second, third):
            await page.send("run", run=1, source=DRIVE)
            await page.op("state", state="queued")
        await second.send("stop")
        await second.ended(1)
        assert (await third.op("state", state="queued"))["place"] == 1
        await first.send("run", run=2, source=DRIVE)
        await third.op("state", state="running")
        await first.op("state", state="queued", place=1)

    played(room_for(config, 1), 3, play)


def test_a_page_that_leaves_gives_its_place_back(config: Config) -> None:
    async def play(pages: list[Page], _: Service) -> None:
        first, second = pages
        await first.send("run", run=1, source=DRIVE)
        await first.op("state", state="running")
        await second.send("run", run=1, source=DRIVE)
        await second.op("state", state="queued")
        await first.socket.close()
        await second.op("state", state="running")

    played(room_for(config, 1), 2, play)


def test_a_program_that_is_refused_or_loses_its_worker_gives_its_place_back(config: Config) -> None:
    async def play(pages: list[Page], _: Service) -> None:
        [page] = pages
        for run, source in enumerate(("refuse", "die", "slow", "hang@0", "close@1", DRIVE), 1):
            await page.send("run", run=run, source=source)
            if source == DRIVE:
                await page.op("state", run=run, state="running")
            elif source == "slow":
                await page.send("stop")
                await page.ended(run)
            else:
                await page.ended(run)

    limits = replace(config.limits, settle=0.3, runs=1)
    played(config.with_limits(limits), 1, play)
