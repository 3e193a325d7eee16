"""The paper's programs, from their files in ``examples``, drive a base on a real ROS 1, from the page."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable
from dataclasses import replace
from pathlib import Path

import pytest

from rosy_sim.config import discover

from ..ownership.robot_rig import Rig, Robot, rospy
from ..web.page_client import opened, serving
from .real_runs import LIMITS, program

pytestmark = [
    pytest.mark.real,
    pytest.mark.skipif(not discover().worker, reason="the worker is not built"),
    pytest.mark.skipif(discover().robot_executable is None, reason="rosy-robot is not built"),
]


async def drives(robot: Robot, linear: float, angular: float = 0.0) -> None:
    """The base is told this velocity."""
    twist = f'{{"linear": {{"x": {linear}, "y": 0.0, "z": 0.0}}, "angular": {{"x": 0.0, "y": 0.0, "z": {angular}}}}}'
    await robot.begins(f"got /mobile_base/commands/velocity {twist}")


def feels(robot: Robot, event: str, which: str, state: int) -> None:
    more = ', "bottom": 0' if event == "cliff" else ""
    robot.ask("send", f"/mobile_base/events/{event}", f'{{{which}, "state": {state}{more}}}')


async def accelerate(robot: Robot) -> None:
    await drives(robot, 0.5)


async def accelerate_and_play(robot: Robot) -> None:
    await drives(robot, 0.5)
    feels(robot, "bumper", '"bumper": 1', 1)
    await robot.begins('got /mobile_base/commands/sound {"value": 4}')


async def forward_backward(robot: Robot) -> None:
    await drives(robot, 0.5)
    feels(robot, "bumper", '"bumper": 1', 1)
    await drives(robot, -0.5)


async def safety_control(robot: Robot) -> None:
    await drives(robot, 0.2)
    feels(robot, "cliff", '"sensor": 0', 1)
    await drives(robot, -0.1, -0.4)


async def mux(robot: Robot) -> None:
    await drives(robot, 0.2, 0.2)
    feels(robot, "button", '"button": 0', 1)
    await drives(robot, 0.0, 1.0)
    await drives(robot, 0.2, 0.2)


async def random_walk(robot: Robot) -> None:
    await drives(robot, 0.5)
    feels(robot, "bumper", '"bumper": 1', 1)
    await robot.begins('got /mobile_base/commands/led1 {"value": 2}')
    await robot.says(lambda line: '{"linear": {"x": 0.0, ' in line and line.endswith(('"z": 1.0}}', '"z": -1.0}}')))


async def draw_square(robot: Robot) -> None:
    await drives(robot, 0.2)
    robot.ask("send", "/odom", '{"pose": {"pose": {"position": {"x": 0.6}, "orientation": {"w": 1.0}}}}')
    await drives(robot, 0.0, 0.5)


STORIES: dict[str, Callable[[Robot], Awaitable[None]]] = {
    "accelerate": accelerate,
    "accelerateAndPlay": accelerate_and_play,
    "forwardBackward": forward_backward,
    "safetyControl": safety_control,
    "mux": mux,
    "randomWalk": random_walk,
    "drawSquare": draw_square,
}


def test_the_papers_programs_drive_a_base_on_ros(tmp_path: Path) -> None:
    async def play() -> None:
        async with rospy(tmp_path) as robot:
            for event in ("cliff", "button"):
                robot.ask("pub", f"/mobile_base/events/{event}", f"kobuki_msgs/{event.capitalize()}Event")
            robot.ask("sub", "/mobile_base/commands/sound", "kobuki_msgs/Sound")
            robot.ask("sub", "/mobile_base/commands/led1", "kobuki_msgs/Led")
            config = replace(discover().with_limits(LIMITS), robots={"Kitchen": robot.address})
            async with serving(config) as (address, service), opened(address) as page:
                rig = Rig(address, service, page, robot)
                await rig.takes()
                for topic in ("bumper", "cliff", "button"):
                    robot.ask("connected", f"/mobile_base/events/{topic}", "1")
                    await robot.begins(f"connected /mobile_base/events/{topic}")
                rig.looks()
                for run, (name, tell) in enumerate(STORIES.items(), 1):
                    await page.send("run", run=run, source=program(name)[0], speed=1)
                    await tell(robot)
                    await page.send("stop")
                    ended = await page.ended(run)
                    assert (ended["ended"], ended["problems"]) == ("stopped", []), name
                    await drives(robot, 0.0)

    asyncio.run(play())
