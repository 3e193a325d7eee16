"""
Literate Haskell (Haskell 2010 report §10.4): code behind bird tracks, or between lines ``\\begin{code}`` and
``\\end{code}``; all else is prose.

In: the text of a file. Out: its program, with the prose as comments, line for line, and where a place of the program is
in the file. The page reads by the same rules: ``codegen/src/source/literate.ts``.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import msgspec

from ..wire.problem import Edit, Fix, Place, Problem

__all__ = ["BEGIN_CODE", "END_CODE", "TRACK", "LiterateProgram", "is_literate", "literate_program"]

_TAB = 8
"""Columns between tab stops. Haskell 2010 report §10.3."""

TRACK, BEGIN_CODE, END_CODE = ">", "\\begin{code}", "\\end{code}"


def is_literate(path: Path) -> bool:
    """By the name of the file."""
    return path.suffix.lower() == ".lhs"


@dataclass(frozen=True, slots=True)
class LiterateProgram:
    """``columns`` has for each line of ``source`` the columns, from 1, of its characters and of its end in the file."""

    source: str
    columns: tuple[tuple[int, ...], ...]

    def place(self, found: Place) -> Place:
        """Where a place of the program is in the file."""
        columns = self.columns[found.line - 1] if 0 < found.line <= len(self.columns) else (found.column,)
        return Place(found.line, columns[min(max(found.column, 1), len(columns)) - 1])

    def in_file(self, found: Problem) -> Problem:
        """A problem of the program, with its places in the file."""
        return msgspec.structs.replace(
            found,
            start=self.place(found.start) if found.start is not None else None,
            end=self.place(found.end) if found.end is not None else None,
            fixes=[self._fix(fix) for fix in found.fixes],
        )

    def json_in_file(self, value: object) -> object:
        """JSON about the program, with each place in it in the file."""
        if isinstance(value, list):
            return [self.json_in_file(item) for item in value]
        if not isinstance(value, dict):
            return value
        if value.keys() == {"line", "column"}:
            return msgspec.to_builtins(self.place(msgspec.convert(value, Place)))
        return {key: self.json_in_file(item) for key, item in value.items()}

    def _fix(self, fix: Fix) -> Fix:
        edits = [Edit(self.place(e.start), self.place(e.end), e.text) for e in fix.edits]
        return msgspec.structs.replace(fix, edits=edits)


@dataclass(frozen=True, slots=True)
class _Line:
    kind: Literal["bird", "latex", "prose", "delimiter"]
    text: str
    columns: tuple[int, ...]


def literate_program(text: str) -> LiterateProgram | None:
    """
    The program of a literate text whose lines end with ``\\n``; ``None`` where it has no code. Columns of code are
    counted from its leftmost line.
    """
    lines = _classified(text.split("\n"))
    if all(line.kind in ("prose", "delimiter") for line in lines):
        return None
    margins = {kind: _least_indentation(lines, kind) for kind in ("bird", "latex")}
    read = [_read(line, margins.get(line.kind, 0)) for line in lines]
    return LiterateProgram("\n".join(source for source, _ in read), tuple(columns for _, columns in read))


def _read(line: _Line, margin: int) -> tuple[str, tuple[int, ...]]:
    if line.kind in ("bird", "latex"):
        cut = min(margin, len(line.text))
        return line.text[cut:], line.columns[cut:]
    words = line.text.strip()
    if line.kind == "delimiter" or not words:
        return "", (1,)
    start = line.text.index(words) + 1
    return f"-- {words}", (start,) * 3 + tuple(range(start, start + len(words) + 1))


def _classified(lines: Sequence[str]) -> list[_Line]:
    found: list[_Line] = []
    in_code = False
    for line in lines:
        is_delimiter = line.rstrip() == (END_CODE if in_code else BEGIN_CODE)
        if is_delimiter:
            in_code = not in_code
            found.append(_Line("delimiter", line, ()))
        elif in_code:
            found.append(_Line("latex", *_without_tabs(line)))
        elif line.startswith(TRACK):
            # A track counts as a space, also for tab stops.
            found.append(_Line("bird", *_without_tabs(f" {line[1:]}")))
        else:
            found.append(_Line("prose", line, ()))
    return found


def _without_tabs(line: str) -> tuple[str, tuple[int, ...]]:
    """A line with spaces in place of its tabs, and the column in the file of each character and of the end."""
    text = ""
    columns: list[int] = []
    for at, char in enumerate(line, 1):
        put = " " * (_TAB - len(text) % _TAB) if char == "\t" else char
        text += put
        columns += [at] * len(put)
    return text, (*columns, len(line) + 1)


def _least_indentation(lines: Sequence[_Line], kind: str) -> int:
    return min(
        (len(line.text) - len(line.text.lstrip()) for line in lines if line.kind == kind and line.text.strip()),
        default=0,
    )
