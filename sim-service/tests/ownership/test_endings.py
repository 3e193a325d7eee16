"""
However a drive ends, the robot stands: every way to a robot and the simulator, every cause, how long it took by the
robot's own clock. The times are printed as a table beside what is allowed, and not judged: this machine may be busy.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
import os
import signal
from collections.abc import AsyncIterator, Awaitable, Callable, Iterator
from contextlib import AbstractAsyncContextManager
from dataclasses import replace
from pathlib import Path

import pytest
from websockets.asyncio.client import connect

from rosy_sim.config import Config, discover
from rosy_sim.ownership.driver_locks import emergency_stop
from rosy_sim.web.sessions.page_session import PageSession

from ..conftest import PATIENCE, UNHURRIED
from ..processes import children
from ..web.page_client import Page, opened, serving
from .robot_rig import LIMIT, Rig, Robot, kobuki, rosbridge, rospy

Times = dict[str, dict[str, float]]


@pytest.fixture(scope="module")
def times(request: pytest.FixtureRequest) -> Iterator[Times]:
    """Cause, way and seconds; printed as a table when all is measured."""
    measured: Times = {}
    yield measured
    ways = list(dict.fromkeys(way for by_way in measured.values() for way in by_way))
    with request.config.pluginmanager.getplugin("capturemanager").global_and_fixture_disabled():
        print(f"\n{f'seconds until it stood (allowed: {LIMIT})':40}" + "".join(f"{way:>18}" for way in ways))
        for cause, by_way in measured.items():
            cells = [f"{by_way[way]:.2f}" if way in by_way else "" for way in ways]
            print(f"{cause:40}" + "".join(f"{cell:>18}" for cell in cells))


async def _program_fails(rig: Rig) -> None:
    """An exception in a function."""
    await rig.pressed()


async def _program_is_killed(rig: Rig) -> None:
    assert rig.service.worker.pid is not None
    [program] = children(rig.service.worker.pid)
    os.kill(program, signal.SIGKILL)


async def _page_is_closed(rig: Rig) -> None:
    await rig.page.socket.close()


async def _stop_is_pressed(rig: Rig) -> None:
    await rig.page.send("stop")


async def _emergency_stop_in_the_page(rig: Rig) -> None:
    await rig.page.send("estop")


async def _emergency_stop_elsewhere(rig: Rig) -> None:
    assert [d.process for d in emergency_stop(rig.robot.address)] == [rig.driver]


async def _driver_is_killed(rig: Rig) -> None:
    os.kill(rig.driver, signal.SIGKILL)


async def _driver_is_asked_to_end(rig: Rig) -> None:
    os.kill(rig.driver, signal.SIGTERM)


async def _cable_is_pulled(rig: Rig) -> None:
    await rig.robot.unplugged(rig.driver)


HAPPENINGS: list[tuple[Callable[[Rig], Awaitable[None]], str]] = [
    (_program_is_killed, "drive:0.2"),
    (_program_fails, "drive:0.2 error@touch"),
    (_page_is_closed, "drive:0.2"),
    (Rig.looks_away, "drive:0.2"),
    (_stop_is_pressed, "drive:0.2"),
    (_emergency_stop_in_the_page, "drive:0.2"),
    (_emergency_stop_elsewhere, "drive:0.2"),
    (_driver_is_killed, "drive:0.2"),
    (_driver_is_asked_to_end, "drive:0.2"),
    (_cable_is_pulled, "drive:0.2"),
]

WAYS: dict[str, Callable[[Path], AbstractAsyncContextManager[Robot]]] = {
    "serial": kobuki,
    "rosbridge": rosbridge,
    "ROS 1": rospy,
}


def named(happening: Callable[[Rig], Awaitable[None]]) -> str:
    return happening.__name__.strip("_").replace("_", " ")


@pytest.mark.long
@pytest.mark.skipif(discover().robot_executable is None, reason="rosy-robot is not built")
@pytest.mark.parametrize("way", WAYS)
def test_a_real_robot_stands(way: str, config: Config, tmp_path: Path, times: Times) -> None:
    async def play() -> None:
        async with WAYS[way](tmp_path) as robot:
            robots = replace(config, robots={"Kitchen": robot.address}, robot_executable=discover().robot_executable)
            async with serving(robots) as (address, service):
                for happening, script in HAPPENINGS:
                    async with opened(address) as page:
                        rig = Rig(address, service, page, robot)
                        await rig.takes()
                        await rig.drives(script)
                        driver = rig.driver
                        await robot.marked()
                        await happening(rig)
                        times.setdefault(named(happening), {})[way] = await robot.stands()
                        robot.released()
                        if happening is _cable_is_pulled:
                            await robot.plugged(driver)

    asyncio.run(play())


class Simulated:
    """A robot in the simulator, with its own clock."""

    def __init__(self, page: Page, session: PageSession) -> None:
        self.page = page
        self.session = session

    @property
    def time(self) -> float:
        """Seconds that its world has moved on."""
        return self.session.simulator.steps / 50

    async def drives(self) -> None:
        await self.page.until(lambda m: m["op"] == "frame" and m["channels"]["Velocity"][0] > 0.19)

    async def stands(self) -> None:
        """It is slower than its command: it has been told to stand."""
        async with asyncio.timeout(PATIENCE):
            while self.session.world.v > 0.19 and not self.session.closed.is_set():
                await asyncio.sleep(0.001)


@contextlib.asynccontextmanager
async def simulated(config: Config) -> AsyncIterator[tuple[Simulated, Rig]]:
    async with serving(config) as (address, service), opened(address) as page:
        hello = await page.op("hello")
        session = service.sessions[hello["session"]]
        yield Simulated(page, session), Rig(address, service, page)


IN_THE_SIMULATOR = [_program_is_killed, _program_fails, _page_is_closed, _stop_is_pressed]


@pytest.mark.parametrize(("happening", "script"), [h for h in HAPPENINGS if h[0] in IN_THE_SIMULATOR])
def test_the_simulated_robot_stands(
    happening: Callable[[Rig], Awaitable[None]], script: str, config: Config, times: Times
) -> None:
    async def play() -> None:
        async with simulated(config) as (robot, rig):
            await robot.page.send("run", run=1, source=script, speed=1)
            await robot.drives()
            before = robot.time
            await happening(rig)
            await robot.stands()
            times.setdefault(named(happening), {})["simulator"] = robot.time - before

    asyncio.run(play())


@pytest.mark.parametrize("closed", [False, True], ids=["cable is pulled", "connection is lost"])
def test_the_simulated_robot_stands_without_its_ros_client(closed: bool, config: Config, times: Times) -> None:
    """Its own watchdog, which is kobuki_node's, stops it."""

    async def play() -> None:
        async with simulated(config) as (robot, rig):
            path = f"ws://{rig.address}/rosbridge/{robot.session.id}"
            twist = {"linear": {"x": 0.2}, "angular": {"z": 0.0}}
            message = {"op": "publish", "topic": "/mobile_base/commands/velocity", "msg": twist}
            async with connect(path, max_queue=None, **UNHURRIED) as client:
                await client.send('{"op":"subscribe","topic":"/odom"}')
                await client.send(json.dumps(message))
                await robot.drives()
                await client.send(json.dumps(message))
                await client.recv()
                before = robot.time
                if closed:
                    await client.close()
                await robot.stands()
            cause = "connection is lost" if closed else named(_cable_is_pulled)
            times.setdefault(cause, {})["simulator"] = robot.time - before

    asyncio.run(play())
