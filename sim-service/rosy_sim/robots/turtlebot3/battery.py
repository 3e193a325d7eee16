"""Battery of TurtleBot 3: three lithium cells, which drain while the robot is on. It has no dock to charge in."""

from __future__ import annotations

from ...world.arena import Arena
from ...world.robot import Surroundings

__all__ = ["EMPTY", "FULL", "RUN_TIME", "LithiumBattery"]

RUN_TIME = 2.5 * 3600.0
"""From full to empty, s. ROBOTIS e-Manual, TurtleBot3, Features: expected operating time of the Burger, 2 h 30 min."""

FULL = 12.6
"""Voltage of three full lithium cells, V: 4.2 V each. ROBOTIS e-Manual, TurtleBot3, Features: LiPo 11.1 V nominal."""

EMPTY = 11.0
"""Voltage at which the robot warns, V. OpenCR, turtlebot3_diagnosis.cpp: voltage_ref."""


class LithiumBattery:
    """The charge, from 0 to 1."""

    events: frozenset[str] = frozenset()

    def __init__(self, arena: Arena) -> None:
        self._charge = arena.battery
        # What was reported last.
        self._volts = 0.0
        self._values: dict[str, tuple[float | int | str, ...]] = {}

    def integrate(self, robot: Surroundings, dt: float) -> None:
        """Drain."""
        del robot
        self._charge = max(0.0, self._charge - dt / RUN_TIME)

    def values(self, robot: Surroundings) -> dict[str, tuple[float | int | str, ...]]:
        """``Battery`` in V, in steps of 0.1 V."""
        del robot
        volts = round(EMPTY + self._charge * (FULL - EMPTY), 1)
        if volts != self._volts:
            self._volts = volts
            self._values = {"Battery": (volts,)}
        return self._values
