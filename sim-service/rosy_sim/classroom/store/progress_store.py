"""
Store of the pupils' progress in lessons, in a database.

Blocking, as ``class_store.py``, which opens the database. Times are in s since 1970.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import msgspec

from .database import Database
from .roster_store import PRESENT

__all__ = ["MAX_LESSONS", "LessonDone", "ProgressStore"]

MAX_LESSONS = 200
"""Lessons in which the progress of one pupil is stored."""


@dataclass(frozen=True, slots=True)
class LessonDone:
    """
    The progress of a pupil in a lesson: the ids of the steps that are done, of ``steps`` steps. ``title`` is in the
    language of the page that sent it.
    """

    pupil: int
    lesson: str
    title: str
    steps: int
    done: list[str]


class ProgressStore:
    """
    Progress in an open database.

    Args:
        database: of the class, with the current schema.
    """

    def __init__(self, database: Database) -> None:
        self._database = database

    def all(self) -> list[LessonDone]:
        """The progress of all pupils who are in the class, the lesson that was begun first first."""
        return self._progress(PRESENT)

    def of_pupil(self, pupil: int, begun_since: float) -> list[LessonDone]:
        """The progress of a pupil in lessons that were begun at this time or later."""
        return self._progress("pupil = ? AND begun >= ?", pupil, begun_since)

    def _progress(self, condition: str, *arguments: float) -> list[LessonDone]:
        rows = self._database.execute(
            f"SELECT pupil, lesson, title, steps, done FROM lesson_progress WHERE {condition} ORDER BY pupil, begun",
            arguments,
        )
        return [
            LessonDone(pupil, lesson, title, steps, msgspec.json.decode(done, type=list[str]))
            for pupil, lesson, title, steps, done in rows
        ]

    def add(self, pupil: int, lesson: str, title: str, steps: int, done: Sequence[str], now: float) -> bool:
        """Add steps that a pupil has done to those stored; false if there are ``MAX_LESSONS`` other lessons."""
        with self._database.transaction():
            row = self._database.execute(
                "SELECT done FROM lesson_progress WHERE pupil = ? AND lesson = ?", (pupil, lesson)
            ).fetchone()
            if row is None:
                (count,) = self._database.execute(
                    "SELECT count(*) FROM lesson_progress WHERE pupil = ?", (pupil,)
                ).fetchone()
                if count >= MAX_LESSONS:
                    return False
            known = [] if row is None else msgspec.json.decode(row[0], type=list[str])
            together = msgspec.json.encode(list(dict.fromkeys([*known, *done])))
            self._database.execute(
                "INSERT INTO lesson_progress (pupil, lesson, title, steps, done, begun) VALUES (?, ?, ?, ?, ?, ?) "
                "ON CONFLICT (pupil, lesson) DO UPDATE SET "
                "title = excluded.title, steps = excluded.steps, done = excluded.done",
                (pupil, lesson, title, steps, together, now),
            )
            return True
