"""
Folders of classes on the disk: one folder a class, with the database, its journal, and a copy of the database from when
the class was last opened. Only their owner can read them, or which classes there are.

A service that has a class open holds a lock on it, so that no other service writes it and no command deletes it.
A deleted class is moved into the folder ``.deleted``, from which it can be restored.
"""

from __future__ import annotations

import fcntl
import os
import re
import secrets
import shutil
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from datetime import datetime
from pathlib import Path

from ...errors import BadInput
from ...sentences.sentence import Sentence, tr, verbatim
from .class_store import Admission, ClassStore
from .database import DeletedClass, SqliteDatabase, StoreDamaged, StoreError

__all__ = [
    "announce_removal",
    "check_name",
    "class_exists",
    "class_names",
    "delete_class",
    "deleted_classes",
    "new_admission",
    "open_class",
    "read_class",
    "remove_deleted",
    "restore_class",
]

_LETTERS = "bcdfghjkmnpqrstvwxyz23456789"
"""Without vowels, which form words, and without letters and digits that look alike."""

_CODE_LENGTH, _KEY_LENGTH = 6, 16

_NAME = re.compile(r"\w[\w-]{0,39}")

_DATABASE, _LOCK = "class.sqlite3", "lock"

_COPY = "backup.sqlite3"
"""The database as it was when the class was last opened by a service."""

_SMALLEST = 512
"""Bytes of a database; SQLite takes fewer for an empty one. SQLite, "Database File Format", section 1.3.2."""

_NEW = ".new"
"""Behind the name of a file that is not complete yet."""

_ANNOUNCED = "announced"
"""In the folder of a deleted class: when its removal was announced, in s since 1970 (``retention.py``)."""

_DELETED = ".deleted"
"""No class has a name with a dot. A deleted class is a folder ``SECONDS-NAME`` in it, in s since 1970."""


def new_admission() -> Admission:
    """A random code of 28^6 (4.8e8) and a random key of 28^16 (1.4e23)."""
    return Admission(_random(_CODE_LENGTH), _random(_KEY_LENGTH))


def _random(length: int) -> str:
    return "".join(secrets.choice(_LETTERS) for _ in range(length))


def class_names(folder: Path) -> list[str]:
    """The classes in a folder of classes."""
    return sorted(path.parent.name for path in folder.glob(f"*/{_DATABASE}"))


def check_name(name: str) -> None:
    """
    Refuse what cannot be the name of a class.

    Raises:
        BadInput: it cannot.
    """
    if _NAME.fullmatch(name) is None:
        raise BadInput(tr("The name of a class has at most 40 letters, digits, - and _."))


def _class_path(folder: Path, name: str) -> Path:
    check_name(name)
    return folder / name


@contextmanager
def open_class(folder: Path, name: str) -> Iterator[ClassStore]:
    """
    Open a class for a service, and lock it; a class that does not exist is created.

    Raises:
        BadInput: the name cannot be used, the class is in use, or its file cannot be read.
    """
    path = _class_path(folder, name)
    database = path / _DATABASE
    with _locked(path, name, create=True):
        _make_private(folder, path)
        for unfinished in path.glob(f"*{_NEW}*"):
            unfinished.unlink()
        # A journal without its database is what is left of a class.
        if not any(path.glob(f"{_DATABASE}*")):
            _create(database, name)
        with _opened(database, name, for_service=True) as store:
            yield store


@contextmanager
def read_class(folder: Path, name: str) -> Iterator[ClassStore]:
    """
    Open a class to read it, also while a service has it open.

    Raises:
        BadInput: the class does not exist, or its file cannot be read.
    """
    database = _class_path(folder, name) / _DATABASE
    if not database.exists():
        raise BadInput(tr("There is no class called {name}. ./rosy class list names them.", name=name))
    with _opened(database, name) as store:
        yield store


def _make_private(folder: Path, path: Path) -> None:
    """Take the rights of other users to a class, and to the names of classes, which an earlier Rosy may have left."""
    paths = [(path, 0o700), *((file, 0o600) for file in path.iterdir())]
    # A folder in which there is something else as well, such as /tmp, is not for classes alone.
    if all(entry.name == _DELETED or (entry / _LOCK).exists() for entry in folder.iterdir()):
        paths.append((folder, 0o700))
    for one, mode in paths:
        if one.stat().st_mode & 0o077:
            # Of another owner, who decides about it.
            with suppress(PermissionError):
                one.chmod(mode)


def _create(database: Path, name: str) -> None:
    """The database of a new class, which is there when it is complete."""
    new = database.with_name(f"{database.name}{_NEW}")
    with _openable(database, name):
        _make_file(new)
        ClassStore(SqliteDatabase(new), new_admission(), time.time()).close()
        new.rename(database)


def _make_file(path: Path) -> None:
    """An empty file, for its owner only before anything is in it."""
    os.close(os.open(path, os.O_CREAT | os.O_TRUNC | os.O_RDWR, 0o600))


@contextmanager
def _openable(database: Path, name: str) -> Iterator[None]:
    try:
        yield
    except (OSError, StoreError) as error:
        raise BadInput(
            tr("The class {name} cannot be opened ({database}): {why}.", name=name, database=database, why=error)
        ) from error


@contextmanager
def _opened(database: Path, name: str, *, for_service: bool = False) -> Iterator[ClassStore]:
    with _openable(database, name):
        opened = _whole(database, name)
        store = ClassStore(opened, new_admission(), time.time())
    try:
        if for_service:
            # Before the copy, which would keep those who are deleted now.
            with _openable(database, name):
                store.roster.purge(time.time())
            _copy(opened, database.with_name(_COPY))
        yield store
    finally:
        store.close()


def _whole(database: Path, name: str) -> SqliteDatabase:
    """
    The database of a class that was created.

    Raises:
        BadInput: the file is damaged.
        StoreError: it cannot be opened.
    """
    if not database.exists() or database.stat().st_size < _SMALLEST:
        raise _damaged(database, name, tr("the file is empty"))
    opened = None
    try:
        opened = SqliteDatabase(database)
        opened.check()
        if opened.applied_migrations() == 0:
            raise StoreDamaged("no tables")
    except StoreDamaged as error:
        if opened is not None:
            opened.close()
        raise _damaged(database, name, verbatim(str(error))) from error
    return opened


def _damaged(database: Path, name: str, why: Sentence) -> BadInput:
    copy = database.with_name(_COPY)
    if copy.exists():
        date = datetime.fromtimestamp(copy.stat().st_mtime).strftime("%Y-%m-%d %H:%M")
        backup = tr(
            "A copy from {date} is {copy}: move all files whose names begin with {file} out of its folder, then rename "
            "the copy to {file}.",
            date=date,
            copy=copy,
            file=database.name,
        )
    else:
        backup = tr("There is no copy of it here; a backup that the board has downloaded has its programs.")
    return BadInput(
        tr(
            "The class {name} is damaged ({database}: {why}). {backup}",
            name=name,
            database=database,
            why=why,
            backup=backup,
        )
    )


def _copy(opened: SqliteDatabase, copy: Path) -> None:
    """Replace the copy. On a full disk the old one stays; the first change of the class says that the disk is full."""
    new = copy.with_name(f"{copy.name}{_NEW}")
    with suppress(OSError, StoreError):
        _make_file(new)
        opened.copy_to(new)
        new.rename(copy)
        return
    new.unlink(missing_ok=True)


@contextmanager
def _locked(path: Path, name: str, *, create: bool) -> Iterator[None]:
    if not create and not path.is_dir():
        raise BadInput(tr("There is no class called {name}. ./rosy class list names them.", name=name))
    try:
        path.mkdir(mode=0o700, parents=True, exist_ok=True)
        lock = os.open(path / _LOCK, os.O_CREAT | os.O_RDWR | os.O_CLOEXEC, 0o600)
    except OSError as error:
        raise BadInput(
            tr("The class {name} cannot be opened ({path}): {why}.", name=name, path=path, why=error.strerror or "")
        ) from error
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError as error:
        os.close(lock)
        raise BadInput(tr("The class {name} is open in another Rosy; end that one first.", name=name)) from error
    try:
        yield
    finally:
        os.close(lock)


def delete_class(folder: Path, name: str, now: float) -> None:
    """
    Move a class with its journal and everything else in its folder among the deleted ones; ``now`` is in s since 1970.

    Raises:
        BadInput: there is no such class, or it is in use.
    """
    path = _class_path(folder, name)
    with _locked(path, name, create=False), _moving(path, name):
        (folder / _DELETED).mkdir(mode=0o700, exist_ok=True)
        path.rename(_free(folder, name, int(now)))


def _free(folder: Path, name: str, seconds: int) -> Path:
    while (target := folder / _DELETED / f"{seconds}-{name}").exists():
        seconds += 1
    return target


@contextmanager
def _moving(path: Path, name: str) -> Iterator[None]:
    try:
        yield
    except OSError as error:
        raise BadInput(
            tr(
                "The class {name} cannot be moved or removed ({path}): {why}.",
                name=name,
                path=path,
                why=error.strerror or "",
            )
        ) from error


def deleted_classes(folder: Path) -> list[DeletedClass]:
    """The deleted classes that can be restored, the newest first."""
    found = []
    for path in folder.glob(f"{_DELETED}/*/{_DATABASE}"):
        seconds, _, name = path.parent.name.partition("-")
        if seconds.isdecimal():
            found.append(DeletedClass(name, float(seconds), _announced(path.parent)))
    return sorted(found, key=lambda deleted: -deleted.at)


def _announced(path: Path) -> float | None:
    """When the removal of the class in this folder was announced; a file that is no time counts for nothing."""
    try:
        return float((path / _ANNOUNCED).read_text("utf-8"))
    except (OSError, ValueError):
        return None


def announce_removal(folder: Path, deleted: DeletedClass, at: float | None) -> None:
    """
    Store when the removal of a deleted class was announced; ``None`` withdraws it.

    Raises:
        BadInput: it cannot be stored.
    """
    path = _deleted_path(folder, deleted)
    with _moving(path, deleted.name):
        if at is None:
            (path / _ANNOUNCED).unlink(missing_ok=True)
        else:
            (path / _ANNOUNCED).write_text(f"{at!r}\n", "utf-8")


def restore_class(folder: Path, deleted: DeletedClass, name: str) -> None:
    """
    Bring a deleted class back under a name.

    Raises:
        BadInput: a class has this name, or the folder cannot be moved.
    """
    path = _class_path(folder, name)
    with _moving(path, name):
        if path.exists():
            raise class_exists(name)
        (_deleted_path(folder, deleted) / _ANNOUNCED).unlink(missing_ok=True)
        _deleted_path(folder, deleted).rename(path)


def class_exists(name: str) -> BadInput:
    """The refusal to restore a class under the name of another one."""
    return BadInput(tr("There is a class called {name}; choose another name with --as.", name=name))


def remove_deleted(folder: Path, deleted: DeletedClass) -> None:
    """
    Remove a deleted class for good.

    Raises:
        BadInput: the folder cannot be removed.
    """
    path = _deleted_path(folder, deleted)
    with _moving(path, deleted.name):
        shutil.rmtree(path)
        if not any(path.parent.iterdir()):
            path.parent.rmdir()


def _deleted_path(folder: Path, deleted: DeletedClass) -> Path:
    return folder / _DELETED / f"{int(deleted.at)}-{deleted.name}"
