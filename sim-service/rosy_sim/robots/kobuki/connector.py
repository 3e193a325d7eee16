"""Inputs of Kobuki's connector. Nothing is plugged in: digital inputs are low, analogue inputs have 0 V."""

from __future__ import annotations

from ...world.arena import Arena
from ...world.robot import Surroundings

__all__ = ["Connector"]

_VALUES: dict[str, tuple[float | int | str, ...]] = {
    "DigitalInput": (0, 0, 0, 0),
    "AnalogInput": (0.0, 0.0, 0.0, 0.0),
}


class Connector:
    """Four digital inputs, whose changes are events, and four analogue ones."""

    events: frozenset[str] = frozenset({"DigitalInput"})

    def __init__(self, arena: Arena) -> None:
        """Needs nothing from the room."""

    def values(self, robot: Surroundings) -> dict[str, tuple[float | int | str, ...]]:
        """``DigitalInput`` as 0 and 1, ``AnalogInput`` in V."""
        del robot
        return _VALUES
