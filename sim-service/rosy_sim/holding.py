"""
A real robot in a page's hands: ``rosy-robot`` as a process of its own, which stops the robot when it loses us.

It ends when its input does, so also when this service is killed; it stands still when nobody says that they watch. So
nothing that happens to us or to a page leaves a robot driving.
"""

from __future__ import annotations

import asyncio
import contextlib
import socket
from collections import deque
from pathlib import Path
from typing import Literal, Protocol

import msgspec

from .wire.holder import EndedLine, Line, ask, read_line

__all__ = ["Holding", "Listener", "RunListener"]

_LINE = 1_000_000
"""Longest line, bytes; what a program says is cut to ten thousand characters there."""

_FAREWELL = 2.0
"""For rosy-robot to stop the robot and end, before it is killed, s."""


class RunListener(Protocol):
    """Who is told how a run ended; called on the loop."""

    def on_ended(self, line: EndedLine) -> None:
        """It has."""

    def on_lost(self) -> None:
        """The robot is no longer ours, so it has."""


class Listener(Protocol):
    """Who is told what the robot does; called on the loop."""

    def on_line(self, line: Line) -> None:
        """Anything but the end of a run."""

    def on_gone(self) -> None:
        """rosy-robot has ended without being asked."""


class Holding:
    """Connects at once; close() leaves the robot standing."""

    def __init__(self, speaker: Path, address: str, listener: Listener) -> None:
        self._listener = listener
        # Who waits for the ends of the programs that were handed over, in their order.
        self._runs: deque[RunListener] = deque()
        # Over this socket programs' links are handed over.
        self._doors, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_STREAM)
        self._process: asyncio.subprocess.Process | None = None
        # Asked for before the process was there.
        self._early: list[bytes] = []
        self._closed = False
        self._keeper = asyncio.get_running_loop().create_task(self._keep(speaker, address, theirs))

    def run(self, link: socket.socket, listener: RunListener) -> None:
        """Let a program drive; its link is rosy-robot's from now on."""
        with link:
            try:
                socket.send_fds(self._doors, [b"\0"], [link.fileno()])
            except OSError:
                listener.on_lost()
                return
        self._runs.append(listener)
        self._ask("run")

    def stop(self) -> None:
        """End the program in good order; the wheels stand at once."""
        self._ask("stop")

    def emergency_stop(self) -> None:
        """The wheels stand until free()."""
        self._ask("estop")

    def free(self) -> None:
        """The emergency stop is over."""
        self._ask("free")

    def alive(self) -> None:
        """Somebody watches."""
        self._ask("alive")

    async def close(self) -> None:
        """Let go; returns when the robot has been told to stand."""
        self._closed = True
        self._early = []
        if self._process is not None and self._process.stdin is not None:
            self._process.stdin.close()
        try:
            async with asyncio.timeout(_FAREWELL):
                await asyncio.shield(self._keeper)
        except TimeoutError:
            self._keeper.cancel()
            with contextlib.suppress(asyncio.CancelledError):
                await self._keeper

    def _ask(self, op: Literal["run", "stop", "estop", "free", "alive"]) -> None:
        if self._process is None:
            self._early.append(ask(op))
        elif self._process.stdin is not None and not self._process.stdin.is_closing():
            self._process.stdin.write(ask(op))

    async def _keep(self, speaker: Path, address: str, theirs: socket.socket) -> None:
        """From the start of the process to its end."""
        process: asyncio.subprocess.Process | None = None
        try:
            with theirs:
                process = await asyncio.create_subprocess_exec(
                    str(speaker),
                    "hold",
                    address,
                    str(theirs.fileno()),
                    stdin=asyncio.subprocess.PIPE,
                    stdout=asyncio.subprocess.PIPE,
                    pass_fds=[theirs.fileno()],
                    limit=_LINE,
                    # Ctrl-C in our terminal is for us: we let go of the robot in good order.
                    start_new_session=True,
                )
            self._process = process
            assert process.stdin is not None
            assert process.stdout is not None
            if self._closed:
                process.stdin.close()
            for early in self._early:
                process.stdin.write(early)
            while line := await process.stdout.readline():
                self._hear(read_line(line))
        except (OSError, ValueError, msgspec.DecodeError):
            # Not there, or of another version; a line without end.
            pass
        finally:
            if process is not None:
                await _reap(process)
            self._doors.close()
            for run in self._runs:
                run.on_lost()
            self._runs.clear()
            if not self._closed:
                self._listener.on_gone()

    def _hear(self, line: Line) -> None:
        if isinstance(line, EndedLine):
            if self._runs:
                self._runs.popleft().on_ended(line)
        elif len(self._runs) <= 1:
            # With two, what is told is of the first, which nobody follows any more.
            self._listener.on_line(line)


async def _reap(process: asyncio.subprocess.Process) -> None:
    """It ends by itself once its input has; one that does not is killed, and the base's watchdog stops the robot."""
    assert process.stdin is not None
    process.stdin.close()
    try:
        async with asyncio.timeout(_FAREWELL):
            await process.wait()
    except (TimeoutError, asyncio.CancelledError):
        with contextlib.suppress(ProcessLookupError):
            process.kill()
        await process.wait()
