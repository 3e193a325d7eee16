"""
Robot link, the simulator's side, without any I/O.

Feed it the bytes that arrived from the program, in pieces of any size; it returns the messages they
complete and checks that they come in an order ``protocol/README.md`` section 2 allows. Whatever a
program sends, the answer is messages or a ``LinkError`` that says what it broke.
"""

from __future__ import annotations

import msgspec

from ..world.events import Command
from ..world.time_step import STEPS_PER_SECOND
from .line_splitter import LineSplitter, LineTooLong
from .link_messages import (
    CallService,
    CancelActionGoal,
    Ended,
    ProgramLine,
    Publish,
    Ready,
    SendActionGoal,
    Settled,
    Subscribe,
)
from .topics import COMMAND_TOPICS, BadMessage, TopicMessage, read_command

__all__ = [
    "MAX_COMMANDS",
    "MAX_LINE",
    "MAX_RUN",
    "MAX_STEP",
    "LimitExceeded",
    "LinkError",
    "Request",
    "SimulatorLink",
    "start_line",
    "step_line",
    "stop_line",
]

PROTOCOL = 1

MAX_LINE = 1_000_000
"""Longest line a program may send, bytes. A `settled` with its trace stays far below."""

MAX_COMMANDS = 10_000
"""Most commands in one step."""

MAX_STEP = 4_000_000
"""Most bytes in one step."""

MAX_RUN = 2_000_000_000
"""Bytes of a whole run: more than a day of a chatty program."""

MAX_FIRED = 100_000
"""Most firings that one `settled` may report."""

MAX_MEMORY = 1_000
"""Most values of a memory that one `settled` may report."""


class LinkError(Exception):
    """The program broke the protocol; the text says how. Not caused by the learner."""


class LimitExceeded(LinkError):
    """The program exceeded a limit, which the learner may have caused."""


_decoder = msgspec.json.Decoder(ProgramLine)

Request = SendActionGoal | CancelActionGoal | CallService
"""A call of an action or a service."""

Message = Ready | Command | TopicMessage | Request | Settled | Ended

MAX_TOPICS = 100
"""Most topics that a program may take, and most that it may send, the robot's own included."""


def start_line(seed: int, trace: bool, quiet: bool = False) -> bytes:
    """The first line. With ``quiet`` the program tells which steps are quiet."""
    line: dict[str, object] = {"op": "start", "protocol": PROTOCOL, "seed": seed, "trace": trace}
    return msgspec.json.encode(line | ({"quiet": True} if quiet else {})) + b"\n"


def step_line(
    step: int, memory: bool = False, firings: bool = False, late: bool = False, time: float | None = None
) -> bytes:
    """
    The end of a step's batch; it may ask what the program remembers, and for its firings with their provenance.
    ``late`` is the batch of a quiet step that is over, which is not answered. ``time`` (s) is that of the simulator if
    absent.
    """
    asking = b""
    if memory or firings or late:
        asking = (b',"memory":true' if memory else b"") + (b',"firings":true' if firings else b"")
        asking += b',"late":true' if late else b""
    seconds = step / STEPS_PER_SECOND if time is None else time
    return b'{"op":"step","step":%d,"time":%s%s}\n' % (step, repr(seconds).encode(), asking)


def stop_line() -> bytes:
    """Asks the program to clean up and end."""
    return b'{"op":"stop"}\n'


_commands: dict[bytes, Command] = {}
"""Commands by their lines. Programs often repeat one, and looking it up takes a tenth of the time of reading it."""

_MAX_REMEMBERED = 4096
"""Lines that are remembered."""

_SHORT = 300
"""Lines up to this length are remembered, bytes: that of a velocity has 110."""


def _remember(line: bytes, command: Command) -> None:
    if len(line) > _SHORT:
        return
    if len(_commands) >= _MAX_REMEMBERED:
        _commands.clear()
    _commands[line] = command


class SimulatorLink:
    """Protocol state of the simulator's end."""

    __slots__ = (
        "_commands",
        "_lines",
        "_run_bytes",
        "_step_bytes",
        "advertised",
        "ended",
        "ready",
        "step",
        "subscribed",
    )

    def __init__(self) -> None:
        self._lines = LineSplitter(MAX_LINE)
        # Commands and bytes since the last `settled`.
        self._commands = 0
        self._step_bytes = 0
        # Set by the program's `ready`, and by its `ended`.
        self.ready = False
        self.ended = False
        # The step whose `settled` may come next; set by the owner when it sends a batch.
        self.step: int | None = None
        # Bytes of the run so far.
        self._run_bytes = 0
        # Topics that the program takes, and those that it sends.
        self.subscribed: set[str] = set()
        self.advertised: set[str] = set()

    def feed(self, data: bytes) -> list[Message]:
        """
        Take bytes from the program; return the messages they complete, in order.

        Raises:
            LinkError: a line is not a message, comes at the wrong time, or there is too much of it (``TooMuch``).
        """
        self._step_bytes += len(data)
        if self._step_bytes > MAX_STEP:
            raise LimitExceeded(f"more than {MAX_STEP} bytes in one step")
        self._run_bytes += len(data)
        if self._run_bytes > MAX_RUN:
            raise LimitExceeded(f"more than {MAX_RUN} bytes in one run")
        try:
            lines = self._lines.feed(data)
        except LineTooLong as too_long:
            raise LimitExceeded(str(too_long)) from too_long
        messages: list[Message] = []
        for line in lines:
            command = _commands.get(line)
            if command is not None and not self.ended:
                self._count_command()
                messages.append(command)
                continue
            try:
                message = _decoder.decode(line)
            except (msgspec.DecodeError, UnicodeDecodeError, RecursionError) as error:
                raise LinkError(f"a line is not a message: {error}") from error
            understood = self._take(message)
            if understood is not None:
                messages.append(understood)
                if type(understood) is Command:
                    _remember(line, understood)
        return messages

    def _take(self, message: ProgramLine) -> Message | None:
        if self.ended:
            raise LinkError("a line follows `ended`")
        if isinstance(message, Settled):
            return self._settled(message)
        if isinstance(message, Publish):
            return self._publish(message)
        if isinstance(message, Request):
            self._count_command()
            return message
        if isinstance(message, Ended):
            self.ended = True
            return message
        if self.ready:
            raise LinkError("the topics were already settled with `ready`")
        if isinstance(message, Ready):
            self.ready = True
            return message
        named = self.subscribed if isinstance(message, Subscribe) else self.advertised
        named.add(message.topic)
        if len(named) > MAX_TOPICS:
            raise LinkError(f"more than {MAX_TOPICS} topics")
        return None

    def _count_command(self) -> None:
        self._commands += 1
        if self._commands > MAX_COMMANDS:
            raise LimitExceeded(f"more than {MAX_COMMANDS} commands in one step")

    def _publish(self, message: Publish) -> Command | TopicMessage:
        self._count_command()
        try:
            if message.topic not in COMMAND_TOPICS and message.topic in self.advertised:
                return TopicMessage(message.topic, msgspec.json.decode(message.msg))
            return read_command(message.topic, message.msg)
        except BadMessage as error:
            raise LinkError(str(error)) from error

    def _settled(self, message: Settled) -> Settled:
        if message.step != self.step:
            raise LinkError(f"`settled` for step {message.step} instead of {self.step}")
        if len(message.fired) > MAX_FIRED:
            raise LinkError(f"more than {MAX_FIRED} firings in one step")
        if message.memory is not None and len(message.memory) > MAX_MEMORY:
            raise LinkError(f"more than {MAX_MEMORY} values in a memory")
        self._commands = self._step_bytes = 0
        self.step = None
        return message
