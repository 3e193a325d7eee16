"""The simulated robot drives into its dock: the action, and what the goals of its clients become."""

from __future__ import annotations

import math
from typing import Any

import pytest

from rosy_sim.robots.kobuki.dock_drive import DOCK_ACTION
from rosy_sim.robots.kobuki.power import CHARGED, CHARGING
from rosy_sim.world.action_goals import ActionReply
from rosy_sim.world.robot import ABORTED, CANCELED, SUCCEEDED
from rosy_sim.world.world import World

from ..conftest import hall

LONGEST = 3000
"""Steps of an attempt, a minute."""


def place(x: float, y: float, theta: float = 0.0) -> dict[str, float]:
    return {"x": x, "y": y, "theta": theta}


def result(world: World, client: str = "me") -> ActionReply | None:
    for _ in range(LONGEST):
        world.integrate()
        for reply in world.actions.take_replies(client):
            if reply.kind == "result":
                return reply
    return None


def drive(dock: dict[str, float] | None, **room: Any) -> tuple[World, ActionReply | None]:
    world = hall(**({"dock": dock} if dock is not None else {}), **room)
    world.actions.send("me", "1", DOCK_ACTION, {})
    return world, result(world)


@pytest.mark.parametrize(
    "dock",
    [
        # The robot stands at (10, 10) and looks along x: ahead, to the side, behind, near, and the robot in it.
        place(13, 10),
        place(14, 10.9),
        place(9, 11.5, 2.0),
        place(7, 9.5, math.pi),
        place(10.4, 10.1),
        place(10, 10),
    ],
    ids=str,
)
def test_it_drives_into_a_dock_that_it_sees_and_charges(dock: dict[str, float]) -> None:
    world, reply = drive(dock)
    assert reply is not None
    assert reply.status == SUCCEEDED
    world.integrate(1.0)
    assert world.channels()["Charger"] in ((CHARGED,), (CHARGING,))
    assert (world.v, world.w) == (0.0, 0.0)


@pytest.mark.parametrize(
    ("dock", "room", "why"),
    [
        (None, {}, "no dock is in sight"),
        (place(7, 10), {}, "no dock is in sight"),
        (place(13, 10), {"walls": [{"from": [12, 8], "to": [12, 12]}]}, "no dock is in sight"),
        (place(13, 10), {"rounds": [{"x": 12.35, "y": 10.35, "r": 0.2}]}, "something is in the way"),
    ],
    ids=["none", "another side", "hidden", "blocked"],
)
def test_it_says_why_it_does_not(dock: dict[str, float] | None, room: dict[str, Any], why: str) -> None:
    _, reply = drive(dock, **room)
    assert reply is not None
    assert reply.status == ABORTED
    assert isinstance(reply.values, dict)
    assert why in reply.values["text"]


def test_a_goal_that_is_taken_back_stops_it() -> None:
    world = hall(dock=place(13, 10))
    world.actions.send("me", "1", DOCK_ACTION, {})
    world.integrate(2.0)
    assert world.v > 0
    assert world.actions.cancel("me", "1")
    world.drive(0.0, 0.0)
    world.integrate(1.0)
    assert world.v == 0.0
    assert [reply.status for reply in world.actions.take_replies("me") if reply.kind == "result"] == [CANCELED]


def test_a_second_goal_is_rejected_and_another_action_is_unknown() -> None:
    world = hall(dock=place(13, 10))
    world.actions.send("me", "1", DOCK_ACTION, {})
    world.actions.send("you", "2", DOCK_ACTION, {})
    assert not world.actions.send("you", "3", "/fibonacci", {})
    assert not world.actions.cancel("you")
    assert [(reply.ident, reply.values, reply.succeeded) for reply in world.actions.take_replies("you")] == [
        ("2", "Action goal was rejected", False),
        ("3", "No action server available", False),
    ]
    assert result(world) is not None
