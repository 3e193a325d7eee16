"""
The path that each example drives, for its picture in the gallery.

Computed by running the example headless in its world when it is first requested, one example at a time, and kept while
the service lives and the example's file stays the same.
"""

from __future__ import annotations

import asyncio
import socket
from pathlib import Path
from typing import Any

import msgspec

from ...accounting.client import SERVICE
from ...accounting.fair_queue import FairQueue
from ...config import Limits
from ...errors import BadInput, RosyError
from ...programs.program_file import read_program
from ...run.headless_run import RunOutput, RunSettings, run_over_link
from ...sentences.sentence import tr
from ...wire.worker import Started
from ...worker.supervisor import RunningProgram, WorkerSupervisor
from ...world.world import World
from ...worlds.gallery import DEFAULT_WORLD, named_world, usable_world
from .examples import example_file

__all__ = ["ExamplePaths", "PathRecorder"]

_SECONDS = 30.0
"""Of the run, simulated: the square and the measurement are complete by then."""

_SEED = 1
"""The examples that use chance drive the same path each time."""

_APART = 0.02
"""Between two points of a path, m: less than a pixel of a picture."""


class PathRecorder:
    """Reads the positions from the lines of a trace (protocol §8)."""

    def __init__(self) -> None:
        # Room coordinates, m, at least _APART from each other.
        self.points: list[tuple[float, float]] = []

    def write(self, data: bytes, /) -> None:
        """Add the position of one line."""
        line = msgspec.json.decode(data)
        x, y = line["x"], line["y"]
        if not self.points or abs(x - self.points[-1][0]) + abs(y - self.points[-1][1]) >= _APART:
            self.points.append((round(x, 3), round(y, 3)))


class ExamplePaths:
    """Runs examples in the worker of the service, within its run queue."""

    def __init__(self, folder: Path, worker: WorkerSupervisor, queue: FairQueue, limits: Limits) -> None:
        self._folder = folder
        self._worker = worker
        self._queue = queue
        self._limits = limits
        self._one_at_a_time = asyncio.Lock()
        # By the example's name; with the time of the last change of its file.
        self._known: dict[str, tuple[int, dict[str, Any]]] = {}

    async def path(self, name: str) -> dict[str, Any] | None:
        """
        ``world`` as JSON and ``path`` as a list of x, y in m; ``None`` for an unknown example.

        Raises:
            RosyError: the example or its world cannot be read, or the worker is lost.
        """
        file = example_file(self._folder, name)
        if file is None:
            return None
        async with self._one_at_a_time:
            changed = file.stat().st_mtime_ns
            known = self._known.get(name)
            if known is not None and known[0] == changed:
                return known[1]
            program = read_program(file)
            value = program.world if program.world is not None else DEFAULT_WORLD
            json = named_world(value) if isinstance(value, str) else value
            world = usable_world(json, name, _SEED)
            found = {"world": json, "path": await self._drive(program.source, world)}
            self._known[name] = (changed, found)
            return found

    async def _drive(self, source: str, world: World) -> list[tuple[float, float]]:
        place = await self._queue.acquire(SERVICE)
        ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_STREAM)
        program: RunningProgram | None = None
        recorder = PathRecorder()
        with ours:
            try:
                async with asyncio.timeout(self._limits.worker_ready + self._limits.compile):
                    program = await self._worker.start(source, theirs)
                    program.gone.add_done_callback(lambda _: place.release())
                    answer = await asyncio.shield(program.started)
                if not isinstance(answer, Started):
                    raise BadInput(tr("The example does not compile."))
                settings = RunSettings(_SECONDS, _SEED, None, (), self._limits)
                await asyncio.to_thread(run_over_link, ours, world, settings, RunOutput(trace=recorder))
            except TimeoutError as error:
                raise RosyError(tr("The example did not start in time.")) from error
            finally:
                if program is None:
                    place.release()
                else:
                    self._worker.kill(program)
        return recorder.points
