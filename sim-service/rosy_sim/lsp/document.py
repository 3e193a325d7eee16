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

__all__ = ["Document"]

_LINE_END = re.compile(r"\r\n|\n|\r")


@dataclass(frozen=True)
class Document:
    """``encoding`` is the unit of columns: ``utf-8``, ``utf-16`` or ``utf-32``."""

    uri: str
    text: str
    version: int | None = None
    encoding: str = types.PositionEncodingKind.Utf16

    def changed(self, version: int | None, changes: Iterable[types.TextDocumentContentChangeEvent]) -> Document:
        """The document after the changes of one notification, which apply one after the other."""
        document = replace(self, version=version)
        for change in changes:
            if isinstance(change, types.TextDocumentContentChangePartial):
                start, end = document.offset(change.range.start), document.offset(change.range.end)
                text = document.text[:start] + change.text + document.text[max(start, end) :]
            else:
                text = change.text
            document = replace(document, text=text)
        return document

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
        start = 0
        for _ in range(place.line - 1):
            newline = self.text.find("\n", start)
            if newline < 0:
                return len(self.text)
            start = newline + 1
        newline = self.text.find("\n", start)
        return min(start + max(0, place.column - 1), len(self.text) if newline < 0 else newline)

    def place(self, position: types.Position) -> Place:
        """The worker's place of an editor's position."""
        before = self.text[: self.offset(position)]
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
