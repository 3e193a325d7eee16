"""
Worker session of one program: from its text through the run queue and the compilation to the end of its process.

Independent of what the program drives: the listener gets the other end of the program's robot link.
"""

from __future__ import annotations

import asyncio
import socket
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Literal, Protocol

from ..config import Limits
from ..errors import RosyError
from ..wire.problem import Problem
from ..wire.worker import Gone, Refused, Started
from ..worker.prepared_runs import PreparedRun
from ..worker.question_scheduler import QuestionScheduler
from ..worker.supervisor import RunningProgram, WorkerSupervisor
from .frame_rate import FrameRate
from .lateness import Lateness
from .observed_runs import MOST_OBSERVED, ObservedRuns
from .problems import died, stuck, worker_lost
from .run_queue import RunQueue
from .step_phases import StepPhases

__all__ = ["CompilationListener", "RunServices", "Silence", "WorkerSession"]

Silence = Literal["stuck", "died"]
"""A program that lives and does not answer, and one whose process is gone; the worker knows more about both."""


@dataclass(frozen=True, slots=True)
class RunServices:
    """What all runs of a service share."""

    worker: WorkerSupervisor
    queue: RunQueue
    limits: Limits
    lateness: Lateness
    frame_rate: FrameRate
    scheduler: QuestionScheduler
    phases: StepPhases = field(default_factory=StepPhases)
    observed: ObservedRuns = field(default_factory=lambda: ObservedRuns(MOST_OBSERVED))


class CompilationListener(Protocol):
    """Receives the progress of a compilation on the event loop; exactly one of the last two is called."""

    def on_queued(self, place: int) -> None:
        """The run queue is full; the position in it, 1 for the next."""

    def on_turn(self) -> None:
        """The wait in the queue is over."""

    def on_started(self, link: socket.socket, started: Started) -> None:
        """The program runs. The listener owns the socket from now on. The problems are warnings."""

    def on_failed(self, ended: Literal["refused", "error"], problems: list[Problem]) -> None:
        """The program does not compile, or the worker is lost."""


class WorkerSession:
    """
    Starts at once. cancel() ends it while it compiles, kill() afterwards; a cancelled one calls nothing more.

    Args:
        prepared: what is compiled of this text already. It is the session's, and ends with it.
    """

    def __init__(
        self,
        source: str,
        services: RunServices,
        listener: CompilationListener,
        prepared: PreparedRun | None = None,
    ) -> None:
        self._worker = services.worker
        self._queue = services.queue
        self._limits = services.limits
        self._listener = listener
        # Whether this run has a place among those that run at once.
        self._has_slot = False
        # Waits for a place after yield_slot().
        self._return: asyncio.Task[None] | None = None
        # Set when the worker has accepted the text.
        self._program: RunningProgram | None = None
        # Until the compilation begins: a task that is cancelled before its first step never runs.
        self._prepared = prepared
        # None when the compilation is over.
        self._compilation: asyncio.Task[None] | None = asyncio.get_running_loop().create_task(self._compile(source))

    @property
    def is_compiling(self) -> bool:
        """Whether the program has neither started nor failed yet."""
        return self._compilation is not None

    def cancel(self) -> None:
        """Abandon the compilation."""
        if self._compilation is not None:
            self._compilation.cancel()
            self._compilation = None
            self._discard(self._take_prepared())

    def _take_prepared(self) -> PreparedRun | None:
        prepared, self._prepared = self._prepared, None
        return prepared

    def _discard(self, prepared: PreparedRun | None) -> None:
        if prepared is not None:
            prepared.link.close()
            self._worker.kill(prepared.program)

    def yield_slot(self) -> None:
        """Let another run have the place of this one, which stands still until the end of take_slot()."""
        if self._return is not None:
            self._return.cancel()
            self._return = None
        if not self.is_compiling:
            self._free_slot()

    def take_slot(self, on_taken: Callable[[], None]) -> None:
        """Call on_taken when there is a place again: at once, or after a wait of which the listener is told."""
        if self._has_slot or (self._program is not None and self._program.gone.done()):
            on_taken()
        elif self._return is None:
            self._return = asyncio.get_running_loop().create_task(self._wait_to_return(on_taken))

    async def _wait_to_return(self, on_taken: Callable[[], None]) -> None:
        await self._queue.acquire(self._listener.on_queued)
        self._return = None
        self._has_slot = True
        if self._program is None or self._program.gone.done():
            self._free_slot()
        on_taken()

    def _free_slot(self) -> None:
        if self._has_slot:
            self._has_slot = False
            self._queue.release()

    def _on_gone(self) -> None:
        """The program has ended, also when it ended with its worker."""
        if self._return is not None:
            self._return.cancel()
            self._return = None
        self._free_slot()

    def kill(self) -> None:
        """End the program at once if it still runs."""
        if self._program is not None:
            self._worker.kill(self._program)

    async def _wait_for_turn(self) -> None:
        waited = False

        def on_position(place: int) -> None:
            nonlocal waited
            waited = True
            self._listener.on_queued(place)

        await self._queue.acquire(on_position)
        self._has_slot = True
        if waited:
            self._listener.on_turn()

    async def _compile(self, source: str) -> None:
        prepared = self._take_prepared()
        try:
            await self._wait_for_turn()
        except asyncio.CancelledError:
            self._discard(prepared)
            raise
        theirs: socket.socket | None = None
        if prepared is not None:
            ours = prepared.link
        else:
            ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_STREAM)
        answer: Started | Refused | Gone
        try:
            async with asyncio.timeout(self._limits.worker_ready + self._limits.compile):
                if theirs is not None:
                    self._program = await self._worker.start(source, theirs)
                else:
                    assert prepared is not None
                    self._program = prepared.program
                    self._worker.begin(prepared.program, source)
                self._program.gone.add_done_callback(lambda _: self._on_gone())
                answer = await asyncio.shield(self._program.started)
        except asyncio.CancelledError:
            self._abort(ours)
            raise
        except (RosyError, TimeoutError):
            self._abort(ours)
            self._compilation = None
            self._listener.on_failed("error", [worker_lost()])
            return
        self._compilation = None
        if isinstance(answer, Started):
            self._listener.on_started(ours, answer)
            return
        ours.close()
        if isinstance(answer, Refused):
            self._listener.on_failed("refused", answer.problems)
        else:
            self._listener.on_failed("error", [died(answer, 0.0)])

    def _abort(self, link: socket.socket) -> None:
        link.close()
        if self._program is None:
            self._free_slot()
        self.kill()

    async def diagnose(self, silence: Silence, time: float) -> Problem:
        """What a silent program was doing, as the worker reports it. One that is stuck is killed."""
        gone: Gone | None = None
        if self._program is not None:
            if silence == "stuck":
                self.kill()
            try:
                async with asyncio.timeout(self._limits.gone):
                    gone = await asyncio.shield(self._program.gone)
            except TimeoutError:
                self.kill()
            except RosyError:
                return worker_lost(time)
        if silence == "stuck":
            return stuck(gone.firing if gone is not None else None, self._limits.settle, time)
        return died(gone, time)
