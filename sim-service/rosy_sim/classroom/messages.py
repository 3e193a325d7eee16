"""
Messages of the sockets of class mode. ``protocol/README.md``, section 11.

Requests of pupils and of the teacher's board are read into values; answers are values whose encoding is the frame.
"""

from __future__ import annotations

from typing import Annotated, Any, Literal

import msgspec

from .check_messages import CancelCheck, CheckAll, Checking, OpenRun, ResultShown, RunShown, ShowResults
from .class_store import Reason
from .nickname import Fault

__all__ = [
    "Attention",
    "BadRequest",
    "BoardAnswer",
    "BoardRequest",
    "BoardShown",
    "BoardTask",
    "BoardTasks",
    "CloseTask",
    "Comment",
    "Conflicting",
    "Enter",
    "Entered",
    "Forget",
    "Hand",
    "HandIn",
    "HandedIn",
    "Handout",
    "Here",
    "Join",
    "LessonProgress",
    "LowerHand",
    "Lowered",
    "Need",
    "NotHandedIn",
    "OpenHandIn",
    "OpenProgram",
    "OpenTask",
    "OwnHandIn",
    "OwnTask",
    "OwnTasks",
    "Place",
    "PlacesShown",
    "ProgramName",
    "ProgramShown",
    "PupilAnswer",
    "PupilRequest",
    "PupilShown",
    "PupilsShown",
    "Read",
    "Refused",
    "Resume",
    "RoomShown",
    "Save",
    "SaveFailed",
    "Saved",
    "SendProgram",
    "Sent",
    "SetAttention",
    "Status",
    "Stored",
    "Unlock",
    "encode",
    "read_board_request",
    "read_pupil_request",
]

Identifier = Annotated[str, msgspec.Meta(min_length=1, max_length=64, pattern=r"^[!-~]+$")]
"""A name that a browser gave: of a program, of a request, of a page session."""

Label = Annotated[str, msgspec.Meta(max_length=200)]
"""A name or a message that people read."""

Typed = Annotated[str, msgspec.Meta(max_length=300)]
"""What a person typed into a field."""

ProjectText = Annotated[str, msgspec.Meta(max_length=400_000)]
"""A project file: twice the characters of a program (``config.Limits.source``), for its layout and room."""

Date = Annotated[float, msgspec.Meta(ge=0, le=4_102_444_800)]
"""Seconds since 1970, until 2100."""

Need = Literal["hand", "error", "idle"]
"""Why a pupil may need help: a raised hand, an error for a minute, no run for five minutes."""

CommentText = Annotated[str, msgspec.Meta(max_length=2000)]
"""A teacher's comment on a hand-in."""

Refusal = (
    Literal[
        "code", "words", "token", "key", "attempts", "taken", "full", "request", "deadline", "tasks", "disk", "rooms"
    ]
    | Fault
)
"""Why a request was refused; the page has the sentences."""


class BadRequest(Exception):
    """A message that is none of the protocol's."""


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
    unacknowledged: Annotated[list[Identifier], msgspec.Meta(max_length=50)] = []


class Read(msgspec.Struct, tag="read", tag_field="op"):
    """The newest version of an own program."""

    program: Identifier


class LessonProgress(msgspec.Struct):
    """The open lesson."""

    name: Label
    done: int
    steps: int


class Status(msgspec.Struct, tag="status", tag_field="op"):
    """What the board shows of the page; ``None`` is no lesson."""

    errors: bool
    running: bool
    lesson: LessonProgress | None = None


class Hand(msgspec.Struct, tag="hand", tag_field="op"):
    """Raise or lower the hand."""

    up: bool


class HandIn(msgspec.Struct, tag="hand-in", tag_field="op"):
    """Hand in a program for a task, in place of an earlier one."""

    task: int
    name: Label
    text: ProjectText


PupilRequest = Join | Resume | Enter | Forget | Here | Save | Read | Status | Hand | HandIn


# Answers to a pupil's page


class ProgramName(msgspec.Struct):
    """An own program and its newest version; ``at`` is in s since 1970."""

    id: str
    name: str
    version: int
    at: float


class Entered(msgspec.Struct, tag="entered", tag_field="op"):
    """The pupil is in the class. ``token`` is new after ``join`` and ``resume``, else ``None``."""

    pupil: int
    nickname: str
    words: str
    token: str | None
    hand: bool
    programs: list[ProgramName]


class Refused(msgspec.Struct, tag="refused", tag_field="op"):
    """The request changed nothing."""

    reason: Refusal


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
    """What ``mark`` asked for cannot be stored: the disk, or the pupil's share of it, is full."""

    program: str
    mark: str


class Attention(msgspec.Struct, tag="attention", tag_field="op"):
    """Pause and show this message; ``None`` ends it."""

    message: str | None


class Handout(msgspec.Struct, tag="handout", tag_field="op"):
    """A program from the teacher."""

    id: str
    name: str
    text: str


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
    """The program was not handed in: the task has ended, or the disk is full."""

    task: int
    reason: Literal["late", "full"]


PupilAnswer = (
    Entered
    | Refused
    | Stored
    | Saved
    | Conflicting
    | SaveFailed
    | Attention
    | Handout
    | Lowered
    | OwnTasks
    | NotHandedIn
)


# Requests of the board


class Unlock(msgspec.Struct, tag="unlock", tag_field="op"):
    """The teacher's key."""

    key: Typed


class OpenProgram(msgspec.Struct, tag="open", tag_field="op"):
    """The newest version of a pupil's program; of the one that was changed last if ``program`` is ``None``."""

    pupil: int
    program: Identifier | None = None


class SetAttention(msgspec.Struct, tag="attention", tag_field="op"):
    """Pause all pages with a message; ``None`` ends it."""

    message: Label | None


class LowerHand(msgspec.Struct, tag="lower", tag_field="op"):
    """The raised hand was seen."""

    pupil: int


class SendProgram(msgspec.Struct, tag="send", tag_field="op"):
    """Send a program to all pupils."""

    name: Label
    text: ProjectText


class OpenTask(msgspec.Struct, tag="open-task", tag_field="op"):
    """Begin a task, which ends the one before; ``deadline`` in s since 1970, ``None`` for none."""

    title: Annotated[str, msgspec.Meta(min_length=1, max_length=200)]
    deadline: Date | None = None


class CloseTask(msgspec.Struct, tag="close-task", tag_field="op"):
    """End a task."""

    task: int


class OpenHandIn(msgspec.Struct, tag="open-hand-in", tag_field="op"):
    """A pupil's hand-in for a task; the answer is ``ProgramShown``."""

    task: int
    pupil: int


class Comment(msgspec.Struct, tag="comment", tag_field="op"):
    """Set the comment on a hand-in; an empty one removes it."""

    task: int
    pupil: int
    text: CommentText


BoardRequest = (
    Unlock
    | OpenProgram
    | SetAttention
    | LowerHand
    | SendProgram
    | OpenTask
    | CloseTask
    | OpenHandIn
    | Comment
    | CheckAll
    | CancelCheck
    | ShowResults
    | OpenRun
)


# Answers to the board


class BoardShown(msgspec.Struct, tag="board", tag_field="op"):
    """The key fits."""

    code: str
    addresses: list[str]
    attention: str | None


class PupilShown(msgspec.Struct):
    """A pupil; ``changed`` is when a program of theirs was stored last, in s ago."""

    id: int
    nickname: str
    words: str
    online: bool
    running: bool
    program: str | None
    changed: float | None
    lesson: LessonProgress | None
    needs: list[Need]


class PupilsShown(msgspec.Struct, tag="pupils", tag_field="op"):
    """All pupils, in the order in which they joined."""

    pupils: list[PupilShown]


class RoomShown(msgspec.Struct, tag="room", tag_field="op"):
    """The room that a pupil's page shows."""

    pupil: int
    world: Any


class Place(msgspec.Struct, array_like=True):
    """Where a pupil's robot is, in m and radians."""

    pupil: int
    x: float
    y: float
    theta: float


class PlacesShown(msgspec.Struct, tag="places", tag_field="op"):
    """The robots that moved since the last message."""

    places: list[Place]


class ProgramShown(msgspec.Struct, tag="program", tag_field="op"):
    """A pupil's program; ``text`` is ``None`` if there is none."""

    pupil: int
    name: str
    text: str | None


class Sent(msgspec.Struct, tag="sent", tag_field="op"):
    """A program was sent to so many pages."""

    pages: int


class HandedIn(msgspec.Struct):
    """
    A pupil's hand-in for a task, without its text; ``at`` in s since 1970. The programs of the pupils ``alike`` differ
    from it in comments, layout and names of their own only.
    """

    pupil: int
    at: float
    name: str
    comment: str
    alike: list[int]


class BoardTask(msgspec.Struct):
    """A task with its hand-ins, oldest first; times in s since 1970."""

    id: int
    title: str
    opened: float
    deadline: float | None
    open: bool
    handed_in: list[HandedIn]


class BoardTasks(msgspec.Struct, tag="tasks", tag_field="op"):
    """The newest tasks, oldest first."""

    tasks: list[BoardTask]


BoardAnswer = (
    BoardShown
    | PupilsShown
    | RoomShown
    | PlacesShown
    | ProgramShown
    | Sent
    | Refused
    | BoardTasks
    | Checking
    | ResultShown
    | RunShown
)


_encoder = msgspec.json.Encoder()
_pupil_requests: msgspec.json.Decoder[PupilRequest] = msgspec.json.Decoder(PupilRequest)
_board_requests: msgspec.json.Decoder[BoardRequest] = msgspec.json.Decoder(BoardRequest)


def encode(answer: PupilAnswer | BoardAnswer) -> str:
    """The text of a frame."""
    return _encoder.encode(answer).decode()


def read_pupil_request(text: str | bytes) -> PupilRequest:
    """
    Read a message of a pupil's page.

    Raises:
        BadRequest: it is none.
    """
    try:
        return _pupil_requests.decode(text)
    except (msgspec.MsgspecError, UnicodeDecodeError) as error:
        raise BadRequest(str(error)) from error


def read_board_request(text: str | bytes) -> BoardRequest:
    """
    Read a message of the board.

    Raises:
        BadRequest: it is none.
    """
    try:
        return _board_requests.decode(text)
    except (msgspec.MsgspecError, UnicodeDecodeError) as error:
        raise BadRequest(str(error)) from error
