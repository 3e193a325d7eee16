"""
Robot process: one ``rosy-robot`` that connects to a real robot, runs programs on it, and stops it at the end.

rosy-robot ends when its input ends, so also when this service is killed, and stops the wheels when alive() is not
called any more. So no failure of the service or of a page leaves a robot driving. ``protocol/README.md``, section 7.
"""

from __future__ import annotations

import asyncio
import contextlib
import socket
from collections import deque
from pathlib import Path
from typing import Literal, Protocol

import msgspec

from ..config import Limits
from ..errors import RosyError
from ..ros2.robot_bridge import bridged
from ..wire.problem import to_wire
from ..wire.robot_process import (
    CommandsLine,
    EndedLine,
    Line,
    LinkLine,
    decode_line,
    encode_alive,
    encode_record,
    encode_request,
    encode_switch,
)
from ..worker.background_process import SHUTDOWN_TIMEOUT, end_process

__all__ = ["RobotListener", "RobotProcess", "RunListener"]

_MAX_LINE = 1_000_000
"""Longest line, bytes; rosy-robot cuts texts to ten thousand characters."""


class RunListener(Protocol):
    """Receives the commands and the end of one run, on the event loop."""

    def on_commands(self, line: CommandsLine) -> None:
        """The program has sent commands."""

    def on_ended(self, line: EndedLine) -> None:
        """The program has ended."""

    def on_lost(self) -> None:
        """The connection to the robot is lost, and the run with it."""


class RobotListener(Protocol):
    """Receives what the robot does, on the event loop."""

    def on_line(self, line: Line) -> None:
        """Any line but the commands and the end of a run."""

    def on_gone(self) -> None:
        """rosy-robot has ended by itself."""


class RobotProcess:
    """Connects at once; close() stops the robot."""

    def __init__(self, executable: Path, address: str, limits: Limits, listener: RobotListener) -> None:
        self.address = address
        self._listener = listener
        # Listeners of the programs that were handed over, in their order.
        self._runs: deque[RunListener] = deque()
        # The socket over which programs' links are handed over.
        self._control_socket, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_STREAM)
        self._process: asyncio.subprocess.Process | None = None
        # Requests made before the process had started.
        self._pending: list[bytes] = []
        self._closed = False
        self._supervision = asyncio.get_running_loop().create_task(self._supervise(executable, address, limits, theirs))

    def run(self, link: socket.socket, listener: RunListener) -> None:
        """Let a program drive; rosy-robot owns its link from now on."""
        with link:
            try:
                socket.send_fds(self._control_socket, [b"\0"], [link.fileno()])
            except OSError:
                listener.on_lost()
                return
        self._runs.append(listener)
        self._send("run")

    def record(self, log: Path) -> None:
        """Write what goes to and fro in the next program's run into a file."""
        self._write(encode_record(str(log)))

    def stop(self) -> None:
        """End the program in good order; the wheels stop at once."""
        self._send("stop")

    def emergency_stop(self) -> None:
        """Stop the wheels until free()."""
        self._send("estop")

    def free(self) -> None:
        """End the emergency stop."""
        self._send("free")

    def alive(self, time: float) -> None:
        """The page was visible and connected at ``time``, s of ``CLOCK_BOOTTIME``."""
        if self._process is not None:
            self._write(encode_alive(time))

    def switch_safety(self, on: bool) -> None:
        """Switch the safety rules; rosy-robot answers with its settings."""
        self._write(encode_switch("safety", on))

    def observe(self, on: bool) -> None:
        """Whether programs tell their firings with their provenance, from the next step on."""
        self._write(encode_switch("observe", on))

    async def close(self) -> None:
        """End the process; returns when the robot has been told to stop."""
        self._closed = True
        self._pending = []
        if self._process is not None and self._process.stdin is not None:
            self._process.stdin.close()
        try:
            async with asyncio.timeout(SHUTDOWN_TIMEOUT):
                await asyncio.shield(self._supervision)
        except TimeoutError:
            self._supervision.cancel()
            with contextlib.suppress(asyncio.CancelledError):
                await self._supervision

    def _send(self, op: Literal["run", "stop", "estop", "free"]) -> None:
        self._write(encode_request(op))

    def _write(self, request: bytes) -> None:
        if self._process is None:
            self._pending.append(request)
        elif self._process.stdin is not None and not self._process.stdin.is_closing():
            self._process.stdin.write(request)

    async def _supervise(self, executable: Path, address: str, limits: Limits, theirs: socket.socket) -> None:
        """From the start of the process to its end."""
        process: asyncio.subprocess.Process | None = None
        bridge = contextlib.ExitStack()
        try:
            with theirs:
                address = await self._reached(bridge, address)
                process = await asyncio.create_subprocess_exec(
                    str(executable),
                    "hold",
                    address,
                    str(theirs.fileno()),
                    str(limits.settle),
                    str(limits.unattended),
                    stdin=asyncio.subprocess.PIPE,
                    stdout=asyncio.subprocess.PIPE,
                    pass_fds=[theirs.fileno()],
                    limit=_MAX_LINE,
                    # Ctrl-C in the terminal ends this service, which ends rosy-robot in good order.
                    start_new_session=True,
                )
            self._process = process
            assert process.stdin is not None
            assert process.stdout is not None
            if self._closed:
                process.stdin.close()
            for request in self._pending:
                process.stdin.write(request)
            while line := await process.stdout.readline():
                self._handle(decode_line(line))
        except (OSError, ValueError, msgspec.DecodeError):
            # The executable is missing or of another version, or a line is too long.
            pass
        finally:
            if process is not None:
                # The base's watchdog stops the robot of a process that is killed.
                await end_process(process)
            # First: this task may be cancelled while the bridge ends.
            self._control_socket.close()
            await asyncio.to_thread(bridge.close)
            for run in self._runs:
                run.on_lost()
            self._runs.clear()
            if not self._closed:
                self._listener.on_gone()

    async def _reached(self, bridge: contextlib.ExitStack, address: str) -> str:
        """The address for rosy-robot; a robot on ROS 2 is looked for until it is there or this process is closed."""
        while True:
            try:
                return await asyncio.to_thread(bridge.enter_context, bridged(address, lambda: not self._closed))
            except RosyError as error:
                if self._closed:
                    return address
                self._listener.on_line(LinkLine("connecting", str(error), to_wire(error.sentence)))

    def _handle(self, line: Line) -> None:
        if isinstance(line, EndedLine):
            if self._runs:
                self._runs.popleft().on_ended(line)
        elif len(self._runs) > 1:
            # The line is about the first run, which has been replaced.
            return
        elif not isinstance(line, CommandsLine):
            self._listener.on_line(line)
        elif self._runs:
            self._runs[0].on_commands(line)
