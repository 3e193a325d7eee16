"""What pupils and teacher are told over real sockets while the database of their class is away or full."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from contextlib import AsyncExitStack, asynccontextmanager
from dataclasses import replace
from pathlib import Path

import pytest

from rosy_sim.classroom.store.class_places import class_place
from rosy_sim.classroom.store.class_store import ClassStore
from rosy_sim.config import Config

from ..classroom.conftest import server
from ..postgresql_server import PostgresqlServer, needs_postgresql, restartable_server
from .page_client import serving
from .test_class import Class, save

__all__ = ["server"]

BIG = "x" * 100_000
"""A text that needs room of its own in the database."""

# In a transaction of its own PostgreSQL says this when it cannot extend a file.
FILL = """
CREATE FUNCTION refuse() RETURNS trigger LANGUAGE plpgsql AS $$
BEGIN RAISE EXCEPTION 'could not extend file: No space left on device' USING ERRCODE = 'disk_full'; END $$;
CREATE TRIGGER full_disk BEFORE INSERT ON version FOR EACH ROW EXECUTE FUNCTION refuse()
"""


@asynccontextmanager
async def taught_on(url: str, config: Config) -> AsyncIterator[tuple[Class, ClassStore]]:
    """A class on a server."""
    with class_place(config.classes, url).open("7b") as store:
        admission = store.admission()
        async with serving(replace(config, class_database=url), store) as (address, service), AsyncExitStack() as stack:
            assert service.classroom is not None
            # A server that is away is away at once.
            service.classroom._store._patience = 0.0
            yield Class(address, admission.code, admission.teacher_key, stack, service), store


@needs_postgresql
def test_what_is_told_as_saved_is_in_the_database_also_when_it_was_away(config: Config) -> None:
    async def lesson(restarted: PostgresqlServer) -> None:
        async with taught_on(restarted.url, config) as (opened, _):
            ada, _ = await opened.pupil("Ada")
            board = await opened.board()
            first = await save(ada, "one")
            assert first["op"] == "saved"
            restarted.stop()
            refused = await save(ada, "two", base=first["version"])
            assert (refused["op"], refused["reason"]) == ("unsaved", "database")
            assert (await board.op("store"))["fault"] == "database"
            await board.send("open-task", title="Maze")
            assert (await board.op("refused"))["reason"] == "database"
            late = await opened.open()
            await late.send("join", code=opened.code, nickname="Bob", language="en")
            assert (await late.op("refused"))["reason"] == "database"
            await asyncio.to_thread(restarted.start)
            # The service connects by itself, and the page sends its program again.
            assert (await board.op("store"))["fault"] is None
            again = await save(ada, "two", base=first["version"])
            assert again["op"] == "saved"
            await late.send("join", code=opened.code, nickname="Bob", language="en")
            await late.op("entered")
        with class_place(config.classes, restarted.url).read("7b") as store:
            assert [(v.number, v.text) for v in store.history(store.pupils()[0].id)] == [
                (first["version"], "one"),
                (again["version"], "two"),
            ]

    with restartable_server() as restarted:
        asyncio.run(lesson(restarted))


@pytest.mark.parametrize("kind", ["sqlite", pytest.param("postgresql", marks=needs_postgresql)])
def test_on_a_full_disk_nothing_is_told_as_saved_and_it_is_sent_again(
    config: Config, tmp_path: Path, kind: str, request: pytest.FixtureRequest
) -> None:
    if kind == "sqlite":
        url, full, free = f"sqlite:{tmp_path}/classes", "PRAGMA max_page_count = 1", "PRAGMA max_page_count = 100000"
    else:
        url, full, free = request.getfixturevalue("server"), FILL, "DROP TRIGGER full_disk ON version"

    async def lesson() -> None:
        async with taught_on(url, config) as (opened, store):
            ada, _ = await opened.pupil("Ada")
            board = await opened.board()
            store._database.execute(full)
            refused = await save(ada, BIG)
            assert (refused["op"], refused["reason"]) == ("unsaved", "disk")
            assert (await board.op("store"))["fault"] == "disk"
            assert store.history(1) == []
            store._database.execute(free)
            again = await save(ada, BIG)
            assert again["op"] == "saved"
            assert (await board.op("store"))["fault"] is None
            assert [(v.number, v.text) for v in store.history(1)] == [(again["version"], BIG)]

    asyncio.run(lesson())
