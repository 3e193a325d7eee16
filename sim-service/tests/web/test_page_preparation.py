"""A page's next run is prepared when a check has found no mistake: same text, changed text, two pages, page closed."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from dataclasses import replace

import pytest

from rosy_sim.config import Config
from rosy_sim.web.service import Service
from rosy_sim.worker.supervisor import RunningProgram, WorkerSupervisor

from ..conftest import PATIENCE
from .page_client import Page, opened, serving, story


async def becomes(condition: Callable[[], bool]) -> None:
    async with asyncio.timeout(PATIENCE):
        while not condition():
            await asyncio.sleep(0)


async def prepared(page: Page, service: Service, ident: int, source: str, count: int = 1) -> None:
    """Have a text checked, and wait until its run is prepared."""
    await page.send("check", id=ident, source=source)
    await page.op("checked", id=ident)
    await becomes(lambda: len(service.prepared_runs) == count)


@pytest.fixture
def begun(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The texts of the prepared runs that were begun."""
    texts: list[str] = []
    begin = WorkerSupervisor.begin

    def record(worker: WorkerSupervisor, program: RunningProgram, source: str) -> None:
        texts.append(source)
        begin(worker, program, source)

    monkeypatch.setattr(WorkerSupervisor, "begin", record)
    return texts


def test_a_run_of_the_checked_text_begins_what_was_prepared_and_is_prepared_again(
    config: Config, begun: list[str]
) -> None:
    async def play(page: Page, service: Service) -> None:
        await prepared(page, service, 1, "drive:0.5")
        for run in (1, 2):
            await page.send("run", run=run, source="drive:0.5", speed=16)
            await page.op("state", run=run, state="running")
            assert begun == run * ["drive:0.5"]
            await becomes(lambda: len(service.prepared_runs) == 1)

    story(play, config)


def test_a_changed_text_is_compiled_for_its_run(config: Config, begun: list[str]) -> None:
    async def play(page: Page, service: Service) -> None:
        await prepared(page, service, 1, "drive:0.5")
        await page.send("run", run=1, source="drive:0.6", speed=16)
        await page.op("state", run=1, state="running")
        assert begun == []

    story(play, config)


def test_a_text_with_a_mistake_is_not_prepared_and_what_was_is_discarded(config: Config, begun: list[str]) -> None:
    async def play(page: Page, service: Service) -> None:
        await prepared(page, service, 1, "drive:0.5")
        await page.send("check", id=2, source="refuse")
        await page.op("checked", id=2)
        assert len(service.prepared_runs) == 0
        await page.send("run", run=1, source="refuse", speed=16)
        ended = await page.ended(1)
        assert (ended["ended"], begun) == ("refused", [])
        assert len(service.prepared_runs) == 0

    story(play, config)


def test_pages_have_their_own_and_lose_it_when_they_close(config: Config, begun: list[str]) -> None:
    async def tell() -> None:
        async with serving(config) as (address, service):
            async with opened(address) as one:
                await prepared(one, service, 1, "drive:0.5", 1)
                async with opened(address) as two:
                    await prepared(two, service, 1, "drive:0.5", 2)
                await becomes(lambda: len(service.prepared_runs) == 1)
                await one.send("run", run=1, source="drive:0.5", speed=16)
                await one.op("state", run=1, state="running")
                assert begun == ["drive:0.5"]
            await becomes(lambda: len(service.prepared_runs) == 0)

    asyncio.run(tell())


def test_a_prepared_run_that_waits_for_a_place_and_is_stopped_leaves_nothing(config: Config) -> None:
    narrow = config.with_limits(replace(config.limits, runs=1))

    async def tell() -> None:
        async with serving(narrow) as (address, service), opened(address) as one, opened(address) as two:
            await one.send("run", run=1, source="drive:0.5", speed=1)
            await one.op("state", run=1, state="running")
            await prepared(two, service, 1, "drive:0.2")
            await two.send("run", run=1, source="drive:0.2", speed=16)
            await two.op("state", run=1, state="queued")
            await two.send("stop")
            await two.ended(1)
            await one.send("stop")
            await one.ended(1)
            await two.send("run", run=2, source="drive:0.2", speed=16)
            await two.op("state", run=2, state="running")

    asyncio.run(tell())
