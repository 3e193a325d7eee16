"""Worlds by name or file, and examples by name: the files the service reads, and nothing about what they mean."""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import Any

import msgspec

from .errors import BadInput
from .world.arena import Arena, ArenaError, read_arena
from .world.world import World

__all__ = [
    "DEFAULT_WORLD",
    "example",
    "examples",
    "load_world",
    "named_world",
    "read_json",
    "read_text",
    "usable_arena",
    "world_names",
]

DEFAULT_WORLD = "room"
"""The world of a program that names none: free floor ahead, then a wall."""

MAX_FILE = 20_000_000
"""Largest file read, bytes."""

STANDARD_INPUT = Path("-")

_WORLDS = Path(__file__).parent / "worlds"
_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9_-]{0,63}")


def world_names() -> list[str]:
    """The gallery, in alphabetical order."""
    return sorted(path.stem for path in _WORLDS.glob("*.json"))


def named_world(name: str) -> dict[str, Any]:
    """
    A world of the gallery, as JSON gives it.

    Raises:
        BadInput: there is no world of that name.
    """
    path = _WORLDS / f"{name}.json"
    if not _NAME.fullmatch(name) or not path.is_file():
        raise BadInput(f"There is no world called {name!r}; there are {', '.join(world_names())}.")
    value: dict[str, Any] = msgspec.json.decode(path.read_bytes())
    return value


def load_world(name_or_file: str) -> dict[str, Any]:
    """A world by name, or by file when it ends in ``.json`` or has a folder in it."""
    if not name_or_file.endswith(".json") and "/" not in name_or_file:
        return named_world(name_or_file)
    value = read_json(Path(name_or_file), "world")
    usable_arena(value, name_or_file)
    assert isinstance(value, dict)
    return value


def usable_arena(value: object, where: str) -> Arena:
    """
    The arena of a world that a robot can stand in.

    Raises:
        BadInput: with the path to what is wrong.
    """
    try:
        arena = read_arena(value)
        World(arena)
    except ArenaError as error:
        raise BadInput(f"{where} is not a world: {error}") from error
    return arena


def read_text(path: Path, kind: str) -> str:
    """
    A file as text.

    Raises:
        BadInput: it is missing, unreadable, too large or not UTF-8.
    """
    try:
        if path == STANDARD_INPUT:
            return sys.stdin.buffer.read(MAX_FILE).decode("utf-8")
        if path.stat().st_size > MAX_FILE:
            raise BadInput(f"{path} is too large to be a {kind}.")
        return path.read_bytes().decode("utf-8")
    except FileNotFoundError as error:
        raise BadInput(f"There is no file {path}.") from error
    except IsADirectoryError as error:
        raise BadInput(f"{path} is a folder, not a {kind}.") from error
    except UnicodeDecodeError as error:
        raise BadInput(f"{path} is not a {kind}: it is not text in UTF-8.") from error
    except OSError as error:
        raise BadInput(f"{path} cannot be read: {error.strerror}.") from error


def read_json(path: Path, kind: str) -> object:
    """
    A file as JSON.

    Raises:
        BadInput: it cannot be read, or it is no JSON (perhaps cut short).
    """
    text = read_text(path, kind)
    try:
        value: object = msgspec.json.decode(text)
    except (msgspec.DecodeError, RecursionError) as error:
        raise BadInput(f"{path} is not a {kind}: the file is damaged or cut short ({error}).") from error
    return value


def examples(folder: Path) -> list[dict[str, str]]:
    """
    Name, title and lesson of each example, in the order of the table in the folder's README. Its own README's heading
    and first paragraph say the title and the lesson.
    """
    found: list[dict[str, str]] = []
    if not folder.is_dir():
        return found
    listed = _listed(folder / "README.md")
    for path in sorted(folder.iterdir(), key=lambda path: (listed.get(path.name, len(listed)), path.name)):
        if (path / "program.rosy").is_file():
            title, teaches = _readme(path / "README.md")
            found.append({"name": path.name, "title": title or path.name, "teaches": teaches})
    return found


def example(folder: Path, name: str) -> bytes | None:
    """The project of an example as it stands in its file, or ``None``."""
    path = folder / name / "program.rosy"
    if not _NAME.fullmatch(name) or not path.is_file():
        return None
    return path.read_bytes()


def _listed(path: Path) -> dict[str, int]:
    """The place of each name that begins a row of a table."""
    try:
        text = path.read_text("utf-8")
    except (OSError, UnicodeDecodeError):
        return {}
    return {name: place for place, name in enumerate(re.findall(r"^\| `([^`]+)` \|", text, re.MULTILINE))}


def _readme(path: Path) -> tuple[str, str]:
    try:
        text = path.read_text("utf-8")
    except (OSError, UnicodeDecodeError):
        return "", ""
    title, teaches = "", []
    for line in text.splitlines():
        if line.startswith("# ") and not title:
            title = line[2:].strip()
        elif line.strip():
            teaches.append(line.strip())
        elif teaches:
            break
    return title, " ".join(teaches)
