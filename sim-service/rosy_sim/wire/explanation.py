"""
Sentence of an explanation, as a value: which sentence it is, and what it is about. ``protocol/README.md`` §4.2.

``explain.wording`` words it in English for the terminal; the page words it in the learner's language.
"""

from __future__ import annotations

from typing import Literal

import msgspec

from .firing import Given

__all__ = ["Sentence", "SentenceId"]

SentenceId = Literal[
    "sent",
    "stopped",
    "stopped-by",
    "sensed",
    "nothing-ran",
    "first-value",
    "old-value",
    "from-start",
    "not-written",
    "remembered",
    "had-come",
    "ran-message",
    "ran-tick",
    "ran-start",
    "ran-wait",
    "ran-end",
    "ran-unknown",
    "ran-event",
    "ran-done",
    "ran-call",
    "ran-feedback",
    "ran-task",
    "nothing-sent",
    "none-came",
    "nothing-sent-yet",
    "not-recorded",
    "not-known-before",
    "run-over",
    "run-not-begun",
    "did-run",
    "did-send",
    "did-take",
    "not-reached",
    "not-part",
    "task-ended",
    "task-waits",
    "runs-once",
    "lacks",
    "ticks",
    "ran-before",
    "never-ran",
    "gave",
    "matched-equation",
    "matched-case",
    "guard-held",
    "was-true",
    "was-false",
    "other-type",
    "in-force",
    "replaced",
    "replaced-by-stop",
    "replaced-by-end",
    "beyond-speed",
    "beyond-turn",
    "overridden",
    "in-the-air",
    "in-the-way",
    "followed",
    "followed-changes",
    "stood",
    "followed-others",
    "placed",
    "not-moved",
    "no-sender",
    "never-sent",
    "no-taker",
    "received",
    "taker-ended",
    "taker-silent",
]


class Sentence(msgspec.Struct, omit_defaults=True, frozen=True):
    """Fields that a sentence does not use are absent. Times are s since the start of the program."""

    id: SentenceId
    time: float | None = None
    since: float | None = None
    until: float | None = None
    # The function that it is about, and one that led to it with the number of its firing.
    function: str = ""
    other: str = ""
    cause: int | None = None
    functions: list[str] = []
    # As Haskell shows them.
    value: str = ""
    values: list[str] = []
    gave: list[Given] = []
    # Of an equation or an alternative, from 1.
    number: int | None = None
    # As Haskell writes them.
    type: str = ""
    types: list[str] = []
    # m/s or rad/s: what was asked for, and the most that the robot does.
    asked: float | None = None
    limit: float | None = None
