"""A robot that pushes against something and does not move is reported once, and no other robot is."""

from __future__ import annotations

import pytest

from rosy_sim.run.steps.lockstep import Lockstep
from rosy_sim.world.world import World

from ..conftest import hall
from .test_lockstep import publish, settled

FORWARD, BACK, STOP, SLOW = publish(0.3), publish(-0.3), publish(0.0), publish(0.01)


def at_wall(theta: float = 0.0, **more: object) -> World:
    """The robot half a metre before the wall on the right."""
    return hall(start={"x": 19.5, "y": 10, "theta": theta}, **more)


def reports(world: World, commands: dict[int, bytes], steps: int = 600) -> list[tuple[float, bool]]:
    """When a program that commands these velocities, by step, is reported, s, and whether with a pressed bumper."""
    lockstep = Lockstep(world, seed=1)
    lockstep.feed(b'{"op":"ready"}\n')
    found = []
    for _ in range(steps):
        lockstep.sense()
        lockstep.feed(commands.get(lockstep.step, b"") + settled(lockstep.step))
        lockstep.integrate()
        if lockstep.is_blocked:
            found.append((lockstep.time, lockstep.has_bumped))
    return found


def test_a_robot_at_the_wall_is_reported_once_two_seconds_later() -> None:
    [(time, has_bumped)] = reports(at_wall(), {0: FORWARD})
    reached = 0.32 / 0.3
    assert reached + 2 < time < reached + 3
    assert has_bumped


def test_backwards_it_is_reported_without_a_bumper() -> None:
    [(_, has_bumped)] = reports(at_wall(theta=3.141592653589793), {0: BACK})
    assert not has_bumped


def test_what_a_program_ends_in_time_begins_anew() -> None:
    pushing = {step: command for n in range(5) for step, command in ((100 * n, FORWARD), (100 * n + 90, STOP))}
    assert reports(at_wall(), pushing) == []


@pytest.mark.parametrize(
    ("why", "world", "commands"),
    [
        ("it drives", hall(), {0: FORWARD}),
        ("it is slow", hall(), {0: SLOW}),
        ("it stands at the wall", at_wall(), {0: FORWARD, 100: STOP}),
        ("it backs off", at_wall(), {0: FORWARD, 100: BACK}),
        ("it slides along the wall", at_wall(theta=1.2), {0: FORWARD}),
        ("it stands", hall(), {}),
    ],
    ids=lambda one: one if isinstance(one, str) else "",
)
def test_no_other_robot_is_reported(why: str, world: World, commands: dict[int, bytes]) -> None:
    assert reports(world, commands) == [], why
