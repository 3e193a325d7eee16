"""
Background process: a module as a process of its own, which answers lines of JSON with lines of JSON.

Both ends: how its owner starts and ends it, and how it reads and answers. It ends when its input ends, also in the
middle of a run, so nothing is left of it when its owner is gone.
"""

from __future__ import annotations

import asyncio
import contextlib
import os
import sys
import threading
from collections.abc import Callable
from pathlib import Path

import msgspec

from ..config import Config, Limits

__all__ = [
    "LOWEST_PRIORITY",
    "SHUTDOWN_TIMEOUT",
    "WorkerSetup",
    "begin_reading",
    "end_process",
    "reap",
    "start_process",
    "write_line",
]

LOWEST_PRIORITY = 19
"""Of a process; ``nice``(2)."""

SHUTDOWN_TIMEOUT = 2.0
"""For a process whose input is closed to end in good order, before it is killed, s."""

_MAX_LINE = 16 * 1024 * 1024
"""Of an answer, bytes: the problems of a program quote it."""


class WorkerSetup(msgspec.Struct, frozen=True):
    """How the worker of a process is started, as in ``Config``."""

    worker: tuple[str, ...]
    sandbox: bool
    visible: list[str]
    limits: Limits
    # Added to the priority of the process.
    nice: int = 0

    @staticmethod
    def of(config: Config, nice: int = 0) -> WorkerSetup:
        """The worker of this machine."""
        return WorkerSetup(
            config.worker, config.sandbox, [str(folder) for folder in config.visible], config.limits, nice
        )

    def config(self) -> Config:
        """A configuration for workers only."""
        nowhere = Path("/")
        visible = tuple(Path(folder) for folder in self.visible)
        return Config(nowhere, nowhere, nowhere, self.worker, self.sandbox, visible, limits=self.limits)


async def start_process(module: str, *arguments: str, stderr: int | None = None) -> asyncio.subprocess.Process:
    """Start the process that a module is, for an owner with an event loop; ``stderr`` as for ``subprocess``."""
    return await asyncio.create_subprocess_exec(
        sys.executable,
        "-m",
        module,
        *arguments,
        stdin=asyncio.subprocess.PIPE,
        stdout=asyncio.subprocess.PIPE,
        stderr=stderr,
        # In a session of its own: Ctrl-C in a terminal reaches only the service, which ends it.
        start_new_session=True,
        limit=_MAX_LINE,
    )


async def reap(process: asyncio.subprocess.Process) -> int:
    """Wait for the end of a process that is to say no more, and close its pipes; returns its status."""
    status = await process.wait()
    # Newer versions of Python wait for the process only, and its descendants may have its output open.
    # No public name closes the pipes.
    process._transport.close()  # type: ignore[attr-defined]
    return status


async def end_process(process: asyncio.subprocess.Process) -> None:
    """Close the input of a process, which ends it; kill it if that takes too long, or if the caller is cancelled."""
    assert process.stdin is not None
    process.stdin.close()
    try:
        async with asyncio.timeout(SHUTDOWN_TIMEOUT):
            await reap(process)
    except (TimeoutError, asyncio.CancelledError):
        with contextlib.suppress(ProcessLookupError):
            process.kill()
        await reap(process)


def begin_reading(on_line: Callable[[bytes], None]) -> None:
    """In the process: call ``on_line`` in a thread for each line of standard input, and end the process with it."""
    threading.Thread(target=_read, args=(on_line,), daemon=True).start()


def _read(on_line: Callable[[bytes], None]) -> None:
    # Unbuffered: the interpreter cannot end while a thread holds the lock of a buffer.
    with open(sys.stdin.fileno(), "rb", buffering=0, closefd=False) as file:
        for line in file:
            on_line(line)
    # The owner is gone or wants no more. The sandbox of the worker dies with this process.
    os._exit(0)


def write_line(line: bytes) -> None:
    """In the process: send a line to the owner."""
    sys.stdout.buffer.write(line + b"\n")
    sys.stdout.buffer.flush()
