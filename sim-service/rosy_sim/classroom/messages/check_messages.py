"""
Messages about checks of all hand-ins of a task, between the teacher's board and the service, and the stored result of a
check. ``protocol/README.md``, section 11.
"""

from __future__ import annotations

from typing import Annotated, Any, Literal

import msgspec

from ...wire.page.room_tests import MAX_ROOMS, MAX_SECONDS, TestedRoom
from ...wire.problem import Problem

__all__ = [
    "ROOMS_OF_A_MESSAGE",
    "CancelCheck",
    "CheckAll",
    "CheckNew",
    "CheckResult",
    "Checking",
    "Fault",
    "OpenRun",
    "ResultShown",
    "RoomsShown",
    "RunShown",
    "ShowResults",
    "ShowRooms",
]

Fault = Literal["compile", "room", "time", "lost", "lesson"]
"""
Why a program has no outcome in the rooms: it does not compile; the room of the hand-in cannot be used; the test took
too long; the trial process was lost; it was made in no lesson.
"""

ROOMS_OF_A_MESSAGE = 20


# Requests of the board


class CheckAll(msgspec.Struct, tag="check-all", tag_field="op"):
    """
    Try every hand-in of a task in the same rooms. The family ``room`` has ``world`` as its first room and rooms like it
    as the others; ``own`` likewise the room of each hand-in. ``lesson`` judges each hand-in by the checks and in the
    rooms of the lesson in which it was made; only ``task`` counts then.
    """

    task: int
    family: Literal["obstacles", "maze", "pits", "room", "own", "lesson"]
    rooms: Annotated[int, msgspec.Meta(ge=1, le=MAX_ROOMS)]
    seed: Annotated[int, msgspec.Meta(ge=0, lt=2**31)]
    # Of each run, simulated.
    seconds: Annotated[float, msgspec.Meta(gt=0, le=MAX_SECONDS)]
    properties: Annotated[str, msgspec.Meta(max_length=1000)]
    world: Any = None


class CheckNew(msgspec.Struct, tag="check-new", tag_field="op"):
    """Try the hand-ins of a task that have no result as its newest ``CheckAll`` has tried the others."""

    task: int


class CancelCheck(msgspec.Struct, tag="cancel-check", tag_field="op"):
    """End the check; the results so far stay."""


class ShowResults(msgspec.Struct, tag="show-results", tag_field="op"):
    """The results of this task are sent from now on, now and whenever one is new."""

    task: int


class ShowRooms(msgspec.Struct, tag="show-rooms", tag_field="op"):
    """All rooms in which a hand-in was tried; the answers are ``RoomsShown``."""

    task: int
    pupil: int


class OpenRun(msgspec.Struct, tag="open-run", tag_field="op"):
    """A hand-in with one of the rooms in which it was tried, by its number; the answer is ``RunShown``."""

    task: int
    pupil: int
    room: int


# Answers to the board


class Checking(msgspec.Struct, tag="checking", tag_field="op"):
    """
    Programs of a task that are checked, of so many, and rooms tried; ``task`` is ``None`` when no check goes on.
    ``number`` counts the checks since the service started, so that the end of each is a message.
    """

    number: int = 0
    task: int | None = None
    done: int = 0
    of: int = 0
    rooms: int = 0


class CheckResult(msgspec.Struct):
    """
    How a hand-in did: in ``passed`` of ``rooms`` rooms it went well, and ``worst`` is the room in which it did worst.
    With a ``fault`` there are no outcomes; ``problems`` are those of a program that does not compile. ``checked`` is in
    s since 1970; the family, the seed and the properties are those of the request. ``unmet`` are the checks of the
    lesson that did not pass, by language; a check by the lesson has no ``worst`` and no ``time``, which is that of
    ``standings.mean_time``.
    """

    checked: float
    family: str
    rooms: int
    seed: int
    seconds: float
    properties: str
    passed: int = 0
    fault: Fault | None = None
    problems: list[Problem] = []
    worst: TestedRoom | None = None
    unmet: list[dict[str, str]] = []
    time: float | None = None


class ResultShown(msgspec.Struct, tag="result", tag_field="op"):
    """The result of a hand-in, a ``CheckResult``; ``null`` when the pupil has handed in again since."""

    task: int
    pupil: int
    result: Annotated[msgspec.Raw, msgspec.Meta(extra={"holds": CheckResult | None})]


class RoomsShown(msgspec.Struct, tag="rooms", tag_field="op"):
    """
    Rooms of a hand-in, worst first. ``after`` counts those of the messages before; a message has at most
    ``ROOMS_OF_A_MESSAGE``, so that none keeps the service busy.
    """

    task: int
    pupil: int
    after: int
    rooms: list[TestedRoom]


class RunShown(msgspec.Struct, tag="run", tag_field="op"):
    """A hand-in, a room, and the seed of its run there; ``text`` is ``None`` if it has no outcome in such a room."""

    pupil: int
    room: int
    name: str
    text: str | None
    world: Any = None
    seed: int = 0
