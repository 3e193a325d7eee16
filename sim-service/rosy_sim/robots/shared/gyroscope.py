"""Gyroscope: the turn rate, which is also the one that the odometry of the robot reports."""

from __future__ import annotations

import math

from ...world.arena import Arena
from ...world.robot import Surroundings

__all__ = ["Gyroscope"]


class Gyroscope:
    """Measures how fast the robot turns, with the errors that the room gives to odometry."""

    events: frozenset[str] = frozenset()

    def __init__(self, arena: Arena) -> None:
        """Needs nothing from the room."""
        del arena
        # What was told last, and as what.
        self._rate = math.nan
        self._values: dict[str, tuple[float | int | str, ...]] = {}

    def values(self, robot: Surroundings) -> dict[str, tuple[float | int | str, ...]]:
        """``TurnRate`` in rad/s, to the left."""
        rate = robot.turn_rate
        # A rate that does not change is the same object, and -0.0 is another than 0.0.
        if rate is not self._rate:
            self._rate = rate
            self._values = {"TurnRate": (rate,)}
        return self._values
