"""A program calls actions and services of the simulated robot."""

from __future__ import annotations

import json
from typing import Any

from rosy_sim.run.steps.lockstep import Lockstep
from rosy_sim.run.steps.velocity_guard import SafetySettings

from ..conftest import hall
from .test_lockstep import settled

GOAL = {"op": "send_action_goal", "id": "rosy-1", "action": "dock", "action_type": "", "args": {}, "feedback": True}


class Caller:
    """A program that does nothing but what it is told."""

    def __init__(self, safety: SafetySettings | None = None) -> None:
        world = hall(dock={"x": 11, "y": 10, "theta": 0})
        self.lockstep = Lockstep(world, seed=1, safety=safety) if safety is not None else Lockstep(world, seed=1)
        self.lockstep.feed(b'{"op":"ready"}\n')
        self.heard: list[dict[str, Any]] = []

    def step(self, *frames: dict[str, Any]) -> None:
        lockstep = self.lockstep
        lines = [json.loads(line) for line in lockstep.sense().splitlines()]
        self.heard += [line for line in lines if line["op"] not in ("publish", "step")]
        lockstep.feed(b"".join(json.dumps(frame).encode() + b"\n" for frame in frames) + settled(lockstep.step))
        lockstep.integrate()

    def results(self) -> list[tuple[Any, ...]]:
        return [
            (line["action"], line["status"], line["result"]) for line in self.heard if line["op"] == "action_result"
        ]


def test_the_replies_of_a_goal_name_the_action_as_the_program_does() -> None:
    caller = Caller()
    caller.step(GOAL)
    for _ in range(1500):
        caller.step()
    assert caller.heard[0]["op"] == "action_feedback"
    assert {line["action"] for line in caller.heard} == {"dock"}
    assert caller.results() == [("dock", 4, True)]


def test_a_goal_is_taken_back() -> None:
    caller = Caller()
    caller.step(GOAL)
    for _ in range(50):
        caller.step()
    caller.step({"op": "cancel_action_goal", "id": "rosy-1", "action": "dock"})
    for _ in range(50):
        caller.step()
    assert caller.results() == [("dock", 5, True)]
    assert (caller.lockstep.world.v, caller.lockstep.world.w) == (0.0, 0.0)


def test_a_program_that_ends_takes_its_goal_back() -> None:
    caller = Caller()
    caller.step(GOAL)
    caller.lockstep.sense()
    caller.lockstep.feed(b'{"op":"ended","how":"done","fired":[]}\n')
    assert not caller.lockstep.world.actions.is_pursuing


def test_the_safety_rules_take_it_back() -> None:
    caller = Caller(SafetySettings(on=True))
    caller.step(GOAL)
    caller.lockstep._guard._contacts.add(("Bumper", 1))
    for _ in range(10):
        caller.step()
    assert caller.results() == [("dock", 5, True)]


def test_what_the_robot_does_not_have_is_answered_and_told() -> None:
    caller = Caller()
    told: list[str] = []
    caller.step({**GOAL, "action": "/fibonacci"}, {**GOAL, "id": "rosy-2", "action": "undock"})
    told += caller.lockstep.unavailable
    caller.step({"op": "call_service", "id": "rosy-3", "service": "/add", "type": "my/Add", "args": {}})
    told += caller.lockstep.unavailable
    caller.step()
    assert [(line["id"], line["values"], line["result"]) for line in caller.heard] == [
        ("rosy-1", "No action server available", False),
        ("rosy-2", "No action server available", False),
        ("rosy-3", "Service /add does not exist", False),
    ]
    # For `undock` the program has a substitute of its own.
    assert told == ["/fibonacci", "/add"]
