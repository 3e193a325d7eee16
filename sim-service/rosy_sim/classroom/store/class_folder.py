"""
Folders of classes on the disk: one folder a class, readable by its owner only, with the database and its journal.

A service that has a class open holds a lock on it, so that no other service writes it and no command deletes it.
"""

from __future__ import annotations

import fcntl
import os
import re
import secrets
import shutil
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from ...errors import BadInput
from ...sentences.sentence import tr
from .class_store import Admission, ClassStore
from .database import SqliteDatabase, StoreError

__all__ = ["check_name", "class_names", "delete_class", "new_admission", "open_class", "read_class"]

_LETTERS = "bcdfghjkmnpqrstvwxyz23456789"
"""Without vowels, which form words, and without letters and digits that look alike."""

_CODE_LENGTH, _KEY_LENGTH = 6, 16

_NAME = re.compile(r"\w[\w-]{0,39}")

_DATABASE, _LOCK = "class.sqlite3", "lock"


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
    with _locked(path, name, create=True), _opened(path / _DATABASE, name) as store:
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


@contextmanager
def _opened(database: Path, name: str) -> Iterator[ClassStore]:
    try:
        # The file is created for its owner only, before anything is in it.
        os.close(os.open(database, os.O_CREAT | os.O_RDWR, 0o600))
        store = ClassStore(SqliteDatabase(database), new_admission(), time.time())
    except (OSError, StoreError) as error:
        raise BadInput(
            tr("The class {name} cannot be opened ({database}): {why}.", name=name, database=database, why=error)
        ) from error
    try:
        yield store
    finally:
        store.close()


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


def delete_class(folder: Path, name: str) -> None:
    """
    Delete a class with its journal and everything else in its folder.

    Raises:
        BadInput: there is no such class, or it is in use.
    """
    path = _class_path(folder, name)
    with _locked(path, name, create=False):
        try:
            shutil.rmtree(path)
        except OSError as error:
            raise BadInput(
                tr(
                    "The class {name} cannot be deleted ({path}): {why}.",
                    name=name,
                    path=path,
                    why=error.strerror or "",
                )
            ) from error
