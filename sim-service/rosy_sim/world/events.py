"""
Input and output of a robot: events it reports, commands it obeys, and actions of a user.

The numbers are those of the ROS messages (``protocol/README.md``, section 2).
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Literal, NamedTuple

from .field_readers import Pose

__all__ = [
    "VELOCITY_CHANNEL",
    "Command",
    "GiveGoal",
    "Lift",
    "Move",
    "Press",
    "Reading",
    "Side",
    "TakeBackGoal",
    "Teleport",
    "UserAction",
    "velocity",
]


class Reading(NamedTuple):
    """
    What one sensor message says: its channel, and the values of ``protocol/robots``. One edge of a bumper is
    ``Reading("Bumper", (1, 1))``: the sensor (0 left, 1 centre, 2 right; wheels 0 left, 1 right), then its state.
    """

    channel: str
    values: tuple[float | int | str, ...]


class Command(NamedTuple):
    """What a program wants of one channel: ``Command("Led1", (2,))``."""

    channel: str
    values: tuple[float | int | str, ...]


VELOCITY_CHANNEL = "Velocity"
"""The channel of velocity commands."""


def velocity(linear: float, angular: float) -> Command:
    """Drive: m/s ahead, rad/s to the left."""
    return Command(VELOCITY_CHANNEL, (linear, angular))


Side = Literal["left", "right", "both"]


@dataclass(frozen=True, slots=True)
class Press:
    """Press (or release) button 0, 1 or 2."""

    button: int
    down: bool


@dataclass(frozen=True, slots=True)
class Lift:
    """Lift (or lower) a side of the robot: its wheels hang."""

    side: Side
    up: bool


@dataclass(frozen=True, slots=True)
class Teleport:
    """Put the robot elsewhere. Odometry does not notice, as on a real one."""

    pose: Pose


@dataclass(frozen=True, slots=True)
class Move:
    """Drag movable thing ``thing`` (boxes, then rounds, in the arena's order) towards a pose."""

    thing: int
    pose: Pose


@dataclass(frozen=True, slots=True)
class GiveGoal:
    """A ROS client gives a goal, a message as JSON, to one of the robot's own programs, an action."""

    client: str
    ident: str
    action: str
    goal: dict[str, Any] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class TakeBackGoal:
    """A ROS client takes back its goal, or, without an identifier, leaves."""

    client: str
    ident: str | None = None


UserAction = Press | Lift | Teleport | Move | GiveGoal | TakeBackGoal
