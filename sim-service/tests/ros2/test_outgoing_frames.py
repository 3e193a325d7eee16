"""Frames that wait for a client that reads slowly."""

from __future__ import annotations

import asyncio
import json
from typing import Any

from rosy_sim.ros2.outgoing_frames import OutgoingFrames


async def all_of(frames: OutgoingFrames, count: int) -> list[dict[str, Any]]:
    return [json.loads(await frames.take()) for _ in range(count)]


def test_they_come_in_their_order() -> None:
    async def play() -> list[dict[str, Any]]:
        frames = OutgoingFrames()
        waiting = asyncio.create_task(all_of(frames, 3))
        await asyncio.sleep(0)
        for number in range(3):
            frames.put({"n": number})
        return await waiting

    assert asyncio.run(play()) == [{"n": 0}, {"n": 1}, {"n": 2}]


def test_who_reads_too_slowly_loses_the_oldest_and_is_told_once() -> None:
    async def play() -> list[dict[str, Any]]:
        frames = OutgoingFrames()
        found: list[dict[str, Any]] = []
        # It catches up in between.
        for _ in range(2):
            for number in range(2500):
                frames.put({"n": number})
            found += await all_of(frames, 1001)
            frames.put({"n": 0})
            found += await all_of(frames, 1)
            waiting = asyncio.create_task(frames.take())
            await asyncio.sleep(0)
            frames.put({"n": 1})
            found.append(json.loads(await waiting))
        return found

    kept = [{"n": number} for number in range(1500, 2500)]
    told, *found = asyncio.run(play())
    assert told["op"] == "status"
    assert found == [*kept, {"n": 0}, {"n": 1}, told, *kept, {"n": 0}, {"n": 1}]
