"""
Messages of the socket of a pupil's page in class mode. ``protocol/README.md``, section 11.

Requests are read into values; answers are values whose encoding is the frame.
"""

from __future__ import annotations

from typing import Annotated, Literal

import msgspec

from ..store.class_store import Reason
from .message_fields import (
    Identifier,
    Label,
    LessonProgress,
    PlaceInProgram,
    ProjectText,
    Refused,
    SharedKind,
    Typed,
    decoded,
)
from .shared_messages import Asked, Cursor, Decline, EndSharing, Over, Push, Share, Updates
from .shared_messages import Shared as ShareBegun

__all__ = [
    "AnswerStudy",
    "Attention",
    "ClassNamed",
    "CommentDone",
    "Conflicting",
    "Enter",
    "Entered",
    "Forget",
    "Hand",
    "HandIn",
    "Handout",
    "Here",
    "Join",
    "Lowered",
    "NotHandedIn",
    "OwnComment",
    "OwnComments",
    "OwnHandIn",
    "OwnStudy",
    "OwnTask",
    "OwnTasks",
    "ProgramName",
    "Progress",
    "PupilAnswer",
    "PupilRequest",
    "Read",
    "Renamed",
    "Resume",
    "Save",
    "SaveFailed",
    "Saved",
    "Status",
    "Stored",
    "read_pupil_request",
]

# Requests of a pupil's page


class Join(msgspec.Struct, tag="join", tag_field="op"):
    """A new pupil; the words are drawn from the list of ``language``."""

    code: Typed
    nickname: Typed
    language: Annotated[str, msgspec.Meta(max_length=35)] = "en"


class Resume(msgspec.Struct, tag="resume", tag_field="op"):
    """A pupil on another device."""

    code: Typed
    words: Typed


class Enter(msgspec.Struct, tag="enter", tag_field="op"):
    """A pupil on a device that joined before."""

    token: Typed


class Forget(msgspec.Struct, tag="forget", tag_field="op"):
    """The pupil leaves the class on this device."""


class Here(msgspec.Struct, tag="here", tag_field="op"):
    """The page session whose room the board shows."""

    session: Identifier


class Save(msgspec.Struct, tag="save", tag_field="op"):
    """Store a version of a program; ``ClassStore.save`` explains the fields."""

    program: Identifier
    name: Label
    text: ProjectText
    reason: Reason
    base: int
    mark: Identifier
    unacknowledged: Annotated[list[Identifier], msgspec.Meta(max_length=50, extra={"constant": True})] = []


class Read(msgspec.Struct, tag="read", tag_field="op"):
    """The newest version of an own program."""

    program: Identifier


class Status(msgspec.Struct, tag="status", tag_field="op"):
    """What the board shows of the page; ``None`` is no lesson, and a ``program`` that is not stored."""

    errors: bool
    running: bool
    lesson: LessonProgress | None = None
    program: Identifier | None = None


class Hand(msgspec.Struct, tag="hand", tag_field="op"):
    """Raise or lower the hand."""

    up: bool


class HandIn(msgspec.Struct, tag="hand-in", tag_field="op"):
    """Hand in a program for a task, in place of an earlier one."""

    task: int
    name: Label
    text: ProjectText


LessonName = Annotated[str, msgspec.Meta(min_length=1, max_length=200)]
"""Of a lesson of the service, or of a teacher's own, which has a space in it."""


class Progress(msgspec.Struct, tag="progress", tag_field="op"):
    """Steps of a lesson that are done, of ``steps``; those stored earlier stay done."""

    lesson: LessonName
    title: Label
    steps: Annotated[int, msgspec.Meta(ge=0, le=100)]
    done: Annotated[list[Identifier], msgspec.Meta(max_length=100)]


class CommentDone(msgspec.Struct, tag="comment-done", tag_field="op"):
    """The pupil has dealt with a comment on an own program, or has not after all."""

    comment: int
    done: bool


class AnswerStudy(msgspec.Struct, tag="answer-study", tag_field="op"):
    """The pupil takes part in the study of the class, or does not."""

    agrees: bool


PupilRequest = (
    Join
    | Resume
    | Enter
    | Forget
    | Here
    | Save
    | Read
    | Status
    | Hand
    | HandIn
    | Progress
    | CommentDone
    | AnswerStudy
    | Share
    | Decline
    | Push
    | Cursor
    | EndSharing
)


# Answers to a pupil's page


class ClassNamed(msgspec.Struct, tag="class", tag_field="op"):
    """
    The first message of a connection: a public identifier of the class, with which a browser tells classes apart that
    follow one another at the same address.
    """

    id: str


class ProgramName(msgspec.Struct):
    """An own program and its newest version; ``at`` is in s since 1970."""

    id: str
    name: str
    version: int
    at: float


class Entered(msgspec.Struct, tag="entered", tag_field="op"):
    """
    The pupil is in the class. ``token`` is new after ``join`` and ``resume``, else ``None``. ``progress`` has the ids
    of the steps that are done, by lesson.
    """

    pupil: int
    nickname: str
    words: str
    token: str | None
    hand: bool
    programs: list[ProgramName]
    progress: dict[str, list[str]] = {}


class Stored(msgspec.Struct, tag="program", tag_field="op"):
    """The newest version of an own program."""

    program: str
    version: int
    name: str
    text: str


class Saved(msgspec.Struct, tag="saved", tag_field="op"):
    """What ``mark`` asked for is on the teacher's disk."""

    program: str
    mark: str
    version: int


class Conflicting(msgspec.Struct, tag="conflict", tag_field="op"):
    """What ``mark`` asked for is not stored: another device stored this version meanwhile."""

    program: str
    mark: str
    version: int
    name: str
    text: str


class SaveFailed(msgspec.Struct, tag="unsaved", tag_field="op"):
    """
    What ``mark`` asked for cannot be stored: the pupil's share of the disk is full, the disk is full or broken, or the
    database cannot be reached.
    """

    program: str
    mark: str
    reason: Literal["full", "disk", "database"]


class Attention(msgspec.Struct, tag="attention", tag_field="op"):
    """Pause and show this message; ``None`` ends it."""

    message: str | None


class Handout(msgspec.Struct, tag="handout", tag_field="op"):
    """A program, a room or a lesson from the teacher."""

    id: str
    what: SharedKind
    name: str
    text: str


class Renamed(msgspec.Struct, tag="renamed", tag_field="op"):
    """The teacher has given the pupil another nickname."""

    nickname: str


class Lowered(msgspec.Struct, tag="lowered", tag_field="op"):
    """The teacher has seen the raised hand."""


class OwnHandIn(msgspec.Struct):
    """When a pupil handed in, in s since 1970, the program's name, and the teacher's comment; empty for none."""

    at: float
    name: str
    comment: str


class OwnTask(msgspec.Struct):
    """A task as a pupil sees it; ``left`` are the s until its deadline, ``None`` without one."""

    id: int
    title: str
    open: bool
    deadline: float | None
    left: float | None
    handed_in: OwnHandIn | None


class OwnTasks(msgspec.Struct, tag="tasks", tag_field="op"):
    """The task that is open, and those for which the pupil handed in, oldest first."""

    tasks: list[OwnTask]


class NotHandedIn(msgspec.Struct, tag="not-handed-in", tag_field="op"):
    """The program was not handed in: the task has ended, the disk is full, or the database cannot be reached."""

    task: int
    reason: Literal["late", "full", "database"]


class OwnComment(msgspec.Struct):
    """The teacher's comment on a place in an own program; ``at`` in s since 1970."""

    id: int
    program: str
    at: float
    text: str
    place: PlaceInProgram
    done: bool


class OwnComments(msgspec.Struct, tag="comments", tag_field="op"):
    """All comments on own programs, oldest first."""

    comments: list[OwnComment]


class OwnStudy(msgspec.Struct, tag="study", tag_field="op"):
    """
    Whom to ask about the study of the class, ``None`` without a study; and whether the pupil takes part, ``None``
    without an answer.
    """

    contact: str | None
    takes_part: bool | None


PupilAnswer = (
    ClassNamed
    | Entered
    | Refused
    | Stored
    | Saved
    | Conflicting
    | SaveFailed
    | Attention
    | Handout
    | Renamed
    | Lowered
    | OwnTasks
    | NotHandedIn
    | OwnComments
    | OwnStudy
    | Asked
    | ShareBegun
    | Updates
    | Cursor
    | Over
)


_decoder: msgspec.json.Decoder[PupilRequest] = msgspec.json.Decoder(PupilRequest)


def read_pupil_request(text: str | bytes) -> PupilRequest:
    """
    Read a message of a pupil's page.

    Raises:
        BadRequest: it is none.
    """
    return decoded(_decoder, text)
