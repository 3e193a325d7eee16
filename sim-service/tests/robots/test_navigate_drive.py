"""The simulated robot drives to a pose round what stands in its way, and says why where it cannot."""

from __future__ import annotations

import math
from typing import Any

import pytest

from rosy_sim.robots.shared.navigate_drive import NAVIGATE_ACTION
from rosy_sim.world.action_goals import ActionReply
from rosy_sim.world.events import GiveGoal
from rosy_sim.world.robot import ABORTED, SUCCEEDED
from rosy_sim.world.world import World

from ..conftest import hall

LONGEST = 6000
"""Steps of a drive, two minutes."""

SCREEN = [{"from": [11, 9], "to": [11, 12]}]
"""A wall across the straight way, with its near end on the right."""


def goal(x: float, y: float, degrees: float = 0.0) -> dict[str, Any]:
    half = math.radians(degrees) / 2
    orientation = {"z": math.sin(half), "w": math.cos(half)}
    return {
        "pose": {"header": {"frame_id": "odom"}, "pose": {"position": {"x": x, "y": y}, "orientation": orientation}}
    }


def drive(world: World, to: dict[str, Any]) -> ActionReply:
    world.apply(GiveGoal("me", "1", NAVIGATE_ACTION, to))
    for _ in range(LONGEST):
        for reply in world.actions.take_replies("me"):
            if reply.kind == "result":
                return reply
        world.integrate()
        world.sense()
    raise AssertionError("no result")


@pytest.mark.parametrize(
    ("room", "to"),
    [
        ({}, (1.0, 0.0, 0.0)),
        ({}, (-0.7, 0.4, 90.0)),
        ({"walls": SCREEN}, (2.0, 0.0, 180.0)),
        ({"boxes": [{"x": 11, "y": 10, "w": 0.4, "h": 0.4}]}, (2.0, 0.0, -45.0)),
        # A corridor of half a metre, as mazes of tiles have them.
        ({"walls": [{"from": [10.5, y], "to": [12, y]} for y in (10.275, 9.725)]}, (3.0, 0.0, 0.0)),
    ],
)
def test_it_arrives_and_faces_as_asked(room: dict[str, Any], to: tuple[float, float, float]) -> None:
    world = hall(**room)
    reply = drive(world, goal(*to))
    x, y, theta, _, _ = world.odometry()
    turned = math.remainder(theta - math.radians(to[2]), math.tau)
    assert reply.status == SUCCEEDED, reply
    assert (x, y, turned) == pytest.approx((to[0], to[1], 0), abs=0.05)
    assert not world.sensors.bumpers


def test_round_a_hole() -> None:
    tiles = ["........", "...O....", "........"]
    world = hall(size=[8, 3], tile=1, tiles=tiles, start={"x": 1, "y": 1.5, "theta": 0})
    assert drive(world, goal(5, 0)).status == SUCCEEDED
    assert not world.sensors.cliffs


@pytest.mark.parametrize(
    ("room", "to"),
    [
        ({"boxes": [{"x": 12, "y": 10, "w": 0.4, "h": 0.4}]}, (2.0, 0.0)),
        ({"boxes": [{"x": 10, "y": 10 + s, "w": 2, "h": 0.1} for s in (-1, 1)]
          + [{"x": 10 + s, "y": 10, "w": 0.1, "h": 2} for s in (-1, 1)]}, (3.0, 0.0)),
        ({}, (100.0, 0.0)),
    ],
)  # fmt: skip
def test_where_no_way_leads_it_says_so_and_stands(room: dict[str, Any], to: tuple[float, float]) -> None:
    world = hall(**room)
    reply = drive(world, goal(*to))
    assert (reply.status, reply.values) == (ABORTED, {"error_code": 208, "error_msg": "no way leads there"})
    assert world.odometry()[:3] == pytest.approx((0, 0, 0))


def test_what_is_put_into_its_way_ends_it() -> None:
    world = hall(boxes=[{"x": 11, "y": 13, "w": 0.5, "h": 4, "movable": True, "mass": 500}])
    world.apply(GiveGoal("me", "1", NAVIGATE_ACTION, goal(2, 0)))
    world.integrate()
    world.obstacles.drag(0, 11, 10, 0, robot=(world.x, world.y))
    for _ in range(LONGEST):
        world.integrate()
        results = [reply for reply in world.actions.take_replies("me") if reply.kind == "result"]
        if results:
            break
    stuck = {"error_code": 105, "error_msg": "something is in the way"}
    assert [(reply.status, reply.values) for reply in results] == [(ABORTED, stuck)]


@pytest.mark.parametrize("bad", [{"pose": 1}, {"pose": {"pose": {"position": {"x": "far"}}}}, goal(math.inf, 0)])
def test_a_goal_that_is_no_pose_is_rejected(bad: dict[str, Any]) -> None:
    reply = drive(hall(), bad)
    assert not reply.succeeded
    assert str(reply.values).startswith("Action goal was rejected: pose")


def test_a_large_room_is_searched_a_piece_in_each_step() -> None:
    world = hall(walls=[{"from": [15, 1.5], "to": [15, 20]}])
    world.apply(GiveGoal("me", "1", NAVIGATE_ACTION, goal(8, 5)))
    world.integrate()
    assert world.actions.is_pursuing
    assert (world.v, world.w) == (0.0, 0.0)
    assert drive_on(world).status == SUCCEEDED


def drive_on(world: World) -> ActionReply:
    while True:
        world.integrate()
        for reply in world.actions.take_replies("me"):
            if reply.kind == "result":
                return reply
