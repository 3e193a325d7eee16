"""
Recordings that one page may open: those of its own runs on real robots, and the file that it uploaded last.
"""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import Callable
from pathlib import Path
from typing import BinaryIO

from ...accounting.slots import Slots
from ...errors import BadInput
from ...recordings.recorded_run import RecordedRun
from ...recordings.recording_stream import RecordingStream, open_stream
from ...sentences.sentence import Sentence, tr
from ...wire import page

__all__ = ["PageRecordings", "UploadedFile"]

_MOST_RUNS = 20
"""Runs whose recordings can be opened by their number; a page keeps as many."""


class UploadedFile:
    """
    An uploaded file without a name, and the bytes of it that count for a client; close() removes both.

    Args:
        file: open and empty.
        space: bytes of all uploaded files.
        client: whom they are charged to.
    """

    def __init__(self, file: BinaryIO, space: Slots, client: str) -> None:
        self.file = file
        self.size = 0
        self._space = space
        self._client = client

    def reserve(self, size: int) -> bool:
        """Make room for so many more bytes; returns whether there was."""
        if not self._space.take(self._client, size):
            return False
        self.size += size
        return True

    def close(self) -> None:
        """Remove the file."""
        self.file.close()
        if self.size:
            self._space.free(self._client, self.size)
            self.size = 0


class PageRecordings:
    """``send`` puts a message into the page's outbox."""

    def __init__(self, send: Callable[[page.Answer], None]) -> None:
        self._send = send
        self._made: dict[int, Path] = {}
        # The file that the page uploaded last, and its name there.
        self._sent: tuple[UploadedFile, str] | None = None
        self._opening: asyncio.Task[None] | None = None

    def add(self, run: int, path: Path) -> None:
        """Add the recording of a run of this page."""
        self._made[run] = path
        for oldest in list(self._made)[:-_MOST_RUNS]:
            del self._made[oldest]
        self._send(page.RunRecorded(run, str(path)))

    def receive(self, file: UploadedFile, name: str) -> None:
        """Keep an uploaded file in place of the one before, which is closed."""
        self._forget_sent()
        self._sent = file, name

    def open(
        self,
        request: page.Replay,
        begin: Callable[[page.Replay, RecordingStream], RecordedRun],
        fail: Callable[[int, Sentence], None],
    ) -> None:
        """Call ``begin`` when the recording is open, or ``fail`` with the number of the run."""
        self.cancel()
        self._opening = asyncio.get_running_loop().create_task(self._open(request, begin, fail))

    def cancel(self) -> None:
        """Cancel opening and playback."""
        if self._opening is not None:
            self._opening.cancel()

    async def close(self) -> None:
        """Cancel everything and close the uploaded file."""
        self.cancel()
        if self._opening is not None:
            with contextlib.suppress(asyncio.CancelledError):
                await self._opening
        self._forget_sent()

    async def _open(
        self,
        request: page.Replay,
        begin: Callable[[page.Replay, RecordingStream], RecordedRun],
        fail: Callable[[int, Sentence], None],
    ) -> None:
        try:
            with contextlib.ExitStack() as files:
                file, name = self._file(request, files)
                async with open_stream(file, name) as stream:
                    await begin(request, stream).over.wait()
        except BadInput as error:
            fail(request.run, error.sentence)

    def _file(self, request: page.Replay, files: contextlib.ExitStack) -> tuple[BinaryIO, str]:
        if request.of is None:
            if self._sent is None:
                raise BadInput(tr("The recording has not arrived. Open it again."))
            file, name = self._sent
            # Another file description: a process that reads the file still has a place of its own in it.
            return files.enter_context(Path(f"/proc/self/fd/{file.file.fileno()}").open("rb")), name
        path = self._made.get(request.of)
        if path is None:
            raise BadInput(tr("The recording of this run is not known any more. Open its file."))
        try:
            return files.enter_context(path.open("rb")), path.name
        except OSError as error:
            raise BadInput(tr("{path} cannot be read: {why}.", path=path, why=error.strerror or "")) from error

    def _forget_sent(self) -> None:
        if self._sent is not None:
            self._sent[0].close()
            self._sent = None
