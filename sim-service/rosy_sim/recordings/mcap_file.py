"""
Recordings as MCAP files (https://mcap.dev/spec), which Foxglove opens: written from the log of a run, and read again.

Messages are JSON with a JSON schema, on the topics of the simulated robot. Odometry has the header that ROS gives it,
with the time of its line. A channel says in its metadata where its messages come from (``source``); log times increase
strictly, so the order of the lines is kept. The program is an attachment, what else is known of the run a metadata
record.
"""

from __future__ import annotations

import re
import struct
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, BinaryIO, Protocol, cast, get_args

import msgspec
from mcap.exceptions import McapError
from mcap.records import Attachment, Metadata, Statistics
from mcap.writer import Writer
from zstandard import ZstdError

from ..errors import BadInput
from ..files import refuse_newer
from ..sentences.sentence import tr
from ..wire.topics import COMMAND_TOPICS, ODOMETRY, SENSOR_TOPICS
from .link_log import LinkLine, LinkMessage, LogEnd, Source, read_log, to_line, to_message
from .mcap_records import RecordTooLarge, described, messages

__all__ = ["VERSION", "Output", "Recording", "RunDetails", "open_recording", "read_recording", "write_recording"]

_PROGRAM = "program.hs"
_DETAILS = "rosy"

VERSION = 1
"""Of what is in the file besides MCAP, as the metadata record has it; it grows when older readers would take it for
something else. Recordings before 0.7.0 do not say it, and are version 1."""

_SENT = "/sent"
"""Before the topics of what was sent to the robot: the program's own commands have the topics themselves."""

MAX_RECORDING = 2_000_000_000
"""Size of a file that is read, bytes. Longer ones than ours come from elsewhere. ``mcap_records`` limits what is in
memory."""

_BROKEN = (
    McapError,
    ZstdError,
    msgspec.DecodeError,
    struct.error,
    EOFError,
    ValueError,
    LookupError,
    RuntimeError,
    MemoryError,
    OverflowError,
)
"""What the MCAP library raises for files that are damaged."""


_FRAME = ODOMETRY.constants[("child_frame_id",)]

_HEADED = re.compile(rb'^\{"header":\{"stamp":\{[^{}]*\},[^{}]*\},"child_frame_id":"[^"]*",?')
"""The beginning of a message with the header that ``_with_header`` gives it."""


class Output(Protocol):
    """Receives bytes: an ``AtomicFile`` or a ``BytesIO``."""

    def write(self, data: bytes, /) -> object:
        """Append bytes."""


@dataclass(frozen=True, slots=True)
class RunDetails:
    """What is known of a run besides its messages. ``robot`` is its address."""

    program: str
    robot: str
    # The file of the program, or the name of the robot in the page.
    name: str = ""
    ended: str = ""


@dataclass(slots=True)
class Recording:
    """A recording that is open for reading."""

    details: RunDetails
    # Whether the run was recorded to its end, and how many batches of lines are missing before.
    is_complete: bool
    left_out: int
    # From the first to the last line, s; 0 when the file does not say.
    seconds: float
    _stream: BinaryIO = field(repr=False)
    _name: Path = field(repr=False)

    def lines(self) -> Iterator[LinkLine]:
        """
        The lines of the robot link, in their order.

        Raises:
            BadInput: the file is damaged.
        """
        with _readable(self._name):
            for channel, message in messages(self._stream):
                source = channel.metadata.get("source")
                if source in get_args(Source):
                    found = cast(Source, source)
                    topic = channel.topic.removeprefix(_SENT) if found == "to_robot" else channel.topic
                    data = _HEADED.sub(b"{", message.data) if topic == ODOMETRY.topic else message.data
                    yield LinkLine(message.log_time, found, to_line(found, LinkMessage(topic, data)))


class _McapOutput:
    """What the MCAP writer needs of a stream, over an output that only appends."""

    def __init__(self, output: Output) -> None:
        self._output = output
        self._position = 0

    def write(self, data: bytes, /) -> int:
        self._output.write(data)
        self._position += len(data)
        return len(data)

    def tell(self) -> int:
        return self._position

    def flush(self) -> None:
        """The owner of the output flushes it."""

    def seekable(self) -> bool:
        return False


class _Channels:
    """Channels and schemas of a file that is written: one per source and topic."""

    def __init__(self, writer: Writer) -> None:
        self._writer = writer
        self._known: dict[tuple[Source, str], int] = {}

    def channel(self, source: Source, message: LinkMessage) -> int:
        key = (source, message.topic)
        if key not in self._known:
            kind = SENSOR_TOPICS.get(message.topic) or COMMAND_TOPICS.get(message.topic) or message.topic.strip("/")
            schema = msgspec.json.encode(_schema(msgspec.json.decode(message.data)) | {"title": kind})
            topic = _SENT + message.topic if source == "to_robot" else message.topic
            ident = self._writer.register_schema(kind, "jsonschema", schema)
            self._known[key] = self._writer.register_channel(topic, "json", ident, {"source": source})
        return self._known[key]


def _with_header(source: Source, message: LinkMessage, time: int) -> LinkMessage:
    """Odometry with header and frames, whose time is that of the line in ns; other messages as they are."""
    if source != "to_program" or message.topic != ODOMETRY.topic:
        return message
    sec, nanosec = divmod(time, 10**9)
    header = {"stamp": {"sec": sec, "nanosec": nanosec}, "frame_id": ODOMETRY.header}
    head = msgspec.json.encode({"header": header, "child_frame_id": _FRAME})
    rest = message.data[1:] if message.data == b"{}" else b"," + message.data[1:]
    return LinkMessage(message.topic, head[:-1] + rest)


def _schema(value: Any) -> dict[str, Any]:
    """A JSON schema of messages like this one."""
    match value:
        case bool():
            return {"type": "boolean"}
        case int() | float():
            return {"type": "number"}
        case str():
            return {"type": "string"}
        case list():
            return {"type": "array"} | ({"items": _schema(value[0])} if value else {})
        case dict():
            return {"type": "object", "properties": {name: _schema(part) for name, part in value.items()}}
        case _:
            return {}


def write_recording(log: BinaryIO, output: Output, details: RunDetails) -> int:
    """Turn the log of a run into an MCAP file; returns the number of its messages, 0 if nothing is in the log."""
    writer = Writer(cast(BinaryIO, _McapOutput(output)))
    writer.start(profile="", library="rosy")
    channels = _Channels(writer)
    count, first, time = 0, 0, 0
    end: LogEnd | None = None
    for line in read_log(log):
        if isinstance(line, LogEnd):
            end = line
            break
        time = max(line.time, time + 1)
        message = _with_header(line.source, to_message(line.source, line.text), time)
        first = first or time
        count += 1
        writer.add_message(channels.channel(line.source, message), time, message.data, time, count)
    program = details.program.encode()
    writer.add_attachment(first, first, _PROGRAM, "text/x-haskell", program)
    told = {
        "version": str(VERSION),
        "robot": details.robot,
        "name": details.name,
        "ended": details.ended,
        "complete": "yes" if end is not None else "no",
        "left_out": str(end.left_out if end is not None else 0),
    }
    writer.add_metadata(_DETAILS, told)
    writer.finish()  # type: ignore[no-untyped-call]
    return count


@contextmanager
def open_recording(path: Path) -> Iterator[Recording]:
    """
    A recording for reading.

    Raises:
        BadInput: it cannot be read, or is no recording of Rosy's.
    """
    try:
        stream = path.open("rb")
    except OSError as error:
        raise BadInput(tr("{path} cannot be read: {why}.", path=path, why=error.strerror or "")) from error
    with stream:
        yield read_recording(stream, path)


def read_recording(stream: BinaryIO, path: Path) -> Recording:
    """
    A recording in an open file; ``path`` is what messages call it.

    Raises:
        BadInput: it is no recording of Rosy's, or one of a newer Rosy.
    """
    with _readable(path):
        if stream.seek(0, 2) > MAX_RECORDING:
            raise BadInput(tr("{path} is too large for a recording of a run.", path=path))
        program, told, seconds = None, None, 0.0
        for found in described(stream):
            match found:
                case Attachment(name=name, data=data) if name == _PROGRAM:
                    program = data
                case Metadata(name=name, metadata=metadata) if name == _DETAILS:
                    told = metadata
                case Statistics(message_start_time=first, message_end_time=last):
                    seconds = (last - first) / 1e9
        if program is None or told is None:
            raise BadInput(tr("{path} is no recording of a run: it lacks the program that was recorded.", path=path))
        refuse_newer(path, int(told.get("version", "1")), VERSION)
        run = RunDetails(program.decode(), told.get("robot", ""), told.get("name", ""), told.get("ended", ""))
        return Recording(run, told.get("complete") == "yes", int(told.get("left_out", "0")), seconds, stream, path)


@contextmanager
def _readable(path: Path) -> Iterator[None]:
    try:
        yield
    except RecordTooLarge as error:
        raise BadInput(tr("{path} is too large for a recording of a run.", path=path)) from error
    except _BROKEN as error:
        raise BadInput(
            tr("{path} is no recording of a run, or is damaged. Choose an .mcap file that Rosy has stored.", path=path)
        ) from error
    except OSError as error:
        raise BadInput(tr("{path} cannot be read: {why}.", path=path, why=error.strerror or "")) from error
