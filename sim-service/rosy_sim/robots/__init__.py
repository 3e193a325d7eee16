"""Robots that the simulator knows, one package each: body, limits, sensors and order of events."""

from __future__ import annotations

from ..world.robot import Robot
from .kobuki import KOBUKI

__all__ = ["DEFAULT_ROBOT", "ROBOTS"]

ROBOTS: dict[str, Robot] = {robot.name: robot for robot in (KOBUKI,)}
"""By name."""

DEFAULT_ROBOT = KOBUKI
