"""
Database of a class: the few operations that its stores need, and the SQLite file behind them.

``postgresql_database.py`` has the same operations on a PostgreSQL server. Statements are written once, in the common
part of both languages, with ``?`` for a value. Blocking; one thread at a time uses it.
"""

from __future__ import annotations

import sqlite3
from collections.abc import Iterator, Sequence
from contextlib import AbstractContextManager, closing, contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal, Protocol

__all__ = [
    "ClassTaken",
    "Database",
    "DeletedClass",
    "Rows",
    "SqliteDatabase",
    "StoreAway",
    "StoreDamaged",
    "StoreError",
    "StoreFault",
    "StoreRefused",
    "fault_of",
]


class StoreError(Exception):
    """The disk is full or broken, or the database server cannot be reached; the transaction changed nothing."""


class StoreDamaged(StoreError):
    """The file of the database is not as it was written."""


class StoreAway(StoreError):
    """The database server cannot be reached now; the transaction changed nothing and can be tried again."""


class StoreRefused(StoreAway):
    """The server is there and does not admit this service: its password, its database or its address."""


class ClassTaken(StoreError):
    """While the server could not be reached another service has opened the class; this one must end."""


_DAMAGED = (sqlite3.SQLITE_CORRUPT, sqlite3.SQLITE_NOTADB)

StoreFault = Literal["disk", "database"]
"""Why nothing can be stored: the disk is full or broken, or the database server cannot be reached."""


def fault_of(error: StoreError) -> StoreFault:
    """The fault that a client is told when its request failed with this error."""
    return "database" if isinstance(error, StoreAway) else "disk"


@dataclass(frozen=True, slots=True)
class DeletedClass:
    """A class that was deleted, and can be restored. Times are in s since 1970."""

    name: str
    at: float
    # When its removal was announced (``retention.py``).
    announced: float | None = None


@dataclass(frozen=True, slots=True)
class Rows:
    """The rows that a statement gives, and how many it changed."""

    rows: Sequence[tuple[Any, ...]]
    rowcount: int

    def fetchone(self) -> Any:
        """The first row; ``None`` without one."""
        return self.rows[0] if self.rows else None

    def __iter__(self) -> Iterator[Any]:
        return iter(self.rows)


class Database(Protocol):
    """A database of one class. Statements outside of a transaction are transactions of their own."""

    def execute(self, statement: str, values: Sequence[object] = ()) -> Rows:
        """
        Run a statement.

        Raises:
            StoreError: nothing was changed.
        """

    def transaction(self) -> AbstractContextManager[None]:
        """
        A transaction that no other writer interrupts; its changes are on the disk when it ends.

        Raises:
            StoreError: nothing was changed.
        """

    def applied_migrations(self) -> int:
        """How many migrations of ``schema.py`` the database has."""

    def migrate(self, statements: Sequence[str], number: int) -> None:
        """Apply the migration of that number, as one transaction."""

    def keep(self) -> None:
        """
        Make sure that the class is locked for this service, after a lost connection through a new one.

        Raises:
            StoreAway: the server cannot be reached now.
            ClassTaken: another service has opened the class meanwhile.
        """

    def beside(self) -> Database:
        """
        A connection of its own to the same class, to read it meanwhile.

        Raises:
            StoreError: there is none to be had.
        """

    def close(self) -> None:
        """Close it."""


class SqliteDatabase:
    """A file in WAL mode; it is created when it does not exist."""

    def __init__(self, path: Path) -> None:
        self._path = path
        with _as_store_error():
            # Autocommit: transactions are explicit. One thread at a time uses it (`store_thread.py`).
            self._connection = sqlite3.connect(path, isolation_level=None, check_same_thread=False)
        try:
            self.execute("PRAGMA journal_mode = WAL")
            self.execute("PRAGMA synchronous = FULL")
            self.execute("PRAGMA foreign_keys = ON")
            # What is deleted is overwritten.
            self.execute("PRAGMA secure_delete = ON")
        except StoreError:
            self.close()
            raise

    def check(self) -> None:
        """
        See that the file is whole.

        Raises:
            StoreDamaged: it is not.
        """
        found = self.execute("PRAGMA quick_check(1)").fetchone()[0]
        if found != "ok":
            raise StoreDamaged(str(found))

    def copy_to(self, path: Path) -> None:
        """
        Copy the database to a file.

        Raises:
            StoreError: the file cannot be written.
        """
        with _as_store_error(), closing(sqlite3.connect(path)) as copy:
            self._connection.backup(copy)

    def execute(self, statement: str, values: Sequence[object] = ()) -> Rows:
        """``Database.execute``."""
        with _as_store_error():
            cursor = self._connection.execute(statement, values)
            return Rows(cursor.fetchall(), cursor.rowcount)

    @contextmanager
    def transaction(self) -> Iterator[None]:
        """``Database.transaction``."""
        self.execute("BEGIN IMMEDIATE")
        try:
            yield
        except BaseException:
            self.execute("ROLLBACK")
            raise
        self.execute("COMMIT")

    def applied_migrations(self) -> int:
        """``Database.applied_migrations``: SQLite has a place for this number."""
        return int(self.execute("PRAGMA user_version").fetchone()[0])

    def migrate(self, statements: Sequence[str], number: int) -> None:
        """``Database.migrate``."""
        with self.transaction():
            for statement in statements:
                self.execute(statement)
            self.execute(f"PRAGMA user_version = {number}")

    def keep(self) -> None:
        """``Database.keep``: the lock of the folder stays as long as the process."""

    def beside(self) -> SqliteDatabase:
        """``Database.beside``."""
        return SqliteDatabase(self._path)

    def close(self) -> None:
        """Close the file; the journal is merged into it."""
        self._connection.close()


@contextmanager
def _as_store_error() -> Iterator[None]:
    try:
        yield
    except sqlite3.Error as error:
        # The last byte is the code without its extension. Errors of Python's own module have none.
        code = getattr(error, "sqlite_errorcode", 0) & 0xFF
        raise (StoreDamaged if code in _DAMAGED else StoreError)(str(error)) from error
