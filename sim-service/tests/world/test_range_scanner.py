"""
The laser scanner of the simulated robot: distances by geometry, five turns a second, nothing without a listener, the
same in each run.
"""

from __future__ import annotations

import math
from typing import Any

import pytest

from rosy_sim.robot_description import description
from rosy_sim.robots.kobuki import KOBUKI, facts
from rosy_sim.world.arena import ArenaError, read_arena
from rosy_sim.world.events import Move, Reading, Teleport, velocity
from rosy_sim.world.field_readers import Pose
from rosy_sim.world.obstacles import Obstacles
from rosy_sim.world.world import World


def room(**more: Any) -> World:
    """A robot that looks along x, two metres from the wall ahead, in a room of four by four metres."""
    return World(read_arena({"size": [4, 4], "start": {"x": 2, "y": 2}, **more}), KOBUKI)


def measured(world: World, channel: str) -> list[tuple[float | int | str, ...]]:
    """What a channel says in the next second."""
    found = []
    for _ in range(50):
        found += [reading.values for reading in world.sense() if reading.channel == channel]
        world.integrate()
    return found


def ahead(world: World) -> float:
    world.listen("program", ["Ahead"])
    return float(measured(world, "Ahead")[0][0])


@pytest.mark.parametrize(
    ("things", "distance"),
    [
        ({}, 2.0),
        ({"walls": [{"from": [3, 0], "to": [3, 4]}]}, 0.975),
        ({"boxes": [{"x": 3, "y": 2, "w": 0.4, "h": 0.4}]}, 0.8),
        ({"boxes": [{"x": 3, "y": 2, "w": 0.4, "h": 0.4, "movable": True}]}, 0.8),
        ({"rounds": [{"x": 3, "y": 2, "r": 0.3}]}, 0.7),
        # Seven degrees to the left, and half as much again.
        ({"rounds": [{"x": 3, "y": 2.125, "r": 0.02}]}, 0.988),
        ({"rounds": [{"x": 3, "y": 2.25, "r": 0.02}]}, 2.0),
    ],
)
def test_ahead_is_the_nearest_wall_or_thing_within_ten_degrees(things: dict[str, Any], distance: float) -> None:
    assert ahead(room(**things)) == pytest.approx(distance, abs=0.002)


def test_ahead_is_the_longest_distance_that_the_scanner_measures_when_nothing_is_near() -> None:
    assert ahead(World(read_arena({"size": [20, 20], "start": {"x": 10, "y": 10}}), KOBUKI)) == 3.5


def test_ahead_turns_with_the_robot_and_follows_a_thing_that_is_moved() -> None:
    world = room(boxes=[{"x": 3, "y": 2, "w": 0.4, "h": 0.4, "movable": True}])
    world.apply(Teleport(Pose(1.5, 2, math.pi)))
    assert ahead(world) == pytest.approx(1.5)
    world.apply(Teleport(Pose(1.5, 2, 0)))
    assert ahead(world) == pytest.approx(1.3)
    world.apply(Move(0, Pose(3.5, 2, 0)))
    assert ahead(world) == pytest.approx(1.8)


def test_a_robot_that_touches_a_wall_measures_its_own_radius() -> None:
    world = room()
    world.command(velocity(0.5, 0))
    for _ in range(500):
        world.command(velocity(0.5, 0))
        world.integrate()
    assert ahead(world) == pytest.approx(facts.RADIUS, abs=0.002)


def test_a_scan_has_the_distances_all_around_counter_clockwise() -> None:
    world = room(boxes=[{"x": 2, "y": 3, "w": 0.2, "h": 0.2}])
    world.listen("program", ["Scan"])
    first, step, nearest, farthest, *distances = (float(v) for v in measured(world, "Scan")[0])
    assert (first, nearest, farthest, len(distances)) == (0.0, 0.12, 3.5, 360)
    assert step == pytest.approx(math.radians(1))
    # Ahead, to the left, behind, to the right.
    assert [distances[i] for i in (0, 90, 180, 270)] == [2.0, 0.9, 2.0, 2.0]
    assert distances[45] == pytest.approx(2 * math.sqrt(2), abs=0.002)


def test_it_measures_five_times_a_second_also_when_nothing_changes() -> None:
    world = room()
    world.listen("program", ["Ahead", "Scan"])
    assert len(measured(world, "Ahead")) == 5
    assert len(measured(world, "Scan")) == 5


def test_no_beam_is_cast_when_nothing_listens(monkeypatch: pytest.MonkeyPatch) -> None:
    cast: list[float] = []
    real = Obstacles.distance

    def distance(obstacles: Obstacles, x: float, y: float, direction: float, farthest: float) -> float:
        cast.append(direction)
        return real(obstacles, x, y, direction, farthest)

    monkeypatch.setattr(Obstacles, "distance", distance)
    world = room()
    measured(world, "Ahead")
    assert (cast, "Ahead" in world.channels()) == ([], False)
    # Only the beams that look ahead.
    world.listen("program", ["Ahead"])
    measured(world, "Ahead")
    assert len(cast) == 5 * 21
    assert world.channels()["Ahead"] == (2.0,)
    world.listen("program", [])
    measured(world, "Ahead")
    assert (len(cast), world.channels()["Ahead"]) == (5 * 21, ())


def test_one_listener_of_two_is_enough() -> None:
    world = room()
    world.listen("program", ["Ahead"])
    world.listen("ros", ["Scan"])
    world.listen("program", [])
    assert (len(measured(world, "Scan")), measured(world, "Ahead")) == (5, [])


def test_two_runs_measure_the_same() -> None:
    def run() -> list[Reading]:
        world = room(boxes=[{"x": 3, "y": 2, "w": 0.4, "h": 0.4, "movable": True}])
        world.listen("program", ["Scan"])
        found: list[Reading] = []
        for _ in range(200):
            world.command(velocity(0.4, 0.3))
            found += world.sense()
            world.integrate()
        return found

    assert run() == run()


def test_a_room_can_take_the_scanner_away() -> None:
    world = room(scanner=False)
    world.listen("program", ["Ahead"])
    assert measured(world, "Ahead") == []
    with pytest.raises(ArenaError, match="scanner"):
        room(scanner="no")


def test_the_descriptions_agree_on_what_is_ahead() -> None:
    for robot in ("kobuki", "turtlebot3"):
        [channel] = [c for c in description(robot)["channels"] if c["name"] == "Ahead"]
        assert math.radians(channel["ros"]["fields"][0]["ahead"]) == facts.AHEAD_HALF_WIDTH
