"""
Store of the teacher's comments on places in programs, in a database.

Blocking, as ``class_store.py``, which opens the database. Times are in s since 1970.
"""

from __future__ import annotations

from dataclasses import dataclass

from .database import Database
from .roster_store import PRESENT

__all__ = ["MAX_COMMENTS", "CommentKept", "CommentStore"]

MAX_COMMENTS = 200
"""Comments on the programs of one pupil."""


@dataclass(frozen=True, slots=True)
class CommentKept:
    """A comment; ``place`` is JSON (``message_fields.PlaceInProgram``)."""

    id: int
    pupil: int
    program: str
    at: float
    text: str
    place: bytes
    done: bool = False


class CommentStore:
    """
    Comments in an open database.

    Args:
        database: of the class, with the current schema.
    """

    def __init__(self, database: Database) -> None:
        self._database = database

    def comments(self) -> list[CommentKept]:
        """All comments on programs of pupils who are in the class, oldest first."""
        rows = self._database.execute(
            f"SELECT id, pupil, program, at, text, place, done FROM comment WHERE {PRESENT} ORDER BY id"
        )
        return [
            CommentKept(number, pupil, program, at, text, place, bool(done))
            for number, pupil, program, at, text, place, done in rows
        ]

    def add(self, pupil: int, program: str, text: str, place: bytes, now: float) -> CommentKept | None:
        """Add a comment; ``None`` if the pupil has ``MAX_COMMENTS``."""
        with self._database.transaction():
            (count,) = self._database.execute("SELECT count(*) FROM comment WHERE pupil = ?", (pupil,)).fetchone()
            if count >= MAX_COMMENTS:
                return None
            (number,) = self._database.execute(
                "INSERT INTO comment (pupil, program, at, text, place) VALUES (?, ?, ?, ?, ?) RETURNING id",
                (pupil, program, now, text, place),
            ).fetchone()
            return CommentKept(number, pupil, program, now, text, place)

    def set_done(self, comment: int, done: bool) -> None:
        """Set whether the pupil has dealt with a comment."""
        with self._database.transaction():
            self._database.execute("UPDATE comment SET done = ? WHERE id = ?", (int(done), comment))

    def remove(self, comment: int) -> None:
        """Delete a comment."""
        with self._database.transaction():
            self._database.execute("DELETE FROM comment WHERE id = ?", (comment,))
