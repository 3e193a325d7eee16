"""User input as JSON: the page's ``input`` and the lines of ``./rosy run --input``."""

from __future__ import annotations

from typing import Annotated, Any, Literal

import msgspec

from ..world.arena import Pose
from ..world.events import Command, Lift, Move, Press, Teleport, UserAction
from .topics import TopicMessage, read_message

__all__ = ["Published", "TimedInput", "UserInput", "published", "user_actions"]

Published = Command | TopicMessage
"""A message that a person publishes."""

_Button = Literal["Button0", "Button1", "Button2"]
_Side = Literal["left", "right", "both"]


class _Place(msgspec.Struct):
    x: float
    y: float
    theta: float = 0.0


class _Drag(_Place):
    thing: Annotated[int, msgspec.Meta(ge=0, le=10_000)] = 0


class _Message(msgspec.Struct):
    topic: str
    msg: dict[str, Any] = {}


class UserInput(msgspec.Struct, kw_only=True):
    """One or more actions, applied in this order."""

    press: _Button | None = None
    release: _Button | None = None
    lift: _Side | None = None
    lower: _Side | None = None
    teleport: _Place | None = None
    move: _Drag | None = None
    publish: _Message | None = None


class TimedInput(UserInput, kw_only=True, forbid_unknown_fields=True):
    """A line of an input file: ``t`` in simulated seconds."""

    t: float


def published(message: UserInput) -> list[Published]:
    """
    The message that is published, if there is one.

    Raises:
        BadMessage: its topic is one of the robot's sensors, or it does not fit.
    """
    if message.publish is None:
        return []
    topic = message.publish.topic
    return [read_message(topic if topic.startswith("/") else f"/{topic}", message.publish.msg)]


def user_actions(message: UserInput) -> list[UserAction]:
    """The actions of a message, in order."""
    found: list[UserAction] = []
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
        drag = message.move
        found.append(Move(drag.thing, Pose(drag.x, drag.y, drag.theta)))
    return found
