"""
Headless run: a program and a world on one blocking thread, without a page, as fast as requested.

The program comes from a worker or from a native executable. Texts go to a callback at once, the trace to a file.
"""

from __future__ import annotations

import contextlib
import os
import socket
import subprocess
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from itertools import chain, repeat
from pathlib import Path
from typing import Literal, Protocol

from ..config import Limits
from ..explain.recorded_run import RecordedRun
from ..explain.recorded_step import ShownCommand
from ..wire.firing import read_firings
from ..wire.problem import Problem
from ..wire.robot_link import LimitExceeded, LinkError
from ..wire.worker import Gone, Refused
from ..worker.blocking_worker import BlockingWorker
from ..worker.mailbox import Mailbox, open_mailbox
from ..world.goals import GoalState
from ..world.time_step import STEP
from ..world.world import World
from .core_affinity import REVIEW_STEPS, CoreAffinity
from .problems import broken_link, died, missing_parts, stuck, too_much_output, worker_lost
from .program_link import ProgramLink
from .steps.hands import HandAction, apply_hand
from .steps.lockstep import Lockstep, State
from .steps.velocity_guard import OFF, SafetySettings

__all__ = [
    "Ended",
    "Program",
    "RunOutput",
    "RunResult",
    "RunSettings",
    "TraceOutput",
    "run_native",
    "run_over_link",
    "run_program",
]

Ended = Literal["time", "done", "error", "stuck", "refused"]


class TraceOutput(Protocol):
    """
    Receives the lines of a trace: an ``AtomicFile`` or a ``BytesIO``. It must not raise ``OSError``, which stands for a
    lost link here.
    """

    def write(self, data: bytes, /) -> object:
        """Append bytes."""


@dataclass(frozen=True, slots=True)
class RunSettings:
    """``seconds`` are simulated; ``actions`` are hands, each with its time in s."""

    seconds: float
    seed: int
    # A factor of real time; None for as fast as possible.
    speed: float | None = None
    actions: tuple[tuple[float, HandAction], ...] = ()
    limits: Limits = field(default_factory=Limits)
    safety: SafetySettings = OFF
    # Whether steps in which nothing can fire are left out; False only for comparison.
    skips_quiet: bool = True
    # Whether the program and this thread are given their cores; False only for comparison.
    pins: bool = True
    # Whether both may busy-wait, each on a core of its own: for one run, for which a person waits.
    busy_waits: bool = False

    def open_mailbox(self) -> contextlib.AbstractContextManager[Mailbox | None]:
        """A mailbox for the program, if both may busy-wait."""
        return (open_mailbox() if self.busy_waits and self.is_pinned else None) or contextlib.nullcontext()

    @property
    def is_pinned(self) -> bool:
        """Whether both are given cores. A run that waits for the clock gains nothing from it."""
        return self.pins and self.speed is None


@dataclass(frozen=True, slots=True)
class RunOutput:
    """
    Where a run's texts and its trace go, with ``provenance`` in each line of it, and what records the firings.

    ``observe`` is called after each step; when it returns True, the run ends as if its time were over.
    """

    say: Callable[[str], None] = lambda _: None
    trace: TraceOutput | None = None
    observe: Callable[[Lockstep], bool | None] = lambda _: None
    provenance: bool = False
    record: RecordedRun | None = None


@dataclass(slots=True)
class RunResult:
    """How a run ended. ``steps`` counts the steps that settled; ``wall`` is in s, without the compilation."""

    ended: Ended
    problems: list[Problem] = field(default_factory=list)
    steps: int = 0
    wall: float = 0.0
    goals: list[GoalState] = field(default_factory=list)


class Program(Protocol):
    """A program that runs."""

    def kill(self) -> None:
        """End it at once."""

    def gone(self) -> Gone | None:
        """How it ended, as far as that is known."""


@dataclass(frozen=True, slots=True)
class _NativeProgram:
    process: subprocess.Popen[bytes] | None = None

    def kill(self) -> None:
        if self.process is not None:
            self.process.kill()

    def gone(self) -> Gone | None:
        return None


class _Stuck(Exception):
    """No answer within the limit."""


class _Died(Exception):
    """The link closed without `ended`."""


def run_program(
    worker: BlockingWorker, source: str, world: World, settings: RunSettings, output: RunOutput
) -> RunResult:
    """Compile a program and run it in a world."""
    ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_STREAM)
    with ours, settings.open_mailbox() as mailbox:
        answer = worker.run(source, theirs, mailbox=mailbox)
        if isinstance(answer, Refused):
            return RunResult("refused", answer.problems)
        missing = missing_parts(world, answer.uses)
        if missing:
            worker.kill()
            return RunResult("refused", missing)
        return run_over_link(ours, world, settings, output, worker, mailbox)


def run_native(binary: Path, world: World, settings: RunSettings, output: RunOutput) -> RunResult:
    """Run an executable that ``./rosy build`` made. It has no sandbox: its user could start it directly as well."""
    ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_STREAM)
    with ours, theirs, settings.open_mailbox() as mailbox:
        command = [str(binary.absolute()), "--link", str(theirs.fileno())]
        descriptors, variables = [theirs.fileno()], dict(os.environ)
        if mailbox is not None:
            descriptors.append(mailbox.descriptor)
            variables["ROSY_MAILBOX"] = str(mailbox.descriptor)
        with subprocess.Popen(command, pass_fds=descriptors, env=variables) as process:
            theirs.close()
            try:
                return run_over_link(ours, world, settings, output, _NativeProgram(process), mailbox)
            finally:
                process.kill()


def run_over_link(
    link: socket.socket,
    world: World,
    settings: RunSettings,
    output: RunOutput,
    program: Program | None = None,
    mailbox: Mailbox | None = None,
) -> RunResult:
    """Run a program that waits at the other end of a link, with its mailbox if it has one."""
    if program is None:
        program = _NativeProgram()
    traces = output.trace is not None or output.record is not None
    lockstep = Lockstep(world, settings.seed, traces, settings.safety, settings.skips_quiet)
    lockstep.observes = output.provenance or output.record is not None
    began = time.perf_counter()
    ended: Ended = "error"
    try:
        program_link = ProgramLink(link, mailbox)
        with CoreAffinity(program_link, settings.is_pinned) as core:
            ended, problems = _Steps(program_link, lockstep, settings, output, core).run()
    except _Stuck:
        program.kill()
        last = program.gone()
        ended, problems = "stuck", [stuck(last.firing if last else None, settings.limits.settle, lockstep.time)]
    except _Died:
        problems = [died(program.gone(), lockstep.time)]
    except LinkError as error:
        program.kill()
        explain = too_much_output if isinstance(error, LimitExceeded) else broken_link
        problems = [explain(str(error), lockstep.time)]
    except OSError:
        problems = [worker_lost(lockstep.time)]
    lockstep.goals.finish(lockstep.time)
    return RunResult(ended, problems, lockstep.step, time.perf_counter() - began, lockstep.goals.states)


class _Steps:
    """The steps of one run, over a blocking socket."""

    def __init__(
        self,
        link: ProgramLink,
        lockstep: Lockstep,
        settings: RunSettings,
        output: RunOutput,
        core: CoreAffinity,
    ) -> None:
        self._link = link
        self._core = core
        self._lockstep = lockstep
        self._settings = settings
        self._limits = settings.limits
        self._output = output
        # Actions that are not due yet.
        self._actions = list(settings.actions)

    def run(self) -> tuple[Ended, list[Problem]]:
        """All steps until the program or the time has ended."""
        lockstep = self._lockstep
        last = round(self._settings.seconds / STEP)
        self._link.limit_waiting(self._limits.ready)
        self._send(self._link.send, lockstep.begin())
        self._read_while("opening", self._limits.ready)
        if not lockstep.uses_mailbox:
            self._link.has_mailbox = False
        self._core.begin()
        if lockstep.state == "ended":
            # A program without `simulate` may have printed.
            self._say()
        self._link.limit_waiting(self._limits.settle)
        began = time.perf_counter()
        while lockstep.state != "ended":
            if lockstep.step >= last:
                self._stop()
                return "time", []
            self._wait_for_clock(began)
            if lockstep.step % REVIEW_STEPS == 0:
                self._core.review()
            if self._step():
                self._stop()
                return "time", []
        ended = lockstep.ended
        assert ended is not None
        if ended.how == "error":
            return "error", [ended.problem] if ended.problem is not None else [died(None, lockstep.time)]
        return "done", []

    def _wait_for_clock(self, began: float) -> None:
        if self._settings.speed is not None:
            ahead = self._lockstep.time / self._settings.speed - (time.perf_counter() - began)
            if ahead > 0:
                time.sleep(ahead)

    def _step(self) -> bool:
        """One step; returns whether the observer ends the run."""
        lockstep = self._lockstep
        if self._actions:
            self._apply_hands(self._actions)
        batch = lockstep.sense()
        if batch:
            self._send(self._link.send_batch, batch)
            self._read_while("thinking", self._limits.settle)
            if lockstep.commands:
                self._say()
        output = self._output
        if output.trace is not None:
            output.trace.write(lockstep.trace_line(output.provenance))
        if output.record is not None:
            self._record(output.record)
        if lockstep.state == "settled":
            lockstep.integrate()
        return output.observe(lockstep) is True and lockstep.state != "ended"

    def _record(self, record: RecordedRun) -> None:
        lockstep = self._lockstep
        done = lockstep.settled or lockstep.ended
        if done is not None:
            # A command that was not sent to the robot has no channel.
            channels = chain(lockstep.channels(), repeat(""))
            commands = [ShownCommand(*one) for one in zip(channels, done.commands, strict=False)]
            record.add_step(
                lockstep.time,
                read_firings(done.firings),
                done.events,
                commands,
                is_overridden=lockstep.is_overridden,
            )

    def _apply_hands(self, actions: list[tuple[float, HandAction]]) -> None:
        while actions and actions[0][0] <= self._lockstep.time + 1e-9:
            apply_hand(self._lockstep, actions.pop(0)[1])

    def _say(self) -> None:
        for text in self._lockstep.said():
            self._output.say(text)

    @staticmethod
    def _send(send: Callable[[bytes], None], data: bytes) -> None:
        """
        Send to a program that may have ended already, as one without `simulate` does at once. What it said before is
        still to be read.
        """
        # `contextlib.suppress` takes as long as the rest of this function, which is called in each step.
        try:  # noqa: SIM105
            send(data)
        except BrokenPipeError:
            pass

    def _read_while(self, state: State, limit: float) -> None:
        """Read until the lockstep leaves a state. The deadline covers all reads, so single bytes do not extend it."""
        deadline = time.monotonic() + limit
        while True:
            try:
                data = self._link.receive()
            except BlockingIOError as error:
                raise _Stuck from error
            if not data:
                raise _Died
            if self._lockstep.feed(data) != state:
                return
            if time.monotonic() > deadline:
                raise _Stuck

    def _stop(self) -> None:
        """Ask the program to end; the worker kills one that does not."""
        try:
            self._link.send_batch(self._lockstep.stop())
            deadline = time.monotonic() + self._limits.stop
            while self._lockstep.state != "ended":
                left = deadline - time.monotonic()
                if left <= 0 or not self._link.has_bytes(left):
                    return
                data = self._link.read()
                if not data:
                    return
                self._lockstep.feed(data)
        except (OSError, LinkError):
            # The time is over in any case, and the worker ends the program with its sandbox.
            return
