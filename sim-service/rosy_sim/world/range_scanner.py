"""
Range scanner: casts the beams of a laser scanner, while a program or a ROS client listens.

``Ahead`` is the nearest thing within a few degrees of straight ahead, ``Scan`` the distance of every beam. A beam that
meets nothing says the longest distance that the scanner can measure. The scanner turns at a fixed rate from the start
of the world, so what it says is a function of the room and the pose. Nothing is cast when nothing listens.
"""

from __future__ import annotations

import math
from collections.abc import Collection

from .events import Reading
from .obstacles import Obstacles
from .robot import ScannerModel

__all__ = ["AHEAD", "SCAN", "RangeScanner"]

AHEAD, SCAN = "Ahead", "Scan"
"""The two channels."""

_DECIMALS = 3
"""hls_lfcd_lds_driver, src/hlds_laser_publisher.cpp: distances are whole millimetres."""


class RangeScanner:
    """The scanner of one robot."""

    def __init__(self, model: ScannerModel, obstacles: Obstacles) -> None:
        self._model = model
        self._obstacles = obstacles
        self._listeners: dict[str, frozenset[str]] = {}
        # The channels that have a listener.
        self.heard: frozenset[str] = frozenset()
        # What each channel said last; empty when nothing listens to it any more.
        self.latest: dict[str, tuple[float | int | str, ...]] = {}
        step = math.tau / model.beams
        self._angles = [i * step for i in range(model.beams)]
        side = math.floor(model.ahead / step + 1e-9)
        self._ahead = [*range(side + 1), *range(model.beams - side, model.beams)]
        self._head = (0.0, step, model.nearest, model.farthest)

    def listen(self, listener: str, channels: Collection[str]) -> None:
        """A listener wants these channels from now on, and no others."""
        if not channels and not self._listeners.get(listener):
            return
        wanted = frozenset(channels) & {AHEAD, SCAN}
        if self._listeners.get(listener, frozenset()) == wanted:
            return
        self._listeners[listener] = wanted
        self.heard = frozenset().union(*self._listeners.values())
        for channel in self.latest:
            if channel not in self.heard:
                self.latest[channel] = ()

    def readings(self, step: int, x: float, y: float, theta: float) -> list[Reading]:
        """What it says in a step of the world to those who listen; nothing between two turns."""
        if not self.heard or step % self._model.period != 0:
            return []
        forwards = self._model.forwards
        x, y = x + forwards * math.cos(theta), y + forwards * math.sin(theta)
        found: list[Reading] = []
        if SCAN in self.heard:
            distances = [self._cast(i, x, y, theta) for i in range(self._model.beams)]
            ahead = min(distances[i] for i in self._ahead)
            found.append(Reading(SCAN, (*self._head, *distances)))
        else:
            ahead = min(self._cast(i, x, y, theta) for i in self._ahead)
        if AHEAD in self.heard:
            found.insert(0, Reading(AHEAD, (ahead,)))
        self.latest.update(found)
        return found

    def _cast(self, beam: int, x: float, y: float, theta: float) -> float:
        """The distance that a beam measures, m."""
        far = self._model.farthest
        distance = self._obstacles.distance(x, y, theta + self._angles[beam], far)
        return max(self._model.nearest, round(distance, _DECIMALS))
