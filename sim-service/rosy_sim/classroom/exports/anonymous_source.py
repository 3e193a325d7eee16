"""
Haskell source without what a pupil may have written about a person: comments are left out, letters of texts in quotes
are replaced by ``x``, and names of the program's own that contain the name of a pupil are replaced by ``name1``,
``name2`` and so on.

Names of the library stay, also where a pupil is called like one of them: they are not the pupil's words.
"""

from __future__ import annotations

import re
from collections.abc import Iterable

from ..program_fingerprint import bound_names, without_comments

__all__ = ["anonymous_source", "name_parts"]

_GAP = re.compile(r"\\\s*\n\s*\\")
"""A string gap, with which a text goes on in the next line. Haskell 2010 report, section 2.6."""

_TEXT = re.compile(r'"(?:\\.|[^"\\\n])*"?')

_WORD = re.compile(r"[^\W\d][\w']*")

_TOKEN = re.compile(rf"{_TEXT.pattern}|{_WORD.pattern}|[!#$%&*+./<=>?@\\^|~:-]+|\S")

_ESCAPE = re.compile(r"(\\[nt\\\"])|\\?[^\W\d_]")
"""A short escape, which stays, or a letter."""


def name_parts(names: Iterable[str]) -> frozenset[str]:
    """What of names of pupils, or of their three words, is recognised in a name of a program: at least two letters."""
    parts: set[str] = set()
    for name in names:
        words = re.findall(r"[^\W_]+", name.casefold())
        parts |= {"".join(words), *words}
    return frozenset(part for part in parts if len(part) > 1)


def anonymous_source(source: str, parts: frozenset[str]) -> str:
    """The program; ``parts`` are those of all pupils of the class."""
    kept = _TEXT.sub(_without_letters, without_comments(_GAP.sub("", source)))
    lines = [_TOKEN.findall(line) for line in kept.split("\n")]
    own = {name for line in lines for name in _own_names(line)}
    numbers: dict[str, int] = {}

    def replaced(found: re.Match[str]) -> str:
        word = found.group()
        plain = re.sub(r"[_']", "", word.casefold())
        if word not in own or not any(part in plain for part in parts):
            return word
        return f"{'Name' if word[0].isupper() else 'name'}{numbers.setdefault(word, len(numbers) + 1)}"

    return "\n".join(line.rstrip() for line in _WORD.sub(replaced, kept).split("\n")).strip("\n") + "\n"


def _own_names(line: list[str]) -> list[str]:
    """Names that a line defines, and those of patterns before an arrow."""
    if line[:1] and line[0] in ("data", "newtype", "type"):
        return [token for token in line[1:] if _WORD.fullmatch(token)]
    before = line[: len(line) - line[::-1].index("->") - 1] if "->" in line else []
    return [*bound_names(line), *(token for token in before if token[0].islower())]


def _without_letters(text: re.Match[str]) -> str:
    return _ESCAPE.sub(lambda found: found.group(1) or "x", text.group())
