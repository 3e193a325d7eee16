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
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Literal, TypeVar

import msgspec

from ..config import Config
from ..errors import WorkerLost, WorkerMissing, WorkerRefused
from ..wire.lines import LineTooLong
from ..wire.worker import (
    Answer,
    Checked,
    Completed,
    Failed,
    Gone,
    Refused,
    Started,
    WorkerReady,
    WorkerStream,
    check_request,
    complete_request,
    kill_request,
    ping_request,
    run_request,
)
from .launch import WorkerProcess, launch
from .pulse import BEAT, Pulse

__all__ = ["RunningProgram", "State", "Worker"]

_T = TypeVar("_T")

_log = logging.getLogger(__name__)

State = Literal["starting", "ready", "restarting"]

_FIRST_PAUSE, _LAST_PAUSE = 0.02, 1.0
"""Between a death and the next start, s; doubles while it keeps dying before it is ready."""

_SPARE_DELAY = 1.0
"""After a worker is ready until the next one is warmed up beside it, s: the first run comes first."""


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
        # Warm and waiting; takes over at once when the worker dies.
        self._spare: WorkerProcess | None = None
        self._prepared = asyncio.Event()
        # Set when run() is over: no spare may be started any more.
        self._over = False
        self._ids = 0
        self._socket: socket.socket | None = None
        self._outgoing: deque[tuple[bytes, tuple[int, ...]]] = deque()
        self._questions: dict[int, asyncio.Future[Checked | Completed]] = {}
        self._runs: dict[int, RunningProgram] = {}
        self._stream = WorkerStream()
        self._ready = asyncio.Event()
        self._closed = asyncio.Event()
        self._pulse = Pulse(0)

    # Keeping one alive

    async def run(self) -> None:
        """Start a worker, and another whenever it dies, for ever."""
        pause = _FIRST_PAUSE
        try:
            await self._keep(pause)
        finally:
            self._over = True
            if self._spare is not None:
                self._spare.kill()
                self._spare.socket.close()
                await _reap(self._spare.pid)

    async def _keep(self, pause: float) -> None:
        while True:
            process = self._take_spare() or self._try_launch()
            if process is None:
                # Rebuilt at this moment, perhaps, or the machine is out of processes: it may come back.
                self._say("restarting")
                pause = min(_LAST_PAUSE, pause * 2)
                await asyncio.sleep(pause)
                continue
            try:
                await self._serve(process)
                pause = _FIRST_PAUSE if self.state == "ready" else min(_LAST_PAUSE, pause * 2)
            finally:
                self._lose()
                process.kill()
                process.socket.close()
                await _reap(process.pid)
            self._say("restarting")
            await asyncio.sleep(pause)

    async def _serve(self, process: WorkerProcess) -> None:
        """Until the worker closes its socket or does not become ready in time."""
        loop = asyncio.get_running_loop()
        process.socket.setblocking(False)
        self._socket, self.pid = process.socket, process.pid
        self._stream = WorkerStream()
        self._ready.clear()
        self._closed.clear()
        self._pulse = Pulse(process.pid)
        loop.add_reader(process.socket, self._read)
        try:
            async with asyncio.timeout(self._config.limits.worker_ready) as limit:
                closed = asyncio.ensure_future(self._closed.wait())
                ready = asyncio.ensure_future(self._ready.wait())
                try:
                    await asyncio.wait((closed, ready), return_when=asyncio.FIRST_COMPLETED)
                    limit.reschedule(None)
                    await self._wedged(closed)
                finally:
                    closed.cancel()
                    ready.cancel()
        except TimeoutError:
            return
        finally:
            loop.remove_reader(process.socket)
            loop.remove_writer(process.socket)

    async def _wedged(self, closed: asyncio.Future[Any]) -> None:
        """Until the worker has closed its socket or gives no sign of life any more."""
        while not closed.done():
            self._send(ping_request(self._next()), ())
            await asyncio.wait((closed,), timeout=BEAT)
            if not closed.done() and self._pulse.beat():
                _log.warning("the worker does not answer any more; another takes its place")
                return

    def _prepare(self) -> None:
        """Warm up the worker that takes over when this one dies."""
        if self._spare is None and self.state == "ready" and self._socket is not None and not self._over:
            self._spare = self._try_launch()
            if self._spare is not None:
                self._prepared.set()

    async def spare_warm(self) -> None:
        """Until another one is ready to take over, for tests and tables."""
        await self._prepared.wait()
        assert self._spare is not None
        warm = asyncio.Event()
        loop = asyncio.get_running_loop()
        loop.add_reader(self._spare.socket, warm.set)
        await warm.wait()
        loop.remove_reader(self._spare.socket)

    def _take_spare(self) -> WorkerProcess | None:
        spare, self._spare = self._spare, None
        self._prepared.clear()
        return spare

    def _try_launch(self) -> WorkerProcess | None:
        try:
            return launch(self._config)
        except (WorkerMissing, OSError) as error:
            _log.warning("the worker cannot be started: %s", error)
            return None

    def _say(self, state: State) -> None:
        if state != self.state:
            self.state = state
            self._tell(state)

    def _lose(self) -> None:
        """Everything under way has lost its worker."""
        self._socket = self.pid = None
        self._ready.clear()
        for _, descriptors in self._outgoing:
            _close(descriptors)
        self._outgoing.clear()
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
        self._send(request(ident), ())
        try:
            async with asyncio.timeout(self._config.limits.compile):
                return await answer
        except (TimeoutError, asyncio.CancelledError):
            self._questions.pop(ident, None)
            self._send(kill_request(ident), ())
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
            self._send(kill_request(program.id), ())

    def _next(self) -> int:
        self._ids += 1
        return self._ids

    # Bytes

    def _send(self, data: bytes, descriptors: tuple[int, ...]) -> None:
        if self._socket is None:
            _close(descriptors)
            return
        self._outgoing.append((data, descriptors))
        self._write()

    def _write(self) -> None:
        sock = self._socket
        if sock is None:
            return
        loop = asyncio.get_running_loop()
        while self._outgoing:
            data, descriptors = self._outgoing[0]
            try:
                sent = socket.send_fds(sock, [data], descriptors)
            except (BlockingIOError, InterruptedError):
                loop.add_writer(sock, self._write)
                return
            except OSError:
                self._closed.set()
                return
            _close(descriptors)
            if sent < len(data):
                self._outgoing[0] = (data[sent:], ())
            else:
                self._outgoing.popleft()
        loop.remove_writer(sock)

    def _read(self) -> None:
        sock = self._socket
        assert sock is not None
        try:
            data = sock.recv(65536)
            if not data:
                self._stop_reading(sock)
                return
            self._pulse.heard()
            for answer in self._stream.feed(data):
                self._take(answer)
        except (BlockingIOError, InterruptedError):
            return
        except (OSError, LineTooLong, msgspec.DecodeError):
            self._stop_reading(sock)

    def _stop_reading(self, sock: socket.socket) -> None:
        asyncio.get_running_loop().remove_reader(sock)
        self._closed.set()

    def _take(self, answer: Answer) -> None:
        match answer:
            case WorkerReady():
                self._ready.set()
                self._say("ready")
                asyncio.get_running_loop().call_later(_SPARE_DELAY, self._prepare)
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


def _close(descriptors: tuple[int, ...]) -> None:
    for descriptor in descriptors:
        os.close(descriptor)


def _wake(waiting: asyncio.Future[None]) -> None:
    if not waiting.done():
        waiting.set_result(None)


async def _reap(pid: int) -> None:
    """Wait for a killed child without stopping the loop."""
    loop = asyncio.get_running_loop()
    try:
        watch = os.pidfd_open(pid)
    except ProcessLookupError:
        return
    try:
        dead: asyncio.Future[None] = loop.create_future()
        loop.add_reader(watch, _wake, dead)
        try:
            await asyncio.shield(dead)
        finally:
            loop.remove_reader(watch)
            # It has been killed, so this returns at once even when the wait was cancelled.
            os.waitpid(pid, 0)  # noqa: ASYNC222
    finally:
        os.close(watch)
