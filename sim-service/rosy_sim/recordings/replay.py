"""
Replay: what a program heard from a robot in a recorded run is sent to a program again, step by step, and its commands
are compared with the recorded ones, byte for byte.

A program is a function of what it hears (language rule R13), so the same one sends the same. No clock is involved: a
step is sent when the one before is answered.
"""

from __future__ import annotations

import socket
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field

import msgspec

from ..config import Limits
from ..errors import BadInput
from ..sentence import tr
from ..wire.line_splitter import LineSplitter, LineTooLong
from ..wire.problem import Problem
from ..wire.robot_link import MAX_LINE
from ..wire.worker import Refused
from ..worker.blocking_worker import BlockingWorker
from .link_log import LinkLine, publication

__all__ = ["Difference", "Exchange", "ReplayResult", "exchanges", "replay", "shown"]

_ENDS_BATCH = frozenset({"start", "step", "stop"})
_ENDS_ANSWER = frozenset({"ready", "settled", "ended"})


class _Op(msgspec.Struct):
    op: str
    time: float = 0.0
    how: str = ""


_op = msgspec.json.Decoder(_Op)


@dataclass(slots=True)
class Exchange:
    """A batch for the program and its answer; ``time`` is in s since the start of the run."""

    time: float = 0.0
    batch: list[bytes] = field(default_factory=list)
    answer: list[bytes] = field(default_factory=list)
    # How the answer ends: ready, settled or ended; empty when the program did not answer.
    end: str = ""


@dataclass(frozen=True, slots=True)
class Difference:
    """The first command that is not the recorded one. None: there is no command there."""

    time: float
    recorded: bytes | None
    replayed: bytes | None


@dataclass(frozen=True, slots=True)
class ReplayResult:
    """``time`` is the length of what was compared, s. ``problems`` are those of compiling the program."""

    commands: int = 0
    time: float = 0.0
    difference: Difference | None = None
    problems: list[Problem] = field(default_factory=list)
    is_refused: bool = False


def exchanges(lines: Iterable[LinkLine]) -> Iterator[Exchange]:
    """
    The batches of a recorded run with their answers.

    Raises:
        BadInput: the lines are no conversation of a program and a robot.
    """
    current = Exchange()
    is_sent = False
    for line in lines:
        if line.source == "to_robot":
            continue
        op = _read_op(line.text)
        if line.source == "to_program":
            if is_sent:
                yield current
                current, is_sent = Exchange(current.time), False
            current.batch.append(line.text)
            if op.op in _ENDS_BATCH:
                is_sent = True
                current.time = op.time if op.op == "step" else current.time
        else:
            current.answer.append(line.text)
            if op.op in _ENDS_ANSWER:
                current.end = op.op
    if is_sent:
        yield current


def _read_op(line: bytes) -> _Op:
    try:
        return _op.decode(line)
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError):
        # A program may have said it.
        return _Op("")


def replay(worker: BlockingWorker, source: str, recorded: Iterable[LinkLine]) -> ReplayResult:
    """Compile a program and let it hear a recorded run, to its end or to the first other command."""
    ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_STREAM)
    with ours:
        answer = worker.run(source, theirs)
        if isinstance(answer, Refused):
            return ReplayResult(problems=answer.problems, is_refused=True)
        try:
            return _compare(_Program(ours, worker.limits), exchanges(recorded), answer.problems)
        finally:
            worker.kill()


def _compare(program: _Program, recorded: Iterator[Exchange], problems: list[Problem]) -> ReplayResult:
    commands, time = 0, 0.0
    for exchange in recorded:
        time = exchange.time
        # The last batch may have had no answer: the program was ended, or the robot was lost.
        if not exchange.end:
            break
        program.send(exchange.batch)
        replayed = program.answer()
        wanted, sent = _commands(exchange.answer), _commands(replayed.answer)
        for number in range(max(len(wanted), len(sent))):
            before = wanted[number] if number < len(wanted) else None
            now = sent[number] if number < len(sent) else None
            if before != now:
                return ReplayResult(commands, time, Difference(time, before, now), problems)
            commands += 1
        if replayed.end != exchange.end:
            return ReplayResult(commands, time, Difference(time, None, None), problems)
    return ReplayResult(commands, time, None, problems)


def _commands(answer: list[bytes]) -> list[bytes]:
    return [line for line in answer if _read_op(line).op == "publish"]


class _Program:
    """A program at the other end of a link."""

    def __init__(self, link: socket.socket, limits: Limits) -> None:
        self._link = link
        self._link.settimeout(max(limits.settle, limits.ready))
        self._lines = LineSplitter(MAX_LINE)
        self._unread: list[bytes] = []

    def send(self, batch: list[bytes]) -> None:
        try:
            self._link.sendall(b"".join(line + b"\n" for line in batch))
        except OSError:
            # Its last answer says why, or there is none.
            return

    def answer(self) -> Exchange:
        """What it answers to a batch; without an end when it has died or is stuck."""
        said = Exchange()
        while True:
            for number, line in enumerate(self._unread):
                said.answer.append(line)
                op = _read_op(line).op
                if op in _ENDS_ANSWER:
                    said.end = op
                    del self._unread[: number + 1]
                    return said
            self._unread = []
            try:
                data = self._link.recv(65536)
                if not data:
                    return said
                self._unread = self._lines.feed(data)
            except LineTooLong as error:
                raise BadInput(tr("The program said more than a robot can take.")) from error
            except OSError:
                return said


def shown(line: bytes | None) -> str | None:
    """A command as topic and message."""
    if line is None:
        return None
    published = publication(line)
    return f"{published[0]} {published[1].decode()}" if published is not None else line.decode(errors="replace")
