"""
Messages of a test in many rooms between a page and the service. ``protocol/README.md``, section 4.1.

The page sends one ``RoomTestRequest``; the service answers with progress and, unless the job fails, one ``Reported``.
"""

from __future__ import annotations

import math
from typing import Any, Literal

import msgspec

from ...sentences.sentence import tr
from ..problem import Problem
from .jobs import BadJob, Failed, Queued, decode_request

__all__ = [
    "FindingShown",
    "Progress",
    "Reported",
    "RoomTestAnswer",
    "RoomTestRequest",
    "SmallestRoom",
    "TestedRoom",
    "read_test",
]

MAX_ROOMS, MAX_SECONDS = 200, 120.0
"""Most rooms, and the longest run in each (s, simulated), that a page may ask for."""

_MAX_SOURCE, _MAX_WORDS = 200_000, 1000
"""Characters of a program and of the properties."""


class RoomTestRequest(msgspec.Struct, tag="test", tag_field="op", frozen=True):
    """``world`` is the room that those of the family ``like`` vary; ``properties`` are words, as for ``--hold``."""

    source: str
    family: Literal["obstacles", "maze", "pits", "like"]
    rooms: int
    seed: int
    seconds: float
    properties: str
    world: Any = None


class Progress(msgspec.Struct, tag="progress", tag_field="op"):
    """Rooms tried and passed so far; ``shrunk`` counts the rooms tried for the smallest failing one."""

    done: int
    passed: int
    shrunk: int


class FindingShown(msgspec.Struct):
    """A property in a room. ``world/properties.py`` explains ``amount``."""

    property: str
    state: Literal["open", "held", "failed"]
    time: float | None
    amount: float


class TestedRoom(msgspec.Struct):
    """How the program did in a room; times in s, points in m."""

    room: int
    seed: int
    passed: bool
    ended: str
    time: float
    findings: list[FindingShown]
    problems: list[Problem]
    world: Any
    path: list[tuple[float, float]]


class SmallestRoom(msgspec.Struct):
    """The smallest failing room: ``things`` of ``of`` are left; ``minimal`` when no smaller one fails."""

    things: int
    of: int
    minimal: bool
    tested: TestedRoom


class Reported(msgspec.Struct, tag="report", tag_field="op"):
    """The end: all rooms, worst first; or ``problems`` when the program does not compile."""

    passed: int
    rooms: list[TestedRoom]
    smallest: SmallestRoom | None
    problems: list[Problem]


RoomTestAnswer = Queued | Progress | Reported | Failed

_decoder = msgspec.json.Decoder(RoomTestRequest)


def read_test(text: str | bytes) -> RoomTestRequest:
    """
    A page's request as a value.

    Raises:
        BadJob: it is none, or asks for too much.
    """
    request = decode_request(_decoder, text)
    if not 1 <= request.rooms <= MAX_ROOMS:
        raise BadJob(tr("the number of rooms must be between 1 and {most}", most=MAX_ROOMS))
    if not (math.isfinite(request.seconds) and 0 < request.seconds <= MAX_SECONDS):
        raise BadJob(tr("the time must be more than 0 and at most {most} s", most=MAX_SECONDS))
    if len(request.source) > _MAX_SOURCE or len(request.properties) > _MAX_WORDS:
        raise BadJob(tr("the program or the list of properties is too long"))
    return request
