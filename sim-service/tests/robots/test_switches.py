"""Commands that last: the power connectors, the motors and the pen."""

from __future__ import annotations

import pytest

from rosy_sim.world.events import Command, velocity
from rosy_sim.world.world import World

from ..conftest import hall


def drive(world: World, steps: int) -> float:
    """The speed after so many steps in which the program wants 0.3 m/s."""
    for _ in range(steps):
        world.command(velocity(0.3, 0.0))
        world.integrate()
    return world.v


def test_a_power_connector_is_switched_alone() -> None:
    world = hall()
    assert world.channels()["ExternalPower"] == (1, 1, 1, 1)
    world.command(Command("ExternalPower", (2, 0)))
    assert world.channels()["ExternalPower"] == (1, 1, 0, 1)


def test_without_motor_power_the_wheels_stand() -> None:
    world = hall()
    assert drive(world, 30) == pytest.approx(0.3)
    world.command(Command("MotorPower", (0,)))
    assert drive(world, 30) == 0.0
    world.command(Command("MotorPower", (1,)))
    assert drive(world, 30) == pytest.approx(0.3)


def test_the_pen_keeps_what_it_was_told() -> None:
    world = hall()
    assert [world.channels()[name] for name in ("Pen", "PenColor", "PenWidth")] == [(0,), (0,), (0.03,)]
    world.command(Command("Pen", (1,)))
    world.command(Command("PenWidth", (0.1,)))
    world.integrate()
    assert [world.channels()[name] for name in ("Pen", "PenColor", "PenWidth")] == [(1,), (0,), (0.1,)]
