"""
Messages of the socket of the teacher's board. ``protocol/README.md``, section 11.

Requests are read into values; answers are values whose encoding is the frame.
"""

from __future__ import annotations

from typing import Annotated, Any, Literal

import msgspec

from ..store.database import StoreFault
from .check_messages import (
    CancelCheck,
    CheckAll,
    Checking,
    CheckNew,
    OpenRun,
    ResultShown,
    RoomsShown,
    RunShown,
    ShowResults,
    ShowRooms,
)
from .message_fields import (
    Identifier,
    Label,
    LessonProgress,
    PlaceInProgram,
    ProjectText,
    Refusal,
    Refused,
    SharedKind,
    Typed,
    decoded,
)
from .projector_messages import Project, Projecting
from .pupil_messages import OwnComment
from .shared_messages import AskToShare, Cursor, EndSharing, Over, Push, Updates, Waiting
from .shared_messages import Shared as ShareBegun

__all__ = [
    "AddComment",
    "AddPupils",
    "BoardAnswer",
    "BoardRequest",
    "BoardShown",
    "BoardTask",
    "BoardTasks",
    "CloseTask",
    "Comment",
    "CommentsShown",
    "DoorShown",
    "HandedIn",
    "LessonShown",
    "LessonsShown",
    "LockDoor",
    "LowerHand",
    "MergePupils",
    "Need",
    "NicknameRefused",
    "OpenHandIn",
    "OpenProgram",
    "OpenTask",
    "Place",
    "PlacesShown",
    "ProgramChanged",
    "ProgramShown",
    "PupilShown",
    "PupilsAdded",
    "PupilsShown",
    "RemoveComment",
    "RemovePupils",
    "RemovedShown",
    "RenamePupil",
    "RestorePupil",
    "RoomShown",
    "Send",
    "Sent",
    "SetAttention",
    "SetStudy",
    "StoreShown",
    "StudyShown",
    "Suspended",
    "Unlock",
    "read_board_request",
]

Date = Annotated[float, msgspec.Meta(ge=0, le=4_102_444_800)]
"""Seconds since 1970, until 2100."""

Need = Literal["hand", "error", "idle"]
"""Why a pupil may need help: a raised hand, an error for a minute, no run for five minutes of a free class."""

CommentText = Annotated[str, msgspec.Meta(max_length=2000)]
"""A teacher's comment."""


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


class Send(msgspec.Struct, tag="send", tag_field="op"):
    """Send a program, a room or a lesson to these pupils, or to all if ``pupils`` is ``None``."""

    name: Label
    text: ProjectText
    what: SharedKind = "program"
    pupils: Annotated[list[int], msgspec.Meta(min_length=1, max_length=1000)] | None = None


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


class AddComment(msgspec.Struct, tag="add-comment", tag_field="op"):
    """Comment on a place in a pupil's program."""

    pupil: int
    program: Identifier
    text: Annotated[str, msgspec.Meta(min_length=1, max_length=2000)]
    place: PlaceInProgram


class RemoveComment(msgspec.Struct, tag="remove-comment", tag_field="op"):
    """Take back a comment on a place in a program."""

    comment: int


class AddPupils(msgspec.Struct, tag="add-pupils", tag_field="op"):
    """
    Add pupils who have not joined yet, and do with their three words, which are drawn from the list of ``language``;
    the answer is ``PupilsAdded``.
    """

    nicknames: Annotated[list[Typed], msgspec.Meta(min_length=1, max_length=400)]
    language: Annotated[str, msgspec.Meta(max_length=35)] = "en"


class RenamePupil(msgspec.Struct, tag="rename-pupil", tag_field="op"):
    """Give a pupil another nickname."""

    pupil: int
    nickname: Typed


class RemovePupils(msgspec.Struct, tag="remove-pupils", tag_field="op"):
    """Remove pupils from the class; they can be restored for some time."""

    pupils: Annotated[list[int], msgspec.Meta(min_length=1, max_length=400)]


class RestorePupil(msgspec.Struct, tag="restore-pupil", tag_field="op"):
    """Restore a removed pupil."""

    pupil: int


class MergePupils(msgspec.Struct, tag="merge-pupils", tag_field="op"):
    """Make two entries of one pupil one: that of ``pupil`` becomes a part of that of ``into``."""

    pupil: int
    into: int


class LockDoor(msgspec.Struct, tag="lock-door", tag_field="op"):
    """Let no new pupils in, or let them in again."""

    locked: bool


class SetStudy(msgspec.Struct, tag="set-study", tag_field="op"):
    """The class takes part in a study, about which pupils ask ``contact``; ``None`` ends it."""

    contact: Annotated[str, msgspec.Meta(min_length=1, max_length=200)] | None


BoardRequest = (
    Unlock
    | AddPupils
    | RenamePupil
    | RemovePupils
    | RestorePupil
    | MergePupils
    | LockDoor
    | SetStudy
    | OpenProgram
    | SetAttention
    | LowerHand
    | Send
    | OpenTask
    | CloseTask
    | OpenHandIn
    | Comment
    | AddComment
    | RemoveComment
    | Project
    | CheckAll
    | CheckNew
    | CancelCheck
    | ShowResults
    | ShowRooms
    | OpenRun
    | AskToShare
    | Push
    | Cursor
    | EndSharing
)


# Answers to the board


class BoardShown(msgspec.Struct, tag="board", tag_field="op"):
    """The key fits."""

    code: str
    addresses: list[str]
    attention: str | None


class StoreShown(msgspec.Struct, tag="store", tag_field="op"):
    """Why nothing can be stored now; ``None`` when it can."""

    fault: StoreFault | None


class Suspended(msgspec.Struct, tag="suspended", tag_field="op"):
    """
    The service did nothing for so many ``seconds`` before ``at``, in s since 1970: its machine slept, or its lid was
    closed.
    """

    at: float
    seconds: float


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
    # Comments on places in the pupil's programs, and those that the pupil has dealt with.
    comments: int
    done: int


class PupilsShown(msgspec.Struct, tag="pupils", tag_field="op"):
    """
    All pupils, in the order in which they joined. ``most_idle``: more than half of the
    connected pupils have not run a program for five minutes; then none of them has the need ``idle``.
    """

    pupils: list[PupilShown]
    most_idle: bool = False


class NicknameRefused(msgspec.Struct):
    """A nickname that was not added, and why."""

    nickname: str
    reason: Refusal


class PupilsAdded(msgspec.Struct, tag="pupils-added", tag_field="op"):
    """So many pupils were added."""

    added: int
    refused: list[NicknameRefused]


class RemovedShown(msgspec.Struct):
    """
    A pupil who was removed; ``at`` is when, and everything stored of the pupil is kept until ``until`` for certain, in
    s since 1970.
    """

    id: int
    nickname: str
    at: float
    until: float


class DoorShown(msgspec.Struct, tag="door", tag_field="op"):
    """Whether new pupils are let in, and who was removed and can be restored, the pupil removed last first."""

    locked: bool
    removed: list[RemovedShown]


class StudyShown(msgspec.Struct, tag="study", tag_field="op"):
    """Whom pupils ask about the study of the class, ``None`` without a study; and how many pupils take part."""

    contact: str | None
    taking_part: int


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
    """
    A pupil's program; ``text`` is ``None`` if there is none. ``program`` is its identifier, ``None`` for a hand-in.
    """

    pupil: int
    name: str
    text: str | None
    program: str | None = None


class ProgramChanged(msgspec.Struct, tag="program-changed", tag_field="op"):
    """Another version of the program that the board opened last is stored."""

    pupil: int
    program: str
    name: str
    text: str


class Sent(msgspec.Struct, tag="sent", tag_field="op"):
    """It was sent to so many pages; so many pupils are not connected and get it when they are."""

    pages: int
    later: int


class HandedIn(msgspec.Struct):
    """
    A pupil's hand-in for a task, without its text; ``at`` in s since 1970. The programs of the pupils ``alike`` differ
    from it in comments, layout and names of their own only. ``lesson`` is the lesson in which it was made, empty for
    none.
    """

    pupil: int
    at: float
    name: str
    comment: str
    alike: list[int]
    lesson: str = ""


class BoardTask(msgspec.Struct):
    """
    A task with its hand-ins, oldest first; times in s since 1970. ``checked``: there was a check of all hand-ins.
    """

    id: int
    title: str
    opened: float
    deadline: float | None
    open: bool
    handed_in: list[HandedIn]
    checked: bool = False


class BoardTasks(msgspec.Struct, tag="tasks", tag_field="op"):
    """The newest tasks, oldest first."""

    tasks: list[BoardTask]


class LessonShown(msgspec.Struct, array_like=True):
    """So many of the steps of a lesson are done by a pupil."""

    pupil: int
    lesson: str
    title: str
    done: int
    steps: int


class LessonsShown(msgspec.Struct, tag="lessons", tag_field="op"):
    """The progress of all pupils in lessons."""

    lessons: list[LessonShown]


class CommentsShown(msgspec.Struct, tag="comments", tag_field="op"):
    """The comments on the programs of the pupil whose program the board opened last, oldest first."""

    pupil: int
    comments: list[OwnComment]


BoardAnswer = (
    BoardShown
    | StoreShown
    | Suspended
    | PupilsShown
    | PupilsAdded
    | DoorShown
    | StudyShown
    | RoomShown
    | PlacesShown
    | ProgramShown
    | ProgramChanged
    | Sent
    | Refused
    | BoardTasks
    | LessonsShown
    | CommentsShown
    | Projecting
    | Checking
    | ResultShown
    | RoomsShown
    | RunShown
    | Waiting
    | ShareBegun
    | Updates
    | Cursor
    | Over
)


_decoder: msgspec.json.Decoder[BoardRequest] = msgspec.json.Decoder(BoardRequest)


def read_board_request(text: str | bytes) -> BoardRequest:
    """
    Read a message of the board.

    Raises:
        BadRequest: it is none.
    """
    return decoded(_decoder, text)
