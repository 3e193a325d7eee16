"""
A run without a page: program, world and worker on one blocking thread, as fast as asked. A native
program needs no worker.

Yields nothing but results: what was said goes to a callback at once, the trace to a file object.
"""

from __future__ import annotations

import select
import socket
import subprocess
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import BinaryIO, Literal

from .config import Limits
from .lockstep import Lockstep
from .sentences import broken_link, died, stuck, too_much, worker_lost
from .wire.link import LinkError, TooMuch
from .wire.problem import Problem
from .wire.worker import Gone, Refused
from .worker.blocking import BlockingWorker
from .world.events import Hand
from .world.facts import STEP
from .world.goals import GoalState
from .world.world import HandRefused, World

__all__ = ["Ended", "Order", "Outcome", "drive", "run_native", "run_program"]

Ended = Literal["time", "done", "error", "stuck", "refused"]


@dataclass(frozen=True, slots=True)
class Order:
    """What to run and how. ``speed`` is a factor of real time, or ``None`` for as fast as possible."""

    seconds: float
    seed: int
    speed: float | None = None
    hands: tuple[tuple[float, Hand], ...] = ()


@dataclass(slots=True)
class Outcome:
    """How it ended. ``steps`` counts the steps that settled; ``wall`` is in s, compilation not counted."""

    ended: Ended
    problems: list[Problem] = field(default_factory=list)
    steps: int = 0
    wall: float = 0.0
    goals: list[GoalState] = field(default_factory=list)


class _Stuck(Exception):
    """No answer within the limit."""


class _Died(Exception):
    """The link closed without `ended`."""


def run_program(
    worker: BlockingWorker,
    source: str,
    world: World,
    order: Order,
    limits: Limits,
    say: Callable[[str], None],
    trace: BinaryIO | None = None,
) -> Outcome:
    """Compile a program, run it in a world, and say how it ended."""
    ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_STREAM)
    with ours:
        answer = worker.run(source, theirs)
        if isinstance(answer, Refused):
            return Outcome("refused", answer.problems)
        return drive(ours, world, order, limits, say, trace, kill=worker.kill, gone=worker.gone)


def run_native(
    binary: Path,
    world: World,
    order: Order,
    limits: Limits,
    say: Callable[[str], None],
    trace: BinaryIO | None = None,
) -> Outcome:
    """The same for what ``./rosy build`` made. It runs in no sandbox: whoever built it may start it too."""
    ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_STREAM)
    with ours, theirs:
        command = [str(binary.absolute()), "--link", str(theirs.fileno())]
        with subprocess.Popen(command, pass_fds=[theirs.fileno()]) as process:
            theirs.close()
            try:
                return drive(ours, world, order, limits, say, trace, kill=process.kill)
            finally:
                process.kill()


def drive(
    link: socket.socket,
    world: World,
    order: Order,
    limits: Limits,
    say: Callable[[str], None],
    trace: BinaryIO | None = None,
    *,
    kill: Callable[[], None] = lambda: None,
    gone: Callable[[], Gone | None] = lambda: None,
) -> Outcome:
    """Run a program that waits at the other end of a link."""
    lockstep = Lockstep(world, order.seed, trace is not None)
    began = time.perf_counter()
    try:
        ended, problems = _steps(link, lockstep, order, limits, say, trace)
    except _Stuck:
        kill()
        last = gone()
        ended, problems = "stuck", [stuck(last.firing if last else None, limits.settle, lockstep.time)]
    except _Died:
        ended, problems = "error", [died(gone(), lockstep.time)]
    except TooMuch as error:
        kill()
        ended, problems = "error", [too_much(str(error), lockstep.time)]
    except LinkError as error:
        kill()
        ended, problems = "error", [broken_link(str(error), lockstep.time)]
    except OSError:
        ended, problems = "error", [worker_lost(lockstep.time)]
    lockstep.goals.finish(lockstep.time)
    return Outcome(ended, problems, lockstep.step, time.perf_counter() - began, lockstep.goals.states)


def _steps(
    link: socket.socket,
    lockstep: Lockstep,
    order: Order,
    limits: Limits,
    say: Callable[[str], None],
    trace: BinaryIO | None,
) -> tuple[Ended, list[Problem]]:
    last = round(order.seconds / STEP)
    hands = list(order.hands)
    link.settimeout(limits.ready)
    link.sendall(lockstep.begin())
    _listen(link, lockstep, "opening", limits.ready)
    link.settimeout(limits.settle)
    began = time.perf_counter()
    while lockstep.state != "ended":
        if lockstep.step >= last:
            _stop(link, lockstep, limits)
            return "time", []
        if order.speed is not None:
            ahead = lockstep.time / order.speed - (time.perf_counter() - began)
            if ahead > 0:
                time.sleep(ahead)
        while hands and hands[0][0] <= lockstep.time + 1e-9:
            _lay(lockstep.world, hands.pop(0)[1])
        link.sendall(lockstep.sense())
        _listen(link, lockstep, "thinking", limits.settle)
        for text in lockstep.said():
            say(text)
        if trace is not None:
            trace.write(lockstep.trace_line())
        if lockstep.state == "settled":
            lockstep.integrate()
    ended = lockstep.ended
    assert ended is not None
    if ended.how == "error":
        return "error", [ended.problem] if ended.problem is not None else [died(None, lockstep.time)]
    return "done", []


def _lay(world: World, hand: Hand) -> None:
    """A hand that finds no room for the robot leaves it where it is, as a person would."""
    try:
        world.hand(hand)
    except HandRefused:
        return


def _listen(link: socket.socket, lockstep: Lockstep, state: str, limit: float) -> None:
    """Read until the lockstep leaves a state. The deadline is for all of it, so drops of bytes do not help."""
    deadline = time.monotonic() + limit
    while lockstep.state == state:
        try:
            data = link.recv(65536)
        except TimeoutError as error:
            raise _Stuck from error
        if not data:
            raise _Died
        lockstep.feed(data)
        if lockstep.state == state and time.monotonic() > deadline:
            raise _Stuck


def _stop(link: socket.socket, lockstep: Lockstep, limits: Limits) -> None:
    """Ask the program to end; the worker kills what does not listen."""
    try:
        link.sendall(lockstep.stop())
        deadline = time.monotonic() + limits.stop
        while lockstep.state != "ended":
            left = deadline - time.monotonic()
            if left <= 0 or not select.select([link], [], [], left)[0]:
                return
            data = link.recv(65536)
            if not data:
                return
            lockstep.feed(data)
    except (OSError, LinkError):
        # The time is up either way, and the worker ends what is left with its sandbox.
        return
