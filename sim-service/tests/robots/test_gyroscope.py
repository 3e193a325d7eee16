"""The gyroscope: the turn rate of the robot."""

from __future__ import annotations

import pytest

from rosy_sim.world.events import velocity

from ..conftest import hall


def test_the_turn_rate_is_that_of_the_robot() -> None:
    world = hall()
    assert world.channels()["TurnRate"] == (0.0,)
    world.command(velocity(0.2, 1.0))
    for _ in range(20):
        world.integrate()
    assert world.channels()["TurnRate"] == pytest.approx((1.0,))


def test_the_turn_rate_has_the_errors_of_odometry() -> None:
    world = hall(realism={"drift": 0.1})
    world.command(velocity(0.0, 1.0))
    for _ in range(20):
        world.integrate()
    assert world.channels()["TurnRate"] == (world.odometry()[4],)
