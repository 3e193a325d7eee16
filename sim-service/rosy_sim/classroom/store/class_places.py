"""
Where classes are kept: in folders of this machine, or where ``ROSY_CLASS_DATABASE`` says: on a PostgreSQL server, from
which they can come up on another machine, or in a folder (``sqlite:/PATH``) that the nodes of one machine share.
"""

from __future__ import annotations

import time
from collections.abc import Iterator
from contextlib import AbstractContextManager, contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

from ...errors import BadInput
from ...sentences.sentence import tr
from . import class_folder
from .class_folder import check_name, new_admission
from .class_store import ClassStore
from .database import StoreAway, StoreError, StoreRefused

__all__ = ["ClassPlace", "class_place"]


class ClassPlace(Protocol):
    """
    All methods raise:
        BadInput: the name cannot be used, the class is in use or does not exist, or it cannot be read or deleted.
    """

    def names(self) -> list[str]:
        """The classes that there are."""

    def open(self, name: str) -> AbstractContextManager[ClassStore]:
        """Open a class for a service, and lock it; a class that does not exist is created."""

    def read(self, name: str) -> AbstractContextManager[ClassStore]:
        """Open a class to read it, also while a service has it open."""

    def delete(self, name: str) -> None:
        """Delete a class with everything in it."""


_SQLITE = "sqlite:"
"""Before the path of a folder: what nodes of a cluster on one machine share."""


def class_place(folder: Path, database: str | None) -> ClassPlace:
    """The folder of classes, or the database with this URL."""
    if database is not None and database.startswith(_SQLITE):
        return _Folder(Path(database.removeprefix(_SQLITE)))
    return _Folder(folder) if database is None else _Server(database)


@dataclass(frozen=True, slots=True)
class _Folder:
    folder: Path

    def names(self) -> list[str]:
        return class_folder.class_names(self.folder)

    def open(self, name: str) -> AbstractContextManager[ClassStore]:
        return class_folder.open_class(self.folder, name)

    def read(self, name: str) -> AbstractContextManager[ClassStore]:
        return class_folder.read_class(self.folder, name)

    def delete(self, name: str) -> None:
        class_folder.delete_class(self.folder, name)


@dataclass(frozen=True, slots=True)
class _Server:
    # Only the environment of a cluster has the driver, so it is imported where it is needed.
    url: str

    def names(self) -> list[str]:
        from .postgresql_database import class_names

        with _as_bad_input():
            return class_names(self.url)

    @contextmanager
    def open(self, name: str) -> Iterator[ClassStore]:
        from .postgresql_database import PostgresqlDatabase

        check_name(name)
        with _as_bad_input():
            store = ClassStore(PostgresqlDatabase(self.url, name), new_admission(), time.time())
        try:
            yield store
        finally:
            store.close()

    @contextmanager
    def read(self, name: str) -> Iterator[ClassStore]:
        from .postgresql_database import PostgresqlDatabase

        if name not in self.names():
            raise BadInput(tr("There is no class called {name}. ./rosy class list names them.", name=name))
        with _as_bad_input():
            store = ClassStore(PostgresqlDatabase(self.url, name, patience=None), new_admission(), time.time())
        try:
            yield store
        finally:
            store.close()

    def delete(self, name: str) -> None:
        from .postgresql_database import delete_class

        with _as_bad_input():
            delete_class(self.url, name)


@contextmanager
def _as_bad_input() -> Iterator[None]:
    try:
        yield
    except StoreRefused as error:
        raise BadInput(
            tr(
                "The server of the classes' database does not admit this machine ({why}). Correct user, password or "
                "database in ROSY_CLASS_DATABASE, or the server's pg_hba.conf.",
                why=error,
            )
        ) from error
    except StoreAway as error:
        raise BadInput(
            tr(
                "The database of the classes cannot be reached ({why}). Start its server, or correct "
                "ROSY_CLASS_DATABASE.",
                why=error,
            )
        ) from error
    except StoreError as error:
        raise BadInput(tr("The database of the classes cannot be used: {why}", why=error)) from error
