"""
Battery and charger of Kobuki: the battery drains while the robot is on, and charges while the robot stands in the dock.
"""

from __future__ import annotations

import math

from ...world.arena import Arena
from ...world.robot import Surroundings
from ..shared.places import wrapped

__all__ = ["Power"]

RUN_TIME = 3 * 3600.0
"""From full to empty, s. kobuki_documentation, doc/specifications.rst: 3 h with the small battery."""

CHARGING_TIME = 1.5 * 3600.0
"""From empty to full, s. Same place: 1.5 h with the small battery."""

LOW, FULL = 13.2, 16.5
"""Voltages of ``LOW_LEVEL`` and of a full battery. kobuki_node, param/base.yaml:
battery_dangerous and battery_capacity."""

LOW_LEVEL = 0.05
"""Charge at ``LOW``. kobuki_driver, src/driver/battery.cpp: linear from 5 % at 13.2 V to 100 % at 16.5 V."""

DOCKED_DISTANCE = 0.05
"""A robot this near to the pose of the dock touches its contacts, m. Our choice; no document has their width."""

DOCKED_ANGLE = math.radians(20)
"""Largest error of its heading then, rad. Our choice."""

DISCHARGING, CHARGED, CHARGING = 0, 2, 6
"""Codes of the charger. kobuki_msgs, msg/SensorState.msg: DISCHARGING, DOCKING_CHARGED, DOCKING_CHARGING."""

_SAME_VOLTS = 0.0499
"""Nearer to a multiple of 0.1 V than this a voltage is rounded to it, V."""


class Power:
    """The charge of the battery, from 0 to 1."""

    events: frozenset[str] = frozenset()

    def __init__(self, arena: Arena) -> None:
        self._charge = arena.battery
        self._has_dock = arena.dock is not None
        # What was said last.
        self._volts, self._charger = 0.0, DISCHARGING
        self._values: dict[str, tuple[float | int | str, ...]] = {}

    def integrate(self, robot: Surroundings, dt: float) -> None:
        """Drain or charge."""
        if self._has_dock and is_docked(robot):
            self._charge = min(1.0, self._charge + dt / CHARGING_TIME)
        elif self._charge > 0.0:
            self._charge = max(0.0, self._charge - dt / RUN_TIME)

    def values(self, robot: Surroundings) -> dict[str, tuple[float | int | str, ...]]:
        """``Battery`` in V, as the base reports it in steps of 0.1 V, and ``Charger`` as the code of its state."""
        volts = LOW + (self._charge - LOW_LEVEL) * (FULL - LOW) / (1 - LOW_LEVEL)
        charger = (
            DISCHARGING if not self._has_dock or not is_docked(robot) else CHARGED if self._charge >= 1.0 else CHARGING
        )
        if abs(volts - self._volts) > _SAME_VOLTS or charger != self._charger:
            self._volts, self._charger = round(volts, 1), charger
            self._values = {"Battery": (self._volts,), "Charger": (charger,)}
        return self._values


def is_docked(robot: Surroundings) -> bool:
    """Whether the robot touches the contacts of the dock."""
    dock = robot.arena.dock
    if dock is None or math.hypot(robot.x - dock.x, robot.y - dock.y) > DOCKED_DISTANCE:
        return False
    return abs(wrapped(robot.theta - dock.theta)) <= DOCKED_ANGLE
