"""A program drives a robot behind a rosbridge server: ours, whose robot is simulated."""

from __future__ import annotations

import asyncio
import json
import math
from typing import Any

import pytest

from rosy_sim.config import Config
from rosy_sim.robot import robot_address, run_on_robot
from rosy_sim.run import Order, Outcome
from rosy_sim.wire.robot import RealRobot
from rosy_sim.wire.topics import full_odometry
from rosy_sim.worker.blocking import BlockingWorker
from rosy_sim.world.events import Led, Say, Sound, Velocity

from .test_app import Page, opened, serving


def odometry(x: float, y: float, theta: float) -> str:
    return json.dumps({"op": "publish", "topic": "/odom", "msg": full_odometry((x, y, theta, 0.5, 0.1), 1.0, 7)})


def test_its_odometry_begins_at_the_origin() -> None:
    robot = RealRobot(1)
    first, second = (json.loads(robot.sensed(odometry(*pose)) or b"") for pose in ((3, 4, 1.0), (3, 5, 1.5)))
    assert first["msg"]["pose"]["pose"]["position"] == {"x": 0.0, "y": 0.0}
    place = second["msg"]["pose"]["pose"]["position"]
    assert (place["x"], place["y"]) == pytest.approx((math.sin(1.0), math.cos(1.0)))
    turn = second["msg"]["pose"]["pose"]["orientation"]
    assert 2 * math.atan2(turn["z"], turn["w"]) == pytest.approx(0.5)


@pytest.mark.parametrize(
    ("ros", "topic", "kind"),
    [(1, "/mobile_base/commands/led1", "kobuki_msgs/Led"), (2, "/commands/led1", "kobuki_ros_interfaces/msg/Led")],
)
def test_each_ros_has_its_names(ros: Any, topic: str, kind: str) -> None:
    robot = RealRobot(ros)
    assert {"op": "advertise", "topic": topic, "type": kind} in [json.loads(text) for text in robot.greetings()]
    assert json.loads(robot.command(Led(1, 2)) or "") == {"op": "publish", "topic": topic, "msg": {"value": 2}}
    assert robot.command(Say("hi")) is None
    assert json.loads(robot.command(Sound(4)) or "")["msg"] == {"value": 4}
    assert json.loads(robot.command(Velocity(0.5, -1.0)) or "")["msg"]["angular"]["z"] == -1.0


@pytest.mark.parametrize(
    "text", ["", "{", "[]", "7", '{"op":"publish"}', '{"op":"publish","topic":"/odom","msg":{}}', b"\xff"]
)
def test_what_is_no_sensor_message_is_passed_over(text: str | bytes) -> None:
    assert RealRobot(1).sensed(text) is None


def test_an_address_says_which_ros() -> None:
    assert robot_address("ws://r:9090") == ("ws://r:9090", 1)
    assert robot_address("ws://r:9090/x?ros=2") == ("ws://r:9090/x", 2)


def test_a_program_drives_a_robot_until_it_bumps_and_is_done(config: Config) -> None:
    said: list[str] = []

    def drive(address: str, source: str) -> Outcome:
        with BlockingWorker(config) as worker:
            worker.ready()
            return run_on_robot(worker, source, address, Order(3.0, 1), config.limits, said.append)

    async def tell() -> None:
        async with serving(config) as (address, _), opened(address) as page:
            hello = await page.op("hello")
            robot = f"ws://{address}/rosbridge/{hello['session']}"
            await page.send("input", teleport={"x": 4.7, "y": 2.0, "theta": 0.0})
            run = asyncio.create_task(asyncio.to_thread(drive, robot, "drive:0.5 bump led:2@3 say:hi@4 done@100"))
            await _sees(page)
            outcome = await run
            assert (outcome.ended, outcome.steps, said) == ("done", 100, ["hi"])
            for source, ended in (("error@3", "error"), ("close@3", "error"), ("refuse", "refused"), ("", "time")):
                assert (await asyncio.to_thread(drive, robot, source)).ended == ended

    asyncio.run(tell())


async def _sees(page: Page) -> None:
    """It lights up, bumps, backs off and stands."""
    await page.until(lambda m: m["op"] == "frame" and m["led1"] == 2)
    await page.until(lambda m: m["op"] == "frame" and m["bumpers"] == 2)
    await page.until(lambda m: m["op"] == "frame" and m["x"] < 4.6 and m["v"] < 0)
    await page.until(lambda m: m["op"] == "frame" and m["v"] == 0)
