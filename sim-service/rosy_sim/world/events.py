"""
What goes in and out of a robot: events it reports, commands it obeys, and what hands do to it.

The numbers are those of kobuki_msgs; the order of ``Event`` kinds is the order in which the driver
reports the changes of one packet (kobuki_core, src/driver/event_manager.cpp).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, NamedTuple

from .fields import Pose

__all__ = [
    "Command",
    "Event",
    "EventKind",
    "Hand",
    "Led",
    "Lift",
    "Move",
    "Press",
    "Say",
    "Side",
    "Sound",
    "Teleport",
    "Velocity",
]

EventKind = Literal["robot_state", "button", "bumper", "cliff", "wheel_drop"]


class Event(NamedTuple):
    """One edge: sensor ``which`` (0 left, 1 centre, 2 right; wheels 0 left, 1 right) went to ``state``."""

    kind: EventKind
    which: int
    state: int


@dataclass(frozen=True, slots=True)
class Velocity:
    """Drive: m/s ahead, rad/s to the left."""

    linear: float
    angular: float


@dataclass(frozen=True, slots=True)
class Led:
    """Light LED 1 or 2: 0 black, 1 green, 2 orange, 3 red."""

    led: Literal[1, 2]
    colour: int


@dataclass(frozen=True, slots=True)
class Sound:
    """Play: 0 on, 1 off, 2 recharge, 3 button, 4 error, 5 cleaning start, 6 cleaning end."""

    sound: int


@dataclass(frozen=True, slots=True)
class Say:
    """Words for the console and the speech bubble. The base ignores them."""

    text: str


Command = Velocity | Led | Sound | Say

Side = Literal["left", "right", "both"]


@dataclass(frozen=True, slots=True)
class Press:
    """A finger on (or off) button 0, 1 or 2."""

    button: int
    down: bool


@dataclass(frozen=True, slots=True)
class Lift:
    """A hand under (or away from) a side of the robot: its wheels hang."""

    side: Side
    up: bool


@dataclass(frozen=True, slots=True)
class Teleport:
    """A hand puts the robot elsewhere. Odometry does not notice, as on the real one."""

    pose: Pose


@dataclass(frozen=True, slots=True)
class Move:
    """A hand pushes movable thing ``thing`` (boxes, then rounds, in the arena's order) towards a pose."""

    thing: int
    pose: Pose


Hand = Press | Lift | Teleport | Move
