"""
Classes whose PostgreSQL server is restarted or whose connection is cut: the class stays locked, each change is made
once, and nothing is reported that is not in the database.
"""

from __future__ import annotations

import asyncio
import re
import signal
import socket
import threading
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path

import pytest

from rosy_sim.classroom.store.class_store import ClassStore, Pupil, Saved
from rosy_sim.classroom.store.database import ClassTaken, StoreAway
from rosy_sim.classroom.store.store_thread import StoreThread
from rosy_sim.errors import BadInput

from ..conftest import PATIENCE
from ..postgresql_server import PostgresqlServer, needs_postgresql, restartable_server
from .conftest import ADMISSION

pytestmark = needs_postgresql


@pytest.fixture(scope="module")
def restarted() -> Iterator[PostgresqlServer]:
    with restartable_server() as server:
        yield server


def opened(url: str, name: str, patience: float = PATIENCE) -> ClassStore:
    from rosy_sim.classroom.store.postgresql_database import PostgresqlDatabase

    return ClassStore(PostgresqlDatabase(url, name, patience=patience), ADMISSION, 0.0)


def save(store: ClassStore, text: str, mark: str) -> object:
    return store.save(1, "p", "walk", text, "change", 0, mark, [], 0.0)


def join(store: ClassStore) -> object:
    return store.join("Ada", lambda: "a b c", "token", 0.0)


def assert_locked(url: str, name: str) -> None:
    with pytest.raises(BadInput, match="open in another Rosy"):
        opened(url, name, patience=0.0)


@pytest.mark.parametrize("how", [signal.SIGINT, signal.SIGQUIT])
def test_after_a_restart_the_class_is_locked_again_and_saves_go_on(
    restarted: PostgresqlServer, how: signal.Signals
) -> None:
    name = f"restart-{how}"

    async def lesson() -> None:
        store = StoreThread(opened(restarted.url, name), PATIENCE)
        assert isinstance(await store.call(join), Pupil)
        restarted.stop(how)
        restarted.start()
        # The lock is taken again without a save in between.
        await store.keep()
        assert_locked(restarted.url, name)
        restarted.stop(how)
        # While the server is away, a save waits for it.
        saving = asyncio.create_task(store.call(save, "one", "m"))
        await asyncio.to_thread(restarted.start)
        saved = await saving
        assert isinstance(saved, Saved)
        assert_locked(restarted.url, name)
        (version,) = await store.call(ClassStore.history, 1)
        assert (version.number, version.text) == (saved.number, "one")
        await store.close()

    asyncio.run(lesson())


def test_a_server_that_stays_away_fails_calls_until_it_is_back(restarted: PostgresqlServer) -> None:
    async def lesson() -> None:
        store = StoreThread(opened(restarted.url, "away"), 0.0)
        assert isinstance(await store.call(join), Pupil)
        restarted.stop()
        for mark in "ab":
            with pytest.raises(StoreAway):
                await store.call(save, "one", mark)
        assert store.is_away
        restarted.start()
        await store.keep()
        assert not store.is_away
        assert isinstance(await store.call(save, "one", "c"), Saved)
        assert len(await store.call(ClassStore.history, 1)) == 1
        await store.close()

    asyncio.run(lesson())


def test_a_class_that_another_service_has_had_meanwhile_is_not_taken_back(restarted: PostgresqlServer) -> None:
    async def lesson() -> None:
        store = StoreThread(opened(restarted.url, "taken"), PATIENCE)
        assert isinstance(await store.call(join), Pupil)
        restarted.stop()
        restarted.start()
        other = opened(restarted.url, "taken")
        with pytest.raises(ClassTaken):
            await store.keep()
        with pytest.raises(ClassTaken):
            await store.call(save, "one", "m")
        other.close()
        with pytest.raises(ClassTaken):
            await store.call(save, "one", "m")
        await store.close()

    asyncio.run(lesson())


class Cutter:
    """A proxy of the server's socket that cuts a connection at its next commit, before or behind the server."""

    def __init__(self, folder: Path, server: PostgresqlServer) -> None:
        self._to = server.url.partition("host=")[2] + "/.s.PGSQL.5432"
        self.url = f"postgresql://rosy@/postgres?host={folder}"
        self.cut: str | None = None
        self._listener = socket.socket(socket.AF_UNIX)
        self._listener.bind(str(folder / ".s.PGSQL.5432"))
        self._listener.listen()
        self._serve(self._accept)

    def _serve(self, work: Callable[..., None], *arguments: socket.socket) -> None:
        threading.Thread(target=work, args=arguments, daemon=True).start()

    def _accept(self) -> None:
        with suppress(OSError):
            while True:
                client, _ = self._listener.accept()
                server = socket.socket(socket.AF_UNIX)
                server.connect(self._to)
                self._serve(self._forward, client, server)

    def _forward(self, client: socket.socket, server: socket.socket) -> None:
        answers = threading.Thread(target=self._answer, args=(client, server), daemon=True)
        answers.start()
        # The client prepares a statement that it has sent often, and from then on sends its name (Parse and Bind).
        names = {b"COMMIT\0"}
        while data := client.recv(65536):
            names |= set(re.findall(rb"P.{4}(\w+\0)COMMIT\0", data, re.DOTALL))
            if self.cut is not None and any(name in data for name in names):
                is_heard, self.cut = self.cut == "behind", None
                # The client gets no answer.
                client.shutdown(socket.SHUT_RDWR)
                if is_heard:
                    server.sendall(data)
                break
            server.sendall(data)
        server.shutdown(socket.SHUT_WR)
        answers.join()
        server.close()
        client.close()

    @staticmethod
    def _answer(client: socket.socket, server: socket.socket) -> None:
        with suppress(OSError):
            while data := server.recv(65536):
                client.sendall(data)

    def close(self) -> None:
        self._listener.shutdown(socket.SHUT_RDWR)
        self._listener.close()


@pytest.fixture
def cutter(tmp_path_factory: pytest.TempPathFactory, restarted: PostgresqlServer) -> Iterator[Cutter]:
    cutter = Cutter(tmp_path_factory.mktemp("cut"), restarted)
    yield cutter
    cutter.close()


@pytest.mark.parametrize("cut", ["before", "behind"])
def test_a_commit_whose_answer_is_lost_takes_place_once(cutter: Cutter, cut: str) -> None:
    async def lesson() -> None:
        store = StoreThread(opened(cutter.url, f"cut-{cut}"), PATIENCE)
        cutter.cut = cut
        # Not "taken" by itself.
        pupil = await store.call(join)
        assert isinstance(pupil, Pupil)
        numbers = [0]
        for text in ("one", "two"):
            cutter.cut = cut
            saved = await store.call(ClassStore.save, pupil.id, "p", "walk", text, "change", numbers[-1], text, [], 0.0)
            assert isinstance(saved, Saved)
            numbers.append(saved.number)
        assert cutter.cut is None
        history = await store.call(ClassStore.history, pupil.id)
        assert [(version.number, version.text) for version in history] == list(
            zip(numbers[1:], ("one", "two"), strict=True)
        )
        assert [pupil.nickname for pupil in await store.call(ClassStore.pupils)] == ["Ada"]
        await store.close()

    asyncio.run(lesson())
