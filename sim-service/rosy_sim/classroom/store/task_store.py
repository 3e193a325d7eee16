"""
Store of a class's tasks in a database: titles and deadlines, the newest hand-in of each pupil, the teacher's comments.

Blocking, as ``class_store.py``, which opens the database. Times are in s since 1970.
"""

from __future__ import annotations

from dataclasses import dataclass

from .database import Database
from .roster_store import PRESENT

__all__ = ["MAX_TASKS", "HandIn", "HandInGraded", "HandInKept", "Task", "TaskStore"]

MAX_TASKS = 200
"""Tasks of a class: five a week in a school year of 40 weeks."""


@dataclass(frozen=True, slots=True)
class Task:
    """
    A task; ``closed`` is when the teacher ended it, ``deadline`` when it ends by itself. ``check`` is the newest check
    of all hand-ins as JSON (``check_messages.CheckAll``), empty if there was none.
    """

    id: int
    title: str
    opened: float
    deadline: float | None = None
    closed: float | None = None
    check: bytes = b""

    def is_open(self, now: float) -> bool:
        """Whether pupils can hand in."""
        return self.closed is None and (self.deadline is None or now < self.deadline)


@dataclass(frozen=True, slots=True)
class HandIn:
    """
    The newest hand-in of a pupil for a task; ``name`` is the program's. An empty ``comment`` is none, an empty
    ``fingerprint`` (``program_fingerprint.py``) is like no other. ``result`` is JSON (``check_messages.CheckResult``),
    empty if the hand-in was not checked. ``lesson`` is the lesson in which it was made, empty for none.
    """

    task: int
    pupil: int
    at: float
    name: str
    comment: str = ""
    fingerprint: str = ""
    result: bytes = b""
    lesson: str = ""


@dataclass(frozen=True, slots=True)
class HandInKept:
    """A hand-in with the project file; ``result`` as in ``HandIn``."""

    pupil: int
    at: float
    name: str
    text: str
    comment: str
    result: bytes = b""


@dataclass(frozen=True, slots=True)
class HandInGraded:
    """A hand-in that was checked; ``result`` as in ``HandIn``, ``rooms_tried`` as ``pack_rooms`` makes it."""

    name: str
    text: str
    result: bytes
    rooms_tried: bytes


class TaskStore:
    """
    Tasks in an open database.

    Args:
        database: of the class, with the current schema.
    """

    def __init__(self, database: Database) -> None:
        self._database = database

    def tasks(self) -> list[Task]:
        """All tasks, oldest first."""
        rows = self._database.execute(
            "SELECT id, title, opened, deadline, closed, check_settings FROM task ORDER BY id"
        )
        return [Task(*row) for row in rows]

    def open(self, title: str, deadline: float | None, now: float) -> Task | None:
        """Open a task and end the others; ``None`` if there are ``MAX_TASKS``."""
        with self._database.transaction():
            (count,) = self._database.execute("SELECT count(*) FROM task").fetchone()
            if count >= MAX_TASKS:
                return None
            self._database.execute("UPDATE task SET closed = ? WHERE closed IS NULL", (now,))
            (number,) = self._database.execute(
                "INSERT INTO task (title, opened, deadline) VALUES (?, ?, ?) RETURNING id", (title, now, deadline)
            ).fetchone()
            return Task(number, title, now, deadline)

    def close(self, task: int, now: float) -> None:
        """End a task."""
        with self._database.transaction():
            self._database.execute("UPDATE task SET closed = ? WHERE id = ? AND closed IS NULL", (now, task))

    def set_check(self, task: int, check: bytes) -> None:
        """Set the newest check of all hand-ins."""
        with self._database.transaction():
            self._database.execute("UPDATE task SET check_settings = ? WHERE id = ?", (check, task))

    def hand_in(
        self, task: int, pupil: int, name: str, text: str, now: float, fingerprint: str = "", lesson: str = ""
    ) -> None:
        """Store a pupil's hand-in in place of an earlier one and its result. The comment stays."""
        with self._database.transaction():
            self._database.execute(
                "INSERT INTO hand_in (task, pupil, at, name, text, fingerprint, lesson) VALUES (?, ?, ?, ?, ?, ?, ?) "
                "ON CONFLICT (task, pupil) DO UPDATE SET "
                "at = excluded.at, name = excluded.name, text = excluded.text, fingerprint = excluded.fingerprint, "
                "lesson = excluded.lesson, result = excluded.result, rooms_tried = excluded.rooms_tried",
                (task, pupil, now, name, text, fingerprint, lesson),
            )

    def comment(self, task: int, pupil: int, text: str) -> None:
        """Set the teacher's comment on a hand-in."""
        with self._database.transaction():
            self._database.execute("UPDATE hand_in SET comment = ? WHERE task = ? AND pupil = ?", (text, task, pupil))

    def grade(self, task: int, pupil: int, at: float, result: bytes, rooms_tried: bytes = b"") -> bool:
        """Set the result of the hand-in of that time, and its rooms; returns whether it is still the newest."""
        with self._database.transaction():
            changed = self._database.execute(
                "UPDATE hand_in SET result = ?, rooms_tried = ? WHERE task = ? AND pupil = ? AND at = ?",
                (result, rooms_tried, task, pupil, at),
            )
            return changed.rowcount == 1

    def graded(self, task: int, pupil: int) -> HandInGraded | None:
        """A hand-in with the rooms of its check; ``None`` if there is none or it was not checked."""
        row = self._database.execute(
            "SELECT name, text, result, rooms_tried FROM hand_in WHERE task = ? AND pupil = ?", (task, pupil)
        ).fetchone()
        return HandInGraded(*row) if row is not None and row[2] else None

    def hand_ins(self) -> list[HandIn]:
        """All hand-ins of pupils who are in the class, without their texts, oldest first."""
        rows = self._database.execute(
            "SELECT task, pupil, at, name, comment, fingerprint, result, lesson FROM hand_in "
            f"WHERE {PRESENT} ORDER BY at"
        )
        return [HandIn(*row) for row in rows]

    def kept(self, task: int) -> list[HandInKept]:
        """The hand-ins of a task with their texts, in the order in which their pupils, who are in the class, joined."""
        rows = self._database.execute(
            f"SELECT pupil, at, name, text, comment, result FROM hand_in WHERE task = ? AND {PRESENT} ORDER BY pupil",
            (task,),
        )
        return [HandInKept(*row) for row in rows]
