"""Databases of classes for tests: a file and, where it is installed, a PostgreSQL server."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from rosy_sim.classroom.store.class_store import Admission, ClassStore
from rosy_sim.classroom.store.database import Database, SqliteDatabase

from ..postgresql_server import needs_postgresql, postgresql_server

ADMISSION = Admission("code", "key")

Opens = Callable[[str], Database]
"""Opens the database of a class by its name."""


@pytest.fixture(scope="session")
def server() -> Iterator[str]:
    """The URL of a PostgreSQL server, which the tests of a process share."""
    with postgresql_server() as url:
        yield url


@pytest.fixture(params=["sqlite", pytest.param("postgresql", marks=needs_postgresql)])
def opens(request: pytest.FixtureRequest, tmp_path: Path) -> Iterator[Opens]:
    """Opens the database of a class by its name; all are closed at the end."""
    opened: list[Database] = []
    url = request.getfixturevalue("server") if request.param == "postgresql" else None

    def open_database(name: str) -> Database:
        if url is None:
            database: Database = SqliteDatabase(tmp_path / name)
        else:
            from rosy_sim.classroom.store.postgresql_database import PostgresqlDatabase

            database = PostgresqlDatabase(url, f"{tmp_path}-{name}")
        opened.append(database)
        return database

    yield open_database
    for database in opened:
        database.close()


@pytest.fixture
def store(opens: Opens) -> ClassStore:
    """An open class."""
    return ClassStore(opens("class.sqlite3"), ADMISSION, 0.0)
