"""
A lesson as one JSON value: what ``GET /api/lessons/<name>`` answers, what a page writes, and opens as a file or link.

``protocol/lesson-document.schema.json`` is generated from the types here.
"""

from __future__ import annotations

from typing import Annotated, Any

import msgspec
from msgspec import Meta

from .checks import Identifier
from .lesson_file import LessonTexts, Step

__all__ = ["DocumentStep", "LessonDocument"]

Haskell = Annotated[str, Meta(description="A program.")]


class WrongAttempt(msgspec.Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """A typical wrong attempt at a step."""

    check: Annotated[str, Meta(description="The id of the check that it fails.")]
    program: Haskell


class DocumentStep(Step, frozen=True, forbid_unknown_fields=True, kw_only=True, omit_defaults=True):
    """A step of ``lesson.json``, with the program itself in place of the name of its file."""

    program: Haskell | None = None
    wrong: Annotated[list[WrongAttempt], Meta(max_length=20, description="For teachers.")] = msgspec.field(
        default_factory=list
    )


class LessonDocument(msgspec.Struct, frozen=True, forbid_unknown_fields=True, kw_only=True, omit_defaults=True):
    """A whole lesson. Only a lesson of the service has ``course``, ``number`` and ``next``."""

    schema: str | None = msgspec.field(name="$schema", default=None)
    lesson: Annotated[int, Meta(ge=1, description="Version of the format.")]
    name: Annotated[str, Meta(min_length=1, max_length=80, description="Tells the progress of lessons apart.")]
    course: Identifier | None = None
    number: Annotated[int, Meta(ge=1, le=999, description="Place in the list of all lessons.")] | None = None
    room: Annotated[dict[str, Any], Meta(description="A room, as world.schema.json describes it.")]
    toolbox: (
        Annotated[list[str], Meta(description="What the blocks of the toolbox say; absent: all blocks.")] | None
    ) = None
    start: Haskell
    solution: Annotated[str, Meta(description="A program that passes the last step; for teachers.")] | None = None
    steps: Annotated[list[DocumentStep], Meta(min_length=1, max_length=12)]
    # By the tag of the language (BCP 47); a page shows its own language, else English, else the first.
    texts: Annotated[dict[str, LessonTexts], Meta(min_length=1)]
    next: str | None = None
