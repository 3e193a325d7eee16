"""
Headless run on a real robot: the worker runs the program in its sandbox, ``rosy-robot`` (rosy-hs/app) connects it.

rosy-robot keeps speeds within limits, backs off from what the robot runs into, repeats a velocity, finds a lost robot
again, and reaches robots on ROS 1 and on a serial line too. What the program says and how it ended goes to standard
output; rosy-robot writes it.
"""

from __future__ import annotations

import contextlib
import signal
import socket
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from urllib.parse import urlsplit

from ..errors import BadInput, RobotMissing
from ..ros2.robot_bridge import bridged
from ..sentences.sentence import tr
from ..sentences.wording import in_terminal
from ..wire.problem import Problem
from ..wire.worker import Refused
from ..worker.blocking_worker import BlockingWorker
from .driver_locks import PORTS, active_drivers, canonical_address
from .robot_configuration import check_address
from .robot_parts import missing_parts_problem

__all__ = ["run_on_robot"]

_CONNECT_TIMEOUT = 5.0
"""For a robot's computer to answer, s."""

_ENDINGS = (signal.SIGTERM, signal.SIGINT)
"""Signals that end a run; rosy-robot gets them as SIGTERM."""


def run_on_robot(
    worker: BlockingWorker,
    robot_executable: Path | None,
    source: str,
    address: str,
    seconds: float,
    log: Path | None = None,
) -> tuple[list[Problem], int]:
    """
    Compile a program and let it drive; returns what compiling found and the exit status. ``log`` gets the lines of the
    robot link.

    Raises:
        BadInput: the address is not valid, or another process drives the robot.
        RobotMissing: the address does not answer.
        RosyError: what speaks ROS 2 does not start.
    """
    robot_executable = check_address(robot_executable, address)
    with bridged(address) as reached:
        return _run(worker, robot_executable, source, reached, seconds, log)


def _run(
    worker: BlockingWorker, robot_executable: Path, source: str, address: str, seconds: float, log: Path | None
) -> tuple[list[Problem], int]:
    for driver in active_drivers():
        if canonical_address(driver.address) == canonical_address(address):
            raise BadInput(
                tr(
                    "Another program here drives the robot at {address} already; ./rosy estop stops it.",
                    address=address,
                )
            )
    _check_reachable(address)
    ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_STREAM)
    with ours:
        answer = worker.run(source, theirs)
        if isinstance(answer, Refused):
            return answer.problems, 1
        missing = missing_parts_problem(address, answer.uses)
        if missing is not None:
            return [*answer.problems, missing], 1
        descriptor, settle = str(ours.fileno()), str(worker.limits.settle)
        recording = ["--record", str(log)] if log is not None else []
        command = [str(robot_executable), *recording, address, descriptor, str(seconds), settle]
        with _forwarded_signals() as forward, subprocess.Popen(command, pass_fds=[ours.fileno()]) as process:
            ours.close()
            forward(process)
            return answer.problems, _status(process)


@contextlib.contextmanager
def _forwarded_signals() -> Iterator[Callable[[subprocess.Popen[bytes]], None]]:
    """
    Ask a process to end when this one is asked, by SIGTERM: SIGINT to this process alone does not reach rosy-robot, and
    a shell's background jobs ignore it.

    The handlers are in place before the process starts. The value names the process; a request that came before it is
    passed on then.
    """
    started: list[subprocess.Popen[bytes]] = []
    requests = 0

    def handle(_number: int, _frame: object) -> None:
        nonlocal requests
        requests += 1
        for process in started:
            process.terminate()

    def forward(process: subprocess.Popen[bytes]) -> None:
        started.append(process)
        if requests:
            process.terminate()

    before = {number: signal.signal(number, handle) for number in _ENDINGS}
    try:
        yield forward
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


def _status(process: subprocess.Popen[bytes]) -> int:
    """The exit status of rosy-robot, which stops the robot before it ends and handles two requests to end as one."""
    status = process.wait()
    if status >= 0:
        return status
    name = signal.Signals(-status).name
    print(
        "rosy: "
        + in_terminal(
            tr(
                "The process that drives the robot was ended by {name} before it could stop the robot. "
                "Look at the robot; ./rosy estop stops what still drives it.",
                name=name,
            )
        ),
        file=sys.stderr,
    )
    return RobotMissing.exit_status


def _check_reachable(address: str) -> None:
    """Check that the robot's computer answers, before the program is compiled."""
    parts = urlsplit(address)
    if parts.scheme in PORTS and parts.hostname:
        try:
            port = parts.port or PORTS[parts.scheme]
            socket.create_connection((parts.hostname, port), _CONNECT_TIMEOUT).close()
        except (OSError, ValueError) as error:
            raise RobotMissing(address) from error
