"""
Text document of an editor as a value, and its positions in three units.

An editor counts lines from 0 and columns in UTF-16 units, or in those that were negotiated; the worker and codegen
count lines and characters from 1 (``protocol/README.md``, section 1); Python counts characters of the whole text.
LSP 3.17, "Position" and "Text Documents".
"""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import cached_property

from lsprotocol import types

from ..wire.problem import Edit, Place

__all__ = ["Document", "without_surrogates"]

_LINE_END = re.compile(r"\r\n|\n|\r")
_LONE_RETURN = re.compile(r"\r(?!\n)")
_SURROGATE = re.compile("[\ud800-\udfff]")
_MARK = "\ufeff"


def without_surrogates(text: str) -> str:
    """The text with U+FFFD for each half of a pair that stands alone; its length and columns stay."""
    return _SURROGATE.sub("\ufffd", text)


@dataclass(frozen=True)
class Document:
    """
    ``encoding`` is the unit of columns: ``utf-8``, ``utf-16`` or ``utf-32``; ``text`` is what the editor has, with a
    byte order mark and halves of pairs.
    """

    uri: str
    text: str
    version: int | None = None
    encoding: str = types.PositionEncodingKind.Utf16

    def changed(self, version: int | None, changes: Iterable[types.TextDocumentContentChangeEvent]) -> Document:
        """The document after the changes of one notification, which apply one after the other."""
        document = replace(self, version=version)
        for change in changes:
            if isinstance(change, types.TextDocumentContentChangePartial):
                before, rest = document._cut(change.range.start)
                after = document._cut(change.range.end)[1]
                text = before + change.text + min(rest, after, key=_units)
                # Halves of a pair that came one after the other are a character.
                text = text.encode("utf-16-le", "surrogatepass").decode("utf-16-le", "surrogatepass")
            else:
                text = change.text
            document = replace(document, text=text)
        return document

    @cached_property
    def source(self) -> str:
        """The program as worker and codegen read it: without a mark, each line ended by ``\\n`` or ``\\r\\n``."""
        return without_surrogates(self._text[self._begin :])

    def source_position(self, offset: int) -> types.Position:
        """The editor's position of an offset in ``source``."""
        return self.position(offset + self._begin)

    def offset(self, position: types.Position) -> int:
        """The offset of an editor's position; past the end of a line or of the text it is that end."""
        if position.line >= len(self._lines):
            return len(self.text)
        start, end = self._lines[position.line]
        left = position.character
        for offset in range(start, end):
            left -= self._width(self.text[offset])
            # A position inside of a character stands for the place before it.
            if left < 0:
                return offset
        return end

    def position(self, offset: int) -> types.Position:
        """The editor's position of an offset."""
        line = bisect_right(self._starts, offset) - 1
        start, end = self._lines[line]
        return types.Position(line, sum(map(self._width, self.text[start : min(offset, end)])))

    def offset_of_place(self, place: Place) -> int:
        """The offset of a worker's place; past the end of a line or of the text it is that end."""
        start = self._begin
        for _ in range(place.line - 1):
            newline = self._text.find("\n", start)
            if newline < 0:
                return len(self.text)
            start = newline + 1
        newline = self._text.find("\n", start)
        return min(start + max(0, place.column - 1), len(self.text) if newline < 0 else newline)

    def place(self, position: types.Position) -> Place:
        """The worker's place of an editor's position."""
        before = self._text[self._begin : self.offset(position)]
        return Place(before.count("\n") + 1, len(before) - before.rfind("\n"))

    def range(self, start: Place, end: Place | None) -> types.Range:
        """The editor's range between two places; an empty one where the end is missing."""
        first = self.offset_of_place(start)
        last = first if end is None else max(first, self.offset_of_place(end))
        return types.Range(self.position(first), self.position(last))

    def text_edits(self, edits: Iterable[Edit]) -> list[types.TextEdit]:
        """The edits of a fix or a renaming, as an editor applies them."""
        return [types.TextEdit(self.range(edit.start, edit.end), edit.text) for edit in edits]

    @cached_property
    def _text(self) -> str:
        """The text with ``\\n`` for each carriage return alone, which ends a line for an editor, but not for GHC."""
        return _LONE_RETURN.sub("\n", self.text)

    @property
    def _begin(self) -> int:
        """Where the program begins in the text: behind a byte order mark."""
        return 1 if self.text.startswith(_MARK) else 0

    def _cut(self, position: types.Position) -> tuple[str, str]:
        """What is in front of a position and behind it; a pair of UTF-16 units around it is cut into its halves."""
        offset = self.offset(position)
        before, after = self.text[:offset], self.text[offset:]
        inside = position.character - self.position(offset).character
        if self.encoding == types.PositionEncodingKind.Utf16 and inside == 1 and after and ord(after[0]) > 0xFFFF:
            units = after[0].encode("utf-16-le")
            high, low = (half.decode("utf-16-le", "surrogatepass") for half in (units[:2], units[2:]))
            return before + high, low + after[1:]
        return before, after

    @cached_property
    def _lines(self) -> list[tuple[int, int]]:
        """Start and end of each line, without its line break."""
        lines, start = [], 0
        for found in _LINE_END.finditer(self.text):
            lines.append((start, found.start()))
            start = found.end()
        return [*lines, (start, len(self.text))]

    @cached_property
    def _starts(self) -> list[int]:
        return [start for start, _ in self._lines]

    def _width(self, character: str) -> int:
        if self.encoding == types.PositionEncodingKind.Utf32:
            return 1
        if self.encoding == types.PositionEncodingKind.Utf8:
            return len(character.encode("utf-8", "surrogatepass"))
        return 2 if ord(character) > 0xFFFF else 1


def _units(text: str) -> int:
    """The length of a text in UTF-16 units: half of a pair is shorter than the pair."""
    return len(text.encode("utf-16-le", "surrogatepass")) // 2
