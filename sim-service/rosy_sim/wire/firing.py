"""
Firing of a function with its provenance (language rule R12), as ``settled`` carries it (``protocol/README.md`` §2).

Numbers count from the start of the observation: firings, instants (each message and each tick is one), user events.
No value here refers back to one that has it, so the garbage collector need not look at them: a page keeps thousands.
Most firings that are recorded are never asked about; they are kept as they were told, and read when something asks.
"""

from __future__ import annotations

from typing import Literal

import msgspec

__all__ = ["Branch", "Cause", "Firing", "Given", "Place", "Taken", "count_firings", "read_firings"]


class Cause(msgspec.Struct, omit_defaults=True, frozen=True, gc=False):
    """Why the function fired then."""

    by: Literal["message", "tick", "event", "start", "instant", "task", "end"]
    # Of a message: the value, as Haskell shows it.
    value: str = ""
    # Of a message, a tick or the end of a wait: the instant.
    instant: int | None = None
    # Of a user event: its number.
    event: int | None = None
    # The firing that sent the event, or that led to the change of tasks.
    firing: int | None = None


class Taken(msgspec.Struct, omit_defaults=True, frozen=True, gc=False, rename={"origin": "from"}):
    """A value that the function took."""

    origin: Literal["event", "state", "memory", "param", "time", "generator"]
    value: str
    # Of a memory: its type, and the firing that wrote it; None before the first write.
    type: str = ""
    firing: int | None = None
    # Of a state: its channel, and the instant of the message that brought it.
    channel: str = ""
    instant: int | None = None
    # Of a generator: its number.
    read: int | None = None


class Given(msgspec.Struct, omit_defaults=True, frozen=True, gc=False):
    """A value that the function gave."""

    to: Literal["command", "event", "memory", "param", "done", "feedback", "call"]
    value: str = ""
    # Of a command, a memory or a user event: its type.
    type: str = ""
    # Of a user event: its number.
    event: int | None = None


class Place(msgspec.Struct, frozen=True, gc=False):
    """A place in the text of the program, from 1."""

    line: int
    column: int


class Branch(msgspec.Struct, frozen=True, gc=False, rename={"definitions": "in"}):
    """A branch that the function took: one of the equations, guards or alternatives between which it chooses."""

    # Names of the definitions around it, outermost first.
    definitions: list[str]
    kind: Literal["equation", "case", "guard", "then", "else"]
    # Among the branches of its choice, from 1.
    number: int
    # Left side, pattern, guard or condition, on one line.
    text: str
    start: Place
    end: Place


class Firing(msgspec.Struct, omit_defaults=True, frozen=True, gc=False):
    """One firing. ``task`` is the scope of its task; 0 is the first one of the program."""

    n: int
    function: str
    task: int
    cause: Cause
    took: list[Taken] = []
    gave: list[Given] = []
    # In the order in which they were taken; a program that was built for another computer tells none.
    branches: list[Branch] = []


_decoder = msgspec.json.Decoder(list[Firing])

_LONG = 2_000
"""Bytes that count for one firing in a limit: some three times what a firing takes."""


def read_firings(told: msgspec.Raw | bytes) -> list[Firing]:
    """
    The firings of a step, as ``settled`` carries them.

    A program that tells something else in their place has none: only answers about itself depend on them.
    """
    try:
        return _decoder.decode(told)
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError):
        return []


def count_firings(told: bytes) -> int:
    """For how many firings these bytes count in a limit: how many they begin, and more if they are long."""
    return max(told.count(b'{"n":'), len(told) // _LONG)
