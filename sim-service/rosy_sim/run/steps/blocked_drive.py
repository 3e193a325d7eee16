"""
Detection of a robot that pushes against something and does not move, without any I/O.

It is reported once for a run: when the wheels have been blocked for 2 s without a break, and the robot has stayed where
it was. A robot that slides along a wall moves; a program that stops the robot or drives it away ends the time.
"""

from __future__ import annotations

import math

from ...world.time_step import STEPS_PER_SECOND
from ...world.world import World

__all__ = ["BlockedDrive"]

BLOCKED_STEPS = 2 * STEPS_PER_SECOND
"""Steps after which a blocked robot is reported, 2 s: a program that reacts to a bump has done so by then. A choice of
ours."""

_NEAR = 0.01
"""How far a robot that stays in its place may be moved by what it pushes against, m. A choice of ours."""

_TURN = 0.05
"""How far it may be turned, rad. A choice of ours."""


class BlockedDrive:
    """Observes one run."""

    def __init__(self) -> None:
        # Whether there is nothing more to report.
        self._is_reported = False
        # Steps for which the robot has been blocked in its place, and the pose at which they began: m, m, rad.
        self._steps = 0
        self._x = self._y = self._theta = 0.0

    def observe(self, world: World) -> bool:
        """Whether the step that has just passed has made it certain."""
        if not world.is_blocked or self._is_reported:
            self._steps = 0
            return False
        if self._steps == 0 or self._has_moved(world):
            self._steps = 0
            self._x, self._y, self._theta = world.x, world.y, world.theta
        self._steps += 1
        self._is_reported = self._steps >= BLOCKED_STEPS
        return self._is_reported

    def _has_moved(self, world: World) -> bool:
        turned = abs(math.remainder(world.theta - self._theta, math.tau))
        return turned > _TURN or math.hypot(world.x - self._x, world.y - self._y) > _NEAR
