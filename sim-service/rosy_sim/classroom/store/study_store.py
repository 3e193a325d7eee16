"""
Store of a study in which a class takes part, in a database: since when, whom to ask, which pupils take part since when,
and when their programs ran. Everything else that a study uses is stored of every class.

Blocking, as ``class_store.py``, which opens the database. Times are in s since 1970.
"""

from __future__ import annotations

from dataclasses import dataclass

from .database import Database

__all__ = ["Study", "StudyStore"]


@dataclass(frozen=True, slots=True)
class Study:
    """A study, since when the class takes part in it, and whom pupils ask about it."""

    since: float
    contact: str


class StudyStore:
    """
    The study in an open database.

    Args:
        database: of the class, with the current schema.
    """

    def __init__(self, database: Database) -> None:
        self._database = database

    def study(self) -> Study | None:
        """The study in which the class takes part."""
        since, contact = self._database.execute("SELECT study_since, study_contact FROM class").fetchone()
        return None if since is None else Study(since, contact)

    def begin(self, contact: str, now: float) -> Study:
        """Let the class take part; a study that has begun goes on with another contact."""
        with self._database.transaction():
            self._database.execute(
                "UPDATE class SET study_contact = ?, study_since = coalesce(study_since, ?)", (contact, now)
            )
        return self.study() or Study(now, contact)

    def end(self) -> None:
        """End the study, with the pupils' answers and the runs: the next one asks anew."""
        with self._database.transaction():
            self._database.execute("UPDATE class SET study_since = NULL, study_contact = ''")
            self._database.execute("UPDATE pupil SET study_part = NULL")
            self._database.execute("DELETE FROM study_run")

    def answers(self) -> dict[int, float]:
        """Since when each pupil takes part; 0 for one who does not want to. Pupils without an answer are not in it."""
        return dict(self._database.execute("SELECT id, study_part FROM pupil WHERE study_part IS NOT NULL"))

    def answer(self, pupil: int, since: float) -> None:
        """Set since when a pupil takes part; with 0 the pupil does not, and the runs are deleted."""
        with self._database.transaction():
            self._database.execute("UPDATE pupil SET study_part = ? WHERE id = ?", (since, pupil))
            if since == 0:
                self._database.execute(
                    "DELETE FROM study_run WHERE version IN (SELECT number FROM version WHERE pupil = ?)", (pupil,)
                )

    def add_run(self, version: int, now: float) -> None:
        """Store that a version of a program ran."""
        with self._database.transaction():
            self._database.execute("INSERT INTO study_run (version, at) VALUES (?, ?)", (version, now))

    def runs(self, pupil: int) -> list[tuple[int, float]]:
        """The runs of a pupil, oldest first: the version that ran, and when."""
        rows = self._database.execute(
            "SELECT version, study_run.at FROM study_run JOIN version ON number = version "
            "WHERE pupil = ? ORDER BY study_run.at",
            (pupil,),
        )
        return [(version, at) for version, at in rows]
