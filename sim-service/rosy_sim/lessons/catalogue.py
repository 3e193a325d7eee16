"""Catalogue of the lessons in a folder: their list, and each lesson as one JSON value (protocol section 9)."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path
from typing import Any

import msgspec

from .lesson_file import Lesson, read_lesson

__all__ = ["lesson_json", "lesson_list", "lesson_names", "lesson_of_room", "lessons"]

_NAME = re.compile(r"[a-z][a-z0-9-]{0,63}")

_ROOM_PREFIX = "lesson "
"""Before the name of a lesson in the name of its room."""


def lesson_of_room(room: str) -> str:
    """The name of the lesson whose room has this name; empty for another room."""
    return room.removeprefix(_ROOM_PREFIX) if room.startswith(_ROOM_PREFIX) else ""


def lessons(folder: Path) -> list[Lesson]:
    """
    All lessons of a folder in their order.

    Raises:
        BadInput: a lesson has a mistake.
    """
    if not folder.is_dir():
        return []
    paths = [path for path in folder.iterdir() if (path / "lesson.json").is_file()]
    changed = tuple(sorted((str(file), file.stat().st_mtime_ns) for path in paths for file in path.rglob("*.*")))
    return list(_read(tuple(sorted(paths)), changed))


@cache
def _read(paths: tuple[Path, ...], _changed: object) -> tuple[Lesson, ...]:
    return tuple(sorted((read_lesson(path) for path in paths), key=lambda lesson: lesson.file.number))


def lesson_names(folder: Path) -> frozenset[str]:
    """
    Names of all lessons of a folder.

    Raises:
        BadInput: a lesson has a mistake.
    """
    return frozenset(lesson.name for lesson in lessons(folder))


def lesson_list(folder: Path) -> list[dict[str, Any]]:
    """Name, course, number, ids of the steps and titles of each lesson, for the list of a page."""
    return [
        {
            "name": lesson.name,
            "course": lesson.file.course,
            "number": lesson.file.number,
            "steps": [step.id for step in lesson.file.steps],
            "titles": {language: texts.title for language, texts in lesson.texts.items()},
            "ideas": {language: texts.idea for language, texts in lesson.texts.items()},
        }
        for lesson in lessons(folder)
    ]


def lesson_json(folder: Path, name: str) -> dict[str, Any] | None:
    """A lesson with its room, programs and texts, and with all blocks that lessons until then have brought."""
    if not _NAME.fullmatch(name):
        return None
    found = lessons(folder)
    place = next((i for i, lesson in enumerate(found) if lesson.name == name), None)
    if place is None:
        return None
    lesson = found[place]
    steps = []
    for step in lesson.file.steps:
        value: dict[str, Any] = msgspec.to_builtins(step)
        # Only rehearsals use these.
        value.pop("hands", None)
        value.pop("also_in", None)
        if step.program is not None:
            value["program"] = lesson.programs[step.program]
        steps.append(value)
    return {
        "lesson": lesson.file.lesson,
        "name": name,
        "course": lesson.file.course,
        "number": lesson.file.number,
        "room": {**lesson.world, "name": f"{_ROOM_PREFIX}{name}"},
        "toolbox": sorted({word for earlier in _until(lesson, found) for word in earlier.file.blocks}),
        "start": lesson.start,
        "steps": steps,
        "texts": {language: msgspec.to_builtins(texts) for language, texts in lesson.texts.items()},
        "next": _next(lesson, found[place + 1 :]),
    }


def _until(lesson: Lesson, found: list[Lesson]) -> list[Lesson]:
    """The lesson and those that come before it: of a strand, also the lessons that it follows."""
    file = lesson.file
    return [
        one
        for one in found
        if one.file.number <= file.number
        and (file.after is None or one.file.course == file.course or one.file.number <= file.after)
    ]


def _next(lesson: Lesson, later: list[Lesson]) -> str | None:
    """The name of the lesson to go on with; a strand is chosen, and no course leads into it."""
    follows = [one for one in later if one.file.after is None or one.file.course == lesson.file.course]
    return follows[0].name if follows else None
