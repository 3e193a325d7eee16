"""
Line sensor: a row of detectors under the nose. Of those that see a line the one nearest to the middle says where it is.

In: the lines on the floor of the room, which do not change, and the pose. Out: ``LineSensor``, a code of its type.
"""

from __future__ import annotations

import math

from ...world.arena import Arena
from ...world.robot import Surroundings
from .facts import LINE_DETECTORS

__all__ = ["LineSensor"]

_NO_LINE, _LEFT, _AHEAD, _RIGHT = 0, 1, 2, 3
"""Codes of ``LineSensor``, protocol/robots."""

_REACH = max(math.hypot(x, y) for x, y in LINE_DETECTORS)
"""Of the farthest detector from the middle of the robot, m."""

_VALUES: tuple[dict[str, tuple[float | int | str, ...]], ...] = tuple({"LineSensor": (code,)} for code in range(4))
"""What it senses, by code: the same object as long as nothing changes."""

_Segment = tuple[float, float, float, float, float]
"""Its two ends and half of its width, m."""


class LineSensor:
    """Says on which side of the nose the line is."""

    events: frozenset[str] = frozenset()

    def __init__(self, arena: Arena) -> None:
        """Takes the lines of the room apart into segments."""
        self._segments: list[_Segment] = [
            (*start, *end, line.width / 2)
            for line in arena.lines
            for start, end in zip(line.points, line.points[1:], strict=False)
        ]
        self._pose = (math.nan, math.nan, math.nan)
        self._values = _VALUES[_NO_LINE]

    def values(self, robot: Surroundings) -> dict[str, tuple[float | int | str, ...]]:
        """``LineSensor``: no line, to the left, ahead, to the right."""
        pose = (robot.x, robot.y, robot.theta)
        if self._segments and pose != self._pose:
            self._pose = pose
            self._values = _VALUES[self._place(*pose)]
        return self._values

    def _place(self, x: float, y: float, theta: float) -> int:
        near = [segment for segment in self._segments if _distance(segment, x, y) <= _REACH + segment[4]]
        if not near:
            return _NO_LINE
        c, s = math.cos(theta), math.sin(theta)
        for ahead, left in LINE_DETECTORS:
            px, py = x + c * ahead - s * left, y + s * ahead + c * left
            if any(_distance(segment, px, py) <= segment[4] for segment in near):
                return _AHEAD if left == 0 else _LEFT if left > 0 else _RIGHT
        return _NO_LINE


def _distance(segment: _Segment, x: float, y: float) -> float:
    """From a point to the middle of a segment, m."""
    x0, y0, x1, y1, _ = segment
    dx, dy = x1 - x0, y1 - y0
    length = dx * dx + dy * dy
    part = max(0.0, min(1.0, ((x - x0) * dx + (y - y0) * dy) / length)) if length else 0.0
    return math.hypot(x - x0 - part * dx, y - y0 - part * dy)
