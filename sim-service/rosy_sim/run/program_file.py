"""A program from a file: plain Haskell, or the text and the world of a saved project."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from ..errors import BadInput
from ..files import read_json, read_text
from ..sentences.sentence import tr

__all__ = ["VERSION", "ProgramFile", "read_program"]

VERSION = 1
"""Of the project format. protocol/README.md, section 5."""

MAX_SOURCE = 200_000
"""Longest program, characters. protocol/README.md, section 3."""


@dataclass(frozen=True, slots=True)
class ProgramFile:
    """``world`` is a name or a world's JSON; ``None`` when the file names none."""

    source: str
    world: object = None


def read_program(path: Path) -> ProgramFile:
    """
    Read a ``.hs`` or ``.rosy`` file.

    Raises:
        BadInput: it cannot be used; the sentence says why.
    """
    program = _project(path) if path.suffix == ".rosy" else ProgramFile(read_text(path, tr("program")))
    if len(program.source) > MAX_SOURCE:
        raise BadInput(
            tr("{path} is too long: a program can have at most {most} characters.", path=path, most=MAX_SOURCE)
        )
    return program


def _project(path: Path) -> ProgramFile:
    value = read_json(path, tr("Rosy project"))
    if not isinstance(value, dict) or "rosy" not in value:
        raise BadInput(tr("{path} is not a Rosy project: it does not say which version it is.", path=path))
    version = value["rosy"]
    if isinstance(version, bool) or not isinstance(version, int) or version < 1:
        raise BadInput(tr("{path} is not a Rosy project: its version is not a number.", path=path))
    if version > VERSION:
        raise BadInput(
            tr(
                "{path} was saved by a newer Rosy (version {version}); update Rosy to open it.",
                path=path,
                version=version,
            )
        )
    source = value.get("haskell")
    if not isinstance(source, str):
        raise BadInput(tr("{path} is not a Rosy project: it holds no program.", path=path))
    return ProgramFile(source, value.get("world"))
