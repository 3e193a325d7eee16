"""
The worker for a service with many pages: one process, restarted when it dies, asked from asyncio.

Answers come home by ``id``. When the process dies or gives no sign of life, everything under way ends with
``WorkerLost``, the pages are told, and one that is warm already takes its place (after a growing pause when they keep
dying).
"""

from __future__ import annotations

import asyncio
import logging
import os
import socket
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Literal, TypeVar

from ..config import Config
from ..errors import WorkerLost, WorkerMissing, WorkerRefused
from ..wire.worker import (
    Answer,
    Checked,
    Completed,
    Failed,
    Gone,
    Refused,
    Started,
    WorkerReady,
    check_request,
    complete_request,
    kill_request,
    run_request,
)
from .connection import Connection
from .launch import launch
from .spare import LAST_PAUSE, Spare

__all__ = ["RunningProgram", "State", "Worker"]

_T = TypeVar("_T")

_log = logging.getLogger(__name__)

State = Literal["starting", "ready", "restarting"]

_FIRST_PAUSE = 0.02
"""Between a death and the next start, s; doubles while it keeps dying before it is ready."""

_SPARE_DELAY = 0.25
"""After a worker is ready until the next one is warmed up beside it, s: the first run comes first. One that is wedged
right then has been found out when the next one is warm, and all of it takes less than a second."""


@dataclass(slots=True)
class RunningProgram:
    """A run as the worker sees it."""

    id: int
    # Done when the worker says that the program starts, is refused, or is gone before either.
    started: asyncio.Future[Started | Refused | Gone]
    # Done when the child has been reaped; fails with WorkerLost when the worker dies first.
    gone: asyncio.Future[Gone]


class Worker:
    """Use as a task: ``run()`` keeps a worker alive until it is cancelled."""

    def __init__(self, config: Config, tell: Callable[[State], None]) -> None:
        self._config = config
        self._tell = tell
        # What pages are told; changed by run() only.
        self.state: State = "starting"
        # The process id of the current worker, for tests and tables.
        self.pid: int | None = None
        # Takes over at once when the worker dies.
        self._spare = Spare(self._connect)
        self._ids = 0
        self._connection: Connection | None = None
        self._questions: dict[int, asyncio.Future[Checked | Completed]] = {}
        self._runs: dict[int, RunningProgram] = {}
        self._ready = asyncio.Event()

    # Keeping one alive

    async def run(self) -> None:
        """Start a worker, and another whenever it dies, for ever."""
        try:
            await self._keep()
        finally:
            await self._spare.close()

    async def _keep(self) -> None:
        pause = _FIRST_PAUSE
        while True:
            connection = self._spare.take() or self._connect()
            if connection is None:
                # Rebuilt at this moment, perhaps, or the machine is out of processes: it may come back.
                self._say("restarting")
                pause = min(LAST_PAUSE, pause * 2)
                await asyncio.sleep(pause)
                continue
            try:
                await self._serve(connection)
                pause = _FIRST_PAUSE if connection.ready.is_set() else min(LAST_PAUSE, pause * 2)
            finally:
                self._lose()
                await connection.end()
            self._say("restarting")
            await asyncio.sleep(pause)

    async def _serve(self, connection: Connection) -> None:
        """Until the worker is lost."""
        self._connection, self.pid = connection, connection.pid
        connection.listener = self._take
        if connection.ready.is_set():
            self._begin()
        preparing = asyncio.get_running_loop().create_task(self._prepare(connection))
        try:
            await connection.lives()
        finally:
            preparing.cancel()

    async def _prepare(self, connection: Connection) -> None:
        """Warm up the worker that takes over when this one dies."""
        await connection.ready.wait()
        await asyncio.sleep(_SPARE_DELAY)
        self._spare.prepare()

    async def spare_warm(self) -> None:
        """Until another one is ready to take over, for tests and tables."""
        await self._spare.warm()

    @property
    def spare_pid(self) -> int | None:
        """The process id of the worker in waiting, for tests and tables."""
        return self._spare.pid

    def _connect(self) -> Connection | None:
        try:
            return Connection(launch(self._config), self._config.limits.worker_ready)
        except (WorkerMissing, OSError) as error:
            _log.warning("the worker cannot be started: %s", error)
            return None

    def _begin(self) -> None:
        self._ready.set()
        self._say("ready")

    def _say(self, state: State) -> None:
        if state != self.state:
            self.state = state
            self._tell(state)

    def _lose(self) -> None:
        """Everything under way has lost its worker."""
        if self._connection is not None:
            self._connection.listener = None
        self._connection = self.pid = None
        self._ready.clear()
        questions, self._questions = self._questions, {}
        runs, self._runs = self._runs, {}
        for question in questions.values():
            _fail(question)
        for run in runs.values():
            _fail(run.started)
            _fail(run.gone)

    # Asking

    async def check(self, source: str) -> Checked:
        """
        Problems, declarations, graph and types. Cancelling it cancels the worker's work as well.

        Raises:
            WorkerLost: the worker died meanwhile.
        """
        answer = await self._ask(lambda ident: check_request(ident, source))
        assert isinstance(answer, Checked)
        return answer

    async def complete(self, source: str, line: int, column: int) -> Completed:
        """
        What can stand at a place. Cancelling it cancels the worker's work as well.

        Raises:
            WorkerLost: the worker died meanwhile.
        """
        answer = await self._ask(lambda ident: complete_request(ident, source, line, column))
        assert isinstance(answer, Completed)
        return answer

    async def _ask(self, request: Callable[[int], bytes]) -> Checked | Completed:
        await self._ready.wait()
        ident = self._next()
        answer: asyncio.Future[Checked | Completed] = asyncio.get_running_loop().create_future()
        self._questions[ident] = answer
        self._send(request(ident))
        try:
            async with asyncio.timeout(self._config.limits.compile):
                return await answer
        except (TimeoutError, asyncio.CancelledError):
            self._questions.pop(ident, None)
            self._send(kill_request(ident))
            raise

    async def start(self, source: str, link: socket.socket) -> RunningProgram:
        """Ask for a run; ``link`` is handed over and closed here."""
        try:
            await self._ready.wait()
        except asyncio.CancelledError:
            link.close()
            raise
        loop = asyncio.get_running_loop()
        program = RunningProgram(self._next(), loop.create_future(), loop.create_future())
        for future in (program.started, program.gone):
            # Nobody may be waiting any more when a worker dies.
            future.add_done_callback(lambda f: f.cancelled() or f.exception())
        self._runs[program.id] = program
        self._send(run_request(program.id, source, self._config.limits.memory), (link.detach(),))
        return program

    def kill(self, program: RunningProgram) -> None:
        """End a run at once; nothing happens when it has ended."""
        if program.id in self._runs:
            self._send(kill_request(program.id))

    def _next(self) -> int:
        self._ids += 1
        return self._ids

    def _send(self, data: bytes, descriptors: tuple[int, ...] = ()) -> None:
        if self._connection is not None:
            self._connection.send(data, descriptors)
            return
        for descriptor in descriptors:
            os.close(descriptor)

    # Answers

    def _take(self, answer: Answer) -> None:
        match answer:
            case WorkerReady():
                self._begin()
            case Checked() | Completed():
                _answer(self._questions.pop(answer.id, None), answer)
            case Started():
                if answer.id in self._runs:
                    _answer(self._runs[answer.id].started, answer)
            case Refused():
                refused = self._runs.pop(answer.id, None)
                if refused is not None:
                    _answer(refused.started, answer)
                    _answer(refused.gone, Gone(answer.id))
            case Gone():
                run = self._runs.pop(answer.id, None)
                if run is not None:
                    _answer(run.started, answer)
                    _answer(run.gone, answer)
            case Failed():
                self._fail_request(answer)
            case _:
                return

    def _fail_request(self, answer: Failed) -> None:
        if answer.id is None:
            return
        question = self._questions.pop(answer.id, None)
        if question is not None and not question.done():
            question.set_exception(WorkerRefused(answer.message))
        run = self._runs.pop(answer.id, None)
        if run is not None:
            for future in (run.started, run.gone):
                if not future.done():
                    future.set_exception(WorkerRefused(answer.message))


def _answer(future: asyncio.Future[_T] | None, value: _T) -> None:
    if future is not None and not future.done():
        future.set_result(value)


def _fail(future: asyncio.Future[Any]) -> None:
    if not future.done():
        future.set_exception(WorkerLost())
