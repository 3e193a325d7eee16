"""
Motor controller: a target speed, its limits, and the watchdog that stops a robot without commands.

Time comes in as ``dt``; nothing here knows where the robot is.
"""

from __future__ import annotations

import math

from .robot import MotorLimits

__all__ = ["MotorController", "approach", "clamp"]

_ROUNDING = 1e-9
"""Thirty steps of 0.02 s must add up to the timeout of 0.6 s, s."""


def clamp(limit: float, value: float) -> float:
    """The nearest number to ``value`` within ``limit`` of zero."""
    nearest = value if value < limit else limit
    # Comparisons take a third of the time of `min` and `max`.
    return nearest if nearest > -limit else -limit


def approach(dt: float, acceleration: float, target: float, value: float) -> float:
    """Move ``value`` towards ``target`` for ``dt`` seconds, no faster than ``acceleration`` either way."""
    change = acceleration * dt
    most = value + change
    nearest = target if target < most else most
    least = value - change
    return nearest if nearest > least else least


class MotorController:
    """Two wheels' worth of motor, seen as a translational and a rotational speed."""

    __slots__ = ("_age", "_limits", "angular", "linear")

    def __init__(self, limits: MotorLimits) -> None:
        self._limits = limits
        # What the last command asks for, within the limits; m/s and rad/s.
        self.linear = 0.0
        self.angular = 0.0
        # Seconds since the last command; grows only in next().
        self._age = 0.0

    def command(self, linear: float, angular: float) -> None:
        """Obey a velocity command from now on."""
        limits = self._limits
        self.linear, self.angular = limits.within_wheels(
            clamp(limits.speed, linear), clamp(limits.angular_speed, angular)
        )
        self._age = 0.0

    def next(self, dt: float, v: float, w: float) -> tuple[float, float]:
        """The speeds after ``dt`` seconds, from the speeds now."""
        limits = self._limits
        if self._age >= limits.command_timeout - _ROUNDING:
            self.linear = self.angular = 0.0
        elif self.linear == v and self.angular == w:
            # Nothing to approach.
            self._age += dt
            return self.linear, self.angular
        self._age += dt
        linear = approach(dt, limits.acceleration, self.linear, v)
        angular = approach(dt, limits.angular_acceleration, self.angular, w)
        # On the way from one velocity to another a wheel may be asked for too much: the speed that grows waits.
        turning = abs(angular) * limits.wheelbase / 2
        if abs(linear) + turning > limits.wheel_speed:
            if abs(linear) > abs(v):
                linear = math.copysign(limits.wheel_speed - turning, linear)
            else:
                angular = math.copysign((limits.wheel_speed - abs(linear)) * 2 / limits.wheelbase, angular)
        return linear, angular
