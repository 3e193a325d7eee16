"""A problem: what a learner must know. The table is in ``protocol/README.md``, section 1."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

import msgspec

from ..sentences import sentence
from ..sentences.wording import Wording

__all__ = [
    "Edit",
    "Fix",
    "Place",
    "Problem",
    "Sentence",
    "Sentences",
    "failure_context",
    "is_complete",
    "problem",
    "sentences",
    "to_wire",
    "worded",
]


class Place(msgspec.Struct, frozen=True):
    """1-based; counts characters."""

    line: int
    column: int


class Edit(msgspec.Struct, frozen=True):
    """A piece of the program and the text that goes in its place."""

    start: Place
    end: Place
    text: str


class Sentence(msgspec.Struct, frozen=True, omit_defaults=True):
    """A sentence for other languages: its English template and its arguments (protocol/README.md, section 1.1)."""

    id: str
    arguments: dict[str, str | int | float | list[str] | Sentence] = {}


class Sentences(msgspec.Struct, frozen=True, omit_defaults=True):
    """The sentences of a problem; absent for a text that is not translated."""

    message: Sentence | None = None
    hint: Sentence | None = None


class Fix(msgspec.Struct, frozen=True, omit_defaults=True):
    """One way to mend a problem: what a button for it says, and all that it replaces, at once."""

    title: str
    edits: list[Edit]
    sentence: Sentence | None = None


class Problem(msgspec.Struct, frozen=True, omit_defaults=True, kw_only=True):
    """
    What a learner must know. ``end`` is exclusive; ``hint`` and ``ghc``, the compiler's own text, may be empty.

    ``time`` (s since the start of the program) and ``inputs`` (as Haskell shows them) belong to problems at run time.
    """

    # A note is advice about a program that may be meant so.
    severity: Literal["error", "warning", "note"]
    kind: str
    message: str
    hint: str
    ghc: str
    start: Place | None = None
    end: Place | None = None
    function: str | None = None
    time: float | None = None
    inputs: list[str] = []
    # Ways to mend it, the likeliest first.
    fixes: list[Fix] = []
    sentences: Sentences | None = None


def is_complete(problems: list[Problem]) -> bool:
    """Whether a checked program has no error and no empty place. With empty places only it runs until it needs one."""
    return not any(found.severity == "error" or found.kind == "hole" for found in problems)


def problem(
    kind: str,
    message: sentence.Sentence,
    hint: sentence.Sentence | None = None,
    *,
    function: str | None = None,
    time: float | None = None,
    ghc: str = "",
) -> Problem:
    """An error that the service itself found; ``ghc`` is a technical text."""
    return Problem(
        severity="error",
        kind=kind,
        message=str(message),
        hint=str(hint or ""),
        ghc=ghc,
        function=function,
        time=time,
        sentences=sentences(message, hint),
    )


def sentences(message: sentence.Sentence, hint: sentence.Sentence | None) -> Sentences | None:
    """The sentences of a problem or a refusal for the wire."""
    found = Sentences(to_wire(message), to_wire(hint) if hint is not None else None)
    return found if found != Sentences() else None


def worded(found: Problem, language: Wording) -> Problem:
    """The problem in a language."""
    said = found.sentences or Sentences()
    return msgspec.structs.replace(
        found,
        message=language.put(said.message, found.message) if said.message is not None else found.message,
        hint=language.put(said.hint, found.hint) if said.hint is not None else found.hint,
        fixes=[
            msgspec.structs.replace(fix, title=language.put(fix.sentence, fix.title))
            if fix.sentence is not None
            else fix
            for fix in found.fixes
        ],
    )


def failure_context(time: float, inputs: Sequence[str] | None) -> sentence.Sentence:
    """When a run failed, s, and what the function was given then."""
    if inputs:
        return sentence.tr("(at {time} s, given: {inputs})", time=time, inputs=inputs)
    return sentence.tr("(at {time} s)", time=time)


def to_wire(said: sentence.Template) -> Sentence | None:
    """A sentence for the wire; ``None`` for a text without translation."""
    if not said.id:
        return None
    return Sentence(said.id, {name: _argument(value) for name, value in said.arguments.items()})


def _argument(value: sentence.Argument) -> str | int | float | list[str] | Sentence:
    if isinstance(value, str | int | float):
        return value
    if isinstance(value, Sequence):
        return list(value)
    return to_wire(value) or sentence.english(value)
