"""
Messages of a background job of a page, on a socket of its own: tests in many rooms and rehearsals of a lesson.
``protocol/README.md``, sections 4.1 and 9.1.

The page sends one request; the service answers until the job is done. A closed socket cancels.
"""

from __future__ import annotations

from typing import TypeVar

import msgspec

from ...sentences import sentence
from ...sentences.sentence import SentenceError, verbatim
from ..problem import Sentence, to_wire

__all__ = ["BadJob", "Failed", "Queued", "decode_request", "encode_answer", "failed"]

_Request = TypeVar("_Request")


class BadJob(SentenceError):
    """A message is no request for a job, or asks for too much; the text says why."""


class Queued(msgspec.Struct, tag="queued", tag_field="op"):
    """Jobs of other pages are running; 1 is the next."""

    place: int


class Failed(msgspec.Struct, tag="failed", tag_field="op", omit_defaults=True):
    """The job could not be done or went on for too long."""

    message: str
    sentence: Sentence | None = None


def failed(why: sentence.Sentence) -> Failed:
    """The failure in English with its sentence for other languages."""
    return Failed(str(why), to_wire(why))


_encoder = msgspec.json.Encoder()


def decode_request(decoder: msgspec.json.Decoder[_Request], text: str | bytes) -> _Request:
    """
    A page's request as a value.

    Raises:
        BadJob: it is none.
    """
    try:
        return decoder.decode(text)
    except (msgspec.DecodeError, RecursionError, UnicodeError) as error:
        raise BadJob(verbatim(str(error))) from error


def encode_answer(answer: msgspec.Struct) -> str:
    """The text of a message to the page."""
    return _encoder.encode(answer).decode()
