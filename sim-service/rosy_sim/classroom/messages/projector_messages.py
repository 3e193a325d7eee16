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
    "Standing",
    "Standings",
    "UnlockProjector",
    "read_projector_request",
]


class Project(msgspec.Struct, tag="project", tag_field="op"):
    """
    Request of the board: show the room of a pupil on the projectors, ``named`` with the nickname, with ``program``
    beside it; ``None`` shows nothing, or the standings of ``task`` with nicknames.
    """

    pupil: int | None
    named: bool = False
    program: bool = False
    task: int | None = None


class Projecting(msgspec.Struct, tag="projecting", tag_field="op"):
    """Answer to the board: what the projectors show."""

    pupil: int | None
    named: bool
    program: bool
    task: int | None = None


class UnlockProjector(msgspec.Struct, tag="unlock", tag_field="op"):
    """Request of a projector: the teacher's key."""

    key: Typed


class Invitation(msgspec.Struct, tag="invitation", tag_field="op"):
    """Answer to a projector: how pupils join, which it shows while no pupil is chosen."""

    code: str
    addresses: list[str]


class Standing(msgspec.Struct, array_like=True):
    """A pupil in the standings of a task; ``time`` is that of ``CheckResult``."""

    place: int
    nickname: str
    passed: int
    rooms: int
    time: float | None


class Standings(msgspec.Struct):
    """The standings of a task, the first place first."""

    title: str
    rows: list[Standing]


class Projected(msgspec.Struct, tag="projected", tag_field="op"):
    """
    Answer to a projector: what it shows now. ``number`` is another one whenever the teacher chooses another pupil.
    ``nickname`` is ``None`` for a pupil who is not named, ``haskell`` without a program beside the room. ``standings``
    are shown in place of a pupil.
    """

    number: int
    shows: bool
    nickname: str | None
    online: bool
    running: bool
    haskell: str | None
    standings: Standings | None = None


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
