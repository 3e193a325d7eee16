"""
Word lists from which the three words of a pupil are drawn: nouns that children know, without letters beyond a to z.

A language has its list in ``languages/<tag>/pupil_words.txt``. The shortest has 253 words: 16,194,277 triples.
"""

from __future__ import annotations

import secrets
from functools import cache

from ..sentences.wording import LANGUAGES

__all__ = ["draw_words", "read_words", "word_list"]

WORDS_EACH = 3


@cache
def word_list(language: str) -> tuple[str, ...]:
    """The words of a language, or of English if there is no list of it."""
    file = LANGUAGES / language / "pupil_words.txt"
    return tuple(file.read_text("utf-8").split()) if language.isalpha() and file.is_file() else word_list("en")


def draw_words(language: str) -> str:
    """Three random words of a language, as a tag of BCP 47 names it."""
    words = word_list(language.partition("-")[0].lower())
    return " ".join(secrets.choice(words) for _ in range(WORDS_EACH))


def read_words(typed: str) -> str:
    """Typed words as they are stored: capitals, commas, hyphens and further spaces do not matter."""
    return " ".join("".join(c if c.isalpha() else " " for c in typed.lower()).split())
