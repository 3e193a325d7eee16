"""
Alphabetical order of names in a language: letters before their accents, accents before case.

It follows the Unicode Collation Algorithm (UTS 10) as far as the languages of Rosy need it. A locale of the system
would know more; which ones are installed differs from machine to machine.
"""

from __future__ import annotations

import unicodedata

__all__ = ["SortKey", "sort_key"]

SortKey = tuple[str, str, str]

_BASES = str.maketrans({"œ": "oe", "æ": "ae", "ø": "o", "ł": "l", "đ": "d"})
"""Letters that stand with others and have no decomposition in Unicode (UTS 10, DUCET)."""

_LETTERS = {"es": {"n\u0303": "n\U0010ffff"}}
"""Letters with marks that have a place of their own. Spanish has ñ after n (CLDR, collation es)."""


def sort_key(name: str, language: str) -> SortKey:
    """What to compare instead of the name."""
    decomposed = unicodedata.normalize("NFD", name)
    letters = unicodedata.normalize("NFD", name.casefold())
    for letter, place in _LETTERS.get(language, {}).items():
        letters = letters.replace(letter, place)
    plain = "".join(character for character in letters if not unicodedata.combining(character))
    return plain.translate(_BASES), letters, decomposed.swapcase()
