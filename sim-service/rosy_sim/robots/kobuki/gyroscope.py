"""Gyroscope of Kobuki: the turn rate, which is also the one that its odometry reports."""

from __future__ import annotations

from ...world.arena import Arena
from ...world.robot import Surroundings

__all__ = ["Gyroscope"]


class Gyroscope:
    """Measures how fast the robot turns, with the errors that the room gives to odometry."""

    events: frozenset[str] = frozenset()

    def __init__(self, arena: Arena) -> None:
        """Needs nothing from the room."""

    def integrate(self, robot: Surroundings, dt: float) -> None:
        """Has no state of its own."""

    def values(self, robot: Surroundings) -> dict[str, tuple[float | int | str, ...]]:
        """``TurnRate`` in rad/s, to the left."""
        return {"TurnRate": (robot.odometry()[4],)}
