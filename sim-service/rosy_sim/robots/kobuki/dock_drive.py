"""
Kobuki's own program that drives into the dock: the action ``/dock_drive_action`` of kobuki_auto_docking.

As upstream it finds the dock by its infrared beams: it starts only where a beam reaches the robot, and it is aborted
where upstream would search without end. Its path is simpler: to a place in front of the dock, turn, straight in.
The texts are upstream's (kobuki_auto_docking, src/auto_docking_ros.cpp) where it has one.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from ...world.arena import Pose
from ...world.robot import ABORTED, SUCCEEDED, Driving, Finished, Surroundings
from ...world.time_step import STEPS_PER_SECOND
from ..shared.places import wrapped
from .dock_receivers import sees_dock
from .power import is_docked

__all__ = ["DOCK_ACTION", "DockDrive"]

DOCK_ACTION = "/dock_drive_action"
"""kobuki_auto_docking, src/auto_docking_ros.cpp: the node's name, ``dock_drive``, and ``_action``."""

_STAGING = 0.6
"""The place from which the robot drives straight in, m in front of the dock. Our choice."""

_SPEED, _SLOW, _TURN = 0.15, 0.06, 1.0
"""Fastest ahead and in the dock, m/s, and turning, rad/s. Our choice."""

_TIME_LIMIT = 90 * STEPS_PER_SECOND
"""Steps after which the attempt is given up. Our choice."""


class DockDrive:
    """One attempt. A goal of AutoDocking has no fields."""

    def __init__(self, _goal: Mapping[str, Any]) -> None:
        self._state = "FIND_STREAM"
        self._steps = 0

    def canceled(self) -> dict[str, Any]:
        """The result of an attempt that was cancelled."""
        return {"text": "Cancelled: Cancel requested."}

    def step(self, robot: Surroundings) -> Driving | Finished:
        """The next 20 ms."""
        dock = robot.arena.dock
        self._steps += 1
        if dock is None or (self._state == "FIND_STREAM" and not (is_docked(robot) or sees_dock(robot))):
            return _aborted("no dock is in sight.")
        if self._steps > _TIME_LIMIT:
            return _aborted("it took too long.")
        depth, left, deviation = _offset(robot, dock)
        if is_docked(robot) and depth < 0.01:
            return Finished(SUCCEEDED, {"text": "Arrived on docking station successfully."})
        if robot.has_contacts and not is_docked(robot):
            return _aborted("something is in the way.")
        if self._state == "FIND_STREAM":
            self._state = "DOCKING" if abs(left) < 0.02 and depth < _STAGING + 0.05 else "GET_STREAM"
        if self._state == "GET_STREAM":
            x, y = dock.x - _STAGING * math.cos(dock.theta), dock.y - _STAGING * math.sin(dock.theta)
            away = math.hypot(x - robot.x, y - robot.y)
            if away > 0.02:
                return self._towards(wrapped(math.atan2(y - robot.y, x - robot.x) - robot.theta), away)
            self._state = "ALIGNED"
        if self._state == "ALIGNED":
            if abs(deviation) > 0.02:
                return self._driving(0.0, _limited(3 * deviation))
            self._state = "DOCKING"
        speed = max(0.02, min(_SLOW, depth))
        return self._driving(speed, _limited(2 * deviation - 4 * left))

    def _towards(self, bearing: float, away: float) -> Driving:
        """Turn to a place, then drive to it."""
        ahead = max(0.03, min(_SPEED, away)) if abs(bearing) < 0.3 else 0.0
        return self._driving(ahead, _limited(3 * bearing))

    def _driving(self, linear: float, angular: float) -> Driving:
        return Driving(linear, angular, {"state": self._state, "text": ""})


def _offset(robot: Surroundings, dock: Pose) -> tuple[float, float, float]:
    """How far the robot still has to go into the dock and how far it is left of its axis, m; the angle to turn, rad."""
    dx, dy = dock.x - robot.x, dock.y - robot.y
    c, s = math.cos(dock.theta), math.sin(dock.theta)
    return dx * c + dy * s, dx * s - dy * c, wrapped(dock.theta - robot.theta)


def _limited(turn: float) -> float:
    return max(-_TURN, min(_TURN, turn))


def _aborted(why: str) -> Finished:
    return Finished(ABORTED, {"text": f"Aborted: {why}"})
