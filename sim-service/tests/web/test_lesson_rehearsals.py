"""Rehearsals of a lesson: a verdict per attempt, a cancellation that leaves nothing, and bad requests."""

from __future__ import annotations

import asyncio
import json
import os
from typing import Any

import pytest
from websockets.asyncio.client import connect

from rosy_sim.config import Config

from ..conftest import PATIENCE, UNHURRIED
from ..processes import await_end, below, command_of
from .page_client import opened, serving
from .test_room_tests import Message, session_of, wait_for

ROOM: Message = {"size": [6, 4], "start": {"x": 1, "y": 2}}
STEP: Message = {"seconds": 4, "checks": [{"kind": "moves", "id": "far", "metres": 1}]}
AT: Message = {"kind": "at", "id": "x", "time": 1, "goal": 0}
"""A check about a place, of which the room has none."""
REQUEST: Message = {"op": "rehearse", "world": ROOM, "attempts": [{"source": "drive:0.5", "step": STEP}]}


async def answers(address: str, session: str, request: Message) -> list[Message]:
    """All that the service says about the attempts."""
    url = f"ws://{address}/api/lesson-rehearsals/{session}"
    async with asyncio.timeout(PATIENCE), connect(url, **UNHURRIED) as socket:
        await socket.send(json.dumps(request))
        return [json.loads(text) async for text in socket]


def asked(config: Config, **changed: Any) -> list[Message]:
    async def play() -> list[Message]:
        async with serving(config) as (address, _), opened(address) as page:
            return await answers(address, await session_of(page), {**REQUEST, **changed})

    return asyncio.run(play())


def rehearsal_processes() -> set[int]:
    owners = {pid for pid in below(os.getpid()) if "rosy_sim.lessons" in command_of(pid)}
    return owners.union(*(below(pid) for pid in owners))


def test_each_attempt_is_judged_in_its_order(config: Config) -> None:
    sources = ["drive:0.5", "drive:0.1", "refuse"]
    far, near, refused = asked(config, attempts=[{"source": source, "step": STEP} for source in sources])
    assert [did["number"] for did in (far, near, refused)] == [0, 1, 2]
    assert (far["passed"], far["checks"]) == (True, [{"id": "far", "state": "done"}])
    assert not near["passed"]
    [missed] = near["checks"]
    assert (missed["state"], missed["seen"]["what"]) == ("missed", "drove")
    assert (refused["passed"], refused["ended"], len(refused["problems"])) == (False, "refused", 1)


@pytest.mark.parametrize(
    "changed",
    [
        {"op": "test"}, {"world": {}}, {"attempts": []}, {"attempts": [{"source": 7, "step": STEP}]},
        {"attempts": [{"source": "x" * 200_001, "step": STEP}]}, {"attempts": [{"source": "", "step": {"seconds": 0}}]},
        {"attempts": [{"source": "", "step": {"seconds": 1, "checks": [AT]}}]},
    ],
)  # fmt: skip
def test_a_bad_request_is_refused_with_a_sentence(changed: Message, config: Config) -> None:
    [answer] = asked(config, **changed)
    assert answer["op"] == "failed"
    assert answer["message"]


def test_rehearsals_end_with_their_socket_and_leave_nothing(config: Config) -> None:
    hanging = {**REQUEST, "attempts": [{"source": "mute", "step": STEP}]}

    async def play() -> None:
        async with serving(config) as (address, service), opened(address) as page:
            session = await session_of(page)
            async with connect(f"ws://{address}/api/lesson-rehearsals/{session}", **UNHURRIED) as socket:
                await socket.send(json.dumps(hanging))
                await asyncio.to_thread(wait_for, lambda: len(rehearsal_processes()) >= 3)
                seen = rehearsal_processes()
                [refusal] = await answers(address, session, REQUEST)
                assert refusal["op"] == "failed"
            await asyncio.to_thread(wait_for, lambda: not service.lesson_rehearsals.is_busy)
            await asyncio.to_thread(await_end, seen, PATIENCE)

    asyncio.run(play())
