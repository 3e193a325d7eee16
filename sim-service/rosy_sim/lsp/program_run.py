"""
Run of a program in the simulator for an editor: headless, as fast as possible, in the warm worker.

The steps run on a thread of their own (``run.headless_run``); what the program says and the simulated time come back to
the event loop.
"""

from __future__ import annotations

import asyncio
import math
import random
import socket
import threading
from collections.abc import Callable
from concurrent.futures import Future
from dataclasses import dataclass, field

from ..config import Limits
from ..errors import WorkerFailed, WorkerLost
from ..robots import robot_in
from ..run.headless_run import RunOutput, RunResult, RunSettings, run_over_link
from ..run.problems import worker_lost, worker_problem
from ..run.steps.lockstep import Lockstep
from ..sentences.sentence import Sentence, tr
from ..sentences.wording import Wording
from ..wire.problem import Problem, failure_context, worded
from ..wire.worker import Gone, Refused
from ..worker.supervisor import RunningProgram, WorkerSupervisor
from ..world.arena import Arena
from ..world.time_step import STEPS_PER_SECOND
from ..world.world import World

__all__ = ["ProgramRun", "Report", "RunChoice"]

MAX_LINES = 200
"""Lines of a program that are kept for the report."""


@dataclass(frozen=True, slots=True)
class RunChoice:
    """Where and how long to run: a room by name, and simulated seconds."""

    world: str
    arena: Arena
    seconds: float


@dataclass(slots=True)
class Report:
    """How a run went. ``distance`` is that of the robot's centre, m; ``said`` are its first lines."""

    ended: str
    world: str
    seed: int
    time: float = 0.0
    distance: float = 0.0
    x: float = 0.0
    y: float = 0.0
    said: list[str] = field(default_factory=list)
    problems: list[Problem] = field(default_factory=list)

    def text(self, language: Wording) -> str:
        """The report as a sentence or two."""
        if self.problems:
            first = worded(self.problems[0], language)
            parts = [first.message, first.hint]
            if self.time:
                parts.append(language.put(failure_context(self.time, None)))
        else:
            parts = [language.put(self._ending()), language.put(self._drive())]
            if self.said:
                parts.append(language.put(tr("It said: {text}", text=self.said[-1])))
        return " ".join(part for part in parts if part)

    def _ending(self) -> Sentence:
        match self.ended:
            case "done":
                return tr(
                    "The program was done after {time} s in the simulator ({room}).", time=self.time, room=self.world
                )
            case "stopped":
                return tr("You stopped it after {time} s in the simulator ({room}).", time=self.time, room=self.world)
            case _:
                return tr("It ran for {time} s in the simulator ({room}).", time=self.time, room=self.world)

    def _drive(self) -> Sentence:
        return tr(
            "The robot drove {distance} m, to x {x} m, y {y} m.",
            distance=f"{self.distance:.2f}",
            x=f"{self.x:.2f}",
            y=f"{self.y:.2f}",
        )


class ProgramRun:
    """
    One run; ``stop`` ends it at the next step.

    Args:
        on_progress: called with the simulated seconds, on the event loop.
        on_say: called with each line that the program says, on the event loop.
    """

    def __init__(
        self,
        worker: WorkerSupervisor,
        limits: Limits,
        on_progress: Callable[[float], None],
        on_say: Callable[[str], None],
    ) -> None:
        self._worker = worker
        self._limits = limits
        self._on_progress = on_progress
        self._on_say = on_say
        self._stopped = threading.Event()

    def stop(self) -> None:
        """End the run in good order."""
        self._stopped.set()

    async def run(self, source: str, choice: RunChoice) -> Report:
        """Compile and run a program."""
        seed = random.SystemRandom().randrange(2**31)
        report = Report("refused", choice.world, seed)
        ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_STREAM)
        with ours:
            try:
                program = await self._worker.start(source, theirs)
                answer = await asyncio.wait_for(program.started, self._limits.compile)
            except (WorkerFailed, WorkerLost) as error:
                report.ended, report.problems = "error", [worker_problem(error)]
                return report
            if isinstance(answer, Refused):
                report.problems = answer.problems
                return report
            if isinstance(answer, Gone):
                report.problems = [answer.problem] if answer.problem is not None else [worker_lost(0.0)]
                return report
            world = World(choice.arena, robot_in(choice.arena), seed)
            settings = RunSettings(choice.seconds, seed, None, (), self._limits)
            supervised = _SupervisedProgram(self._worker, program, self._limits.gone, asyncio.get_running_loop())
            try:
                result = await asyncio.to_thread(self._steps, ours, world, settings, supervised, report)
            except asyncio.CancelledError:
                self.stop()
                raise
            finally:
                self._worker.kill(program)
        return self._finished(report, result, world)

    def _steps(
        self, link: socket.socket, world: World, settings: RunSettings, program: _SupervisedProgram, report: Report
    ) -> RunResult:
        """On a thread."""
        loop = program.loop
        before = [world.x, world.y]

        def observe(lockstep: Lockstep) -> bool:
            report.distance += math.hypot(world.x - before[0], world.y - before[1])
            before[:] = [world.x, world.y]
            if lockstep.step % STEPS_PER_SECOND == 0:
                loop.call_soon_threadsafe(self._on_progress, lockstep.time)
            return self._stopped.is_set()

        def say(text: str) -> None:
            if len(report.said) < MAX_LINES:
                report.said.append(text)
                loop.call_soon_threadsafe(self._on_say, text)

        return run_over_link(link, world, settings, RunOutput(say, observe=observe), program)

    def _finished(self, report: Report, result: RunResult, world: World) -> Report:
        stopped = self._stopped.is_set() and result.ended == "time"
        report.ended = "stopped" if stopped else result.ended
        report.problems = result.problems
        report.time = result.steps / STEPS_PER_SECOND
        report.x, report.y = world.x, world.y
        return report


@dataclass(frozen=True, slots=True)
class _SupervisedProgram:
    """A program of the supervised worker, for the thread of its steps."""

    worker: WorkerSupervisor
    program: RunningProgram
    patience: float
    loop: asyncio.AbstractEventLoop

    def kill(self) -> None:
        """End it at once."""
        self.loop.call_soon_threadsafe(self.worker.kill, self.program)

    def gone(self) -> Gone | None:
        """What became of it, or ``None`` when the worker does not say in time."""
        answer: Future[Gone] = asyncio.run_coroutine_threadsafe(self._wait(), self.loop)
        try:
            return answer.result()
        except (TimeoutError, WorkerLost):
            return None

    async def _wait(self) -> Gone:
        return await asyncio.wait_for(asyncio.shield(self.program.gone), self.patience)
