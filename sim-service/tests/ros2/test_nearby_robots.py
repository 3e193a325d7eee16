"""Robots nearby: discovered from bases that speak Fast DDS, listed by a command and by the page, and taken there."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Sequence
from dataclasses import replace

import msgspec
import pytest

from rosy_sim.cli.robots_command import list_robots
from rosy_sim.config import Config, discover
from rosy_sim.errors import BadInput, RobotMissing
from rosy_sim.ownership.robot_configuration import read_nearby_addresses
from rosy_sim.ownership.robot_registry import RobotRegistry
from rosy_sim.ros2.battery import Battery
from rosy_sim.ros2.nearby_robots import NearbyRobot

from ..conftest import PATIENCE
from ..web.page_client import opened, serving
from .bases import base, place
from .fast_dds import free_domain

SPEAKER = discover().robot_executable

pytestmark = pytest.mark.skipif(SPEAKER is None, reason="rosy-robot is not built")


def test_the_command_prints_each_robot_with_its_address_and_battery(capsys: pytest.CaptureFixture[str]) -> None:
    def is_enough(robots: Sequence[NearbyRobot]) -> bool:
        return len(robots) == 2 and robots[1].battery.charge is not None

    with place("DDS") as where, base(where, "", "kobuki"), base(where, "/lab", "turtlebot3", "best_effort"):
        assert list_robots(SPEAKER, [where.address], PATIENCE, print, is_enough) == 0
    assert capsys.readouterr().out == f"Kobuki       {where.address}\nTurtleBot 3  {where.address}/lab  87 %\n"


def test_a_robot_over_zenoh_is_listed_at_its_router(capsys: pytest.CaptureFixture[str]) -> None:
    def is_enough(robots: Sequence[NearbyRobot]) -> bool:
        return any(robot.battery.charge is not None for robot in robots)

    with place("Zenoh") as where, base(where, "/lab", "turtlebot3"):
        assert list_robots(SPEAKER, [where.address], PATIENCE, print, is_enough) == 0
    assert capsys.readouterr().out == f"TurtleBot 3  {where.address}/lab  Zenoh  87 %\n"


def test_two_robots_on_one_router_with_the_same_topics_are_said_to_be_two(capsys: pytest.CaptureFixture[str]) -> None:
    def is_enough(robots: Sequence[NearbyRobot]) -> bool:
        return any(robot.several for robot in robots) and len(robots) == 2

    with (
        place("Zenoh") as where,
        base(where, "/lab", "turtlebot3"),
        base(where, "/lab", "turtlebot3", "no_router"),
        base(where, "/hall", "turtlebot3", "no_router"),
    ):
        assert list_robots(SPEAKER, [where.address], PATIENCE, print, is_enough) == 0
    *rows, said = capsys.readouterr().out.splitlines()
    assert [row.split()[2] for row in rows] == [f"{where.address}/hall", f"{where.address}/lab"]
    assert said.startswith(f"Several robots answer on the same topics at {where.address}/lab, ")
    assert said.endswith("give each a namespace.")


def test_where_no_robot_is_the_command_says_so() -> None:
    with free_domain() as domain, pytest.raises(RobotMissing, match=f"No robot is found at ros2:{domain}:"):
        list_robots(SPEAKER, [f"ros2:{domain}"], 0.0, print)
    with pytest.raises(BadInput, match="ws://pi is none"):
        list_robots(SPEAKER, ["ws://pi"], 0.0, print)
    with pytest.raises(BadInput, match="999"):
        list_robots(SPEAKER, ["ros2:999"], 0.0, print)


def test_an_address_without_a_name_means_all_robots_there() -> None:
    given = ["ros2:?rearm=off", "Lab=ros2:7", "ros2:30/lab", "Pi=ws://pi"]
    assert read_nearby_addresses(SPEAKER, given) == (["Lab=ros2:7", "Pi=ws://pi"], ("ros2:?rearm=off", "ros2:30/lab"))
    with pytest.raises(BadInput, match="999"):
        read_nearby_addresses(SPEAKER, ["ros2:999"])


def test_a_page_that_knows_the_code_takes_a_robot_that_was_found(config: Config) -> None:
    async def play(domain: int) -> None:
        places = replace(config, nearby=(f"ros2:{domain}?rearm=off",), robot_executable=SPEAKER)
        async with serving(places) as (address, service), opened(address) as page:
            assert (await page.op("robots"))["robots"] == []
            await page.send("unlock", code=service.robots.code)
            async with asyncio.timeout(PATIENCE):
                while (found := await page.op("robots", locked=False))["robots"] == []:
                    continue
            assert found["discovers"]
            assert found["robots"][0].items() >= {"name": "lab", "holder": None, "yours": False}.items()
            assert found["robots"][0]["nearby"].items() >= {"title": "TurtleBot 3", "domain": domain}.items()
            await page.send("take", robot="lab", who="Anna")
            await page.op("robot", link="connected")

    with place("DDS") as where, base(where, "/lab", "turtlebot3", "stamped"):
        asyncio.run(play(where.domain))


def nearby(bare: str, title: str = "TurtleBot 3", battery: Battery = Battery()) -> NearbyRobot:  # noqa: B008
    name = bare.partition("/")[2]
    return NearbyRobot(title, name, 0, bare, f"{bare}?robot=turtlebot3", battery)


def registry(addresses: dict[str, str]) -> RobotRegistry:
    return RobotRegistry(addresses, None, time.monotonic, lambda: None, discovers=True)


def names(robots: RobotRegistry, session: str = "page") -> list[str]:
    return [robot.name for robot in robots.robots_for(session)]


def test_robots_of_one_name_are_told_apart_and_keep_their_names() -> None:
    robots = registry({"TurtleBot 4": "ws://pi", "Lab": "ros2:0/lab?rearm=off"})
    assert names(robots) == ["TurtleBot 4", "Lab"]
    one, two, three = nearby("ros2:0"), nearby("ros2:1"), nearby("ros2:1/a", "TurtleBot 4")
    robots.set_nearby([one, two, nearby("ros2:0@10.0.0.5", "TurtleBot 4"), three])
    known = ["TurtleBot 3", "TurtleBot 3 (ros2:1)", "TurtleBot 4 (ros2:0@10.0.0.5)", "a"]
    assert names(robots) == ["TurtleBot 4", "Lab", *known]
    assert robots.acquire("TurtleBot 3 (ros2:1)", "page", "Anna") == "ros2:1?robot=turtlebot3"
    robots.release("TurtleBot 3 (ros2:1)", "page")
    robots.set_nearby([two])
    assert names(robots) == ["TurtleBot 4", "Lab", "TurtleBot 3 (ros2:1)"]
    with pytest.raises(BadInput, match="no robot called TurtleBot 3"):
        robots.acquire("TurtleBot 3", "page", "Anna")


def test_a_robot_that_has_a_name_already_is_listed_once_with_what_is_found() -> None:
    robots = registry({"Lab": "ros2:0/lab?rearm=off"})
    robots.set_nearby(
        [msgspec.structs.replace(nearby("ros2:0/lab", battery=Battery(87, 11.9)), zenoh=True, several=True)]
    )
    [robot] = robots.robots_for("page")
    assert robot.name == "Lab"
    assert robot.nearby is not None
    assert (robot.nearby.title, robot.nearby.charge, robot.nearby.volts) == ("TurtleBot 3", 87, 11.9)
    assert robot.nearby.zenoh
    assert robot.nearby.several
    assert robots.acquire("Lab", "page", "Anna") == "ros2:0/lab?rearm=off"


def test_a_robot_that_is_gone_stays_in_the_list_of_its_owner() -> None:
    robots = registry({})
    robots.set_nearby([nearby("ros2:0")])
    robots.acquire("TurtleBot 3", "page", "Anna")
    robots.set_nearby([])
    assert [(robot.name, robot.yours, robot.nearby) for robot in robots.robots_for("page")] == [
        ("TurtleBot 3", True, None)
    ]
    with pytest.raises(BadInput, match="Anna has TurtleBot 3"):
        robots.acquire("TurtleBot 3", "other", "Ben")
    robots.release("TurtleBot 3", "page")
    assert names(robots) == []
