"""
Nicknames of pupils: what is accepted, and the sentence about what is not.

A nickname is shown to the teacher as plain text, so markup in it is harmless. Refused is what would confuse a reader:
invisible characters, writing direction controls, and piles of accents.
"""

from __future__ import annotations

import unicodedata
from dataclasses import dataclass
from typing import Literal

__all__ = ["BadNickname", "Fault", "read_nickname"]

MAX_LENGTH = 24
"""Characters; two lines of a card of the board."""

MAX_MARKS = 2
"""Accents on one letter: Vietnamese has two."""

Fault = Literal["nickname-empty", "nickname-long", "nickname-letters"]

_REFUSED = {"Cc", "Cf", "Cn", "Co", "Cs", "Zl", "Zp"}
"""Control, format (bidirectional ones among them), unassigned, private, surrogate, line and paragraph separators."""

_MARKS = {"Mn", "Me"}


@dataclass(frozen=True, slots=True)
class BadNickname:
    """Why a nickname is not accepted."""

    fault: Fault


def read_nickname(typed: str) -> str | BadNickname:
    """The nickname, in Unicode's composed form and without spaces around it, or what is wrong with it."""
    if len(typed) > 10 * MAX_LENGTH:
        return BadNickname("nickname-long")
    if any(unicodedata.category(c) in _REFUSED for c in typed.strip()):
        return BadNickname("nickname-letters")
    name = " ".join(unicodedata.normalize("NFKC", typed).split())
    if len(name) > MAX_LENGTH:
        return BadNickname("nickname-long")
    if any(unicodedata.category(c) in _REFUSED for c in name) or _has_piled_marks(name):
        return BadNickname("nickname-letters")
    if not any(c.isalnum() for c in name):
        return BadNickname("nickname-empty")
    return name


def _has_piled_marks(name: str) -> bool:
    marks = 0
    for character in unicodedata.normalize("NFD", name):
        marks = marks + 1 if unicodedata.category(character) in _MARKS else 0
        if marks > MAX_MARKS:
            return True
    return False
