"""
The worker's messages as values, and the requests as bytes. ``protocol/README.md``, section 3.

Graph, declarations, types and completions pass through unread: they are for the page.
"""

from __future__ import annotations

from typing import Annotated

import msgspec

from .firing import Branch
from .line_splitter import LineSplitter
from .problem import Problem

__all__ = [
    "MAX_LINE",
    "Answer",
    "Checked",
    "Completed",
    "Declaration",
    "Failed",
    "Forked",
    "Gone",
    "Pong",
    "Refused",
    "Started",
    "Suggestion",
    "TypesAtPlaces",
    "WorkerReady",
    "WorkerStream",
    "check_request",
    "complete_request",
    "fork_request",
    "kill_request",
    "ping_request",
    "prepare_request",
    "run_request",
]

MAX_LINE = 16_000_000
"""Longest answer of the worker, bytes."""


class WorkerReady(msgspec.Struct, tag="ready", tag_field="op"):
    """The session is warm."""

    protocol: int
    ghc: str = ""


class Declaration(msgspec.Struct):
    """A name that the program defines, and its type as Haskell writes it."""

    name: str
    type: str


class TypesAtPlaces(msgspec.Struct):
    """
    The piece of text from line and column up to line and column has the type ``names[n]``; an outer piece comes before
    those inside it.
    """

    names: list[str]
    at: list[list[int]]


class Suggestion(msgspec.Struct):
    """A name that can stand at a place, its type, and how many values must follow it to give what is wanted there."""

    name: str
    type: str
    takes: int


class Checked(msgspec.Struct, tag="checked", tag_field="op"):
    """A check's answer."""

    id: int
    problems: list[Problem]
    declarations: Annotated[msgspec.Raw, msgspec.Meta(extra={"holds": list[Declaration]})] = msgspec.Raw(b"[]")
    graph: msgspec.Raw = msgspec.Raw(b'{"functions":[]}')
    types: Annotated[msgspec.Raw, msgspec.Meta(extra={"holds": TypesAtPlaces})] = msgspec.Raw(b'{"names":[],"at":[]}')
    # Places of the composite nodes of the parsed program, four numbers each; none when it cannot be parsed.
    groups: Annotated[msgspec.Raw, msgspec.Meta(extra={"holds": list[int] | None})] = msgspec.Raw(b"null")


class Completed(msgspec.Struct, tag="completed", tag_field="op", omit_defaults=True):
    """What can stand at a place."""

    id: int
    names: Annotated[msgspec.Raw, msgspec.Meta(extra={"holds": list[Suggestion]})]
    expected: str | None = None


class Started(msgspec.Struct, tag="started", tag_field="op"):
    """``main`` is about to run."""

    id: int
    problems: list[Problem] = []
    compile: float = 0.0
    # Types of the library that its functions take and give.
    uses: list[str] = []
    # Between which its functions choose.
    branches: list[Branch] = []


class Refused(msgspec.Struct, tag="refused", tag_field="op"):
    """It does not compile."""

    id: int
    problems: list[Problem]


class Gone(msgspec.Struct, tag="gone", tag_field="op"):
    """The child of a run has been reaped."""

    id: int
    exit: int | None = None
    signal: int | None = None
    firing: str | None = None
    problem: Problem | None = None


class Forked(msgspec.Struct, tag="forked", tag_field="op"):
    """A worker has been forked; ``pid`` is its process in the worker's own namespace."""

    id: int
    pid: int


class Pong(msgspec.Struct, tag="pong", tag_field="op"):
    """Answer to a ping."""

    id: int


class Failed(msgspec.Struct, tag="failed", tag_field="op"):
    """The request itself was wrong."""

    message: str
    id: int | None = None


Answer = WorkerReady | Checked | Completed | Started | Refused | Gone | Forked | Pong | Failed

_decoder = msgspec.json.Decoder(Answer)


class WorkerStream:
    """Bytes from the worker in, answers out."""

    __slots__ = ("_lines",)

    def __init__(self) -> None:
        self._lines = LineSplitter(MAX_LINE)

    def feed(self, data: bytes) -> list[Answer]:
        """
        Take bytes; return the answers they complete.

        Raises:
            LineTooLong, msgspec.DecodeError: the worker broke the protocol.
        """
        return [_decoder.decode(line) for line in self._lines.feed(data)]


def _line(**fields: object) -> bytes:
    return msgspec.json.encode(fields) + b"\n"


def check_request(ident: int, source: str) -> bytes:
    """Asks for problems, declarations, graph and types."""
    return _line(op="check", id=ident, source=source)


def complete_request(ident: int, source: str, line: int, column: int) -> bytes:
    """Asks what can stand at a place."""
    return _line(op="complete", id=ident, source=source, line=line, column=column)


def run_request(ident: int, source: str, memory: int, plain: bool = False) -> bytes:
    """
    Asks for a run; the robot link's descriptor rides along, or has come with `prepare`. Of a ``plain`` one only what it
    commands is wanted, so it begins sooner.
    """
    asking = {"plain": True} if plain else {}
    return _line(op="run", id=ident, source=source, memory=memory, **asking)


def prepare_request(ident: int, source: str, memory: int) -> bytes:
    """Has a run compiled that may be asked for with the same id; the robot link's descriptor rides along."""
    return _line(op="prepare", id=ident, source=source, memory=memory)


def fork_request(ident: int) -> bytes:
    """Asks for a forked worker; the descriptor of its socket rides along."""
    return _line(op="fork", id=ident)


def kill_request(ident: int) -> bytes:
    """Ends a check or a run."""
    return _line(op="kill", id=ident)


def ping_request(ident: int) -> bytes:
    """Asks for a `pong`."""
    return _line(op="ping", id=ident)
