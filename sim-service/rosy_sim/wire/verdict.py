"""Verdict on a check of a lesson. ``protocol/README.md``, section 9."""

from __future__ import annotations

from typing import Literal

import msgspec

__all__ = ["Seen", "Verdict"]


class Seen(msgspec.Struct, frozen=True, omit_defaults=True):
    """
    What a verdict is about: ``what`` is a word of ``protocol/README.md`` section 9, the others are its arguments, in s,
    m, m/s and degrees.
    """

    what: str
    time: float | None = None
    number: float | None = None
    name: str | None = None


class Verdict(msgspec.Struct, frozen=True, omit_defaults=True):
    """``open`` may still become one of the others while the run goes on."""

    id: str
    state: Literal["open", "done", "missed"]
    seen: Seen | None = None
