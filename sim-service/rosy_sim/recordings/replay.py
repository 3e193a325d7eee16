"""
Replay: what a program heard from a robot in a recorded run is sent to a program again, step by step, and its commands
are compared with the recorded ones, byte for byte.

A program is a function of what it hears (language rule R13), so the same one sends the same. No clock is involved: a
step is sent when the one before is answered.
"""

from __future__ import annotations

import itertools
import socket
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field

import msgspec

from ..config import Limits
from ..errors import BadInput
from ..sentences.sentence import tr
from ..wire.line_splitter import LineSplitter, LineTooLong
from ..wire.problem import Problem
from ..wire.robot_link import MAX_LINE
from ..wire.worker import Refused
from ..worker.blocking_worker import BlockingWorker
from .link_log import LinkLine, publication

__all__ = [
    "Difference",
    "Exchange",
    "ExchangeReader",
    "ReplayResult",
    "difference_in",
    "exchanges",
    "published",
    "replay",
    "shown",
]

_ENDS_BATCH = frozenset({"start", "step", "stop"})
_ENDS_ANSWER = frozenset({"ready", "settled", "ended"})


class _Op(msgspec.Struct):
    op: str
    step: int = 0
    time: float = 0.0
    how: str = ""


_op = msgspec.json.Decoder(_Op)


@dataclass(slots=True)
class Exchange:
    """A batch for the program and its answer; ``time`` is in s since the start of the run."""

    time: float = 0.0
    step: int = 0
    batch: list[bytes] = field(default_factory=list)
    answer: list[bytes] = field(default_factory=list)
    # What was sent to the robot meanwhile, after limits and safety rules.
    sent: list[bytes] = field(default_factory=list)
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


class ExchangeReader:
    """Puts the lines of a recorded run together to exchanges."""

    def __init__(self) -> None:
        self._current = Exchange()
        # Whether the batch of the current exchange is whole.
        self._is_sent = False

    def feed(self, line: LinkLine) -> Exchange | None:
        """Take a line; the exchange that is over with it, if one is."""
        before = None
        if line.source == "to_robot":
            self._current.sent.append(line.text)
            return None
        op = _read_op(line.text)
        if line.source == "to_program":
            if self._is_sent:
                before = self._current
                self._current, self._is_sent = Exchange(before.time, before.step), False
            self._current.batch.append(line.text)
            if op.op in _ENDS_BATCH:
                self._is_sent = True
                if op.op == "step":
                    self._current.time, self._current.step = op.time, op.step
        else:
            self._current.answer.append(line.text)
            if op.op in _ENDS_ANSWER:
                self._current.end = op.op
        return before

    def last(self) -> Exchange | None:
        """The exchange that the last line belongs to, if its batch is whole."""
        return self._current if self._is_sent else None


def exchanges(lines: Iterable[LinkLine]) -> Iterator[Exchange]:
    """
    The batches of a recorded run with their answers.

    Raises:
        BadInput: the recording is damaged.
    """
    reader = ExchangeReader()
    for line in lines:
        exchange = reader.feed(line)
        if exchange is not None:
            yield exchange
    last = reader.last()
    if last is not None:
        yield last


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
        wanted = published(exchange.answer)
        difference = difference_in(time, wanted, published(replayed.answer))
        if difference is not None:
            return ReplayResult(commands, time, difference, problems)
        commands += len(wanted)
        if replayed.end != exchange.end:
            return ReplayResult(commands, time, Difference(time, None, None), problems)
    return ReplayResult(commands, time, None, problems)


def published(answer: list[bytes]) -> list[bytes]:
    """The commands of an answer."""
    return [line for line in answer if _read_op(line).op == "publish"]


def difference_in(time: float, recorded: list[bytes], replayed: list[bytes]) -> Difference | None:
    """The first difference in the commands of a step; None when they are the same."""
    for before, now in itertools.zip_longest(recorded, replayed):
        if before != now:
            return Difference(time, before, now)
    return None


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
