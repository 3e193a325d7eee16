"""
Path recorder: what a page draws of a preview, taken step by step from its run: path, collisions and the pen.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from ..run.steps.lockstep import Lockstep
from ..world.world import World

__all__ = ["PathRecorder", "point_of"]

_POINT_DISTANCE = 0.02
"""Between two points of a path, m: less than a pixel of a picture of a whole room."""

_MAX_POINTS = 2000
"""Points of a path; a longer one has its points farther apart. 40 m at the usual distance."""

_MAX_COLLISIONS = 100
"""Collisions that are told of one preview."""

_MAX_PEN_CHANGES = 1000
"""Changes of the pen that are told of one preview."""

_CONTACT_PAUSE = 0.2
"""Contacts closer together than this are one collision, s: the hold of the safety rules after a contact."""

_LOOK = 10
"""Steps after which it is asked whether the run is over, half a millisecond of a fast one."""


class PathRecorder:
    """
    Path and collisions of a run, each point as time (s), x, y (m), and what the pen is from a time (s) on.

    Args:
        is_over: true when the run is to end early.
    """

    def __init__(self, world: World, is_over: Callable[[], bool]) -> None:
        self.path: list[tuple[float, float, float]] = [point_of(0.0, world)]
        self.collisions: list[tuple[float, float, float]] = []
        self.pen: list[tuple[float, int, int, float]] = []
        # The world replaces its outputs when a command changes one of them.
        self._outputs = world.outputs
        self._pen = _pen_of(world.outputs)
        self._is_over = is_over
        self._distance = _POINT_DISTANCE
        self._steps = 0
        # When the robot last touched something; long before the first contact.
        self._touched = -1.0

    def observe(self, lockstep: Lockstep) -> bool:
        """Take the state after a step; returns whether the run is to end."""
        if lockstep.state != "ended":
            self._record(lockstep)
        self._steps += 1
        return self._steps % _LOOK == 0 and self._is_over()

    def _record(self, lockstep: Lockstep) -> None:
        world = lockstep.world
        _, x, y = self.path[-1]
        if abs(world.x - x) + abs(world.y - y) >= self._distance:
            self._add(point_of(lockstep.time, world))
        if world.is_blocked or (world.has_contacts and world.sensors.bumpers):
            now = lockstep.time
            if now - self._touched > _CONTACT_PAUSE and len(self.collisions) < _MAX_COLLISIONS:
                self.collisions.append(point_of(now, world))
            self._touched = now
        if world.outputs is not self._outputs:
            self._record_pen(lockstep.time, world)

    def _record_pen(self, time: float, world: World) -> None:
        """Take what the pen is now, with a point of the path where it changes."""
        self._outputs = world.outputs
        pen = _pen_of(world.outputs)
        if pen is None or pen == self._pen or len(self.pen) >= _MAX_PEN_CHANGES:
            return
        self._pen = pen
        point = point_of(time, world)
        if self.path[-1][1:] != point[1:]:
            self._add(point)
        self.pen.append((point[0], *pen))

    def _add(self, point: tuple[float, float, float]) -> None:
        if len(self.path) >= _MAX_POINTS:
            self._distance *= 2
            self.path = self.path[::2]
        self.path.append(point)


def _pen_of(outputs: Mapping[str, tuple[float | int | str, ...]]) -> tuple[int, int, float] | None:
    """Up (0) or down (1), the number of the colour, and the width (m); ``None`` of a robot without a pen."""
    if "Pen" not in outputs:
        return None
    return int(outputs["Pen"][0]), int(outputs["PenColor"][0]), float(outputs["PenWidth"][0])


def point_of(time: float, world: World) -> tuple[float, float, float]:
    """Where the robot is at a time (s), as it is told: in hundredths of a second, and millimetres."""
    return (round(time, 2), round(world.x, 3), round(world.y, 3))
