"""
Velocity guard of the simulator, replayed from the table that also holds the guard of real robots.
"""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import pytest

from rosy_sim.robots.kobuki import KOBUKI
from rosy_sim.run.steps.lockstep import Lockstep
from rosy_sim.run.steps.velocity_guard import SafetySettings, VelocityGuard
from rosy_sim.world.events import Reading

from ..conftest import hall
from .test_lockstep import publish, steps

TABLE = Path(__file__).parents[3] / "protocol/goldens/safety.jsonl"
CASES = [json.loads(line) for line in TABLE.read_text().splitlines()]


def settings(on: bool) -> SafetySettings:
    return SafetySettings(on, max_speed=0.7, max_turn=3.0)


@pytest.mark.parametrize("case", CASES, ids=[case["case"] for case in CASES])
def test_table(case: dict[str, Any]) -> None:
    guard = VelocityGuard(settings(case["on"]), KOBUKI.limits)
    for happening in case["happenings"]:
        match happening:
            case {"hear": [channel, *values]}:
                guard.hear(Reading(channel, tuple(values)))
                told = None
            case {"at": time, "command": [linear, angular]}:
                told = guard.command(time, linear, angular)
            case {"at": time, "tick": True}:
                told = guard.tick(time)
            case {"on": on}:
                told = guard.switch(settings(on))
            case _:
                pytest.fail(f"unknown: {happening}")
        expected = happening.get("told")
        assert told == (None if expected is None else tuple(expected)), happening


def test_numbers_that_are_none_become_zero() -> None:
    assert VelocityGuard(settings(True), KOBUKI.limits).command(0.0, math.nan, math.inf) == (0.0, 0.0)


def test_a_program_that_drives_into_a_wall_is_turned_away_only_while_the_rules_are_on() -> None:
    def run(settings: SafetySettings) -> tuple[bool, bool]:
        lockstep = Lockstep(hall(), seed=1, safety=settings)
        lockstep.feed(b'{"op":"ready"}\n')
        overridden = False
        backed = False
        for step in range(50 * 50):
            steps(lockstep, 1, {0: publish(0.5)} if step == 0 else {})
            overridden = overridden or lockstep.is_overridden
            backed = backed or lockstep.world.v < -0.05
        return overridden, backed

    assert run(SafetySettings()) == (False, False)
    assert run(SafetySettings(on=True)) == (True, True)


def test_the_limits_hold_while_the_rules_are_on() -> None:
    lockstep = Lockstep(hall(), seed=1, safety=SafetySettings(on=True, max_speed=0.1))
    lockstep.feed(b'{"op":"ready"}\n')
    steps(lockstep, 100, {0: publish(0.5)})
    assert lockstep.world.v == pytest.approx(0.1)
    lockstep.switch_safety(SafetySettings())
    steps(lockstep, 100, {})
    assert lockstep.world.v == pytest.approx(0.1), "the velocity in force stays until the next command"
    steps(lockstep, 100, {lockstep.step: publish(0.5)})
    assert lockstep.world.v == pytest.approx(0.5)
