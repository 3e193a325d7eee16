"""
Schema of a class database: migrations, applied in order; the database counts those applied.

A migration that was released is never changed; a change of the schema is a further migration at the end.
"""

from __future__ import annotations

from ...errors import BadInput
from ...sentences.sentence import tr
from .database import Database

__all__ = ["MIGRATIONS", "migrate"]

MIGRATIONS: tuple[tuple[str, ...], ...] = (
    (
        # One row. Times are in s since 1970.
        "CREATE TABLE class (code TEXT NOT NULL, teacher_key TEXT NOT NULL, created REAL NOT NULL)",
        # `nickname_key` is the nickname without differences of case.
        """CREATE TABLE pupil (
            id INTEGER PRIMARY KEY AUTOINCREMENT,
            nickname TEXT NOT NULL,
            nickname_key TEXT NOT NULL UNIQUE,
            words TEXT NOT NULL UNIQUE,
            joined REAL NOT NULL
        )""",
        # What a browser shows to be let in again; only its SHA-256 is stored.
        """CREATE TABLE device (
            token_hash BLOB PRIMARY KEY,
            pupil INTEGER NOT NULL REFERENCES pupil (id) ON DELETE CASCADE,
            created REAL NOT NULL
        )""",
        # `program` is the identifier that the browser gave; `mark` identifies the request that saved the version.
        """CREATE TABLE version (
            number INTEGER PRIMARY KEY AUTOINCREMENT,
            pupil INTEGER NOT NULL REFERENCES pupil (id) ON DELETE CASCADE,
            program TEXT NOT NULL,
            at REAL NOT NULL,
            reason TEXT NOT NULL CHECK (reason IN ('change', 'run')),
            mark TEXT NOT NULL,
            name TEXT NOT NULL,
            text TEXT NOT NULL,
            size INTEGER NOT NULL
        )""",
        "CREATE INDEX version_of_program ON version (pupil, program, number)",
    ),
    (
        # `closed` is when the teacher ended it; `deadline` when it ends by itself.
        """CREATE TABLE task (
            id INTEGER PRIMARY KEY AUTOINCREMENT,
            title TEXT NOT NULL,
            opened REAL NOT NULL,
            deadline REAL,
            closed REAL
        )""",
        # The newest of each pupil for each task.
        """CREATE TABLE hand_in (
            task INTEGER NOT NULL REFERENCES task (id) ON DELETE CASCADE,
            pupil INTEGER NOT NULL REFERENCES pupil (id) ON DELETE CASCADE,
            at REAL NOT NULL,
            name TEXT NOT NULL,
            text TEXT NOT NULL,
            comment TEXT NOT NULL DEFAULT '',
            PRIMARY KEY (task, pupil)
        )""",
    ),
    (
        # `program_fingerprint.py`; empty if it was not made.
        "ALTER TABLE hand_in ADD COLUMN fingerprint TEXT NOT NULL DEFAULT ''",
    ),
    (
        # The result of the newest check as JSON (`check_messages.CheckResult`); empty if it was not checked.
        "ALTER TABLE hand_in ADD COLUMN result BLOB NOT NULL DEFAULT x''",
    ),
    (
        # The teacher's comments on places in programs. `place` is JSON (`message_fields.Place`), `done` 0 or 1.
        """CREATE TABLE comment (
            id INTEGER PRIMARY KEY AUTOINCREMENT,
            pupil INTEGER NOT NULL REFERENCES pupil (id) ON DELETE CASCADE,
            program TEXT NOT NULL,
            at REAL NOT NULL,
            text TEXT NOT NULL,
            place BLOB NOT NULL,
            done INTEGER NOT NULL DEFAULT 0
        )""",
        "CREATE INDEX comment_of_pupil ON comment (pupil)",
    ),
    (
        # The newest check of all hand-ins as JSON (`check_messages.CheckAll`); empty if there was none.
        "ALTER TABLE task ADD COLUMN check_settings BLOB NOT NULL DEFAULT x''",
    ),
    (
        # All rooms of the result (`rooms_tried.py`); empty if there are none, or the check is older than this column.
        "ALTER TABLE hand_in ADD COLUMN rooms_tried BLOB NOT NULL DEFAULT x''",
    ),
    (
        # The lesson in which it was made (`lesson_checks.lesson_of`); empty for none.
        "ALTER TABLE hand_in ADD COLUMN lesson TEXT NOT NULL DEFAULT ''",
    ),
    (
        # `done` are the ids of the steps that are done, as JSON; `begun` when the first of them was stored.
        """CREATE TABLE lesson_progress (
            pupil INTEGER NOT NULL REFERENCES pupil (id) ON DELETE CASCADE,
            lesson TEXT NOT NULL,
            title TEXT NOT NULL,
            steps INTEGER NOT NULL,
            done BLOB NOT NULL,
            begun REAL NOT NULL,
            PRIMARY KEY (pupil, lesson)
        )""",
    ),
    (
        # 1 while no new pupils are let in.
        "ALTER TABLE class ADD COLUMN locked INTEGER NOT NULL DEFAULT 0",
        # `removed` is when the teacher removed the pupil; `merged_into` the entry that this one became a part of.
        "ALTER TABLE pupil ADD COLUMN removed REAL",
        "ALTER TABLE pupil ADD COLUMN merged_into INTEGER REFERENCES pupil (id) ON DELETE CASCADE",
    ),
    (
        # When it was announced that a removed pupil is deleted (`retention.py`).
        "ALTER TABLE pupil ADD COLUMN announced REAL",
    ),
    (
        # Since when the class takes part in a study, NULL while it does not, and whom to ask about it.
        "ALTER TABLE class ADD COLUMN study_since REAL",
        "ALTER TABLE class ADD COLUMN study_contact TEXT NOT NULL DEFAULT ''",
        # Since when the pupil takes part; 0 for one who does not want to, NULL without an answer.
        "ALTER TABLE pupil ADD COLUMN study_part REAL",
        # Runs of pupils who take part, with the version that ran.
        """CREATE TABLE study_run (
            version INTEGER NOT NULL REFERENCES version (number) ON DELETE CASCADE,
            at REAL NOT NULL
        )""",
        "CREATE INDEX study_run_of_version ON study_run (version)",
    ),
)


def migrate(database: Database) -> None:
    """
    Bring a database to the current schema; each migration is one transaction.

    Raises:
        BadInput: the database was written by a newer Rosy.
        StoreError: a migration failed, and changed nothing.
    """
    applied = database.applied_migrations()
    if applied > len(MIGRATIONS):
        raise BadInput(
            tr(
                "This class was opened by a newer Rosy: its version is {version}, and this Rosy reads up to {newest}. "
                "Open it with that one.",
                version=applied,
                newest=len(MIGRATIONS),
            )
        )
    for number, statements in enumerate(MIGRATIONS[applied:], start=applied + 1):
        database.migrate(statements, number)
