"""
A program on a real robot: the worker runs it in its sandbox, ``rosy-robot`` (rosy-hs/app) takes the simulator's place.

rosy-robot keeps speeds within limits, backs off from what the robot runs into, repeats a velocity, finds a lost robot
again, and reaches robots on ROS 1 and on a serial line too. What the program says and how it ended goes to standard
output; rosy-robot writes it.
"""

from __future__ import annotations

import signal
import socket
import subprocess
from pathlib import Path
from urllib.parse import urlsplit

from .drivers import PORTS, drivers, way
from .errors import BadInput
from .roster import usable
from .wire.problem import Problem
from .wire.worker import Refused
from .worker.blocking import BlockingWorker

__all__ = ["run_natively"]

_PATIENCE = 5.0
"""For a robot's computer to answer, s."""


def run_natively(
    worker: BlockingWorker, speaker: Path | None, source: str, address: str, seconds: float
) -> tuple[list[Problem], int]:
    """
    Compile a program and let it drive; returns what compiling found and the exit status.

    Raises:
        BadInput: the address is none, nobody answers there, or somebody drives already.
    """
    speaker = usable(speaker, address)
    for driver in drivers():
        if way(driver.address) == way(address):
            raise BadInput(f"Somebody on this machine drives the robot at {address} already; ./rosy estop stops it.")
    _answers(address)
    ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_STREAM)
    with ours:
        answer = worker.run(source, theirs)
        if isinstance(answer, Refused):
            return answer.problems, 1
        command = [str(speaker), address, str(ours.fileno()), str(seconds)]
        with subprocess.Popen(command, pass_fds=[ours.fileno()]) as process:
            ours.close()
            before = signal.signal(signal.SIGTERM, lambda _number, _frame: process.terminate())
            try:
                return answer.problems, _status(process)
            finally:
                signal.signal(signal.SIGTERM, before)


def _status(process: subprocess.Popen[bytes]) -> int:
    """The exit status. Ctrl-C reaches rosy-robot too, which stops the robot first: we wait for it."""
    while True:
        try:
            return process.wait()
        except KeyboardInterrupt:
            continue


def _answers(address: str) -> None:
    """Look whether anybody is there, before a program is compiled for nobody."""
    parts = urlsplit(address)
    if parts.scheme in PORTS and parts.hostname:
        try:
            port = parts.port or PORTS[parts.scheme]
            socket.create_connection((parts.hostname, port), _PATIENCE).close()
        except (OSError, ValueError) as error:
            raise BadInput(f"No robot answers at {address}; is it on, and does its server run?") from error
