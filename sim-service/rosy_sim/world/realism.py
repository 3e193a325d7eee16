"""
How a real robot differs from an ideal one: wheels that slip, a heading that drifts, noisy speeds, late commands.

Off unless the world asks for it. The robot still goes exactly where its wheels take it; what it *believes* goes
astray, so a learner meets the difference in the simulator first. All of it comes from the run's seed.
"""

from __future__ import annotations

import math
import random
from collections import deque
from dataclasses import dataclass

from .events import Command
from .fields import ArenaError, number, objekt

__all__ = ["Belief", "Latency", "Realism", "read_realism"]

_SLIP_LASTS = 0.5
"""How long the wheels slip alike before the floor changes, s. Our choice."""


@dataclass(frozen=True, slots=True)
class Realism:
    """All zero is ideal."""

    # Relative error of a wheel's distance, standard deviation.
    slip: float = 0.0
    # Wandering of the heading, rad per square root of a second.
    drift: float = 0.0
    # Error of a measured speed, m/s and rad/s, standard deviation.
    noise: float = 0.0
    # From a command to the wheels, s.
    latency: float = 0.0


def read_realism(value: object) -> Realism:
    """
    The ``realism`` of a world.

    Raises:
        ArenaError: the first thing that is wrong, with its path.
    """
    fields = objekt(value, "realism")
    limits = {"slip": 0.5, "drift": 1.0, "noise": 0.5, "latency": 2.0}
    read: dict[str, float] = {}
    for key, given in fields.items():
        if key not in limits:
            raise ArenaError(f"realism.{key}", f"expected one of {', '.join(limits)}.")
        read[key] = number(given, f"realism.{key}")
        if not 0 <= read[key] <= limits[key]:
            raise ArenaError(f"realism.{key}", f"it must be between 0 and {limits[key]:g}.")
    return Realism(**read)


class Belief:
    """Where the robot thinks it is, from wheels that slip and a gyro that drifts."""

    def __init__(self, realism: Realism, seed: int) -> None:
        self._realism = realism
        self._dice = random.Random(seed)
        # m, m, rad from the start pose; m/s, rad/s. Changed by moved().
        self.pose = (0.0, 0.0, 0.0)
        self.speeds = (0.0, 0.0)
        self._slip = (0.0, 0.0)
        self._slips_until = 0.0
        self._time = 0.0

    def moved(self, ahead: float, turn: float, v: float, w: float, dt: float) -> None:
        """The robot went ``ahead`` m and turned ``turn`` rad in ``dt`` s, and does now v and w."""
        realism, dice = self._realism, self._dice
        self._time += dt
        if self._time >= self._slips_until:
            self._slips_until = self._time + _SLIP_LASTS
            self._slip = (dice.gauss(0.0, realism.slip), dice.gauss(0.0, realism.slip))
        ahead *= 1 + self._slip[0]
        turn *= 1 + self._slip[1]
        if v or w:
            turn += dice.gauss(0.0, realism.drift * math.sqrt(dt))
        x, y, theta = self.pose
        middle = theta + turn / 2
        self.pose = (x + ahead * math.cos(middle), y + ahead * math.sin(middle), theta + turn)
        self.speeds = (v + dice.gauss(0.0, realism.noise), w + dice.gauss(0.0, realism.noise))


class Latency:
    """Commands on their way to the wheels."""

    def __init__(self, delay: float) -> None:
        self._delay = delay
        self._under_way: deque[tuple[float, Command]] = deque()
        self._time = 0.0

    def send(self, command: Command) -> None:
        """A command leaves the program."""
        self._under_way.append((self._time + self._delay, command))

    def arrive(self, dt: float) -> list[Command]:
        """The commands that reach the robot before the next ``dt`` s pass."""
        arrived: list[Command] = []
        while self._under_way and self._under_way[0][0] <= self._time + 1e-9:
            arrived.append(self._under_way.popleft()[1])
        self._time += dt
        return arrived
