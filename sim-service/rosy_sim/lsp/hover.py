"""Types at a place of a program: of the piece of text there, and of a name in general, as in the page's tooltips."""

from __future__ import annotations

from collections.abc import Sequence

import msgspec

from ..wire.problem import Place

__all__ = ["Declaration", "KnownName", "TypesAtPlaces", "lines_about"]

LONGEST = 60
"""Longer pieces of a program are not repeated beside their type, characters."""


class Declaration(msgspec.Struct, frozen=True):
    """A definition of the program. protocol/README.md, section 3."""

    name: str
    type: str
    start: Place
    end: Place


class TypesAtPlaces(msgspec.Struct, frozen=True):
    """Types of pieces of text. protocol/README.md, section 3."""

    names: list[str]
    at: list[tuple[int, int, int, int, int]]

    def innermost(self, place: Place) -> tuple[Place, Place, str] | None:
        """The smallest piece around a place, and its type."""
        here, best = (place.line, place.column), None
        for line, column, end_line, end_column, number in self.at:
            if (line, column) <= here < (end_line, end_column):
                best = (Place(line, column), Place(end_line, end_column), self.names[number])
        return best


class KnownName(msgspec.Struct, frozen=True):
    """A name of Rosy or the Prelude; the type of a type is its constructors."""

    name: str
    kind: str
    type: str


def lines_about(
    word: str, piece: str, type_here: str | None, declarations: Sequence[Declaration], known: Sequence[KnownName]
) -> list[str]:
    """Haskell lines about a word: its type at this place, and in general. ``piece`` is the text that has the type."""
    lines = []
    if type_here is not None and len(piece) <= LONGEST and "\n" not in piece:
        lines.append(f"{piece} :: {type_here}")
    own = [f"{declared.name} :: {declared.type}" for declared in declarations if declared.name == word]
    lines += own or [_line_about(name) for name in known if name.name == word]
    return list(dict.fromkeys(lines))


def _line_about(name: KnownName) -> str:
    if name.kind == "type":
        return f"data {name.name}" + (f" = {name.type}" if name.type else "")
    return f"{name.name} :: {name.type}"
