"""
Imperfections of a real robot: wheels that do not turn as told, wheel slip, gyro drift, noise of measured speeds, and
command latency.

All are off unless the world has them. Slip moves the robot less far, and less straight, than its wheels turn; the
odometry counts the turning of the wheels. Wheels that do not turn as told move robot and odometry alike. Drift and
noise change only the odometry. All random numbers come from the run's seed.
"""

from __future__ import annotations

import math
import random
from collections import deque
from dataclasses import dataclass

from ..sentences.sentence import tr
from .events import Command
from .field_readers import ArenaError, number, object_fields

__all__ = ["LIMITS", "CommandLatency", "GyroOdometry", "Realism", "WheelSlip", "read_realism"]

_PATCH = 0.5
"""Time from one value of slip to the next, s. Our choice."""


@dataclass(frozen=True, slots=True)
class Realism:
    """All zero is ideal."""

    # Part of its turning that a wheel loses, standard deviation.
    slip: float = 0.0
    # Wandering of the heading, rad per square root of a second.
    drift: float = 0.0
    # Error of a measured speed, m/s and rad/s, standard deviation.
    noise: float = 0.0
    # From a command to the wheels, s.
    latency: float = 0.0
    # What the wheels do of the way and of the turn that they are told.
    travel: float = 1.0
    turning: float = 1.0
    # How far they turn the robot to the left for each metre, rad/m.
    veer: float = 0.0

    def turned(self, v: float, w: float) -> tuple[float, float]:
        """The speeds for which the wheels turn when they are told these, m/s and rad/s."""
        v *= self.travel
        return v, w * self.turning + v * self.veer

    def told(self, v: float, w: float) -> tuple[float, float]:
        """What the wheels are told when they turn for these speeds: the inverse."""
        return v / self.travel, (w - v * self.veer) / self.turning


LIMITS: dict[str, tuple[float, float]] = {
    "slip": (0, 0.5),
    "drift": (0, 1.0),
    "noise": (0, 0.5),
    "latency": (0, 2.0),
    "travel": (0.2, 2.0),
    "turning": (0.2, 2.0),
    "veer": (-5.0, 5.0),
}
"""Least and most of each."""


def read_realism(value: object) -> Realism:
    """
    The ``realism`` of a world.

    Raises:
        ArenaError: the first thing that is wrong, with its path.
    """
    fields = object_fields(value, "realism")
    read: dict[str, float] = {}
    for key, given in fields.items():
        if key not in LIMITS:
            raise ArenaError(f"realism.{key}", tr("expected one of {limits}.", limits=list(LIMITS)))
        read[key] = number(given, f"realism.{key}")
        least, most = LIMITS[key]
        if not least <= read[key] <= most:
            raise ArenaError(f"realism.{key}", tr("it must be between {least} and {most}.", least=least, most=most))
    return Realism(**read)


class WheelSlip:
    """Slip of two wheels: each loses a part of its speed, which changes slowly."""

    def __init__(self, slip: float, seed: int, wheelbase: float, max_turn: float) -> None:
        # m; rad/s.
        self._wheelbase = wheelbase
        self._max_turn = max_turn
        self._deviation = slip
        self._random = random.Random(f"slip {seed}")
        # What each wheel loses now and at the end of the patch, left and right, 0 to 1; how long the patch still is, s.
        self._lost = (self._draw(), self._draw())
        self._next = (self._draw(), self._draw())
        self._left = _PATCH

    def _draw(self) -> float:
        return min(1.0, abs(self._random.gauss(0.0, self._deviation)))

    def on_floor(self, v: float, w: float, dt: float) -> tuple[float, float]:
        """The speeds (m/s, rad/s) at which the robot goes when its wheels turn for these, after ``dt`` s."""
        if dt >= self._left:
            self._lost, self._next = self._next, (self._draw(), self._draw())
            self._left = _PATCH
        else:
            part = dt / self._left
            self._lost = (
                self._lost[0] + (self._next[0] - self._lost[0]) * part,
                self._lost[1] + (self._next[1] - self._lost[1]) * part,
            )
            self._left -= dt
        base, limit = self._wheelbase, self._max_turn
        left = (v - w * base / 2) * (1 - self._lost[0])
        right = (v + w * base / 2) * (1 - self._lost[1])
        return (left + right) / 2, max(-limit, min(limit, (right - left) / base))


class GyroOdometry:
    """Odometry of a robot with a gyro: distance from its wheels, heading from the gyro, which drifts."""

    def __init__(self, realism: Realism, seed: int) -> None:
        self._realism = realism
        self._random = random.Random(seed)
        # m, m, rad from the start pose; m/s, rad/s. Changed by moved().
        self.pose = (0.0, 0.0, 0.0)
        self.speeds = (0.0, 0.0)

    def moved(self, ahead: float, turn: float, v: float, w: float, dt: float) -> None:
        """The wheels rolled ``ahead`` m in ``dt`` s and do now v, and the robot turned ``turn`` rad and does now w."""
        realism, random_numbers = self._realism, self._random
        if v or w:
            turn += random_numbers.gauss(0.0, realism.drift * math.sqrt(dt))
        x, y, theta = self.pose
        middle = theta + turn / 2
        # The chord of the arc that was driven.
        if abs(turn) > 1e-9:
            ahead *= math.sin(turn / 2) / (turn / 2)
        self.pose = (x + ahead * math.cos(middle), y + ahead * math.sin(middle), theta + turn)
        self.speeds = (v + random_numbers.gauss(0.0, realism.noise), w + random_numbers.gauss(0.0, realism.noise))


class CommandLatency:
    """Delay line for commands on their way to the motors."""

    def __init__(self, delay: float) -> None:
        self._delay = delay
        self._under_way: deque[tuple[float, Command]] = deque()
        self._time = 0.0

    def send(self, command: Command) -> None:
        """Take a command from the program."""
        self._under_way.append((self._time + self._delay, command))

    def arrive(self, dt: float) -> list[Command]:
        """The commands that reach the robot before the next ``dt`` s pass."""
        arrived: list[Command] = []
        while self._under_way and self._under_way[0][0] <= self._time + 1e-9:
            arrived.append(self._under_way.popleft()[1])
        self._time += dt
        return arrived
