"""A program on a real robot, and the same program in the simulator beside it."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from contextlib import AbstractAsyncContextManager
from pathlib import Path
from typing import Any

import pytest

from rosy_sim.config import Config, discover

from ..conftest import PATIENCE
from .robot_rig import Rig, Robot, rosbridge, rospy
from .test_robot_ownership import story

pytestmark = pytest.mark.skipif(discover().robot_executable is None, reason="rosy-robot is not built")

START = (1.5, 2.0, 0.0)
"""Of the usual room."""

REAL, TWIN = 1, 2


def frames(rig: Rig, run: int) -> list[dict[str, Any]]:
    return [message for message in rig.page.seen if message["op"] == "frame" and message["run"] == run]


def pose(frame: dict[str, Any]) -> tuple[float, float, float]:
    return frame["pose"]["x"], frame["pose"]["y"], frame["pose"]["theta"]


async def driven_beside(rig: Rig, source: str, real: int = REAL, twin: int = TWIN) -> None:
    """Both runs from their begin to their end."""
    rig.looks()
    await rig.page.send("run", run=real, twin=twin, source=source, seed=1, speed=1)
    await both_end(rig, real, twin)


async def both_end(rig: Rig, real: int, twin: int) -> None:
    """A busy machine may lose the robot for a moment, so how they end is not told."""
    async with asyncio.timeout(PATIENCE):
        await rig.page.all_of(*({"op": "state", "state": "ended", "run": run} for run in (real, twin)))


def test_both_drive_from_the_start_of_the_room_for_the_same_time(config: Config, tmp_path: Path) -> None:
    async def tell(rig: Rig) -> None:
        await rig.takes()
        await driven_beside(rig, "drive:0.2 done@100")
        real, twin = frames(rig, REAL), frames(rig, TWIN)
        assert pose(real[0]) == pytest.approx(START, abs=0.02)
        assert pose(twin[0]) == pytest.approx(START, abs=0.001)
        assert pose(real[-1])[0] > START[0] + 0.1
        # The twin accelerates; 20 cm/s for some 2 s.
        assert pose(twin[-1])[0] > START[0] + 0.1
        assert twin[-1]["time"] <= real[-1]["time"] + 0.1
        assert [frame["time"] for frame in real] == sorted(frame["time"] for frame in real)

    story(tell, config, tmp_path)


def test_both_answer_why(config: Config, tmp_path: Path) -> None:
    async def tell(rig: Rig) -> None:
        await rig.takes()
        await rig.page.send("observe", on=True)
        await driven_beside(rig, "drive:0.2 tell done@50")
        for run in (REAL, TWIN):
            await rig.page.send("why", id=run, run=run, function="f", time=frames(rig, run)[-1]["time"])
            answer = await rig.page.op("because", id=run)
            assert answer["sentences"][0]["said"]["id"] == "gave"
        # A question without a number is about the robot.
        await rig.page.send("why", id=3)
        assert (await rig.page.op("because", id=3))["sentences"][0]["said"]["id"] != "not-recorded"

    story(tell, config, tmp_path)


@pytest.mark.parametrize("link", [rosbridge, rospy])
def test_the_twin_drives_beside_a_robot_on_a_network(
    config: Config, tmp_path: Path, link: Callable[[Path], AbstractAsyncContextManager[Robot]]
) -> None:
    """These stand-ins report no motion, so only the simulated robot moves."""

    async def tell(rig: Rig) -> None:
        await rig.takes()
        rig.looks()
        await rig.page.send("run", run=REAL, twin=TWIN, source="drive:0.2", seed=1, speed=1)
        # Whichever comes first: both are under way at the same time.
        await rig.page.until(lambda m: m["op"] == "frame" and m["run"] == TWIN and pose(m)[0] > START[0] + 0.1)
        await rig.robot.moves(0.2)
        await rig.page.until(lambda m: m["op"] == "frame" and m["run"] == REAL)
        await rig.page.send("stop")
        await both_end(rig, REAL, TWIN)
        real, twin = frames(rig, REAL), frames(rig, TWIN)
        assert pose(real[-1]) == pytest.approx(START, abs=0.001)
        assert pose(twin[-1])[0] > START[0] + 0.1
        assert twin[-1]["time"] <= real[-1]["time"] + 0.1

    story(tell, config, tmp_path, link=link)


def test_a_robot_that_slips_stays_behind_its_twin(config: Config, tmp_path: Path) -> None:
    async def tell(rig: Rig) -> None:
        await rig.takes()
        rig.robot.ask("slip", "0.5", "1", "0")
        await driven_beside(rig, "drive:0.4 done@100")
        time = frames(rig, TWIN)[-1]["time"]
        real = [frame for frame in frames(rig, REAL) if frame["time"] <= time][-1]
        ways = [pose(frame)[0] - START[0] for frame in (real, frames(rig, TWIN)[-1])]
        assert ways[0] < 0.75 * ways[1]

    story(tell, config, tmp_path)


def test_another_run_without_a_twin_starts_at_the_origin_and_shows_nothing_of_the_run_before(
    config: Config, tmp_path: Path
) -> None:
    async def tell(rig: Rig) -> None:
        await rig.takes()
        await driven_beside(rig, "drive:0.2 done@50")
        await rig.page.send("run", run=3, source="drive:0.2 done@50", speed=1)
        assert (await rig.page.ended(3))["ended"] == "done"
        alone = frames(rig, 3)
        assert pose(alone[0]) == pytest.approx((0.0, 0.0, 0.0), abs=0.02)
        assert [frame["time"] for frame in alone] == sorted(frame["time"] for frame in alone)

    story(tell, config, tmp_path)


def test_the_twin_ends_with_the_run_whatever_ends_it(config: Config, tmp_path: Path) -> None:
    async def tell(rig: Rig) -> None:
        await rig.takes()
        rig.looks()
        for number, op in enumerate(("stop", "estop")):
            real, twin = 10 * number + 1, 10 * number + 2
            await rig.page.send("run", run=real, twin=twin, source="drive:0.2", seed=1, speed=1)
            await rig.page.op("state", run=twin, state="running")
            await rig.robot.moves(0.2)
            await rig.page.send(op)
            await both_end(rig, real, twin)
            await rig.page.send("free")

    story(tell, config, tmp_path)


def test_a_program_that_is_refused_has_no_twin(config: Config, tmp_path: Path) -> None:
    async def tell(rig: Rig) -> None:
        await rig.takes()
        await rig.page.send("run", run=REAL, twin=TWIN, source="refuse", speed=1)
        await rig.page.ended(REAL)
        await rig.page.send("reset")
        await rig.page.op("world")
        assert not [m for m in rig.page.seen if m.get("run") == TWIN]

    story(tell, config, tmp_path)


def test_only_a_real_robot_has_a_twin(config: Config, tmp_path: Path) -> None:
    async def tell(rig: Rig) -> None:
        await rig.page.send("run", run=REAL, twin=TWIN, source="drive:0.2 done@20", speed=1)
        await rig.page.ended(REAL)
        assert not frames(rig, TWIN)

    story(tell, config, tmp_path)
