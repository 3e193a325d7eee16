"""What a hand does to the robot, as JSON says it: the page's ``input`` and the lines of ``./rosy run --input``."""

from __future__ import annotations

from typing import Annotated, Literal

import msgspec

from ..world.arena import Pose
from ..world.events import Hand, Lift, Move, Press, Teleport

__all__ = ["HandMessage", "TimedHand", "hands_of"]

_Button = Literal["Button0", "Button1", "Button2"]
_Side = Literal["left", "right", "both"]


class _Place(msgspec.Struct):
    x: float
    y: float
    theta: float = 0.0


class _Push(_Place):
    thing: Annotated[int, msgspec.Meta(ge=0, le=10_000)] = 0


class HandMessage(msgspec.Struct, kw_only=True):
    """One or more of these; applied in this order."""

    press: _Button | None = None
    release: _Button | None = None
    lift: _Side | None = None
    lower: _Side | None = None
    teleport: _Place | None = None
    move: _Push | None = None


class TimedHand(HandMessage, kw_only=True, forbid_unknown_fields=True):
    """A line of an input file: ``t`` in simulated seconds."""

    t: float


def hands_of(message: HandMessage) -> list[Hand]:
    """The hands of a message, in order."""
    found: list[Hand] = []
    if message.press is not None:
        found.append(Press(int(message.press[-1]), True))
    if message.release is not None:
        found.append(Press(int(message.release[-1]), False))
    if message.lift is not None:
        found.append(Lift(message.lift, True))
    if message.lower is not None:
        found.append(Lift(message.lower, False))
    if message.teleport is not None:
        found.append(Teleport(Pose(message.teleport.x, message.teleport.y, message.teleport.theta)))
    if message.move is not None:
        push = message.move
        found.append(Move(push.thing, Pose(push.x, push.y, push.theta)))
    return found
