"""
Messages of the rehearsals of a lesson that is being written. ``protocol/README.md``, section 9.1.

The page sends one ``RehearsalRequest``; the service answers about each attempt. A closed socket cancels.
"""

from __future__ import annotations

from typing import Annotated, Any

import msgspec
from msgspec import Meta

from .. import sentence
from ..sentence import SentenceError, verbatim
from .problem import Problem, Sentence, to_wire
from .user_input import TimedInput

__all__ = ["AttemptJudged", "BadRehearsal", "Failed", "Queued", "RehearsalRequest", "encode_answer", "read_request"]

_MAX_ATTEMPTS = 64
"""Of one request. A lesson has at most twelve steps."""


class BadRehearsal(SentenceError):
    """A message is no request for rehearsals; the text says why."""


class AttemptAsked(msgspec.Struct, frozen=True):
    """A program, and the step (``seconds``, ``checks``) that it is an attempt at; ``hands`` are lines of user input."""

    source: Annotated[str, Meta(max_length=200_000)]
    step: Any
    hands: Annotated[list[TimedInput], Meta(max_length=1000)] = []


class RehearsalRequest(msgspec.Struct, tag="rehearse", tag_field="op", frozen=True):
    """All attempts at the steps of a lesson, in its room."""

    world: Any
    attempts: Annotated[list[AttemptAsked], Meta(min_length=1, max_length=_MAX_ATTEMPTS)]


class Queued(msgspec.Struct, tag="queued", tag_field="op"):
    """Tests and rehearsals of other pages are running; 1 is the next."""

    place: int


class AttemptJudged(msgspec.Struct, tag="attempt", tag_field="op"):
    """
    How an attempt did; ``number`` is its place in the request, from 0. After the last one the service sends nothing
    more. ``checks`` are verdicts, ``problems`` those of a program that was refused or failed.
    """

    number: int
    ended: str
    passed: bool
    checks: list[Any]
    problems: list[Problem]


class Failed(msgspec.Struct, tag="failed", tag_field="op", omit_defaults=True):
    """The rehearsals could not be made or went on for too long."""

    message: str
    sentence: Sentence | None = None


def failed(why: sentence.Sentence) -> Failed:
    """The failure in English with its sentence for other languages."""
    return Failed(str(why), to_wire(why))


_decoder = msgspec.json.Decoder(RehearsalRequest)
_encoder = msgspec.json.Encoder()


def read_request(text: str | bytes) -> RehearsalRequest:
    """
    A page's request as a value.

    Raises:
        BadRehearsal: it is none, or asks for too much.
    """
    try:
        return _decoder.decode(text)
    except (msgspec.DecodeError, RecursionError, UnicodeError) as error:
        raise BadRehearsal(verbatim(str(error))) from error


def encode_answer(answer: Queued | AttemptJudged | Failed) -> str:
    """The text of a message to the page."""
    return _encoder.encode(answer).decode()
