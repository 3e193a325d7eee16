"""
Infrared receivers of Kobuki for the beams of its dock.

The dock sends to three regions in front of it, left, centre and right, each divided into near and far
(kobuki_msgs, msg/DockInfraRed.msg). A receiver that faces the dock in a region reports it, unless a wall or a
thing is between them: infrared light does not pass.
"""

from __future__ import annotations

import math

from ...world.arena import Arena, Pose
from ...world.robot import Surroundings
from ..shared.places import wrapped

__all__ = ["DockReceivers", "sees_dock"]

RANGE, HALF_WIDTH = 5.0, 1.0
"""Depth and half the width of the docking area, m. kobuki_documentation, doc/specifications.rst: 2 m by 5 m."""

NEAR = 1.0
"""Depth of the near regions, m. Our choice; no document gives the number."""

CENTRE_HALF_WIDTH = 0.15
"""Half the width of the centre region, m: about that of the robot. Our choice."""

BEARINGS = (math.radians(60), 0.0, math.radians(-60))
"""Directions of the left, centre and right receiver, rad. Our choice, those of the bumpers."""

HALF_VIEW = math.radians(45)
"""Half the field of view of a receiver, rad. Our choice: neighbours overlap, so that two see a dock between them."""

MARGIN = 0.05
"""A surface within this distance of the dock, m, does not hide it: the dock stands at a wall. Our choice."""

NEAR_FLAGS = (1, 2, 4)
FAR_FLAGS = (16, 8, 32)
"""Flags of the left, centre and right region. kobuki_msgs, msg/DockInfraRed.msg."""

_NOTHING: dict[str, tuple[float | int | str, ...]] = {"DockInfraRed": (0, 0, 0)}


class DockReceivers:
    """What the three receivers see of the dock in the room."""

    events: frozenset[str] = frozenset()

    def __init__(self, arena: Arena) -> None:
        """Needs nothing beside the pose of the dock."""

    def values(self, robot: Surroundings) -> dict[str, tuple[float | int | str, ...]]:
        """``DockInfraRed``: the flag of the region that the left, the centre and the right receiver see, or 0."""
        dock = robot.arena.dock
        if dock is None:
            return _NOTHING
        flag = _beam(robot, dock)
        dx, dy = dock.x - robot.x, dock.y - robot.y
        distance, direction = math.hypot(dx, dy), math.atan2(dy, dx)
        # In the dock there is no direction to it: it is straight ahead.
        bearing = wrapped(direction - robot.theta) if distance > 1e-3 else 0.0
        return {"DockInfraRed": tuple(flag if abs(wrapped(bearing - at)) <= HALF_VIEW else 0 for at in BEARINGS)}


def sees_dock(robot: Surroundings) -> bool:
    """Whether a beam of the dock reaches the robot, wherever it looks."""
    dock = robot.arena.dock
    return dock is not None and _beam(robot, dock) != 0


def _beam(robot: Surroundings, dock: Pose) -> int:
    """The flag of the region in which the robot is, or 0 where no beam of the dock reaches it."""
    dx, dy = dock.x - robot.x, dock.y - robot.y
    c, s = math.cos(dock.theta), math.sin(dock.theta)
    flag = _region(dx * c + dy * s, dx * s - dy * c)
    distance = math.hypot(dx, dy)
    if flag and robot.free_distance(math.atan2(dy, dx), distance) < distance - MARGIN:
        return 0
    return flag


def _region(depth: float, left: float) -> int:
    """
    The flag of the region ``depth`` m in front of the dock and ``left`` m to the left of its axis, for a robot that
    faces it.
    """
    if not (-1e-3 <= depth <= RANGE) or abs(left) > HALF_WIDTH:
        return 0
    flags = NEAR_FLAGS if depth <= NEAR else FAR_FLAGS
    return flags[1] if abs(left) <= CENTRE_HALF_WIDTH else flags[0] if left > 0 else flags[2]
