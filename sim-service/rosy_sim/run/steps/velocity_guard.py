"""
Velocity guard: limits, repetition and safety rules between a program and the wheels of the simulated robot.

In: readings, velocities of the program, ticks, the time. Out: velocities for the base. ``Rosy.Robots.Guard`` does the
same for real robots; ``protocol/goldens/safety.jsonl`` holds the two together. The rules and speeds are those of
upstream's safety controller (safety_controller.hpp: spinOnce): the first that fits wins.
"""

from __future__ import annotations

import math

from ...world.events import Reading
from ...world.motor_controller import clamp
from ...world.robot import MotorLimits
from .safety_settings import OFF, SafetySettings

__all__ = ["OFF", "SafetySettings", "Velocity", "VelocityGuard"]


Velocity = tuple[float, float]
"""m/s ahead and rad/s to the left."""

_STANDSTILL: Velocity = (0.0, 0.0)

_BACK = 0.1
"""How fast the robot backs off, m/s (safety_controller.hpp: spinOnce)."""

_TURN = 0.4
"""How fast it turns away from the side meanwhile, rad/s (the same)."""

_HOLD = 0.2
"""How long the rules override after the last contact, s: the timeout of the multiplexer of safe_random_walker_app."""

_ROUNDING = 1e-9
"""Ten steps of 0.02 s must add up to 0.2 s, s."""

# Places of the sensors in readings.
_LEFT, _CENTER, _RIGHT = 0, 1, 2


class VelocityGuard:
    """Of one run; ``limits`` are those of the robot's motors."""

    def __init__(self, settings: SafetySettings, limits: MotorLimits) -> None:
        self._settings = settings
        self._limits = limits
        # Sensors that touch something, also while the rules are off: ("Bumper", 0).
        self._contacts: set[tuple[str, int]] = set()
        # Until when the rules override the program, s; None while they do not.
        self._overrides_until: float | None = None
        # The latest velocity of the program, to be repeated.
        self._latest = _STANDSTILL

    @property
    def is_overriding(self) -> bool:
        """Whether the safety rules drive instead of the program."""
        return self._overrides_until is not None

    def hear(self, reading: Reading) -> None:
        """Take note of a contact or its end."""
        if reading.channel in ("Bumper", "Cliff", "Wheel"):
            place, state = int(reading.values[0]), reading.values[1]
            if state:
                self._contacts.add((reading.channel, place))
            else:
                self._contacts.discard((reading.channel, place))

    def command(self, time: float, linear: float, angular: float) -> Velocity | None:
        """What the base is told when the program commands a velocity at ``time`` s."""
        settings = self._settings
        if settings.on:
            limits = self._limits
            max_speed = limits.speed if settings.max_speed is None else settings.max_speed
            max_turn = limits.angular_speed if settings.max_turn is None else settings.max_turn
            linear, angular = limits.within_wheels(_limited(max_speed, linear), _limited(max_turn, angular))
        self._latest = (linear, angular)
        if self._overrides_until is not None and time < self._overrides_until - _ROUNDING:
            return None
        return self._latest

    def tick(self, time: float) -> Velocity | None:
        """What the base is told ten times per second without a new command: the rules, or the latest velocity (R9)."""
        evasion = self._evasion() if self._settings.on else None
        if evasion is not None:
            self._overrides_until = time + _HOLD
            return evasion
        if self._overrides_until is not None:
            if time < self._overrides_until - _ROUNDING:
                return None
            self._overrides_until = None
            return self._latest
        return None if self._latest == _STANDSTILL else self._latest

    def switch(self, settings: SafetySettings) -> Velocity | None:
        """Change the settings. Rules that are switched off give the wheels back to the program at once."""
        self._settings = settings
        if settings.on or self._overrides_until is None:
            return None
        self._overrides_until = None
        return self._latest

    def _evasion(self) -> Velocity | None:
        if any(channel == "Wheel" for channel, _ in self._contacts):
            return _STANDSTILL
        places = {place for _, place in self._contacts}
        if _CENTER in places:
            return (-_BACK, 0.0)
        if _LEFT in places:
            return (-_BACK, -_TURN)
        if _RIGHT in places:
            return (-_BACK, _TURN)
        return None


def _limited(limit: float, value: float) -> float:
    """The nearest number within the limit; what is no number is zero, as on real robots."""
    return clamp(limit, value) if math.isfinite(value) else 0.0
