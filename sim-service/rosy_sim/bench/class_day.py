"""
Memory of a service through the hours of a class: a leak is seen as a level that rises with each hour.

An hour is what each pupil does in one, without the pauses: joins or enters again, checks, runs, goes back in the run
and on with another program, previews, saves, hands in for the teacher's task, and leaves; the board opens what was
handed in. The service runs here with its worker; pupils and the board are clients in another process.

Recorded with 6 pupils for 60 hours on two busy cores: the service 34 MB at first, 42 MB after an hour, 45.7 MB after 40
and 45.8 after 60; its worker, with what it keeps ready, between 363 and 380 MB all the time; as many open files after
60 hours as after the first.
"""

from __future__ import annotations

import asyncio
import gc
import json
import multiprocessing
import tempfile
import threading
from collections.abc import Callable
from contextlib import AsyncExitStack
from dataclasses import dataclass, replace
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

import psutil
import uvloop
from websockets.asyncio.client import ClientConnection

from ..classroom.store.class_folder import open_class
from ..classroom.store.class_store import ClassStore
from ..config import Config
from .attacks.page_client import PageClient, connected
from .resting import share_of
from .serving import serving

__all__ = ["report"]

_PROGRAM = """accelerateNUMBER :: Velocity -> Velocity
accelerateNUMBER (Velocity v w) = Velocity (v + 0.3) 0.4

main = simulate accelerateNUMBER
"""
"""With a name of its own each time, so that no answer is one that was given before."""

_RETURNS = 3
"""How often a pupil's page is opened again in an hour."""


@dataclass(frozen=True, slots=True)
class Level:
    """What the service and its worker hold: MB without a file behind them, and counts of the service."""

    service: float
    worker: float
    processes: int
    descriptors: int
    tasks: int
    threads: int
    objects: int


def level() -> Level:
    """Of this process and all below it, now; the clients' process does not count."""
    gc.collect()
    process = psutil.Process()
    clients = {child.pid for child in multiprocessing.active_children() if child.pid is not None}
    below = [child for child in process.children(recursive=True) if child.pid not in clients and "rosy" in child.name()]
    shares = []
    for one in [process, *below]:
        try:
            shares.append(share_of(Path(f"/proc/{one.pid}/smaps_rollup").read_text(), one.name()))
        except (OSError, psutil.NoSuchProcess):
            # A program that has ended meanwhile.
            continue
    tasks = len(asyncio.all_tasks())
    return Level(
        shares[0].without_file,
        sum(one.without_file for one in shares[1:]),
        len(below),
        process.num_fds(),
        tasks,
        threading.active_count(),
        len(gc.get_objects()),
    )


def report(config: Config, pupils: int, hours: int) -> list[Level]:
    """Print the level at first and after each hour; returns them."""
    limits = replace(config.limits, sessions=max(2 * pupils, config.limits.sessions), address_sessions=2 * pupils)
    with (
        tempfile.TemporaryDirectory() as folder,
        open_class(Path(folder), "bench") as store,
        asyncio.Runner(loop_factory=uvloop.new_event_loop) as runner,
    ):
        return runner.run(_measure(config.with_limits(limits), store, pupils, hours))


async def _measure(config: Config, store: ClassStore, pupils: int, hours: int) -> list[Level]:
    ours, theirs = multiprocessing.Pipe()
    admission = store.admission()
    async with serving(config, store) as (_, port):
        clients = multiprocessing.get_context("spawn").Process(
            target=work, args=(port, pupils, admission.code, admission.teacher_key, hours, theirs), daemon=True
        )
        clients.start()
        # Its end is noticed.
        theirs.close()
        levels = []
        columns = (("hour", 6), ("service MB", 12), ("worker MB", 11), ("processes", 11), ("files", 7), ("tasks", 7))
        print("".join(f"{name:>{width}}" for name, width in (*columns, ("objects", 10))))
        try:
            for hour in range(hours + 1):
                await asyncio.to_thread(ours.recv)
                now = level()
                levels.append(now)
                print(
                    f"  {hour:>4} {now.service:>11.1f} {now.worker:>10.1f} {now.processes:>10} {now.descriptors:>6} "
                    f"{now.tasks:>6} {now.objects:>9}",
                    flush=True,
                )
                if hour < hours:
                    ours.send("on")
        finally:
            clients.join(5)
            clients.kill()
    return levels


def work(port: int, pupils: int, code: str, key: str, hours: int, talk: Connection) -> None:
    """Say when an hour begins and wait until it may, so often and once more at the end."""
    asyncio.run(_work(port, pupils, code, key, hours, talk))


async def _work(port: int, pupils: int, code: str, key: str, hours: int, talk: Connection) -> None:
    class_pupils = [_Pupil(port, number, code) for number in range(pupils)]
    for hour in range(hours):
        talk.send(hour)
        await asyncio.to_thread(talk.recv)
        await work_an_hour(port, class_pupils, key, hour)
    talk.send(hours)


async def work_an_hour(port: int, class_pupils: list[_Pupil], key: str, hour: int) -> None:
    """All pupils at once, and the board, which opens a task before and the hand-ins afterwards."""
    async with connected(port, "board") as socket:
        board = PageClient(socket, port, "")
        await board.send("unlock", key=key)
        await board.answer("board")
        await board.send("open-task", title=f"task of hour {hour}")
        while True:
            tasks = (await board.answer("tasks"))["tasks"]
            opened = [task for task in tasks if task["title"] == f"task of hour {hour}"]
            if opened:
                break
        task = opened[0]["id"]
        watching = asyncio.create_task(board.drain())
        await asyncio.gather(*(pupil.work(task) for pupil in class_pupils))
        watching.cancel()
    async with connected(port, "board") as socket:
        board = PageClient(socket, port, "")
        await board.send("unlock", key=key)
        await board.answer("tasks")
        for pupil in class_pupils:
            await board.send("open-hand-in", task=task, pupil=pupil.identity)
            await board.answer("program")
        await board.send("close-task", task=task)


class _Pupil:
    """A pupil, who keeps a token, a program and its version between the hours."""

    def __init__(self, port: int, number: int, code: str) -> None:
        self._port, self._number, self._code = port, number, code
        self._token: str | None = None
        self._version = 0
        self._count = number * 1_000_000
        self.identity = 0

    async def work(self, task: int) -> None:
        """An hour's work."""
        for turn in range(_RETURNS):
            async with AsyncExitStack() as stack:
                page_socket = await stack.enter_async_context(connected(self._port, "session"))
                member = await stack.enter_async_context(connected(self._port, "class"))
                session = await _until(page_socket, lambda m: m["op"] == "hello")
                await self._enter(member)
                await _tell(member, "here", session=session["session"])
                await self._learn(page_socket)
                await self._save(member)
                if turn == _RETURNS - 1:
                    await _tell(member, "hand-in", task=task, name="own", text=self._source())
                    await _until(member, lambda m: m["op"] in ("tasks", "not-handed-in"))

    async def _enter(self, member: ClientConnection) -> None:
        if self._token is None:
            await _tell(member, "join", code=self._code, nickname=f"pupil {self._number}", language="en")
        else:
            await _tell(member, "enter", token=self._token)
        entered = await _until(member, lambda m: m["op"] in ("entered", "refused"))
        assert entered["op"] == "entered", entered
        self._token, self.identity = entered.get("token") or self._token, entered["pupil"]

    async def _learn(self, page: ClientConnection) -> None:
        source = self._source()
        number = self._count
        await _tell(page, "check", id=number, source=source)
        await _until(page, lambda m: m["op"] == "checked" and m["id"] == number)
        await _tell(page, "run", run=1, source=source, seed=1, speed=8)
        await _until(page, lambda m: m["op"] == "frame" and m["step"] >= 50)
        # Back to an earlier step, and on from there.
        await _tell(page, "run", run=2, source=self._source(), after=20, of=1, speed=8)
        await _until(page, lambda m: m["op"] == "frame" and m["run"] == 2 and m["step"] >= 50)
        await _tell(page, "stop")
        await _tell(page, "preview", id=number, source=self._source(), seconds=5)
        await _until(page, lambda m: m["op"] == "previewed" and m["id"] == number)

    async def _save(self, member: ClientConnection) -> None:
        for _ in range(5):
            self._count += 1
            mark = f"m{self._count}"
            await _tell(
                member,
                "save",
                **{"program": "own", "name": "own", "text": self._source(), "reason": "change", "base": self._version},
                mark=mark,
            )
            saved = await _until(member, lambda m, mark=mark: m.get("mark") == mark)  # type: ignore[misc]
            assert saved["op"] == "saved", saved
            self._version = saved["version"]

    def _source(self) -> str:
        self._count += 1
        return _PROGRAM.replace("NUMBER", str(self._count))


async def _tell(socket: ClientConnection, op: str, **fields: Any) -> None:
    await socket.send(json.dumps({"op": op, **fields}))


async def _until(socket: ClientConnection, wanted: Callable[[dict[str, Any]], bool]) -> dict[str, Any]:
    """The next message that fits; those before it are dropped."""
    while True:
        message: dict[str, Any] = json.loads(await socket.recv())
        if wanted(message):
            return message
