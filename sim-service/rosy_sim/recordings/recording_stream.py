"""
Recording that the service reads while it plays it back: the file is read by a process of its own (``reading_process``),
only as fast as its lines are taken.
"""

from __future__ import annotations

import asyncio
import contextlib
import sys
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from typing import BinaryIO

import msgspec

from ..errors import BadInput
from ..sentences.sentence import Sentence, tr, verbatim
from .link_log import LinkLine, LogEnd, read_log
from .reading_process import Heading, Unreadable

__all__ = ["RecordingStream", "open_stream"]

_LONGEST = 20_000_000
"""Of a line, bytes: that with the program, and a message of a laser scan, are far below it."""

_first = msgspec.json.Decoder(Heading | Unreadable)


class RecordingStream:
    """``heading`` is what is known of the run."""

    def __init__(self, heading: Heading, reader: asyncio.StreamReader) -> None:
        self.heading = heading
        # Whether all lines were read; false for a file that is damaged.
        self.is_whole = False
        self._reader = reader

    async def lines(self) -> AsyncIterator[LinkLine]:
        """The lines of the robot link, in their order, as far as the file can be read."""
        while True:
            text = await _line(self._reader)
            for line in read_log([text]):
                if isinstance(line, LogEnd):
                    self.is_whole = True
                    return
                yield line
                break
            else:
                return


@asynccontextmanager
async def open_stream(file: BinaryIO, name: str) -> AsyncIterator[RecordingStream]:
    """
    The recording in an open file that messages call ``name``.

    Raises:
        BadInput: it is none.
    """
    process = await asyncio.create_subprocess_exec(
        *(sys.executable, "-m", "rosy_sim.recordings.reading_process", name),
        stdin=file,
        stdout=asyncio.subprocess.PIPE,
        stderr=asyncio.subprocess.DEVNULL,
        limit=_LONGEST,
        start_new_session=True,
    )
    assert process.stdout is not None
    try:
        yield RecordingStream(_heading(await _line(process.stdout), name), process.stdout)
    finally:
        with contextlib.suppress(ProcessLookupError):
            process.kill()
        await process.communicate()


async def _line(reader: asyncio.StreamReader) -> bytes:
    """The next line; one that is too long, or not whole, is as none."""
    try:
        return await reader.readuntil(b"\n")
    except (asyncio.IncompleteReadError, asyncio.LimitOverrunError):
        return b""


def _heading(line: bytes, name: str) -> Heading:
    try:
        found: Heading | Unreadable = _first.decode(line)
    except msgspec.DecodeError as error:
        # The process has ended: the file takes more than it may.
        raise BadInput(
            tr("{path} is no recording of a run, or is damaged. Choose an .mcap file that Rosy has stored.", path=name)
        ) from error
    if isinstance(found, Unreadable):
        said = found.sentence
        raise BadInput(verbatim(found.message) if said is None else Sentence(said.id, said.arguments))
    return found
