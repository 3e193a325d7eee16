"""Several robots in one room: each moves by its own commands, and they are obstacles to each other."""

from __future__ import annotations

import math
from typing import Any

import pytest

from rosy_sim.robots.kobuki import KOBUKI
from rosy_sim.world.arena import Arena, ArenaError, Pose, read_arena
from rosy_sim.world.events import Lift, Teleport, velocity
from rosy_sim.world.obstacles import Obstacles
from rosy_sim.world.shared_world import SharedWorld
from rosy_sim.world.world import ActionRefused, World

from ..conftest import events_of

TOUCHING = 2 * KOBUKI.body.radius
"""Between the centres of two robots that touch, m."""


def room(**more: Any) -> Arena:
    return read_arena({"name": "room", "size": [8, 8], "start": {"x": 2, "y": 4, "theta": 0}, **more})


def shared(arena: Arena, *starts: Pose) -> SharedWorld:
    obstacles = Obstacles(KOBUKI.body)
    for _ in obstacles.add(arena):
        pass
    return SharedWorld(arena, KOBUKI, 1, obstacles, starts)


def drive(world: SharedWorld, speeds: list[float], steps: int) -> list[list[str]]:
    """Command all robots in each step; the channels of what each of them has sensed."""
    robots: list[World] = [world, *world.others]
    sensed: list[list[str]] = [[] for _ in robots]
    for _ in range(steps):
        for robot, speed, found in zip(robots, speeds, sensed, strict=True):
            found += [event.channel for event in events_of(robot)]
            robot.command(velocity(speed, 0.0))
        world.integrate()
    return sensed


def test_each_robot_moves_by_its_own_commands_as_if_it_were_alone() -> None:
    world = shared(room(), Pose(2, 6, 0), Pose(2, 2, 0))
    drive(world, [0.2, 0.4, 0.0], 150)
    alone = World(room(), KOBUKI, 1)
    for _ in range(150):
        alone.command(velocity(0.2, 0.0))
        alone.integrate()
    assert (world.x, world.y, world.theta) == (alone.x, alone.y, alone.theta)
    assert world.others[0].x - 2 == pytest.approx(2 * (world.x - 2), rel=0.05)
    assert (world.others[1].x, world.others[1].y) == (2, 2)


def test_robots_that_meet_stop_each_other_and_both_bumpers_are_pressed() -> None:
    world = shared(room(), Pose(4, 4, math.pi))
    sensed = drive(world, [0.3, 0.3], 300)
    other = world.others[0]
    assert other.x - world.x == pytest.approx(TOUCHING, abs=1e-3)
    assert max(abs(world.v), abs(other.v)) < 1e-3
    assert all("Bumper" in channels for channels in sensed)


def test_a_robot_that_is_hit_from_behind_stays_and_feels_nothing() -> None:
    world = shared(room(), Pose(4, 4, 0))
    first, second = drive(world, [0.3, 0.0], 300)
    assert world.others[0].x == 4
    assert 4 - world.x == pytest.approx(TOUCHING, abs=1e-3)
    assert "Bumper" in first
    # A Kobuki has its bumper in front.
    assert "Bumper" not in second


def test_a_robot_that_drives_into_a_resting_one_presses_its_bumper_too() -> None:
    world = shared(room(), Pose(4, 4, math.pi))
    _, second = drive(world, [0.3, 0.0], 300)
    assert "Bumper" in second


def test_a_faster_robot_follows_a_slower_one_at_its_speed() -> None:
    world = shared(room(), Pose(2.5, 4, 0))
    drive(world, [0.4, 0.1], 400)
    other = world.others[0]
    assert other.x == pytest.approx(2.5 + 0.1 * 8, rel=0.02)
    assert other.x - world.x == pytest.approx(TOUCHING, abs=0.01)


def test_a_distance_sensor_sees_the_other_robot() -> None:
    world = shared(room(), Pose(4, 4, 0))
    assert world.free_distance(0.0, 5.0) == pytest.approx(2 - KOBUKI.body.radius)
    assert world.others[0].free_distance(math.pi, 5.0) == pytest.approx(2 - KOBUKI.body.radius)


def test_two_robots_push_a_box_from_both_sides_and_time_passes_once_for_it() -> None:
    box = {"x": 3, "y": 4, "w": 0.3, "h": 0.3, "theta": 0, "movable": True, "mass": 0.5}
    alone = World(room(boxes=[box]), KOBUKI, 1)
    world = shared(room(boxes=[box]), Pose(6, 6, 0))
    for _ in range(300):
        alone.command(velocity(0.2, 0.0))
        alone.integrate()
    drive(world, [0.2, 0.0], 300)
    assert world.obstacles.poses()[0] == pytest.approx(alone.obstacles.poses()[0], abs=1e-6)
    assert world.x == pytest.approx(alone.x, abs=1e-6)
    between = shared(room(boxes=[box]), Pose(4, 4, math.pi))
    drive(between, [0.2, 0.2], 400)
    # The box lies between them, and neither robot is in it.
    assert between.others[0].x - between.x == pytest.approx(0.3 + TOUCHING, abs=0.02)


def test_robots_that_meet_while_a_box_slides_do_not_overlap() -> None:
    box = {"x": 3, "y": 4, "w": 0.2, "h": 0.2, "theta": 0, "movable": True, "mass": 0.5}
    world = shared(room(boxes=[box]), Pose(2.9, 4.35, -math.pi / 2), Pose(3.4, 4.3, -2.0))
    for _ in range(200):
        drive(world, [0.3, 0.3, 0.3], 1)
        robots: list[World] = [world, *world.others]
        for index, one in enumerate(robots):
            for other in robots[:index]:
                assert math.hypot(one.x - other.x, one.y - other.y) > TOUCHING - 2e-3


def test_the_same_commands_give_the_same_floats() -> None:
    def places() -> list[tuple[float, float, float]]:
        world = shared(room(), Pose(4, 4, 2.8), Pose(3, 5, -1.7))
        drive(world, [0.3, 0.2, 0.4], 300)
        return [(robot.x, robot.y, robot.theta) for robot in (world, *world.others)]

    assert places() == places()


def test_a_robot_cannot_start_or_be_put_where_another_one_stands() -> None:
    with pytest.raises(ArenaError):
        shared(room(), Pose(2.1, 4, 0))
    world = shared(room(), Pose(4, 4, 0))
    world.apply(Teleport(Pose(3.8, 4, 0)))
    assert 4 - world.x >= TOUCHING - 1e-3
    with pytest.raises(ActionRefused):
        world.apply(Teleport(Pose(9, 9, 0)))


def test_a_lifted_robot_stands_still_while_the_other_one_drives() -> None:
    world = shared(room(), Pose(2, 6, 0))
    world.apply(Lift("both", True))
    drive(world, [0.3, 0.3], 100)
    assert world.x == 2
    assert world.others[0].x > 2.3
