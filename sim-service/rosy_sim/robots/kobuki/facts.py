"""Numbers of a Kobuki that the physics uses, from its description, which has their units and sources."""

from __future__ import annotations

import math
from typing import Any

from ...robot_description import description

__all__ = [
    "AHEAD_HALF_WIDTH",
    "BUMPER_BEARINGS",
    "BUMPER_HALF_WIDTH",
    "CLIFF_POINTS",
    "COMMAND_TIMEOUT",
    "INERTIA",
    "LINE_DETECTORS",
    "MASS",
    "MAX_ACCELERATION",
    "MAX_ANGULAR_ACCELERATION",
    "MAX_ANGULAR_SPEED",
    "MAX_SPEED",
    "MAX_WHEEL_SPEED",
    "RADIUS",
    "WHEELBASE",
    "WHEEL_POINTS",
]

_BODY = {name: entry["value"] for name, entry in description("kobuki")["body"].items()}
_LIMITS = {name: entry["value"] for name, entry in description("kobuki")["limits"].items()}


def _points(value: Any) -> tuple[tuple[float, float], ...]:
    return tuple((float(x), float(y)) for x, y in value)


RADIUS: float = _BODY["radius"]
"""m."""

MASS: float = _BODY["mass"]
"""kg."""

INERTIA: float = _BODY["inertia"]
"""About the vertical axis, kg m²."""

WHEELBASE: float = _BODY["wheelbase"]
"""Distance between the wheels, m."""

MAX_SPEED: float = _LIMITS["speed"]
"""Top translational speed, m/s."""

MAX_ANGULAR_SPEED: float = _LIMITS["turn"]
"""Top rotational speed, rad/s."""

MAX_WHEEL_SPEED: float = _LIMITS["wheel"]
"""Top speed of a wheel, m/s."""

MAX_ACCELERATION: float = _BODY["acceleration"]
"""Change of speed in either direction, m/s²."""

MAX_ANGULAR_ACCELERATION: float = _BODY["angularAcceleration"]
"""Change of angular speed in either direction, rad/s²."""

COMMAND_TIMEOUT: float = _BODY["commandTimeout"]
"""A velocity command older than this stops the robot, s. The real node looks ten times a second; here it is exact."""

BUMPER_BEARINGS: tuple[float, ...] = tuple(math.radians(degrees) for degrees in _BODY["bumperBearings"])
"""Middle of the left, centre and right bumper zone, rad."""

BUMPER_HALF_WIDTH: float = math.radians(_BODY["bumperHalfWidth"])
"""Half a bumper zone, rad. A contact on a border presses both sides of it."""

CLIFF_POINTS = _points(_BODY["cliffPoints"])
"""Left, centre and right cliff sensor in the robot frame, m."""

LINE_DETECTORS = _points(_BODY["lineDetectors"])
"""Detectors of the line sensor in the robot frame, from the middle outwards, the left one of two first, m."""

WHEEL_POINTS = _points(_BODY["wheelPoints"])
"""Where the left and right wheel touch the floor, m."""

AHEAD_HALF_WIDTH: float = math.radians(_BODY["aheadHalfWidth"])
"""Beams at most this far from straight ahead count for ``Ahead``, rad."""
