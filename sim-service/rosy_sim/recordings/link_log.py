"""
Log of the robot link as ``rosy-robot`` writes it during a run, and its lines as messages on topics.

A ``publish`` line is a message on its topic; every other line is one on ``/rosy/to_program`` or ``/rosy/from_program``.
``to_message`` and ``to_line`` are each other's inverse, byte for byte. ``protocol/README.md``, section 7.1.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Literal, NamedTuple, get_args

import msgspec

__all__ = [
    "LinkLine",
    "LinkMessage",
    "LogEnd",
    "Source",
    "log_line",
    "publication",
    "read_log",
    "to_line",
    "to_message",
]

Source = Literal["to_program", "from_program", "to_robot"]
"""``to_robot`` are commands as they were sent to the robot, after limits and safety rules."""

_SIGNS: dict[bytes, Source] = {b">": "to_program", b"<": "from_program", b"!": "to_robot"}

_SIGN_OF = {source: sign for sign, source in _SIGNS.items()}

_OTHER_LINES = "/rosy/"
"""Before a source: the topic of lines that publish nothing."""


_ENCODED = b'{"base64":'
"""How a message begins that holds a line which is no JSON object."""


class LinkLine(NamedTuple):
    """A line without its newline; ``time`` is in ns since 1970."""

    time: int
    source: Source
    text: bytes


class LogEnd(NamedTuple):
    """The last line of a whole log, with the number of batches that the disk was too slow for."""

    left_out: int


class LinkMessage(NamedTuple):
    """A line as a message: ``data`` is JSON."""

    topic: str
    data: bytes


class _Publish(msgspec.Struct, tag="publish", tag_field="op"):
    topic: str
    msg: msgspec.Raw


class _Unreadable(msgspec.Struct):
    """A line that is no JSON object."""

    base64: bytes


_publish = msgspec.json.Decoder(_Publish)
_unreadable = msgspec.json.Decoder(_Unreadable)
_object = msgspec.json.Decoder(dict[str, msgspec.Raw])


def read_log(lines: Iterable[bytes]) -> Iterator[LinkLine | LogEnd]:
    """The lines of a log. It ends at a line that is not whole, as that of a killed process."""
    for line in lines:
        if not line.endswith(b"\n"):
            return
        time, _, rest = line[:-1].partition(b" ")
        if time == b"." and rest.isdigit():
            yield LogEnd(int(rest))
            return
        source = _SIGNS.get(rest[:1])
        if source is None or not time.isdigit():
            return
        yield LinkLine(int(time), source, rest[2:])


def log_line(line: LinkLine) -> bytes:
    """A line of a log, with its newline."""
    return b"%d %s %s\n" % (line.time, _SIGN_OF[line.source], line.text)


def publication(line: bytes) -> tuple[str, bytes] | None:
    """Topic and message of a ``publish`` line as Rosy writes them; None for any other line."""
    try:
        published = _publish.decode(line)
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError):
        return None
    data = bytes(published.msg)
    return (published.topic, data) if _publish_line(published.topic, data) == line else None


def _publish_line(topic: str, data: bytes) -> bytes:
    return b'{"op":"publish","topic":' + msgspec.json.encode(topic) + b',"msg":' + data + b"}"


def to_message(source: Source, line: bytes) -> LinkMessage:
    """A line as a message."""
    published = publication(line)
    if published is not None and published[1][:1] == b"{" and not published[0].startswith(tuple(_other_topics())):
        return LinkMessage(*published)
    if not _is_object(line) or line.startswith(_ENCODED):
        line = msgspec.json.encode(_Unreadable(line))
    return LinkMessage(_OTHER_LINES + source, line)


def _is_object(line: bytes) -> bool:
    try:
        _object.decode(line)
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError):
        return False
    return True


def to_line(source: Source, message: LinkMessage) -> bytes:
    """The line of a message."""
    if message.topic != _OTHER_LINES + source:
        return _publish_line(message.topic, message.data)
    return _unreadable.decode(message.data).base64 if message.data.startswith(_ENCODED) else message.data


def _other_topics() -> list[str]:
    return [_OTHER_LINES + source for source in get_args(Source)]
