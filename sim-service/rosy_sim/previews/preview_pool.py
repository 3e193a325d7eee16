"""
Pool of preview processes: as many may be busy with previews as the queue has places.

A process is started when a preview needs one, or is likely to be asked for soon, and ended when it has been idle for a
while. Runs of pages have a worker of their own, so previews take only what they leave of the machine.
"""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import msgspec

from ..accounting.client import Client
from ..accounting.fair_queue import FairQueue, Lease
from ..config import Config
from ..errors import RosyError, WorkerLost, WorkerMissing
from ..sentences.sentence import tr
from ..wire.page import Previewed
from ..worker.background_process import WorkerSetup, reap, start_process
from .computing_budget import PATIENCE
from .preview import PreviewTask

__all__ = ["PreviewPool"]

_IDLE = 120.0
"""A process that has computed nothing for so long is ended, s."""

_MARGIN = 10.0
"""Beyond the limits of the process itself, after which it is ended, s."""


class _Process:
    """A preview process that is warm."""

    def __init__(self, process: asyncio.subprocess.Process, longest: float) -> None:
        self._process = process
        self._longest = longest
        # Ends it when it stays idle.
        self.idle: asyncio.TimerHandle | None = None

    async def ask(self, task: PreviewTask, is_shortened: bool = False) -> Previewed:
        """
        The result of a task; of a shortened one the first piece.

        Raises:
            WorkerLost: the process died or did not answer in time.
        """
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        try:
            async with asyncio.timeout(self._longest):
                self._process.stdin.write(msgspec.json.encode(task) + (b"\n\n" if is_shortened else b"\n"))
                await self._process.stdin.drain()
                line = await self._process.stdout.readline()
        except (TimeoutError, OSError, ValueError) as error:
            raise WorkerLost(str(error)) from error
        if not line:
            raise WorkerLost(tr("a preview process ended"))
        return msgspec.json.decode(line, type=Previewed)

    def cancel(self) -> None:
        """Let the task at work answer at once."""
        assert self._process.stdin is not None
        self._process.stdin.write(b"\n")

    async def end(self) -> None:
        """End it with its worker."""
        if self.idle is not None:
            self.idle.cancel()
        with contextlib.suppress(ProcessLookupError):
            self._process.kill()
        await reap(self._process)


@dataclass(slots=True)
class _Job:
    task: PreviewTask
    on_cost: Callable[[float], None]
    # The process that is busy with it.
    process: _Process | None = None
    is_cancelled: bool = False
    is_shortened: bool = False

    def cancel(self) -> None:
        self.is_cancelled = True
        self.shorten()

    def shorten(self) -> None:
        """End it early, with the path so far; also when its process is not ready yet."""
        self.is_shortened = True
        if self.process is not None:
            self.process.cancel()


class PreviewPool:
    """One preview per call of ``run``; one that takes long ends early for a client that waits."""

    def __init__(self, config: Config, queue: FairQueue) -> None:
        self._config = config
        self._queue = queue
        self._idle: list[_Process] = []
        self._all: set[_Process] = set()
        # Computations and endings that are not finished.
        self._tasks: set[asyncio.Task[Any]] = set()
        self._closed = False
        # Starts a process for a preview that is to come.
        self._preparation: asyncio.Task[None] | None = None

    @property
    def processes(self) -> int:
        """How many there are, for tests."""
        return len(self._all)

    def prepare(self) -> None:
        """Start a process if there is none, for a preview that is to come. A failure costs only time."""
        if self._preparation is None and not self._all and not self._closed and self._config.worker:
            work = self._preparation = asyncio.get_running_loop().create_task(self._prepare())
            self._tasks.add(work)
            work.add_done_callback(self._tasks.discard)

    async def run(self, task: PreviewTask, client: Client, on_cost: Callable[[float], None]) -> Previewed:
        """
        Compute a preview. Cancelling it ends the computation; a process that is being started is kept for the next.

        Args:
            on_cost: called once when a process was busy with it, with the time that took, s.

        Raises:
            RosyError: the process died or could not be started.
        """
        job = _Job(task, on_cost)
        place = await self._queue.acquire(client, on_preempt=job.shorten)
        work = asyncio.get_running_loop().create_task(self._compute(job, place))
        self._tasks.add(work)
        work.add_done_callback(self._tasks.discard)
        # The exception is retrieved even when the preview has been cancelled.
        work.add_done_callback(lambda done: done.cancelled() or done.exception())
        try:
            answer = await asyncio.shield(work)
        except asyncio.CancelledError:
            job.cancel()
            raise
        if answer is None:
            raise WorkerLost(tr("the preview was cancelled"))
        return answer

    async def close(self) -> None:
        """End all processes; no other is started."""
        self._closed = True
        for process in list(self._all):
            self._end(process)
        await asyncio.gather(*self._tasks, return_exceptions=True)

    async def _compute(self, job: _Job, place: Lease) -> Previewed | None:
        """The answer to a job; None when it was cancelled before a process was ready for it."""
        try:
            if not self._idle and self._preparation is not None:
                await asyncio.wait((self._preparation,))
            process = self._idle.pop() if self._idle else await self._start()
            if process.idle is not None:
                process.idle.cancel()
            if job.is_cancelled:
                self._keep(process)
                return None
            job.process = process
            began = asyncio.get_running_loop().time()
            try:
                answer = await process.ask(job.task, job.is_shortened)
            except RosyError:
                self._end(process)
                raise
            finally:
                job.on_cost(asyncio.get_running_loop().time() - began)
            self._keep(process)
            return answer
        finally:
            place.release()

    async def _prepare(self) -> None:
        try:
            if not self._all:
                self._keep(await self._start())
        except (RosyError, OSError):
            # It is told to the page that asks for a preview.
            pass
        finally:
            self._preparation = None

    def _keep(self, process: _Process) -> None:
        self._idle.append(process)
        process.idle = asyncio.get_running_loop().call_later(_IDLE, self._end, process)

    def _end(self, process: _Process) -> None:
        if process in self._idle:
            self._idle.remove(process)
        self._all.discard(process)
        ending = asyncio.get_running_loop().create_task(process.end())
        self._tasks.add(ending)
        ending.add_done_callback(self._tasks.discard)

    async def _start(self) -> _Process:
        config = self._config
        if self._closed or not config.worker:
            raise WorkerMissing
        limits = config.limits
        started = await start_process("rosy_sim.previews")
        longest = limits.compile + limits.ready + PATIENCE * limits.preview + limits.settle + limits.gone + _MARGIN
        process = _Process(started, longest)
        self._all.add(process)
        assert started.stdin is not None
        assert started.stdout is not None
        try:
            started.stdin.write(msgspec.json.encode(WorkerSetup.of(config)) + b"\n")
            async with asyncio.timeout(limits.worker_ready + _MARGIN):
                if not await started.stdout.readline():
                    raise WorkerLost(tr("a preview process ended before it was ready"))
        except (OSError, TimeoutError) as error:
            self._end(process)
            raise WorkerLost(str(error)) from error
        except RosyError:
            self._end(process)
            raise
        return process
