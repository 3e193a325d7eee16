"""
Sensors of TurtleBot 3 Burger whose changes are events: its two buttons. Nothing tells it that it touches a thing, that
there is a hole in front of it, or that a wheel hangs in the air; a wheel over a hole stops it all the same.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from ...world.arena import Arena
from ...world.events import Reading
from ...world.robot import SensorBits
from ..shared.dimensions import numbers_of
from ..shared.places import append_edge, over_hole

__all__ = ["button_edges", "hanging_wheels", "no_bits", "no_contacts", "states"]

_BUTTON_BITS = (1, 2)
_WHEEL_BITS = (2, 1)

_HALF_WHEELBASE = numbers_of("turtlebot3")["wheelbase"] / 2
_WHEEL_POINTS = ((0.0, _HALF_WHEELBASE), (0.0, -_HALF_WHEELBASE))
"""Where the left and right wheel touch the floor, m."""


def no_contacts(contacts: Iterable[float], theta: float) -> int:
    """It has no bumper."""
    del contacts, theta
    return 0


def no_bits(arena: Arena, x: float, y: float, theta: float) -> int:
    """It has no cliff sensor."""
    del arena, x, y, theta
    return 0


def hanging_wheels(arena: Arena, x: float, y: float, theta: float) -> int:
    """Which wheels have no floor under them: they stop the robot, which does not report them."""
    return over_hole(arena, x, y, theta, _WHEEL_POINTS, _WHEEL_BITS)


def states(bits: SensorBits) -> Mapping[str, tuple[int, ...]]:
    """The state of each button."""
    return {"Button": tuple(int(bool(bits.buttons & bit)) for bit in _BUTTON_BITS)}


def button_edges(before: SensorBits, now: SensorBits) -> list[Reading]:
    """The events of one packet: one per changed button."""
    events: list[Reading] = []
    for which, bit in enumerate(_BUTTON_BITS):
        append_edge(events, "Button", which, before.buttons, now.buttons, bit)
    return events
