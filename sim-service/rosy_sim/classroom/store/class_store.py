"""
Store of one class in a database: pupils, the devices they use, and every version of their programs.

Blocking: the service calls it from a thread of its own (``store_thread.py``). A method that returns has its change on
the disk. It does not decide who may ask for what.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Literal

from .comment_store import CommentStore
from .database import Database
from .progress_store import ProgressStore
from .roster_store import NicknameTaken, Pupil, PupilRemoved, RosterStore, StoreFull
from .schema import migrate
from .study_store import StudyStore
from .task_store import TaskStore

__all__ = [
    "Admission",
    "ClassStore",
    "Conflict",
    "NicknameTaken",
    "Pupil",
    "PupilRemoved",
    "Reason",
    "Saved",
    "StoreFull",
    "Version",
]

Reason = Literal["change", "run"]

MAX_VERSIONS = 300
"""Versions kept of one program; the oldest are removed first."""

MAX_BYTES = 64 * 1024 * 1024
"""Bytes kept of one pupil; superseded versions are removed first, oldest first."""

MAX_DEVICES = 20
"""Devices of one pupil that are let in without the words; the oldest are forgotten first."""


@dataclass(frozen=True, slots=True)
class Admission:
    """What lets people in: the code for pupils and the key for the teacher."""

    code: str
    teacher_key: str

    def class_id(self) -> str:
        """
        A public identifier of the class. The key, which is too long to be guessed, cannot be found from it; the code
        could be.
        """
        return hashlib.sha256(f"class {self.teacher_key}".encode()).hexdigest()[:16]


@dataclass(frozen=True, slots=True)
class Version:
    """A version of a program; ``at`` is in s since 1970. Numbers grow over all programs of the class."""

    number: int
    program: str
    at: float
    reason: Reason
    mark: str
    name: str
    text: str


@dataclass(frozen=True, slots=True)
class Saved:
    """The text is stored, as this version."""

    number: int


@dataclass(frozen=True, slots=True)
class Conflict:
    """Nothing is stored: the program was changed on another device meanwhile. Its newest version."""

    latest: Version


_COLUMNS = "number, program, at, reason, mark, name, text"


class ClassStore:
    """
    An open class.

    Args:
        database: of the class; its schema is brought up to date.
        new_admission: code and key of a class that is created.
        now: s since 1970.
    """

    def __init__(self, database: Database, new_admission: Admission, now: float) -> None:
        """
        Raises:
            BadInput: the class was written by a newer Rosy.
            StoreError: the database cannot be read or written.
        """
        self._database = database
        self.roster = RosterStore(database)
        self.tasks = TaskStore(database)
        self.comments = CommentStore(database)
        self.progress = ProgressStore(database)
        self.study = StudyStore(database)
        try:
            migrate(database)
            with database.transaction():
                if database.execute("SELECT count(*) FROM class").fetchone()[0] == 0:
                    admission = (new_admission.code, new_admission.teacher_key, now)
                    database.execute("INSERT INTO class (code, teacher_key, created) VALUES (?, ?, ?)", admission)
        except BaseException:
            database.close()
            raise

    def beside(self, now: float) -> ClassStore:
        """
        The same class, open once more, to read it while this one is used.

        Raises:
            StoreError: the database cannot be read.
        """
        return ClassStore(self._database.beside(), self.admission(), now)

    def keep(self) -> None:
        """``Database.keep``."""
        self._database.keep()

    def close(self) -> None:
        """Close the database."""
        self._database.close()

    # The class

    def admission(self) -> Admission:
        """The code and the key."""
        return Admission(*self._database.execute("SELECT code, teacher_key FROM class").fetchone())

    def pupils(self) -> list[Pupil]:
        """All pupils in the order in which they joined."""
        return self.roster.pupils()

    # Pupils

    def join(
        self, nickname: str, new_words: Callable[[], str], token: str, now: float
    ) -> Pupil | NicknameTaken | StoreFull:
        """Add a pupil, who uses the device with this token. ``new_words`` is called until its answer is unused."""
        with self._database.transaction():
            pupil = self.roster.insert(nickname, new_words, now)
            if isinstance(pupil, Pupil):
                self._add_device(pupil.id, token, now)
        return pupil

    def resume(self, words: str, token: str, now: float) -> Pupil | PupilRemoved | None:
        """The pupil with these words, who uses the device with this token from now on."""
        row = self._database.execute("SELECT id FROM pupil WHERE words = ?", (words,)).fetchone()
        if row is None:
            return None
        pupil = self.roster.pupil(row[0])
        if pupil is None:
            return PupilRemoved()
        with self._database.transaction():
            self._add_device(pupil.id, token, now)
        return pupil

    def _add_device(self, pupil: int, token: str, now: float) -> None:
        self._database.execute(
            "INSERT INTO device (token_hash, pupil, created) VALUES (?, ?, ?)", (_hash(token), pupil, now)
        )
        self._database.execute(
            "DELETE FROM device WHERE pupil = ? AND token_hash NOT IN "
            "(SELECT token_hash FROM device WHERE pupil = ? ORDER BY created DESC, rowid DESC LIMIT ?)",
            (pupil, pupil, MAX_DEVICES),
        )

    def pupil_of(self, token: str) -> Pupil | PupilRemoved | None:
        """The pupil who uses the device with this token."""
        row = self._database.execute("SELECT pupil FROM device WHERE token_hash = ?", (_hash(token),)).fetchone()
        if row is None:
            return None
        pupil = self.roster.pupil(row[0])
        return PupilRemoved() if pupil is None else pupil

    def forget_device(self, token: str) -> None:
        """The device with this token is let in no more."""
        with self._database.transaction():
            self._database.execute("DELETE FROM device WHERE token_hash = ?", (_hash(token),))

    # Programs

    def save(
        self,
        pupil: int,
        program: str,
        name: str,
        text: str,
        reason: Reason,
        base: int,
        mark: str,
        unacknowledged: Sequence[str],
        now: float,
    ) -> Saved | Conflict | StoreFull:
        """
        Store a version of a pupil's program.

        Args:
            base: the version that the text was made from; 0 for none.
            mark: identifies this request.
            unacknowledged: the marks of earlier requests from the same device, made after ``base``, whose answers did
                not arrive: the text was made from what they stored.
        """
        with self._database.transaction():
            latest = self.latest(pupil, program)
            if latest is not None:
                if latest.text == text and latest.name == name:
                    return Saved(latest.number)
                if latest.number != base and latest.mark not in unacknowledged:
                    return Conflict(latest)
            size = len(text.encode())
            if not self._make_room(pupil, size):
                return StoreFull()
            (number,) = self._database.execute(
                "INSERT INTO version (pupil, program, at, reason, mark, name, text, size) "
                "VALUES (?, ?, ?, ?, ?, ?, ?, ?) RETURNING number",
                (pupil, program, now, reason, mark, name, text, size),
            ).fetchone()
            self._database.execute(
                "DELETE FROM version WHERE pupil = ? AND program = ? AND number NOT IN "
                "(SELECT number FROM version WHERE pupil = ? AND program = ? ORDER BY number DESC LIMIT ?)",
                (pupil, program, pupil, program, MAX_VERSIONS),
            )
            return Saved(number)

    def _make_room(self, pupil: int, size: int) -> bool:
        """Remove superseded versions, oldest first, until there is room for ``size`` bytes; whether there is."""
        (used,) = self._database.execute(
            "SELECT coalesce(sum(size), 0) FROM version WHERE pupil = ?", (pupil,)
        ).fetchone()
        while used + size > MAX_BYTES:
            oldest = self._database.execute(
                "SELECT number, size FROM version WHERE pupil = ? AND number NOT IN "
                "(SELECT max(number) FROM version WHERE pupil = ? GROUP BY program) ORDER BY number LIMIT 1",
                (pupil, pupil),
            ).fetchone()
            if oldest is None:
                return False
            self._database.execute("DELETE FROM version WHERE number = ?", (oldest[0],))
            used -= oldest[1]
        return True

    def latest(self, pupil: int, program: str) -> Version | None:
        """The newest version of a pupil's program."""
        row = self._database.execute(
            f"SELECT {_COLUMNS} FROM version WHERE pupil = ? AND program = ? ORDER BY number DESC LIMIT 1",
            (pupil, program),
        ).fetchone()
        return None if row is None else Version(*row)

    def programs(self, pupil: int) -> list[Version]:
        """The newest version of each of a pupil's programs, the one that was changed last first."""
        rows = self._database.execute(
            f"SELECT {_COLUMNS} FROM version WHERE number IN "
            "(SELECT max(number) FROM version WHERE pupil = ? GROUP BY program) ORDER BY number DESC",
            (pupil,),
        )
        return [Version(*row) for row in rows]

    def history(self, pupil: int) -> list[Version]:
        """All versions of all programs of a pupil, oldest first."""
        rows = self._database.execute(f"SELECT {_COLUMNS} FROM version WHERE pupil = ? ORDER BY number", (pupil,))
        return [Version(*row) for row in rows]


def _hash(token: str) -> bytes:
    return hashlib.sha256(token.encode()).digest()
