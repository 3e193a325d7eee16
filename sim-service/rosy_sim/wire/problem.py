"""A problem: what a learner must know. The table is in ``protocol/README.md``, section 1."""

from __future__ import annotations

from typing import Literal

import msgspec

__all__ = ["Edit", "Fix", "Place", "Problem", "problem"]


class Place(msgspec.Struct, frozen=True):
    """1-based; counts characters."""

    line: int
    column: int


class Edit(msgspec.Struct, frozen=True):
    """A piece of the program and the text that goes in its place."""

    start: Place
    end: Place
    text: str


class Fix(msgspec.Struct, frozen=True):
    """One way to mend a problem: what a button for it says, and all that it replaces, at once."""

    title: str
    edits: list[Edit]


class Problem(msgspec.Struct, frozen=True, omit_defaults=True, kw_only=True):
    """Absent fields are ``None``; ``hint`` and ``ghc`` are always sent."""

    severity: Literal["error", "warning"]
    kind: str
    message: str
    hint: str
    ghc: str
    start: Place | None = None
    end: Place | None = None
    function: str | None = None
    time: float | None = None
    inputs: list[str] | None = None
    fixes: list[Fix] | None = None


def problem(
    kind: str, message: str, hint: str = "", *, function: str | None = None, time: float | None = None
) -> Problem:
    """An error that the service itself found."""
    return Problem(severity="error", kind=kind, message=message, hint=hint, ghc="", function=function, time=time)
