"""
Recorder of the runs that pages make on real robots.

``rosy-robot`` writes the log of a run. Afterwards a process of its own makes the MCAP file, at the lowest priority, and
says in the service's terminal where it is. The page of the run is told as well; only the owner may read the folder.
"""

from __future__ import annotations

import asyncio
import sys
from collections.abc import Callable
from pathlib import Path

from ..errors import BadInput
from ..recordings.mcap_file import RunDetails
from ..recordings.recording_folder import PendingRecording, RecordingFolder
from ..sentences.sentence import Sentence

__all__ = ["RunRecorder"]


_CLOSE_TIMEOUT = 10.0
"""For the files of all runs that are over, s."""


class RunRecorder:
    """Lives as long as the service."""

    def __init__(self, folder: Path, tell: Callable[[Sentence], None]) -> None:
        self._path = folder
        self._folder = RecordingFolder(folder)
        self._tell = tell
        self._finishing: set[asyncio.Task[None]] = set()

    def begin(self, details: RunDetails) -> PendingRecording | None:
        """A place for a run's recording. The run goes on without one when there is none, which is told."""
        try:
            return self._folder.begin(details)
        except BadInput as error:
            self._tell(error.sentence)
            return None

    def finish(self, pending: PendingRecording, ended: str, on_made: Callable[[Path], None] = lambda _: None) -> None:
        """Make the file of a run that is over; its log is whole. ``on_made`` is called when there is one."""
        task = asyncio.get_running_loop().create_task(self._finish(pending, ended, on_made))
        self._finishing.add(task)
        task.add_done_callback(self._finishing.discard)

    async def recover(self) -> None:
        """Makes the files of runs whose Rosy was killed, and says where they are."""
        if any(self._path.glob("*.log")):
            await self._convert()

    async def close(self) -> None:
        """Returns when all files are made, or it takes too long; what is left is made after the next run."""
        if self._finishing:
            await asyncio.wait(set(self._finishing), timeout=_CLOSE_TIMEOUT)

    async def _finish(self, pending: PendingRecording, ended: str, on_made: Callable[[Path], None]) -> None:
        if await self._convert(pending.log.stem, ended) == 0 and pending.path.exists():
            on_made(pending.path)

    async def _convert(self, *arguments: str) -> int:
        command = [sys.executable, "-m", "rosy_sim.recordings", str(self._path), *arguments]
        # Ctrl-C in the terminal ends the service and not the recording.
        process = await asyncio.create_subprocess_exec(
            *command, stdin=asyncio.subprocess.DEVNULL, start_new_session=True
        )
        return await process.wait()
