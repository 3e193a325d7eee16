"""
Records of MCAP files (https://mcap.dev/spec), which may come from anywhere: read in the order of the file, one at a
time, with limits on what is read and unpacked before it is.

The readers of the library unpack a chunk whole, hold all chunks whose times overlap, and believe the sizes that a file
states.
"""

from __future__ import annotations

import io
import struct
from collections.abc import Iterator
from typing import BinaryIO, Final, cast

import lz4.frame
import zstandard
from mcap.data_stream import ReadDataStream
from mcap.exceptions import EndOfFile, McapError
from mcap.opcode import Opcode
from mcap.records import Attachment, Channel, Chunk, McapRecord, Message, Metadata, Statistics
from mcap.stream_reader import read_magic

__all__ = ["LARGEST", "RecordTooLarge", "described", "messages"]

LARGEST: Final = 32_000_000
"""Bytes of a record, packed and unpacked. Writers begin a new chunk after 0.8 to 4 MB; a laser scan takes some kB."""

_WINDOW = 1 << 23
"""Bytes that unpacking zstd keeps: what RFC 8878 (section 3.1.1.1.2) asks decoders to support."""

_HEADER = struct.Struct("<BQ")

_CHUNK = struct.Struct("<QQQ")
"""Times of its first and last message, ns, and bytes that it unpacks to."""

_DESCRIPTIONS: dict[int, type[Attachment | Metadata | Statistics]] = {
    Opcode.ATTACHMENT: Attachment,
    Opcode.METADATA: Metadata,
    Opcode.STATISTICS: Statistics,
}


class RecordTooLarge(McapError):
    """A record, or what it unpacks to, is larger than LARGEST."""


def described(stream: BinaryIO) -> Iterator[Attachment | Metadata | Statistics]:
    """
    What a whole file says of itself besides its messages. Nothing is unpacked.

    Raises:
        McapError: the file has another form, or ends before its end.
    """
    for opcode, length in _records(stream):
        if opcode == Opcode.CHUNK and max(length, _CHUNK.unpack(_exactly(stream, _CHUNK.size))[2]) > LARGEST:
            raise RecordTooLarge
        if (kind := _DESCRIPTIONS.get(opcode)) is not None:
            yield kind.read(_content(stream, length))


def messages(stream: BinaryIO) -> Iterator[tuple[Channel, Message]]:
    """
    The messages of a file that `described` has read, in the order of the file, each with its channel.

    Raises:
        McapError: the file has another form, or ends before its end.
        KeyError: a message has no channel.
    """
    channels: dict[int, Channel] = {}
    for record in _unpacked(stream):
        if isinstance(record, Channel):
            channels[record.id] = record
        elif isinstance(record, Message):
            yield channels[record.channel_id], record


def _unpacked(stream: BinaryIO) -> Iterator[McapRecord]:
    """Channels and messages, those in chunks as well."""
    for opcode, length in _records(stream):
        if opcode == Opcode.CHUNK:
            yield from _chunked(Chunk.read(_content(stream, length)))
        elif opcode in (Opcode.CHANNEL, Opcode.MESSAGE):
            yield _read(opcode, _content(stream, length), length)


def _chunked(chunk: Chunk) -> Iterator[McapRecord]:
    """The channels and messages of a chunk, of which only the current one is unpacked."""
    size = chunk.uncompressed_size
    packed = io.BytesIO(chunk.data)
    data: BinaryIO
    match chunk.compression:
        case "":
            data = packed
        case "zstd":
            data = cast(BinaryIO, zstandard.ZstdDecompressor(max_window_size=_WINDOW).stream_reader(packed))
        case "lz4":
            data = cast(BinaryIO, lz4.frame.LZ4FrameFile(packed))
        case other:
            raise McapError(f"unknown compression {other}")
    place = 0
    while place < size:
        opcode, length = _HEADER.unpack(_exactly(data, _HEADER.size))
        place += _HEADER.size + length
        if place > size:
            raise EndOfFile
        content = _exactly(data, length)
        if opcode in (Opcode.CHANNEL, Opcode.MESSAGE):
            yield _read(opcode, ReadDataStream(io.BytesIO(content)), length)


def _read(opcode: int, content: ReadDataStream, length: int) -> McapRecord:
    found: McapRecord = Channel.read(content) if opcode == Opcode.CHANNEL else Message.read(content, length)
    return found


def _records(stream: BinaryIO) -> Iterator[tuple[int, int]]:
    """Opcode and length of each record, whose content may then be read; the footer ends the file."""
    stream.seek(0)
    read_magic(ReadDataStream(stream))
    opcode = None
    while opcode != Opcode.FOOTER:
        opcode, length = _HEADER.unpack(_exactly(stream, _HEADER.size))
        content = stream.tell()
        yield opcode, length
        stream.seek(content + length)
    read_magic(ReadDataStream(stream))


def _content(stream: BinaryIO, length: int) -> ReadDataStream:
    if length > LARGEST:
        raise RecordTooLarge
    return ReadDataStream(io.BytesIO(_exactly(stream, length)))


def _exactly(stream: BinaryIO, length: int) -> bytes:
    found = stream.read(length)
    if len(found) < length:
        raise EndOfFile
    return found
