"""
Messages of the projector, which shows the room of one pupil. ``protocol/README.md``, section 11.
"""

from __future__ import annotations

from typing import Any

import msgspec

from ...wire.page.runs import Frame
from .message_fields import Refused, Typed, decoded

__all__ = [
    "Invitation",
    "Project",
    "Projected",
    "Projecting",
    "ProjectorAnswer",
    "RoomProjected",
    "UnlockProjector",
    "read_projector_request",
]


class Project(msgspec.Struct, tag="project", tag_field="op"):
    """
    Request of the board: show the room of a pupil on the projectors, ``named`` with the nickname, with ``program``
    beside it; ``None`` shows nothing.
    """

    pupil: int | None
    named: bool = False
    program: bool = False


class Projecting(msgspec.Struct, tag="projecting", tag_field="op"):
    """Answer to the board: what the projectors show."""

    pupil: int | None
    named: bool
    program: bool


class UnlockProjector(msgspec.Struct, tag="unlock", tag_field="op"):
    """Request of a projector: the teacher's key."""

    key: Typed


class Invitation(msgspec.Struct, tag="invitation", tag_field="op"):
    """Answer to a projector: how pupils join, which it shows while no pupil is chosen."""

    code: str
    addresses: list[str]


class Projected(msgspec.Struct, tag="projected", tag_field="op"):
    """
    Answer to a projector: what it shows now. ``number`` is another one whenever the teacher chooses another pupil.
    ``nickname`` is ``None`` for a pupil who is not named, ``haskell`` without a program beside the room.
    """

    number: int
    shows: bool
    nickname: str | None
    online: bool
    running: bool
    haskell: str | None


class RoomProjected(msgspec.Struct, tag="room", tag_field="op"):
    """Answer to a projector: the room."""

    world: Any


ProjectorAnswer = Projected | Invitation | RoomProjected | Frame | Refused

_decoder: msgspec.json.Decoder[UnlockProjector] = msgspec.json.Decoder(UnlockProjector)


def read_projector_request(text: str | bytes) -> UnlockProjector:
    """
    Read a message of a projector.

    Raises:
        BadRequest: it is none.
    """
    return decoded(_decoder, text)
