"""
Messages of a program that the teacher and a pupil edit together. ``protocol/README.md``, section 11.1.

Requests of the board and of pupils' pages are read with the other requests of their sockets.
"""

from __future__ import annotations

from typing import Annotated, Literal

import msgspec

from .message_fields import Identifier, ProjectText

__all__ = [
    "SHARING_OPS",
    "AskToShare",
    "Asked",
    "Changes",
    "Cursor",
    "Decline",
    "EndSharing",
    "Over",
    "Push",
    "Share",
    "Shared",
    "Side",
    "Update",
    "Updates",
    "Waiting",
    "length_after",
    "utf16_length",
]

SHARING_OPS = ("share", "push", "cursor")
"""Requests without whose answer, or effect on the other side, the texts of the two sides may differ."""

Side = Literal["teacher", "pupil"]

_Count = Annotated[int, msgspec.Meta(ge=0, le=1_000_000)]

Changes = Annotated[list[_Count | list[_Count | str]], msgspec.Meta(max_length=20_000)]
"""
Changes of a text from its start to its end, as CodeMirror writes them: a number keeps so many UTF-16 units, a list
deletes as many as its number says and inserts its lines.
"""

LONGEST = 400_000
"""UTF-16 units of a text: twice those of a program, because two may paste at the same time."""

_Text = Annotated[str, msgspec.Meta(max_length=LONGEST)]


# Requests of the board


class AskToShare(msgspec.Struct, tag="ask-to-share", tag_field="op"):
    """Ask a pupil whether the teacher may edit a program together with the pupil."""

    pupil: int
    program: Identifier


# Requests of a pupil's page; ``number`` is that of the question


class Share(msgspec.Struct, tag="share", tag_field="op"):
    """The pupil allows it: the program as a project file, and its Haskell, from which the changes start."""

    number: int
    project: ProjectText
    text: _Text


class Decline(msgspec.Struct, tag="decline", tag_field="op"):
    """The pupil does not allow it."""

    number: int


# Requests of both sides


class EndSharing(msgspec.Struct, tag="end-sharing", tag_field="op"):
    """End it; the board also withdraws its question so."""


class Push(msgspec.Struct, tag="push", tag_field="op"):
    """Changes that follow ``version`` of the text, one after the other."""

    version: int
    changes: Annotated[list[Changes], msgspec.Meta(min_length=1, max_length=2000)]


class Cursor(msgspec.Struct, tag="cursor", tag_field="op"):
    """Request and answer: the selection of one side in ``version`` of the text, in UTF-16 units."""

    version: int
    anchor: _Count
    head: _Count


# Answers


class Asked(msgspec.Struct, tag="asked-to-share", tag_field="op"):
    """To a pupil's page: the teacher asks."""

    number: int
    program: str
    name: str


class Waiting(msgspec.Struct, tag="share-waiting", tag_field="op"):
    """To the board: the pupil was asked."""

    pupil: int
    program: str


class Shared(msgspec.Struct, tag="shared", tag_field="op"):
    """It begins, with version 0 of the text. The board gets the program; the page that allowed it has it."""

    project: str | None = None
    text: str | None = None


class Update(msgspec.Struct):
    """Changes that have become a version."""

    by: Side
    changes: Changes


class Updates(msgspec.Struct, tag="updates", tag_field="op"):
    """To both sides: the changes that follow ``version``, in the order that holds for both."""

    version: int
    updates: list[Update]


class Over(msgspec.Struct, tag="sharing-over", tag_field="op"):
    """
    There is nothing to answer or to edit together any more: the pupil declined, one side ended it or has disconnected,
    the question was answered on another page or withdrawn.
    """

    why: Literal["declined", "ended"]


def utf16_length(text: str) -> int:
    """The length of a text as browsers count."""
    return len(text.encode("utf-16-le")) // 2


def length_after(changes: Changes, length: int) -> int | None:
    """The length of a text of this length after the changes; ``None`` if they are no changes of it."""
    before = after = 0
    for part in changes:
        if isinstance(part, int):
            before, after = before + part, after + part
            continue
        deleted, *lines = part or [""]
        if not isinstance(deleted, int):
            return None
        before += deleted
        for line in lines:
            if not isinstance(line, str) or "\n" in line or "\r" in line:
                return None
            after += utf16_length(line)
        after += max(0, len(lines) - 1)
    return after if before == length and after <= LONGEST else None
