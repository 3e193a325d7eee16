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
from .database import DeletedClass, StoreAway, StoreError, StoreRefused
from .retention import next_step

__all__ = ["ClassPlace", "class_place", "remove_expired"]


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

    def delete(self, name: str, now: float) -> None:
        """Put a class with everything in it among the deleted ones; ``now`` is in s since 1970."""

    def deleted(self) -> list[DeletedClass]:
        """The deleted classes that can be restored, the newest first."""

    def restore(self, deleted: DeletedClass, name: str) -> None:
        """Bring a deleted class back under a name that no class has."""

    def announce_removal(self, deleted: DeletedClass, at: float | None) -> None:
        """Store when the removal of a deleted class was announced, in s since 1970; ``None`` withdraws it."""

    def remove(self, deleted: DeletedClass) -> None:
        """Remove a deleted class for good."""


def remove_expired(place: ClassPlace, now: float) -> None:
    """
    Take the next step of ``retention.py`` with each deleted class; ``now`` is in s since 1970.

    Raises:
        BadInput: the classes cannot be reached, or one cannot be removed.
    """
    for deleted in place.deleted():
        match next_step(deleted.at, deleted.announced, now):
            case "announce":
                place.announce_removal(deleted, now)
            case "withdraw":
                place.announce_removal(deleted, None)
            case "remove":
                place.remove(deleted)
            case "keep":
                pass


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

    def delete(self, name: str, now: float) -> None:
        class_folder.delete_class(self.folder, name, now)

    def deleted(self) -> list[DeletedClass]:
        return class_folder.deleted_classes(self.folder)

    def restore(self, deleted: DeletedClass, name: str) -> None:
        class_folder.restore_class(self.folder, deleted, name)

    def announce_removal(self, deleted: DeletedClass, at: float | None) -> None:
        class_folder.announce_removal(self.folder, deleted, at)

    def remove(self, deleted: DeletedClass) -> None:
        class_folder.remove_deleted(self.folder, deleted)


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
            with _as_bad_input():
                store.roster.purge(time.time())
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

    def delete(self, name: str, now: float) -> None:
        from .postgresql_database import delete_class

        with _as_bad_input():
            delete_class(self.url, name, now)

    def deleted(self) -> list[DeletedClass]:
        from .postgresql_database import deleted_classes

        with _as_bad_input():
            return deleted_classes(self.url)

    def restore(self, deleted: DeletedClass, name: str) -> None:
        from .postgresql_database import restore_class

        check_name(name)
        with _as_bad_input():
            restore_class(self.url, deleted, name)

    def announce_removal(self, deleted: DeletedClass, at: float | None) -> None:
        from .postgresql_database import announce_removal

        with _as_bad_input():
            announce_removal(self.url, deleted, at)

    def remove(self, deleted: DeletedClass) -> None:
        from .postgresql_database import remove_deleted

        with _as_bad_input():
            remove_deleted(self.url, deleted)


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
