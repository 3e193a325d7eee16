"""
Fork server: a warm worker process that answers no questions itself and forks the workers that do.

A forked worker shares the compiler's session in memory with the fork server and is ready some milliseconds after it was
requested, so the fork server also replaces a worker that has died. What it does not do: decide when (``supervisor``).
"""

from __future__ import annotations

import asyncio
import os
import socket
from pathlib import Path

from ..config import Config
from ..errors import WorkerMissing
from ..sentences.sentence import Sentence, sentence_of
from ..text_lines import text_lines
from ..wire.worker import Answer, Failed, Forked, fork_request
from .connection import Connection
from .launcher import ForkedWorker, launch
from .liveness import sandboxed_pid

__all__ = ["ForkServer"]


class ForkServer:
    """At most one process, started when a worker is requested. Call close() in any case."""

    def __init__(self, config: Config) -> None:
        self._config = config
        self._server: Connection | None = None
        # Why the latest process could not start; None when it has become warm.
        self.fault: Sentence | None = None
        # The process inside of its sandbox, once that has been looked up.
        self._inner_pid: int | None = None
        self._ids = 0

    @property
    def pid(self) -> int | None:
        """Its process, warm or not; the outermost one of its sandbox."""
        return self._server.pid if self._server is not None else None

    async def fork(self) -> Connection | None:
        """
        A new worker, which the caller owns, or ``None`` when there can be none now.

        Waits for the fork server where that has to be started first. One that has ended, is wedged, or does not become
        warm in time is ended; the next call starts another.
        """
        if self._server is None or self._server.lost.is_set():
            await self.close()
            self._server = self._launch()
        server = self._server
        if server is None:
            return None
        ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_STREAM)
        forked = self._request(server, theirs)
        lost = asyncio.ensure_future(server.wait_until_lost())
        worker: Connection | None = None
        try:
            await asyncio.wait((forked, lost), return_when=asyncio.FIRST_COMPLETED)
            process = _forked_process(self._sandboxed(server), forked.result(), ours) if forked.done() else None
            if process is not None:
                worker = Connection(process, self._config.limits.worker_ready)
        finally:
            lost.cancel()
            server.listener = None
            if worker is None:
                ours.close()
        self.fault = None if server.ready.is_set() else server.start_fault()
        if worker is None:
            await self.close()
        return worker

    async def close(self) -> None:
        """End the fork server, and with it the workers that it has forked."""
        server, self._server, self._inner_pid = self._server, None, None
        if server is not None:
            await server.end()

    def _sandboxed(self, server: Connection) -> int:
        if self._inner_pid is None:
            self._inner_pid = sandboxed_pid(server.pid)
        return self._inner_pid

    def _launch(self) -> Connection | None:
        try:
            return Connection(launch(self._config), self._config.limits.worker_ready)
        except (WorkerMissing, OSError) as error:
            self.fault = sentence_of(error)
            return None

    def _request(self, server: Connection, theirs: socket.socket) -> asyncio.Future[int | None]:
        """Ask for a worker at the other end of this socket; its process id in the sandbox, or ``None`` when refused."""
        self._ids += 1
        ident = self._ids
        forked: asyncio.Future[int | None] = asyncio.get_running_loop().create_future()

        def hear(answer: Answer) -> None:
            if forked.done():
                return
            if isinstance(answer, Forked) and answer.id == ident:
                forked.set_result(answer.pid)
            elif isinstance(answer, Failed) and answer.id in (None, ident):
                forked.set_result(None)

        server.listener = hear
        # The request waits in the socket until the session is warm.
        server.send(fork_request(ident), (theirs.detach(),))
        return forked


def _forked_process(server: int, forked: int | None, ours: socket.socket) -> ForkedWorker | None:
    """The child of a process with this id in its own namespace; ``None`` when it has ended already."""
    if forked is None:
        return None
    for child in _children(server):
        try:
            handle = os.pidfd_open(child)
        except ProcessLookupError:
            continue
        # The handle is of this process, if the process is still there now.
        if _innermost_pid(child) == forked:
            return ForkedWorker(child, handle, ours)
        os.close(handle)
    return None


def _children(pid: int) -> list[int]:
    """The children of a process with one thread, without a look at all processes. proc(5), ``children``."""
    try:
        return [int(child) for child in Path(f"/proc/{pid}/task/{pid}/children").read_text().split()]
    except OSError:
        return []


def _innermost_pid(pid: int) -> int | None:
    """The id of a process in its own namespace. proc(5), ``NSpid``."""
    try:
        status = Path(f"/proc/{pid}/status").read_text()
    except OSError:
        return None
    for line in text_lines(status):
        if line.startswith("NSpid:"):
            return int(line.split()[-1])
    return None
