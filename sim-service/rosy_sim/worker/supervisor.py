"""
Supervisor of the worker for a service with many pages: one process, replaced when it dies, used from asyncio.

Answers are matched to requests by ``id``. When the process dies or is wedged, all pending requests fail with
``WorkerLost``, the pages are told, and the fork server forks another (after a growing pause when workers keep dying).
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
from ..errors import WorkerFailed, WorkerLost, WorkerRefused
from ..sentences.sentence import Sentence, tr
from ..sentences.wording import in_terminal
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
    prepare_request,
    run_request,
)
from .connection import Connection
from .fork_server import ForkServer

__all__ = ["RunningProgram", "WorkerStatus", "WorkerSupervisor"]

_T = TypeVar("_T")

_log = logging.getLogger(__name__)

WorkerStatus = Literal["starting", "ready", "restarting", "failed"]
"""``failed``: several starts have failed one after the other; another is tried now and then."""

_FIRST_PAUSE, _LAST_PAUSE = 0.02, 1.0
"""Between the end of a worker and the next one, s; doubles while workers die before they are ready."""

_FAILED_STARTS = 3
"""Starts in a row after which the cause is reported, and requests are refused until a start succeeds."""

_REST = 9
"""A worker that cannot start is tried again after this many times as long as the latest start took."""


@dataclass(slots=True)
class RunningProgram:
    """A run as the worker sees it."""

    id: int
    # Done when the worker says that the program starts, is refused, or is gone before either.
    started: asyncio.Future[Started | Refused | Gone]
    # Done when the child has been reaped; fails with WorkerLost when the worker dies first.
    gone: asyncio.Future[Gone]


class WorkerSupervisor:
    """Use as a task: ``run()`` keeps a worker alive until it is cancelled."""

    def __init__(self, config: Config, notify: Callable[[WorkerStatus], None]) -> None:
        self._config = config
        self._notify = notify
        # What pages are told; changed by run() only.
        self.state: WorkerStatus = "starting"
        # Why no worker can be started, while the state is "failed".
        self.fault: Sentence | None = None
        # The process id of the current worker, for tests and tables.
        self.pid: int | None = None
        # Warm; makes the next worker when this one dies.
        self._fork_server = ForkServer(config)
        self._ids = 0
        self._connection: Connection | None = None
        self._questions: dict[int, asyncio.Future[Checked | Completed]] = {}
        self._runs: dict[int, RunningProgram] = {}
        self._ready = asyncio.Event()
        # A worker is warm, or none can be started.
        self._decided = asyncio.Event()

    # Keeping one alive

    async def run(self) -> None:
        """Start a worker, and another whenever it dies, for ever."""
        try:
            await self._keep()
        finally:
            await self._fork_server.close()

    async def _keep(self) -> None:
        pause, failed_starts = _FIRST_PAUSE, 0
        clock = asyncio.get_running_loop().time
        while True:
            began = clock()
            connection = await self._fork_server.fork()
            if connection is None:
                # The executable may be in the middle of a build, or the machine out of processes.
                failed_starts += 1
                if failed_starts >= _FAILED_STARTS and self._fork_server.fault is not None:
                    self._report(self._fork_server.fault)
                pause = min(_LAST_PAUSE, pause * 2)
                await asyncio.sleep(max(pause, _REST * (clock() - began)) if self.state == "failed" else pause)
                continue
            failed_starts = 0
            try:
                await self._serve(connection)
            finally:
                self._drop_connection()
                await connection.end()
            self._set_state("restarting")
            if connection.ready.is_set():
                pause = _FIRST_PAUSE
            else:
                # What it has inherited may be damaged.
                await self._fork_server.close()
                pause = min(_LAST_PAUSE, pause * 2)
            await asyncio.sleep(pause)

    async def _serve(self, connection: Connection) -> None:
        """Until the worker is lost."""
        self._connection, self.pid = connection, connection.pid
        connection.listener = self._handle
        if connection.ready.is_set():
            self._become_ready()
        await connection.wait_until_lost()

    @property
    def fork_server_pid(self) -> int | None:
        """The process id of the fork server, for tests and tables."""
        return self._fork_server.pid

    def _report(self, fault: Sentence) -> None:
        """Report once that no worker can be started, and why."""
        self.fault = fault
        self._decided.set()
        if self.state != "failed":
            _log.warning("%s", in_terminal(tr("the worker cannot be started: {why}", why=fault)))
        self._set_state("failed")

    def _become_ready(self) -> None:
        self.fault = None
        self._ready.set()
        self._decided.set()
        self._set_state("ready")

    def _set_state(self, state: WorkerStatus) -> None:
        if state != self.state:
            self.state = state
            self._notify(state)

    def _drop_connection(self) -> None:
        """Fail all pending requests."""
        if self._connection is not None:
            self._connection.listener = None
        self._connection = self.pid = None
        self._ready.clear()
        self._decided.clear()
        questions, self._questions = self._questions, {}
        runs, self._runs = self._runs, {}
        for question in questions.values():
            _fail(question)
        for run in runs.values():
            _fail(run.started)
            _fail(run.gone)

    # Asking

    async def wait_ready(self) -> None:
        """
        Wait until a worker is warm.

        Raises:
            WorkerFailed: none can be started.
        """
        await self._decided.wait()
        if self.fault is not None:
            raise WorkerFailed(self.fault)

    async def check(self, source: str) -> Checked:
        """
        Problems, declarations, graph and types. Cancelling it cancels the worker's work as well.

        Raises:
            WorkerLost: the worker died meanwhile.
            WorkerFailed: none can be started.
        """
        answer = await self._ask(lambda ident: check_request(ident, source))
        assert isinstance(answer, Checked)
        return answer

    async def complete(self, source: str, line: int, column: int) -> Completed:
        """
        What can stand at a place. Cancelling it cancels the worker's work as well.

        Raises:
            WorkerLost: the worker died meanwhile.
            WorkerFailed: none can be started.
        """
        answer = await self._ask(lambda ident: complete_request(ident, source, line, column))
        assert isinstance(answer, Completed)
        return answer

    async def _ask(self, request: Callable[[int], bytes]) -> Checked | Completed:
        await self.wait_ready()
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
        """
        Ask for a run; ``link`` is handed over and closed here.

        Raises:
            WorkerFailed: no worker can be started.
        """
        try:
            await self.wait_ready()
        except (asyncio.CancelledError, WorkerFailed):
            link.close()
            raise
        program = self._new_program()
        self._send(run_request(program.id, source, self._config.limits.memory), (link.detach(),))
        return program

    def prepare(self, source: str, link: socket.socket) -> RunningProgram | None:
        """Have a run compiled that begin() may start; ``link`` is handed over and closed here. ``None``: not now."""
        if not self._ready.is_set():
            link.close()
            return None
        program = self._new_program()
        self._send(prepare_request(program.id, source, self._config.limits.memory), (link.detach(),))
        return program

    def begin(self, program: RunningProgram, source: str) -> None:
        """Start a prepared run, with the text that it was prepared from."""
        if program.id in self._runs:
            self._send(run_request(program.id, source, self._config.limits.memory))

    def _new_program(self) -> RunningProgram:
        loop = asyncio.get_running_loop()
        program = RunningProgram(self._next(), loop.create_future(), loop.create_future())
        for future in (program.started, program.gone):
            # The exception is retrieved even when no caller waits any more.
            future.add_done_callback(lambda f: f.cancelled() or f.exception())
        self._runs[program.id] = program
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

    def _handle(self, answer: Answer) -> None:
        match answer:
            case WorkerReady():
                self._become_ready()
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
