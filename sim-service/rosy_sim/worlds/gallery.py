"""Gallery of worlds: the JSON files beside this module by name, and worlds in files of the user's own."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import msgspec

from ..errors import BadInput
from ..files import read_json
from ..robots import robot_in
from ..sentences.sentence import Sentence, tr
from ..world.arena import Arena, ArenaError, read_arena
from ..world.world import World

__all__ = [
    "DEFAULT_WORLD",
    "load_world",
    "named_world",
    "refusing_worlds",
    "usable_arena",
    "usable_world",
    "world_names",
]

DEFAULT_WORLD = "room"
"""The world of a program that names none: free floor ahead, then a wall."""

_WORLDS = Path(__file__).parent
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
        raise BadInput(
            tr("There is no world called {name}; there are {names}.", name=repr(name), names=list(world_names()))
        )
    value: dict[str, Any] = msgspec.json.decode(path.read_bytes())
    return value


def load_world(name_or_file: str) -> dict[str, Any]:
    """A world by name, or by file when it ends in ``.json`` or has a folder in it."""
    if not name_or_file.endswith(".json") and "/" not in name_or_file:
        return named_world(name_or_file)
    value = read_json(Path(name_or_file), tr("world"))
    usable_arena(value, name_or_file)
    assert isinstance(value, dict)
    return value


def usable_arena(value: object, where: str | Sentence) -> Arena:
    """
    The arena of a world that a robot can stand in.

    Raises:
        BadInput: with the path to what is wrong.
    """
    return usable_world(value, where).arena


def usable_world(value: object, where: str | Sentence, seed: int = 0) -> World:
    """
    A world with its robot in it; ``seed`` of its random numbers.

    Raises:
        BadInput: with the path to what is wrong.
    """
    with refusing_worlds(where):
        arena = read_arena(value)
        return World(arena, robot_in(arena), seed)


@contextmanager
def refusing_worlds(where: str | Sentence) -> Iterator[None]:
    """Turn what is wrong with a world into BadInput."""
    try:
        yield
    except ArenaError as error:
        raise BadInput(tr("{where} is not a world: {why}", where=where, why=error)) from error
