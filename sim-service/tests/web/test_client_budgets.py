"""Two addresses at one service: what one of them asks for leaves the other its share."""

from __future__ import annotations

import asyncio
from asyncio import StreamReader, StreamWriter
from collections.abc import Awaitable, Callable
from contextlib import AsyncExitStack
from dataclasses import replace

import pytest

from rosy_sim.config import Config
from rosy_sim.web.routes import recordings
from rosy_sim.web.service import Service
from rosy_sim.wire.worker import Checked
from rosy_sim.worker.supervisor import WorkerSupervisor

from ..conftest import PATIENCE
from .page_client import Page, opened, serving

CROWD = ("127.0.0.2", 0)
"""Local address of the pages of the client that asks for much."""

OTHER = ("127.0.0.3", 0)

IDLE = "drive:0.5"

Story = Callable[[list[Page], Page, Service], Awaitable[None]]


def crowded(config: Config, pages: int, play: Story) -> None:
    """So many pages of one address, and one of another."""

    async def tell() -> None:
        async with serving(config) as (address, service), AsyncExitStack() as stack:
            crowd = [await stack.enter_async_context(opened(address, local_addr=CROWD)) for _ in range(pages)]
            other = await stack.enter_async_context(opened(address, local_addr=OTHER))
            await play(crowd, other, service)

    asyncio.run(tell())


def test_ten_programs_of_an_address_leave_another_a_place_and_the_one_that_is_stopped_is_told(config: Config) -> None:
    async def play(crowd: list[Page], other: Page, _: Service) -> None:
        for page in crowd:
            await page.send("run", run=1, source=IDLE)
            await page.op("state", state="running")
        await other.send("run", run=1, source=IDLE)
        await other.op("state", state="running")
        endings = [asyncio.create_task(page.ended(1)) for page in crowd]
        [done], rest = await asyncio.wait(endings, return_when=asyncio.FIRST_COMPLETED)
        told = done.result()
        assert told["ended"] == "stopped"
        assert [one["kind"] for one in told["problems"]] == ["place-needed"]
        for ending in rest:
            ending.cancel()
        # Its page waits for a place of its own client, and the other one keeps its place.
        loser = crowd[endings.index(done)]
        await loser.send("run", run=2, source=IDLE)
        await loser.op("state", run=2, state="queued")

    crowded(config.with_limits(replace(config.limits, runs=10)), 10, play)


def test_programs_that_compile_for_ever_leave_another_the_compiler(config: Config) -> None:
    async def play(crowd: list[Page], other: Page, service: Service) -> None:
        for page in crowd:
            await page.send("run", run=1, source="slow")
            await page.op("state", state="compiling")
        while service.budgets.compiling.running < 2:
            await asyncio.sleep(0.005)
        await other.send("run", run=1, source=IDLE)
        await other.op("state", state="running")

    crowded(config, 4, play)


def test_checks_that_take_for_ever_leave_another_the_compiler_and_are_asked_again(
    config: Config, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[str] = []
    check = WorkerSupervisor.check

    async def noted(worker: WorkerSupervisor, source: str) -> Checked:
        asked.append(source)
        return await check(worker, source)

    monkeypatch.setattr(WorkerSupervisor, "check", noted)

    async def tell() -> None:
        async with serving(config) as (address, service), AsyncExitStack() as stack:
            places = (CROWD, ("127.0.0.4", 0), OTHER)
            *crowd, other = [await stack.enter_async_context(opened(address, local_addr=place)) for place in places]
            questions = service.budgets.questions
            questions.policy = replace(questions.policy, long=0.05)
            for number, page in enumerate(crowd):
                await page.send("check", id=1, source=f"slow {number}")
            async with asyncio.timeout(PATIENCE):
                while questions.running < 2:
                    await asyncio.sleep(0.005)
                await other.send("check", id=1, source=IDLE)
                assert (await other.op("checked"))["problems"] == []
                while not any(asked.count(f"slow {number}") > 1 for number in range(2)):
                    await asyncio.sleep(0.005)

    asyncio.run(tell())


async def _begin_upload(address: str, session: str, sent: int, said: int) -> tuple[StreamReader, StreamWriter]:
    """An upload by the page of a session, of which so many bytes are sent and so many were said to come."""
    host, port = address.split(":")
    reader, writer = await asyncio.open_connection(host, int(port))
    head = f"POST /api/recordings/{session}?name=a.mcap HTTP/1.1\r\nHost: {address}\r\nContent-Length: {said}\r\n\r\n"
    writer.write(head.encode() + b"x" * sent)
    await writer.drain()
    return reader, writer


async def _status(reader: StreamReader) -> int:
    async with asyncio.timeout(PATIENCE):
        return int((await reader.readline()).split()[1])


async def _upload(address: str, session: str, size: int) -> int:
    """The status of a whole upload."""
    reader, writer = await _begin_upload(address, session, size, size)
    try:
        return await _status(reader)
    finally:
        writer.close()


def test_an_upload_that_never_ends_is_ended_and_leaves_nothing(config: Config, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(recordings, "UPLOAD_SECONDS", 0.05)

    async def tell() -> None:
        async with serving(config) as (address, service), opened(address) as page:
            session = (await page.op("hello"))["session"]
            reader, writer = await _begin_upload(address, session, 1000, 5000)
            assert await _status(reader) == 408
            writer.close()
            assert service.budgets.uploads.used == 0

    asyncio.run(tell())


def test_an_upload_that_breaks_off_leaves_nothing_and_prints_nothing(
    config: Config, capfd: pytest.CaptureFixture[str]
) -> None:
    async def tell() -> None:
        async with serving(config) as (address, service), opened(address) as page:
            session = (await page.op("hello"))["session"]
            _, writer = await _begin_upload(address, session, 1000, 5000)
            async with asyncio.timeout(PATIENCE):
                while service.budgets.uploads.used == 0:
                    await asyncio.sleep(0.005)
                writer.close()
                while service.budgets.uploads.used:
                    await asyncio.sleep(0.005)

    asyncio.run(tell())
    assert capfd.readouterr().err == ""


def test_uploads_have_a_total_for_a_client_and_for_all(config: Config) -> None:
    async def tell() -> None:
        async with serving(config) as (address, service), AsyncExitStack() as stack:
            space = service.budgets.uploads
            space.total, space.each = 250, 150
            sessions = []
            for place in (CROWD, CROWD, OTHER):
                page = await stack.enter_async_context(opened(address, local_addr=place))
                sessions.append((await page.op("hello"))["session"])
            assert await _upload(address, sessions[0], 100) == 200
            assert await _upload(address, sessions[1], 100) == 507
            assert await _upload(address, sessions[2], 140) == 200
            # A page's file takes the place of its last one, and goes with the page.
            assert await _upload(address, sessions[1], 11) == 507
            assert space.used == 240
        async with asyncio.timeout(PATIENCE):
            while space.used:
                await asyncio.sleep(0.005)

    asyncio.run(tell())
