"""
Messages of the rehearsals of a lesson that is being written. ``protocol/README.md``, section 9.1.

The page sends one ``RehearsalRequest``; the service answers about each attempt.
"""

from __future__ import annotations

from typing import Annotated, Any, Literal

import msgspec
from msgspec import Meta

from ..problem import Problem
from ..user_input import TimedInput
from ..verdict import Verdict
from .jobs import Failed, Queued, decode_request

__all__ = ["AttemptAsked", "AttemptJudged", "RehearsalAnswer", "RehearsalRequest", "read_request"]

_MAX_ATTEMPTS = 64
"""Of one request. A lesson has at most twelve steps."""


class AttemptAsked(msgspec.Struct, frozen=True):
    """A program, and the step (``seconds``, ``checks``) that it is an attempt at; ``hands`` are lines of user input."""

    source: Annotated[str, Meta(max_length=200_000)]
    step: Any
    hands: Annotated[list[TimedInput], Meta(max_length=1000)] = []


class RehearsalRequest(msgspec.Struct, tag="rehearse", tag_field="op", frozen=True):
    """All attempts at the steps of a lesson, in its room."""

    world: Any
    attempts: Annotated[list[AttemptAsked], Meta(min_length=1, max_length=_MAX_ATTEMPTS)]


class AttemptJudged(msgspec.Struct, tag="attempt", tag_field="op"):
    """
    How an attempt did; ``number`` is its place in the request, from 0. After the last one the service sends nothing
    more. ``problems`` are those of a program that was refused or failed.
    """

    number: int
    ended: Literal["time", "done", "error", "stuck", "refused"]
    passed: bool
    checks: list[Verdict]
    problems: list[Problem]


RehearsalAnswer = Queued | AttemptJudged | Failed

_decoder = msgspec.json.Decoder(RehearsalRequest)


def read_request(text: str | bytes) -> RehearsalRequest:
    """
    A page's request as a value.

    Raises:
        BadJob: it is none, or asks for too much.
    """
    return decode_request(_decoder, text)
