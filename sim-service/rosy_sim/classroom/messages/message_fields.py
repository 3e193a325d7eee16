"""
Fields and messages that pupils' pages and the teacher's board share. ``protocol/README.md``, section 11.
"""

from __future__ import annotations

import contextlib
from typing import Annotated, Literal, TypeVar

import msgspec

from .nickname import Fault

__all__ = [
    "PING",
    "BadRequest",
    "Identifier",
    "Label",
    "LessonProgress",
    "PlaceInProgram",
    "Pong",
    "ProjectText",
    "Refusal",
    "Refused",
    "SharedKind",
    "Typed",
    "decoded",
    "encode",
]

Identifier = Annotated[str, msgspec.Meta(min_length=1, max_length=64, pattern=r"^[!-~]+$")]
"""A name that a browser gave: of a program, of a request, of a page session."""

Label = Annotated[str, msgspec.Meta(max_length=200)]
"""A name or a message that people read."""

Typed = Annotated[str, msgspec.Meta(max_length=300)]
"""What a person typed into a field."""

ProjectText = Annotated[str, msgspec.Meta(max_length=400_000)]
"""A project file: twice the characters of a program (``config.Limits.source``), for its layout and room."""

SharedKind = Literal["program", "room", "lesson"]
"""
What a teacher sends. The text of a program is a project file, that of a room a world as JSON or the name of one of the
gallery as a JSON string, that of a lesson its name, or the lesson file of one of the teacher's own.
"""

Refusal = (
    Literal[
        "code",
        "words",
        "token",
        "key",
        "attempts",
        "taken",
        "full",
        "joins",
        "request",
        "deadline",
        "tasks",
        "disk",
        "rooms",
        "comments",
        "busy",
        "away",
        "database",
        "locked",
        "removed",
    ]
    | Fault
)
"""Why a request was refused; the page has the sentences."""


class _Kind(msgspec.Struct):
    op: str


class BadRequest(Exception):
    """A message that is none of the protocol's. ``op`` is its kind, where that can be read."""

    def __init__(self, text: str | bytes, why: Exception) -> None:
        super().__init__(str(why))
        self.op: str | None = None
        with contextlib.suppress(msgspec.MsgspecError, UnicodeError, RecursionError):
            self.op = msgspec.json.decode(text, type=_Kind).op


class LessonProgress(msgspec.Struct):
    """The open lesson."""

    name: Label
    done: int
    steps: int


class PlaceInProgram(msgspec.Struct):
    """
    A place in a program that the page finds again after edits: the range from ``start`` to ``end`` (UTF-16 units) of
    ``piece``, the text of the definition with that name as it was when the place was chosen; ``None`` for lines outside
    of definitions.
    """

    definition: Label | None
    piece: Annotated[str, msgspec.Meta(min_length=1, max_length=20_000)]
    start: Annotated[int, msgspec.Meta(ge=0, le=40_000)]
    end: Annotated[int, msgspec.Meta(ge=0, le=40_000)]


PING = '{"op":"ping"}'
"""A page that has received nothing for a while asks whether the service is there; the answer is ``Pong``."""


class Pong(msgspec.Struct, tag="pong", tag_field="op"):
    """The service is there."""


class Refused(msgspec.Struct, tag="refused", tag_field="op"):
    """The request changed nothing."""

    reason: Refusal


_encoder = msgspec.json.Encoder()


_Message = TypeVar("_Message")


def decoded(decoder: msgspec.json.Decoder[_Message], text: str | bytes) -> _Message:
    """
    A message as a value.

    Raises:
        BadRequest: it is none.
    """
    try:
        return decoder.decode(text)
    except (msgspec.MsgspecError, UnicodeError, RecursionError) as error:
        raise BadRequest(text, error) from error


def encode(answer: msgspec.Struct) -> str:
    """The text of a frame."""
    return _encoder.encode(answer).decode()
