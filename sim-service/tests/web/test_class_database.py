"""What pupils and teacher are told over real sockets while the database of their class is away or full."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from contextlib import AsyncExitStack, asynccontextmanager
from dataclasses import replace

from rosy_sim.classroom.class_places import class_place
from rosy_sim.classroom.store_thread import StoreThread
from rosy_sim.config import Config

from ..postgresql_server import PostgresqlServer, needs_postgresql, restartable_server
from .test_app import serving
from .test_class import Class, save


@asynccontextmanager
async def taught_on(url: str, config: Config) -> AsyncIterator[Class]:
    """A class on a server."""
    with class_place(config.classes, url).open("7b") as store:
        admission = store.admission()
        async with serving(replace(config, class_database=url), store) as (address, service), AsyncExitStack() as stack:
            assert service.classroom is not None
            # A server that is away is away at once.
            service.classroom._store = StoreThread(store, 0.0)
            yield Class(address, admission.code, admission.teacher_key, stack)


@needs_postgresql
def test_what_is_told_as_saved_is_in_the_database_also_when_it_was_away(config: Config) -> None:
    async def lesson(server: PostgresqlServer) -> None:
        async with taught_on(server.url, config) as opened:
            ada, _ = await opened.pupil("Ada")
            board = await opened.board()
            first = await save(ada, "one")
            assert first["op"] == "saved"
            server.stop()
            refused = await save(ada, "two", base=first["version"])
            assert (refused["op"], refused["reason"]) == ("unsaved", "database")
            assert (await board.op("store"))["fault"] == "database"
            await board.send("open-task", title="Maze")
            assert (await board.op("refused"))["reason"] == "database"
            late = await opened.open()
            await late.send("join", code=opened.code, nickname="Bob", language="en")
            assert (await late.op("refused"))["reason"] == "database"
            await asyncio.to_thread(server.start)
            # The service connects by itself, and the page sends its program again.
            assert (await board.op("store"))["fault"] is None
            again = await save(ada, "two", base=first["version"])
            assert again["op"] == "saved"
            await late.send("join", code=opened.code, nickname="Bob", language="en")
            await late.op("entered")
        with class_place(config.classes, server.url).read("7b") as store:
            assert [(v.number, v.text) for v in store.history(store.pupils()[0].id)] == [
                (first["version"], "one"),
                (again["version"], "two"),
            ]

    with restartable_server() as server:
        asyncio.run(lesson(server))
