"""
Blocking client of a worker, for the command line: one request at a time, without asyncio.

``./rosy run`` steps a program hundreds of times real time; a blocking socket costs a third of what an event
loop does.
"""

from __future__ import annotations

import os
import select
import socket
import threading
import time
from collections.abc import Callable
from types import TracebackType

import msgspec

from ..config import Config
from ..errors import WorkerFailed, WorkerLost, WorkerRefused
from ..sentences.sentence import tr
from ..wire.line_splitter import LineTooLong
from ..wire.worker import (
    Answer,
    Checked,
    Failed,
    Gone,
    Refused,
    Started,
    WorkerReady,
    WorkerStream,
    check_request,
    kill_request,
    run_request,
)
from .launcher import ENDED, NOT_IN_TIME, launch
from .mailbox import Mailbox

__all__ = ["BlockingWorker"]


class BlockingWorker:
    """A worker that lives as long as a ``with`` block."""

    def __init__(self, config: Config) -> None:
        self.limits = config.limits
        self._process = launch(config)
        self._socket = self._process.socket
        self._stream = WorkerStream()
        self._check_reachable: list[Answer] = []
        self._next = 0
        # What became of the latest run, once the worker has said it.
        self._gone: Gone | None = None
        # Held while a request is written: kill() may be called from any thread.
        self._writing = threading.Lock()

    def __enter__(self) -> BlockingWorker:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None
    ) -> None:
        self._process.kill()
        os.waitpid(self._process.pid, 0)
        self._process.leave_nothing()
        self._socket.close()

    def ready(self) -> WorkerReady:
        """
        Wait until the session is warm.

        Raises:
            WorkerFailed: it has ended, or is not warm in time.
        """
        deadline = time.monotonic() + self.limits.worker_ready
        try:
            answer = self._wait(self.limits.worker_ready, WorkerReady)
        except WorkerLost as error:
            ended = time.monotonic() < deadline
            raise WorkerFailed(self._process.errors.cause(ENDED if ended else NOT_IN_TIME)) from error
        assert isinstance(answer, WorkerReady)
        return answer

    def check(self, source: str) -> Checked:
        """Problems, declarations and graph of a program."""
        self._next += 1
        self._send(check_request(self._next, source), ())
        answer = self._wait(self.limits.compile, Checked)
        assert isinstance(answer, Checked)
        return answer

    def run(
        self,
        source: str,
        link: socket.socket,
        is_cancelled: Callable[[], bool] = lambda: False,
        mailbox: Mailbox | None = None,
        plain: bool = False,
    ) -> Started | Refused:
        """
        Start a program on a link, with a mailbox if there is one; our copy of its end of the link is closed. Of a
        ``plain`` run the answer has no warnings, no types that it uses, and no branches.

        Another thread that cancels it sees to it that ``is_cancelled`` before it calls ``kill``, which ends only a
        program that has been sent.
        """
        self._next += 1
        self._gone = None
        descriptors = (link.fileno(),) if mailbox is None else (link.fileno(), mailbox.descriptor)
        self._send(run_request(self._next, source, self.limits.memory, plain), descriptors)
        link.close()
        if is_cancelled():
            self.kill()
        answer = self._wait(self.limits.compile, Started, Refused, Gone)
        if isinstance(answer, Gone):
            self._gone = answer
            return Refused(answer.id, [answer.problem] if answer.problem else [])
        assert isinstance(answer, Started | Refused)
        return answer

    def kill(self) -> None:
        """End the run at once, also while it compiles; from any thread."""
        self._send(kill_request(self._next), ())

    def gone(self) -> Gone | None:
        """What became of the run, or ``None`` when the worker does not say in time."""
        if self._gone is None:
            try:
                answer = self._wait(self.limits.gone, Gone)
            except WorkerLost:
                return None
            assert isinstance(answer, Gone)
            self._gone = answer
        return self._gone

    def _send(self, data: bytes, descriptors: tuple[int, ...]) -> None:
        try:
            with self._writing:
                sent = socket.send_fds(self._socket, [data], descriptors)
                self._socket.sendall(data[sent:])
        except OSError as error:
            raise WorkerLost(str(error)) from error

    def _wait(self, limit: float, *kinds: type[Answer]) -> Answer:
        """The next answer of one of these kinds to the latest request; others are passed over."""
        deadline = time.monotonic() + limit
        while True:
            while self._check_reachable:
                answer = self._check_reachable.pop(0)
                if isinstance(answer, Failed) and answer.id in (None, self._next):
                    raise WorkerRefused(answer.message)
                if isinstance(answer, kinds) and (isinstance(answer, WorkerReady) or answer.id == self._next):
                    return answer
            left = deadline - time.monotonic()
            if left <= 0 or not select.select([self._socket], [], [], left)[0]:
                raise WorkerLost(tr("no answer within {limit} s", limit=limit))
            try:
                data = self._socket.recv(65536)
                if not data:
                    raise WorkerLost
                self._check_reachable += self._stream.feed(data)
            except (OSError, LineTooLong, msgspec.DecodeError) as error:
                raise WorkerLost(str(error)) from error
