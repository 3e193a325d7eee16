"""TurtleBot 3 Burger in the simulator: what it has, what it lacks, and how fast it is."""

from __future__ import annotations

import pytest

from rosy_sim.errors import BadInput
from rosy_sim.robot_description import description
from rosy_sim.robots import ROBOTS, robot_in
from rosy_sim.run.problems import missing_parts
from rosy_sim.world.arena import ArenaError, read_arena
from rosy_sim.world.events import Press, Reading, velocity
from rosy_sim.world.world import World
from rosy_sim.worlds.gallery import usable_arena


def world(robot: str | None = "turtlebot3", **room: object) -> World:
    size = {} if "tiles" in room else {"size": [8, 4]}
    named = {} if robot is None else {"robot": robot}
    arena = read_arena({**size, "start": {"x": 2, "y": 2}, **room, **named})
    return World(arena, robot_in(arena))


def driven(at: World, linear: float, angular: float, steps: int) -> list[Reading]:
    events: list[Reading] = []
    for _ in range(steps):
        events += at.sense()
        at.command(velocity(linear, angular))
        at.integrate()
    return events


def test_a_room_names_its_robot_and_one_without_a_name_has_the_first_of_the_registry() -> None:
    assert world().robot is ROBOTS["turtlebot3"]
    assert world(None).robot is ROBOTS["kobuki"]


def test_a_robot_that_the_simulator_does_not_have_is_refused_with_those_that_it_has() -> None:
    with pytest.raises(ArenaError, match=r"no robot 'turtle'; it has kobuki .*, turtlebot3"):
        world("turtle")
    with pytest.raises(BadInput, match="must be text"):
        usable_arena({"size": [4, 4], "start": {"x": 2, "y": 2}, "robot": 3}, "This")


def test_each_robot_of_the_simulator_has_the_channels_that_it_reports_in_its_description() -> None:
    for name, robot in ROBOTS.items():
        arena = read_arena({"size": [8, 4], "start": {"x": 2, "y": 2}, "robot": name})
        reported = set(World(arena, robot).channels())
        assert reported <= {channel["name"] for channel in description(name)["channels"]}


@pytest.mark.parametrize(
    ("linear", "angular", "reached"),
    [(1.0, 0.0, (0.22, 0.0)), (0.0, 9.0, (0.0, 2.84)), (0.2, 2.0, (0.1481, 1.4817))],
)
def test_its_speed_ends_at_the_limits_of_the_burger(
    linear: float, angular: float, reached: tuple[float, float]
) -> None:
    at = world()
    driven(at, linear, angular, 60)
    assert (at.v, at.w) == pytest.approx(reached, abs=1e-3)


def test_it_stops_half_a_second_after_the_last_command() -> None:
    at = world()
    driven(at, 0.2, 0.0, 20)
    moving = 0
    while at.v > 0:
        at.integrate()
        moving += 1
    # 0.5 s are 25 steps; 2.5 m/s² stop 0.2 m/s in 4 more.
    assert moving == 29


def test_its_scanner_is_behind_the_middle_and_sees_360_directions_up_to_three_and_a_half_metres() -> None:
    at = world()
    at.listen("program", ["Scan", "Ahead"])
    ahead, scan, *_ = at.sense()
    first, step, nearest, farthest, *distances = scan.values
    assert (ahead.channel, ahead.values) == ("Ahead", (3.5,))
    assert (first, nearest, farthest, len(distances)) == (0.0, 0.12, 3.5, 360)
    assert step == pytest.approx(0.0174533)
    # The wall behind is 2 m away from the middle, the walls beside it too.
    assert (distances[0], distances[180], distances[90]) == (3.5, 1.968, 2.0)


def test_a_thing_nearer_than_the_scanner_can_measure_is_at_its_shortest_distance() -> None:
    at = world(rounds=[{"x": 2.16, "y": 2, "r": 0.05}])
    at.listen("program", ["Scan"])
    [scan, *_] = (reading for reading in at.sense() if reading.channel == "Scan")
    # 0.16 m less the radius of the post, and 0.032 m that the scanner is behind the middle.
    assert scan.values[4] == 0.142
    at = world(rounds=[{"x": 1.84, "y": 2, "r": 0.05}])
    at.listen("program", ["Scan"])
    [scan, *_] = (reading for reading in at.sense() if reading.channel == "Scan")
    assert scan.values[4 + 180] == 0.12


def test_it_feels_neither_walls_nor_holes() -> None:
    at = world(start={"x": 7.7, "y": 2})
    assert {reading.channel for reading in driven(at, 0.2, 0.0, 150)} == {"TurnRate", "Battery"}
    assert at.is_blocked
    assert at.x == pytest.approx(8 - 0.105, abs=0.002)
    at = world(tile=1, tiles=["......O.", "......O."], start={"x": 5.5, "y": 1})
    assert {reading.channel for reading in driven(at, 0.2, 0.0, 250)} == {"TurnRate", "Battery"}
    assert at.v == 0.0
    assert at.x == pytest.approx(6.0, abs=0.01)


def test_it_has_two_buttons() -> None:
    at = world()
    driven(at, 0.0, 0.0, 1)
    for button in (0, 1, 2):
        at.apply(Press(button, True))
    assert at.sense() == [Reading("Button", (0, 1)), Reading("Button", (1, 1))]
    assert at.channels()["Button"] == (1, 1)


def test_its_battery_lasts_two_and_a_half_hours() -> None:
    at = world(battery=0.5)
    assert at.channels()["Battery"] == (11.8,)
    at.integrate(1.25 * 3600 + 1)
    assert at.channels()["Battery"] == (11.0,)


def test_a_program_is_told_what_the_robot_lacks() -> None:
    uses = ["Bumper", "BumperLeft", "Scan", "Velocity", "Led1", "Seconds"]
    [found] = missing_parts(world(), uses)
    assert found.message == "The robot (TurtleBot 3) has no Bumper, BumperLeft, Led1."
    assert found.hint == "Take out the functions that use it, or choose another robot."
    assert missing_parts(world(None), uses) == []
    [found] = missing_parts(world(scanner=False), ["Scan"])
    assert found.message == "The robot in this room has no Scan."
