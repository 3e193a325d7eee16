"""
Connection to one worker process, from its start to its end: requests, answers and liveness.

The owner sets the listener; ownership of a forked worker passes from the fork server to the supervisor.
"""

from __future__ import annotations

import asyncio
import logging
import os
import socket
from collections import deque
from collections.abc import Callable

import msgspec

from ..sentences.sentence import Sentence, tr
from ..sentences.wording import in_terminal
from ..wire.line_splitter import LineTooLong
from ..wire.worker import Answer, WorkerReady, WorkerStream, ping_request
from .launcher import ENDED, NOT_IN_TIME, ForkedWorker, WorkerProcess
from .liveness import PROBE_INTERVAL, LivenessMonitor

__all__ = ["Connection"]

_log = logging.getLogger(__name__)

_PING = 0
"""The id of pings; their answers only count as activity."""


class Connection:
    """Owns the socket and the process. Call end() in any case."""

    def __init__(self, process: WorkerProcess | ForkedWorker, ready_within: float) -> None:
        process.socket.setblocking(False)
        self.pid = process.pid
        # It is warm.
        self.ready = asyncio.Event()
        # It has closed its socket, or has broken the protocol.
        self.lost = asyncio.Event()
        # Called with each answer.
        self.listener: Callable[[Answer], None] | None = None
        self.liveness = LivenessMonitor(process.pid)
        self._process = process
        self._socket = process.socket
        self._stream = WorkerStream()
        self._outgoing: deque[tuple[bytes, tuple[int, ...]]] = deque()
        self._loop = asyncio.get_running_loop()
        self._ready_by = self._loop.time() + ready_within
        self._loop.add_reader(self._socket, self._read)

    async def wait_until_lost(self, interval: float = PROBE_INTERVAL) -> None:
        """Wait until it is lost, wedged, or not warm in time; probes every ``interval`` s."""
        lost = asyncio.ensure_future(self.lost.wait())
        ready = asyncio.ensure_future(self.ready.wait())
        try:
            while not (lost.done() or ready.done()):
                await asyncio.wait((lost, ready), timeout=PROBE_INTERVAL, return_when=asyncio.FIRST_COMPLETED)
                if not ready.done() and (self._loop.time() > self._ready_by or self.liveness.probe_stopped()):
                    return
            while not lost.done():
                self.send(ping_request(_PING))
                await asyncio.wait((lost,), timeout=interval)
                if not lost.done() and self.liveness.probe():
                    _log.warning("%s", in_terminal(tr("the worker does not answer any more; another takes its place")))
                    return
        finally:
            lost.cancel()
            ready.cancel()

    def start_fault(self) -> Sentence | None:
        """Why a worker of its own process is not warm; ``None`` for a forked one, or when it is not known."""
        if not isinstance(self._process, WorkerProcess):
            return None
        return self._process.errors.cause(ENDED if self.lost.is_set() else NOT_IN_TIME)

    async def wait_ready(self) -> bool:
        """Wait until it is warm or lost; returns whether it is warm."""
        waits = [asyncio.ensure_future(event.wait()) for event in (self.ready, self.lost)]
        try:
            await asyncio.wait(waits, return_when=asyncio.FIRST_COMPLETED)
        finally:
            for wait in waits:
                wait.cancel()
        return self.ready.is_set() and not self.lost.is_set()

    async def end(self) -> None:
        """End the process and everything in its sandbox."""
        self._loop.remove_reader(self._socket)
        self._loop.remove_writer(self._socket)
        for _, descriptors in self._outgoing:
            _close(descriptors)
        self._outgoing.clear()
        self.lost.set()
        self._process.kill()
        self._socket.close()
        await self._process.reap()

    # Bytes

    def send(self, data: bytes, descriptors: tuple[int, ...] = ()) -> None:
        """Send a request; the descriptors are sent with it and closed here."""
        if self.lost.is_set():
            _close(descriptors)
            return
        self._outgoing.append((data, descriptors))
        self._write()

    def _write(self) -> None:
        while self._outgoing:
            data, descriptors = self._outgoing[0]
            try:
                sent = socket.send_fds(self._socket, [data], descriptors)
            except (BlockingIOError, InterruptedError):
                self._loop.add_writer(self._socket, self._write)
                return
            except OSError:
                self.lost.set()
                break
            _close(descriptors)
            if sent < len(data):
                self._outgoing[0] = (data[sent:], ())
            else:
                self._outgoing.popleft()
        self._loop.remove_writer(self._socket)

    def _read(self) -> None:
        try:
            data = self._socket.recv(65536)
            if not data:
                self._stop_reading()
                return
            self.liveness.record_activity()
            for answer in self._stream.feed(data):
                if isinstance(answer, WorkerReady):
                    self.ready.set()
                if self.listener is not None:
                    self.listener(answer)
        except (BlockingIOError, InterruptedError):
            return
        except (OSError, LineTooLong, msgspec.DecodeError):
            self._stop_reading()

    def _stop_reading(self) -> None:
        self._loop.remove_reader(self._socket)
        self.lost.set()


def _close(descriptors: tuple[int, ...]) -> None:
    for descriptor in descriptors:
        os.close(descriptor)
