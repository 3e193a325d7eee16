"""
Check of a hand-in by the lesson in which it was made: the checks of the lesson's last step, in the lesson's own rooms.

The room in a project file has the name of its lesson (``lessons.catalogue``).
"""

from __future__ import annotations

import contextlib
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import msgspec

from ..config import Config
from ..lessons.background_rehearsals import rehearse_in_background
from ..lessons.catalogue import lesson_of_room, lessons
from ..lessons.lesson_file import Lesson, checked_step
from ..lessons.rehearsal_process import Rehearsed, RehearsedAttempt
from ..wire.problem import Problem

__all__ = ["LessonOutcome", "check_by_lesson", "lesson_of"]


class _World(msgspec.Struct):
    name: str = ""


class _Project(msgspec.Struct):
    """The room of a project file. ``protocol/README.md``, section 5."""

    world: str | _World | None = None


@dataclass(frozen=True, slots=True)
class LessonOutcome:
    """
    How a program did: it passed in so many rooms. ``unmet`` are the checks that some room did not pass, each as the
    lesson calls it, by language; ``problems`` are those of a program that does not compile.
    """

    passed: int
    rooms: int
    unmet: list[dict[str, str]]
    problems: list[Problem]


def lesson_of(project: str) -> str:
    """The name of the lesson in whose room a project file was made; empty for none."""
    with contextlib.suppress(msgspec.MsgspecError, UnicodeError, RecursionError):
        world = msgspec.json.decode(project, type=_Project).world
        if isinstance(world, _World):
            return lesson_of_room(world.name)
    return ""


async def check_by_lesson(config: Config, project: str, source: str) -> LessonOutcome | None:
    """
    Judge a program by the last step of its lesson that has checks; ``None`` if it was made in none of the lessons.

    Raises:
        BadInput: the files of the lessons have a mistake.
        RosyError: the process that runs it died, or could not start.
    """
    name = lesson_of(project)
    lesson = next((one for one in _all(config.examples) if one.name == name), None)
    step = None if lesson is None else next((one for one in reversed(lesson.file.steps) if one.checks), None)
    checked = None if step is None else checked_step(step)
    if lesson is None or step is None or checked is None:
        return None
    others = lesson.other_worlds()
    worlds: list[dict[str, Any]] = [lesson.world, *(others[number] for number in step.also_in)]
    attempt = RehearsedAttempt(source, checked, step.hands)
    done: list[Rehearsed] = []
    for world in worlds:
        await rehearse_in_background(config, world, [attempt], done.append)
        if done[-1].ended == "refused":
            return LessonOutcome(0, len(worlds), [], done[-1].problems)
    unmet = {verdict.id for one in done if not one.passed for verdict in one.checks if verdict.state != "done"}
    in_order = [check.id for check in step.checks if check.id in unmet]
    return LessonOutcome(sum(one.passed for one in done), len(worlds), [_texts(lesson, one) for one in in_order], [])


def _all(examples: Path) -> list[Lesson]:
    return lessons(examples / "lessons")


def _texts(lesson: Lesson, check: str) -> dict[str, str]:
    return {language: texts.checks.get(check, check) for language, texts in lesson.texts.items()}
