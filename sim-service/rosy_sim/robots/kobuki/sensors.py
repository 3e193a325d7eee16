"""
Sensors of Kobuki: from its pose and contacts to the bits of SensorState, and from a change of bits to
events. Pure functions; the bits are right 1, centre 2, left 4, wheels right 1, left 2, and
button n is bit n (kobuki_msgs, msg/SensorState.msg).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cache

from ...world.arena import Arena
from ...world.events import Reading
from ...world.robot import SensorBits
from ..shared.places import append_edge, over_hole, wrapped
from .facts import BUMPER_BEARINGS, BUMPER_HALF_WIDTH, CLIFF_POINTS, WHEEL_POINTS

__all__ = ["bumper_bits", "cliff_bits", "edges", "hanging_wheels", "states"]

_ROUNDING = 1e-9
"""A contact exactly on the border of two zones must press both, rad."""

_SIDE_BITS = (4, 2, 1)
_WHEEL_BITS = (2, 1)
_BUTTON_BITS = (1, 2, 4)


def bumper_bits(contacts: Iterable[float], theta: float) -> int:
    """Which zones press, for surfaces touched in these directions (rad, in the room)."""
    bits = 0
    for direction in contacts:
        bearing = wrapped(direction - theta)
        for middle, bit in zip(BUMPER_BEARINGS, _SIDE_BITS, strict=True):
            if abs(bearing - middle) <= BUMPER_HALF_WIDTH + _ROUNDING:
                bits |= bit
    return bits


def cliff_bits(arena: Arena, x: float, y: float, theta: float) -> int:
    """Which cliff sensors look into a hole."""
    return over_hole(arena, x, y, theta, CLIFF_POINTS, _SIDE_BITS)


def hanging_wheels(arena: Arena, x: float, y: float, theta: float) -> int:
    """Which wheels have no floor under them."""
    return over_hole(arena, x, y, theta, WHEEL_POINTS, _WHEEL_BITS)


@cache
def states(bits: SensorBits) -> Mapping[str, tuple[int, ...]]:
    """The state of each sensor whose changes are events, left before right. There are 2048 at most."""
    return {
        "Bumper": tuple(int(bool(bits.bumpers & bit)) for bit in _SIDE_BITS),
        "Cliff": tuple(int(bool(bits.cliffs & bit)) for bit in _SIDE_BITS),
        "Wheel": tuple(int(bool(bits.wheels & bit)) for bit in _WHEEL_BITS),
        "Button": tuple(int(bool(bits.buttons & bit)) for bit in _BUTTON_BITS),
    }


def edges(before: SensorBits, now: SensorBits) -> list[Reading]:
    """The events of one packet: one per changed sensor, in the order of kobuki_core, src/driver/event_manager.cpp."""
    if before == now:
        return []
    events: list[Reading] = []
    for bit in (0, 1, 2):
        append_edge(events, "Button", bit, before.buttons, now.buttons, _BUTTON_BITS[bit])
    for which in (0, 1, 2):
        append_edge(events, "Bumper", which, before.bumpers, now.bumpers, _SIDE_BITS[which])
    for which in (0, 1, 2):
        append_edge(events, "Cliff", which, before.cliffs, now.cliffs, _SIDE_BITS[which])
    for which in (0, 1):
        append_edge(events, "Wheel", which, before.wheels, now.wheels, _WHEEL_BITS[which])
    return events
