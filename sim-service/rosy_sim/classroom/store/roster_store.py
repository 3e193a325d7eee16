"""
Store of the roster of a class in a database: who is in it, who was removed and can be restored, which two entries of
one pupil were merged, and whether the class is locked for new pupils.

Blocking, as ``class_store.py``, which opens the database. Times are in s since 1970. A removed pupil keeps everything
that is stored of the pupil, and is in no list but ``removed``. An entry that was merged into another one stays as the
owner of its three words, which let the pupil in as the other one.
"""

from __future__ import annotations

import secrets
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass

import msgspec

from .database import Database
from .retention import next_step

__all__ = [
    "MAX_PUPILS",
    "PRESENT",
    "NicknameTaken",
    "Pupil",
    "PupilRemoved",
    "RemovedPupil",
    "RosterStore",
    "StoreFull",
]

MAX_PUPILS = 400
"""Pupils of a class: as many as there may be pages (``config.Limits.sessions``)."""

PRESENT = "pupil IN (SELECT id FROM pupil WHERE removed IS NULL)"
"""Condition of a statement: the row belongs to a pupil who was not removed."""

_COLUMNS = "id, nickname, words, joined"


@dataclass(frozen=True, slots=True)
class Pupil:
    """A pupil; ``joined`` is in s since 1970."""

    id: int
    nickname: str
    words: str
    joined: float


@dataclass(frozen=True, slots=True)
class RemovedPupil:
    """
    A pupil who was removed, at a time in s since 1970, and can be restored; ``announced`` is when the removal for good
    was announced (``retention.py``).
    """

    id: int
    nickname: str
    at: float
    announced: float | None = None


@dataclass(frozen=True, slots=True)
class PupilRemoved:
    """The teacher has removed this pupil."""


@dataclass(frozen=True, slots=True)
class NicknameTaken:
    """Another pupil of the class has this nickname."""


@dataclass(frozen=True, slots=True)
class StoreFull:
    """There are as many pupils, or as many bytes of one pupil, as there may be."""


class RosterStore:
    """
    The roster in an open database.

    Args:
        database: of the class, with the current schema.
    """

    def __init__(self, database: Database) -> None:
        self._database = database

    def is_locked(self) -> bool:
        """Whether no new pupils are let in."""
        return bool(self._database.execute("SELECT locked FROM class").fetchone()[0])

    def set_locked(self, locked: bool) -> None:
        """Let no new pupils in, or let them in again."""
        with self._database.transaction():
            self._database.execute("UPDATE class SET locked = ?", (int(locked),))

    def pupils(self) -> list[Pupil]:
        """All pupils in the order in which they joined."""
        return [
            Pupil(*row)
            for row in self._database.execute(f"SELECT {_COLUMNS} FROM pupil WHERE removed IS NULL ORDER BY id")
        ]

    def pupil(self, pupil: int) -> Pupil | None:
        """The pupil with this number, or into whose entry it was merged; ``None`` for a removed one."""
        row = self._database.execute(
            f"SELECT {_COLUMNS} FROM pupil WHERE removed IS NULL AND id = "
            "(SELECT coalesce(merged_into, id) FROM pupil WHERE id = ?)",
            (pupil,),
        ).fetchone()
        return None if row is None else Pupil(*row)

    def removed(self) -> list[RemovedPupil]:
        """The pupils who were removed, the one who was removed last first."""
        rows = self._database.execute(
            "SELECT id, nickname, removed, announced FROM pupil WHERE removed IS NOT NULL AND merged_into IS NULL "
            "ORDER BY removed DESC, id DESC"
        )
        return [RemovedPupil(*row) for row in rows]

    def insert(self, nickname: str, new_words: Callable[[], str], now: float) -> Pupil | NicknameTaken | StoreFull:
        """Add a pupil, in the transaction of the caller. ``new_words`` is called until its answer is unused."""
        if self._is_full():
            return StoreFull()
        if self._has(nickname):
            return NicknameTaken()
        words = new_words()
        while self._database.execute("SELECT 1 FROM pupil WHERE words = ?", (words,)).fetchone():
            words = new_words()
        (number,) = self._database.execute(
            "INSERT INTO pupil (nickname, nickname_key, words, joined) VALUES (?, ?, ?, ?) RETURNING id",
            (nickname, nickname.casefold(), words, now),
        ).fetchone()
        return Pupil(number, nickname, words, now)

    def add(
        self, nicknames: Sequence[str], new_words: Callable[[], str], now: float
    ) -> list[Pupil | NicknameTaken | StoreFull]:
        """Add pupils who have not joined yet; they do with their words. Returns what became of each nickname."""
        with self._database.transaction():
            return [self.insert(nickname, new_words, now) for nickname in nicknames]

    def rename(self, pupil: int, nickname: str) -> Pupil | NicknameTaken | None:
        """Give a pupil another nickname; ``None`` if there is no such pupil."""
        with self._database.transaction():
            if self._has(nickname, other_than=pupil):
                return NicknameTaken()
            self._database.execute(
                "UPDATE pupil SET nickname = ?, nickname_key = ? WHERE id = ? AND removed IS NULL",
                (nickname, nickname.casefold(), pupil),
            )
        return self.pupil(pupil)

    def remove(self, pupils: Collection[int], now: float) -> None:
        """Remove pupils; their nicknames are free again."""
        with self._database.transaction():
            for pupil in pupils:
                self._hide(pupil, now)

    def restore(self, pupil: int) -> Pupil | StoreFull | None:
        """Restore a removed pupil, with a number behind a nickname that was taken since; ``None`` for no such one."""
        with self._database.transaction():
            row = self._database.execute(
                "SELECT nickname FROM pupil WHERE id = ? AND removed IS NOT NULL AND merged_into IS NULL", (pupil,)
            ).fetchone()
            if row is None:
                return None
            if self._is_full():
                return StoreFull()
            nickname, number = row[0], 2
            while self._has(nickname):
                nickname, number = f"{row[0]} {number}", number + 1
            self._database.execute(
                "UPDATE pupil SET nickname = ?, nickname_key = ?, removed = NULL, announced = NULL WHERE id = ?",
                (nickname, nickname.casefold(), pupil),
            )
        return self.pupil(pupil)

    def purge(self, now: float) -> None:
        """Take the next step of ``retention.py`` with each removed pupil; the last deletes all that is stored."""
        with self._database.transaction():
            removed = self._database.execute(
                "SELECT id, removed, announced FROM pupil WHERE removed IS NOT NULL AND merged_into IS NULL"
            )
            for pupil, at, announced in list(removed):
                match next_step(at, announced, now):
                    case "announce":
                        self._database.execute("UPDATE pupil SET announced = ? WHERE id = ?", (now, pupil))
                    case "withdraw":
                        self._database.execute("UPDATE pupil SET announced = NULL WHERE id = ?", (pupil,))
                    case "remove":
                        self._database.execute("DELETE FROM pupil WHERE id = ?", (pupil,))
                    case "keep":
                        pass

    def merge(self, pupil: int, into: int, now: float) -> None:
        """
        Make two entries of one pupil one; both are present and not the same.

        Nothing is lost: of two programs with the same identifier the one of ``pupil`` gets another identifier, of two
        hand-ins for one task the older one becomes a program, steps of lessons are put together, and the devices and
        the words of both let the pupil in. In a study the pupil takes part since the later of two answers, and not at
        all after a refusal of either entry.
        """
        with self._database.transaction():
            self._move_programs(pupil, into)
            self._move_hand_ins(pupil, into)
            self._move_progress(pupil, into)
            self._merge_study(pupil, into)
            self._database.execute("UPDATE device SET pupil = ? WHERE pupil = ?", (into, pupil))
            self._hide(pupil, now)
            self._database.execute(
                "UPDATE pupil SET merged_into = ? WHERE id = ? OR merged_into = ?", (into, pupil, pupil)
            )

    def _merge_study(self, pupil: int, into: int) -> None:
        self._database.execute(
            "UPDATE pupil SET study_part = (SELECT CASE WHEN min(study_part) = 0 THEN 0 ELSE max(study_part) END "
            "FROM pupil WHERE id IN (?, ?)) WHERE id = ?",
            (pupil, into, into),
        )
        self._database.execute(
            "DELETE FROM study_run WHERE version IN "
            "(SELECT number FROM version JOIN pupil ON pupil = id WHERE id = ? AND study_part = 0)",
            (into,),
        )

    def _hide(self, pupil: int, now: float) -> None:
        # No nickname has a line break.
        self._database.execute(
            "UPDATE pupil SET removed = ?, nickname_key = ? WHERE id = ? AND removed IS NULL",
            (now, f"\n{pupil}", pupil),
        )

    def _is_full(self) -> bool:
        (count,) = self._database.execute("SELECT count(*) FROM pupil WHERE removed IS NULL").fetchone()
        return bool(count >= MAX_PUPILS)

    def _has(self, nickname: str, other_than: int = 0) -> bool:
        found = self._database.execute(
            "SELECT 1 FROM pupil WHERE nickname_key = ? AND id <> ?", (nickname.casefold(), other_than)
        )
        return found.fetchone() is not None

    def _move_programs(self, pupil: int, into: int) -> None:
        same = self._database.execute(
            "SELECT DISTINCT program FROM version WHERE pupil = ? "
            "AND program IN (SELECT program FROM version WHERE pupil = ?)",
            (pupil, into),
        )
        for (program,) in list(same):
            other = secrets.token_urlsafe(9)
            for table in ("version", "comment"):
                self._database.execute(
                    f"UPDATE {table} SET program = ? WHERE pupil = ? AND program = ?", (other, pupil, program)
                )
        for table in ("version", "comment"):
            self._database.execute(f"UPDATE {table} SET pupil = ? WHERE pupil = ?", (into, pupil))

    def _move_hand_ins(self, pupil: int, into: int) -> None:
        both = self._database.execute(
            "SELECT other.task, other.pupil, other.at, other.comment, own.pupil, own.at, own.comment "
            "FROM hand_in AS other JOIN hand_in AS own ON own.task = other.task "
            "WHERE other.pupil = ? AND own.pupil = ?",
            (pupil, into),
        )
        for task, *two in list(both):
            (older, _, older_comment), (newer, _, newer_comment) = sorted(
                (tuple(two[:3]), tuple(two[3:])), key=lambda one: one[1]
            )
            self._become_program(task, older, into)
            self._database.execute("DELETE FROM hand_in WHERE task = ? AND pupil = ?", (task, older))
            comment = " ".join(dict.fromkeys(one for one in (older_comment, newer_comment) if one))
            self._database.execute(
                "UPDATE hand_in SET comment = ? WHERE task = ? AND pupil = ?", (comment, task, newer)
            )
        self._database.execute("UPDATE hand_in SET pupil = ? WHERE pupil = ?", (into, pupil))

    def _become_program(self, task: int, pupil: int, into: int) -> None:
        """Store a hand-in as a program, unless its text is a version of one already."""
        at, name, text = self._database.execute(
            "SELECT at, name, text FROM hand_in WHERE task = ? AND pupil = ?", (task, pupil)
        ).fetchone()
        if self._database.execute("SELECT 1 FROM version WHERE pupil = ? AND text = ?", (into, text)).fetchone():
            return
        # A number below all others: it is not the program that was changed last.
        (number,) = self._database.execute("SELECT coalesce(min(number), 0) FROM version").fetchone()
        identifier = secrets.token_urlsafe(9)
        self._database.execute(
            "INSERT INTO version (number, pupil, program, at, reason, mark, name, text, size) "
            "VALUES (?, ?, ?, ?, 'change', ?, ?, ?, ?)",
            (min(number, 0) - 1, into, identifier, at, identifier, name, text, len(text.encode())),
        )

    def _move_progress(self, pupil: int, into: int) -> None:
        both = self._database.execute(
            "SELECT other.lesson, other.done, own.done FROM lesson_progress AS other "
            "JOIN lesson_progress AS own ON own.lesson = other.lesson WHERE other.pupil = ? AND own.pupil = ?",
            (pupil, into),
        )
        for lesson, other, own in list(both):
            steps = dict.fromkeys(step for done in (own, other) for step in msgspec.json.decode(done, type=list[str]))
            self._database.execute(
                "UPDATE lesson_progress SET done = ? WHERE pupil = ? AND lesson = ?",
                (msgspec.json.encode(list(steps)), into, lesson),
            )
            self._database.execute("DELETE FROM lesson_progress WHERE pupil = ? AND lesson = ?", (pupil, lesson))
        self._database.execute("UPDATE lesson_progress SET pupil = ? WHERE pupil = ?", (into, pupil))
