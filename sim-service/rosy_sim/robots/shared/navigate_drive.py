"""
The action ``/navigate_to_pose`` of Nav2 (nav2_msgs, action/NavigateToPose.action): drives to a place round what stands
in the way.

In: a pose in the frame of the odometry. It searches a way in the room as it is when the goal arrives, turns to each
corner and drives straight to it. It aborts when there is no way, or when something holds the robot up. Unlike Nav2 it
knows the room and where the robot is, and it searches once.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from ...world.action_goals import RejectedGoal
from ...world.path_search import CELL, PathSearch, Point
from ...world.robot import ABORTED, SUCCEEDED, Driving, Finished, Surroundings
from ...world.time_step import STEPS_PER_SECOND
from .places import wrapped

__all__ = ["NAVIGATE_ACTION", "NavigateDrive"]

NAVIGATE_ACTION = "/navigate_to_pose"
"""nav2_bt_navigator, src/navigators/navigate_to_pose.cpp: ``getName``."""

_NO_WAY, _HELD_UP = 208, 105
"""nav2_msgs, action/ComputePathToPose.action: NO_VALID_PATH; action/FollowPath.action: FAILED_TO_MAKE_PROGRESS."""

_MESSAGES = {0: "", _NO_WAY: "no way leads there", _HELD_UP: "something is in the way"}
"""What the server says of a code, in English as servers do; the page translates it (``replies`` in its words)."""

_MARGIN = CELL
"""Free way around the robot on its path, m: between two cells it is less."""

_EDGE = 0.2
"""Distance that the robot's centre keeps from holes, m: its cliff sensors are at 0.16."""

_AROUND = [(_EDGE * math.cos(n * math.pi / 4), _EDGE * math.sin(n * math.pi / 4)) for n in range(8)]

_SPEED, _TURN = 0.2, 1.2
"""Fastest, m/s and rad/s. Our choice."""

_NEAR, _AT, _FACING = 0.04, 0.015, 0.02
"""A corner and the place count as reached so near, m; the angle so near, rad."""

_PATIENCE = 8 * STEPS_PER_SECOND
"""Steps without coming 2 cm nearer or turning, before it aborts. Our choice; a half turn takes 3 s."""


class NavigateDrive:
    """One goal: a message of NavigateToPose's goal as JSON, whose missing fields are zero."""

    def __init__(self, goal: Mapping[str, Any]) -> None:
        self._place = _read_pose(goal)
        self._search: PathSearch | None = None
        self._facing = 0.0
        self._corners: list[Point] = []
        self._nearest = math.inf
        self._waited = 0

    def canceled(self) -> dict[str, Any]:
        """The result of a goal that was cancelled."""
        return _result(0)

    def step(self, robot: Surroundings) -> Driving | Finished:
        """The next 20 ms."""
        if self._search is None:
            x, y, self._facing = robot.pose_in_room(*self._place)
            self._search = PathSearch((robot.x, robot.y), (x, y), lambda x, y: _fits(robot, x, y))
        if not self._corners:
            found = self._search.advance()
            if found is None:
                return Driving(0.0, 0.0, {"distance_remaining": 0.0})
            if not found:
                return Finished(ABORTED, _result(_NO_WAY))
            self._corners = found
        here = (robot.x, robot.y)
        while len(self._corners) > 1 and math.dist(here, self._corners[0]) < _NEAR:
            del self._corners[0]
            self._nearest = math.inf
        away = math.dist(here, self._corners[0])
        if away > self._nearest - 0.02 and away > _AT:
            self._waited += 1
            if self._waited > _PATIENCE:
                return Finished(ABORTED, _result(_HELD_UP))
        else:
            self._nearest, self._waited = away, 0
        left = away + sum(math.dist(a, b) for a, b in zip(self._corners, self._corners[1:], strict=False))
        feedback = {"distance_remaining": round(left, 3)}
        if len(self._corners) == 1 and away < _AT:
            deviation = wrapped(self._facing - robot.theta)
            if abs(deviation) < _FACING:
                return Finished(SUCCEEDED, _result(0))
            return Driving(0.0, _limited(3 * deviation), feedback)
        bearing = wrapped(math.atan2(self._corners[0][1] - robot.y, self._corners[0][0] - robot.x) - robot.theta)
        ahead = max(0.03, min(_SPEED, away)) if abs(bearing) < 0.2 else 0.0
        return Driving(ahead, _limited(3 * bearing), feedback)


def _fits(robot: Surroundings, x: float, y: float) -> bool:
    arena = robot.arena
    if arena.tile_at(x, y) == "#" or any(arena.is_hole(x + dx, y + dy) for dx, dy in _AROUND):
        return False
    return robot.free_around(x, y) > _MARGIN


def _limited(turn: float) -> float:
    return max(-_TURN, min(_TURN, turn))


def _result(code: int) -> dict[str, Any]:
    return {"error_code": code, "error_msg": _MESSAGES[code]}


def _read_pose(goal: Mapping[str, Any]) -> tuple[float, float, float]:
    """x, y (m) and the angle (rad) in ``pose.pose``."""
    qx, qy, qz, qw = (_number(goal, "pose", "pose", "orientation", axis) for axis in ("x", "y", "z", "w"))
    theta = math.atan2(2 * (qw * qz + qx * qy), qw * qw + qx * qx - qy * qy - qz * qz)
    return _number(goal, "pose", "pose", "position", "x"), _number(goal, "pose", "pose", "position", "y"), theta


def _number(value: Any, *path: str) -> float:
    for key in path:
        if not isinstance(value, Mapping):
            raise RejectedGoal(f"{'.'.join(path)} is no number")
        value = value.get(key, 0.0 if key == path[-1] else {})
    if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
        raise RejectedGoal(f"{'.'.join(path)} is no number")
    return float(value)
