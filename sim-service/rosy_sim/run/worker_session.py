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

from ..accounting.client import SERVICE, Client
from ..accounting.fair_queue import Lease
from ..accounting.resources import Budgets
from ..config import Limits
from ..errors import RosyError
from ..wire.problem import Problem
from ..wire.worker import Gone, Refused, Started
from ..worker.prepared_runs import PreparedRun
from ..worker.supervisor import RunningProgram, WorkerSupervisor
from .frame_rate import FrameRate
from .lateness import Lateness
from .observed_runs import MOST_OBSERVED, ObservedRuns
from .problems import died, stuck, worker_lost, worker_problem
from .step_phases import StepPhases

__all__ = ["CompilationListener", "RunServices", "Silence", "WorkerSession"]

Silence = Literal["stuck", "died"]
"""A program that lives and does not answer, and one whose process is gone; the worker knows more about both."""


_Begun = tuple[socket.socket, Started | Refused | Gone]
"""Our end of the robot link, and the answer of the worker."""


@dataclass(frozen=True, slots=True)
class RunServices:
    """What all runs of a service share, and the client whose runs they are."""

    worker: WorkerSupervisor
    budgets: Budgets
    limits: Limits
    lateness: Lateness
    frame_rate: FrameRate
    client: Client = SERVICE
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
        on_preempt: called when the place of the program is needed for another client; without it the program keeps it.
    """

    def __init__(
        self,
        source: str,
        services: RunServices,
        listener: CompilationListener,
        prepared: PreparedRun | None = None,
        on_preempt: Callable[[], None] | None = None,
    ) -> None:
        self._worker = services.worker
        self._places = services.budgets.runs
        self._compiling = services.budgets.compiling
        self._client = services.client
        self._on_preempt = on_preempt
        self._limits = services.limits
        self._listener = listener
        # The place of this run among those that run at once.
        self._place: Lease | None = None
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
        if self._place is not None or (self._program is not None and self._program.gone.done()):
            on_taken()
        elif self._return is None:
            self._return = asyncio.get_running_loop().create_task(self._wait_to_return(on_taken))

    async def _wait_to_return(self, on_taken: Callable[[], None]) -> None:
        place = await self._places.acquire(self._client, self._listener.on_queued, self._on_preempt)
        self._return = None
        self._place = place
        if self._program is None or self._program.gone.done():
            self._free_slot()
        on_taken()

    def _free_slot(self) -> None:
        place, self._place = self._place, None
        if place is not None:
            place.release()

    def _on_gone(self) -> None:
        """The program has ended, also when it ended with its worker."""
        if self._return is not None:
            self._return.cancel()
            self._return = None
        self._free_slot()

    def touch(self) -> None:
        """The program has done something."""
        if self._place is not None:
            self._place.touch()

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

        self._place = await self._places.acquire(self._client, on_position, self._on_preempt)
        if waited:
            self._listener.on_turn()

    async def _compile(self, source: str) -> None:
        prepared = self._take_prepared()
        try:
            await self._wait_for_turn()
        except asyncio.CancelledError:
            self._discard(prepared)
            raise
        try:
            ours, answer = await (self._begin(prepared, source) if prepared is not None else self._start(source))
        except (RosyError, TimeoutError) as error:
            self._compilation = None
            self._listener.on_failed("error", [worker_problem(error)])
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

    async def _begin(self, prepared: PreparedRun, source: str) -> _Begun:
        """Let the prepared program run."""
        try:
            async with self._deadline():
                self._adopt(prepared.program)
                self._worker.begin(prepared.program, source)
                return prepared.link, await asyncio.shield(prepared.program.started)
        except BaseException:
            self._abort(prepared.link)
            raise

    async def _start(self, source: str) -> _Begun:
        """Compile the program and let it run; begin again when its place among the compilations was needed."""
        try:
            while True:
                async with self._deadline():
                    # A client is not charged for a worker that starts.
                    await self._worker.wait_ready()
                begun = await self._try_to_start(source)
                if begun is not None:
                    return begun
        except BaseException:
            if self._program is None:
                self._free_slot()
            raise

    async def _try_to_start(self, source: str) -> _Begun | None:
        """``None``: its place was needed."""
        preempted = asyncio.get_running_loop().create_future()
        place = await self._compiling.acquire(
            self._client, on_preempt=lambda: None if preempted.done() else preempted.set_result(None)
        )
        ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_STREAM)
        program: RunningProgram | None = None
        try:
            async with self._deadline():
                program = await self._worker.start(source, theirs)
                await asyncio.wait((program.started, preempted), return_when=asyncio.FIRST_COMPLETED)
            if not program.started.done():
                ours.close()
                self._worker.kill(program)
                return None
            self._adopt(program)
            return ours, program.started.result()
        except BaseException:
            if program is not None and self._program is None:
                self._adopt(program)
            self._abort(ours)
            raise
        finally:
            place.release()

    def _deadline(self) -> asyncio.Timeout:
        return asyncio.timeout(self._limits.worker_ready + self._limits.compile)

    def _adopt(self, program: RunningProgram) -> None:
        """This is the program of the session: its place is free when it is gone."""
        self._program = program
        program.gone.add_done_callback(lambda _: self._on_gone())

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
