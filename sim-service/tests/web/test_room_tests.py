"""Tests in many rooms for pages: a report, a cancellation that leaves nothing, one at a time, and bad requests."""

from __future__ import annotations

import asyncio
import json
import os
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from typing import Any

import pytest
from websockets.asyncio.client import ClientConnection, connect
from websockets.exceptions import InvalidStatus

from rosy_sim.config import Config
from rosy_sim.worlds.gallery import named_world

from ..conftest import PATIENCE, UNHURRIED
from ..processes import await_end, below, command_of
from .page_client import Page, opened, serving

Message = dict[str, Any]

REQUEST: Message = {
    "op": "test", "source": "drive:0.5", "family": "obstacles", "rooms": 3, "seed": 1, "seconds": 12,
    "properties": "never-pushes 1 s",
}  # fmt: skip


@asynccontextmanager
async def socket_of(address: str, session: str) -> AsyncIterator[ClientConnection]:
    async with connect(f"ws://{address}/api/room-tests/{session}", **UNHURRIED) as socket:
        yield socket


async def session_of(page: Page) -> str:
    return str((await page.op("hello"))["session"])


async def answers(address: str, session: str, **changed: Any) -> list[Message]:
    """All that the service says about a test."""
    async with asyncio.timeout(PATIENCE), socket_of(address, session) as socket:
        await socket.send(json.dumps({**REQUEST, **changed}))
        return [json.loads(text) async for text in socket]


def trial_processes() -> set[int]:
    """The trial processes of this test, with their workers and programs."""
    owners = {pid for pid in below(os.getpid()) if "rosy_sim.rooms" in command_of(pid)}
    return owners.union(*(below(pid) for pid in owners))


def wait_for(condition: Callable[[], bool]) -> None:
    while not condition():
        os.sched_yield()


def asked(config: Config, **changed: Any) -> list[Message]:
    async def play() -> list[Message]:
        async with serving(config) as (address, _), opened(address) as page:
            return await answers(address, await session_of(page), **changed)

    return asyncio.run(play())


def test_a_page_gets_all_rooms_worst_first_and_the_smallest(config: Config) -> None:
    *before, report = asked(config)
    assert {message["op"] for message in before} <= {"progress"}
    assert report["op"] == "report"
    assert [room["passed"] for room in report["rooms"]] == [False] * 3
    assert report["passed"] == 0
    for room in report["rooms"]:
        assert room["world"]["goals"]
        assert 2 <= len(room["path"]) <= 81
        [finding] = room["findings"]
        assert (finding["property"], finding["state"]) == ("never-pushes 1 s", "failed")
    smallest = report["smallest"]
    assert (smallest["things"], smallest["minimal"]) == (0, True)
    assert smallest["tested"]["world"]["boxes"] == []


def test_rooms_like_the_one_of_the_page(config: Config) -> None:
    *_, report = asked(config, family="like", world=named_world("pits"), source="done@1", properties="never-falls")
    assert (report["op"], report["passed"], report["smallest"]) == ("report", 3, None)


def test_a_program_that_does_not_compile_is_reported(config: Config) -> None:
    *_, report = asked(config, source="refuse")
    assert (report["op"], report["rooms"], len(report["problems"])) == ("report", [], 1)


@pytest.mark.parametrize(
    "changed",
    [
        {"op": "run"}, {"rooms": 0}, {"rooms": 201}, {"seconds": 0}, {"seconds": 1e9}, {"family": "caves"},
        {"properties": "flies"}, {"properties": ""}, {"source": 7}, {"family": "like"}, {"family": "like", "world": {}},
        {"source": "x" * 200_001},
    ],
)  # fmt: skip
def test_a_bad_request_is_refused_with_a_sentence(changed: Message, config: Config) -> None:
    [answer] = asked(config, **changed)
    assert answer["op"] == "failed"
    assert answer["message"]


def test_a_test_ends_with_its_socket_or_its_page_and_leaves_nothing(config: Config) -> None:
    async def play() -> None:
        async with serving(config) as (address, service):
            for leaves in ("socket", "page"):
                async with opened(address) as page:
                    session = await session_of(page)
                    async with socket_of(address, session) as socket:
                        # A program that hangs: the test would last for a minute.
                        await socket.send(json.dumps({**REQUEST, "source": "hang@5"}))
                        await asyncio.to_thread(wait_for, lambda: len(trial_processes()) >= 3)
                        seen = trial_processes()
                        # A page makes one test at a time.
                        [refusal] = await answers(address, session)
                        assert refusal["op"] == "failed"
                        if leaves == "page":
                            await page.socket.close()
                            assert [text async for text in socket] == []
                await asyncio.to_thread(wait_for, lambda: not service.room_tests.is_busy)
                await asyncio.to_thread(await_end, seen, PATIENCE)

    asyncio.run(play())


def test_only_pages_may_ask(config: Config) -> None:
    async def play() -> None:
        async with serving(config) as (address, _):
            with pytest.raises(InvalidStatus):
                async with socket_of(address, "nobody"):
                    raise AssertionError("it was opened")

    asyncio.run(play())
