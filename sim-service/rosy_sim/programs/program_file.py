"""A program from a file: plain or literate Haskell, or the text and the world of a saved project."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from ..errors import BadInput
from ..files import InOlderEncoding, parse_json, read_text, refuse_newer
from ..sentences.sentence import Sentence, tr
from ..wire.problem import Problem
from .literate_haskell import BEGIN_CODE, END_CODE, TRACK, LiterateProgram, is_literate, literate_program

__all__ = ["OLDER_ENCODINGS", "VERSION", "ProgramFile", "read_program"]

VERSION = 1
"""Of the project format. protocol/README.md, section 5."""

MAX_SOURCE = 200_000
"""Longest program, characters. protocol/README.md, section 3."""

OLDER_ENCODINGS = ("latin-1", "windows-1252")
"""
Encodings in which a program can be read that is not in UTF-8. They are one: where Latin-1 has letters, Windows-1252 has
the same ones.
"""


@dataclass(frozen=True, slots=True)
class ProgramFile:
    """
    ``world`` is a name or a world's JSON; ``None`` when the file names none. ``literate`` says where the program is in
    a file with prose.
    """

    source: str
    world: object = None
    literate: LiterateProgram | None = None

    def in_file(self, problems: Iterable[Problem]) -> list[Problem]:
        """Problems of ``source``, with their places in the file."""
        return [self.literate.in_file(p) for p in problems] if self.literate is not None else list(problems)


def read_program(path: Path, encoding: str | None = None) -> ProgramFile:
    """
    Read a ``.hs``, ``.lhs`` or ``.rosy`` file: in UTF-8 or, where it is not, in the ``encoding`` of
    ``OLDER_ENCODINGS``.

    Raises:
        BadInput: it cannot be used; the sentence says why.
    """
    if path.suffix.lower() == ".rosy":
        kind = tr("Rosy project")
        program = _project(path, parse_json(_text(path, kind, encoding), path, kind))
    elif is_literate(path):
        literate = literate_program(_text(path, tr("program"), encoding))
        if literate is None:
            raise BadInput(
                tr(
                    "{path} has no code: in literate Haskell, code stands behind {track} or between {begin} and {end}.",
                    path=path,
                    track=TRACK,
                    begin=BEGIN_CODE,
                    end=END_CODE,
                )
            )
        program = ProgramFile(literate.source, literate=literate)
    else:
        program = ProgramFile(_text(path, tr("program"), encoding))
    if len(program.source) > MAX_SOURCE:
        raise BadInput(
            tr("{path} is too long: a program can have at most {most} characters.", path=path, most=MAX_SOURCE)
        )
    return program


def _text(path: Path, kind: Sentence, encoding: str | None) -> str:
    try:
        return read_text(path, kind)
    except InOlderEncoding as error:
        if encoding is not None:
            return error.older.text
        repair = tr(
            "Save it as UTF-8 in your editor, or add --encoding {encoding} here.", encoding=error.older.encoding
        )
        raise InOlderEncoding(path, error.older, repair) from error


def _project(path: Path, value: object) -> ProgramFile:
    if not isinstance(value, dict) or "rosy" not in value:
        raise BadInput(tr("{path} is not a Rosy project: it does not say which version it is.", path=path))
    version = value["rosy"]
    if isinstance(version, bool) or not isinstance(version, int) or version < 1:
        raise BadInput(tr("{path} is not a Rosy project: its version is not a number.", path=path))
    refuse_newer(path, version, VERSION)
    source = value.get("haskell")
    if not isinstance(source, str):
        raise BadInput(tr("{path} is not a Rosy project: it holds no program.", path=path))
    return ProgramFile(source, value.get("world"))
