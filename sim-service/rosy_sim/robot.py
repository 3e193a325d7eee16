"""
``./rosy run --robot ws://HOST:9090``: a program in its sandbox drives a real robot behind a rosbridge server.

The program hears what it would hear from the simulator, 50 times a second by the clock on the wall; nothing waits
for it but its own next step. Whatever ends the run, the robot is told to stop first.
"""

from __future__ import annotations

import contextlib
import queue
import socket
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from urllib.parse import parse_qs, urlsplit

from websockets.exceptions import ConnectionClosed, InvalidHandshake, InvalidURI
from websockets.sync.client import ClientConnection, connect

from .config import Limits
from .errors import BadInput
from .run import Order, Outcome
from .sentences import broken_link, died, lost_robot, stuck
from .wire.link import Ended, LinkError, Ready, Settled, SimulatorLink, start_line, step_line, stop_line
from .wire.problem import Problem
from .wire.robot import RealRobot, Ros
from .wire.worker import Refused
from .worker.blocking import BlockingWorker
from .world.events import Command, Say, Velocity
from .world.facts import STEP

__all__ = ["robot_address", "run_on_robot"]

_PATIENCE = 5.0
"""For the robot to answer, s."""

_STILL = Velocity(0.0, 0.0)


def robot_address(url: str) -> tuple[str, Ros]:
    """
    The address of a robot and the ROS it speaks.

    Raises:
        BadInput: it is none that this command can reach.
    """
    parts = urlsplit(url)
    if parts.scheme not in ("ws", "wss") or not parts.hostname:
        raise BadInput(
            f"{url} is not a robot that ./rosy run can reach; it reaches a rosbridge server, like ws://robot:9090."
        )
    ros = parse_qs(parts.query).get("ros", ["1"])[-1]
    if ros not in ("1", "2"):
        raise BadInput(f"{url} should end in ?ros=1 or ?ros=2.")
    return parts._replace(query="").geturl(), 2 if ros == "2" else 1


class _Stuck(Exception):
    """No answer from the program within the limit."""


class _Died(Exception):
    """The program closed the link without `ended`."""


@contextmanager
def _reaching(address: str) -> Iterator[ClientConnection]:
    try:
        connection = connect(address, open_timeout=_PATIENCE, close_timeout=1, compression=None, max_size=1 << 20)
    except (OSError, InvalidHandshake, InvalidURI) as error:
        raise BadInput(f"No robot answers at {address}; is it on, and does its rosbridge server run?") from error
    with connection:
        yield connection


def run_on_robot(
    worker: BlockingWorker, source: str, url: str, order: Order, limits: Limits, say: Callable[[str], None]
) -> Outcome:
    """Compile a program, let it drive the robot, and say how it ended."""
    address, ros = robot_address(url)
    with _reaching(address) as connection:
        ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_STREAM)
        with ours:
            answer = worker.run(source, theirs)
            if isinstance(answer, Refused):
                return Outcome("refused", answer.problems)
            return _Drive(ours, connection, RealRobot(ros), limits, say).run(worker, order)


class _Drive:
    """A program at one end, a robot at the other."""

    def __init__(
        self,
        link: socket.socket,
        connection: ClientConnection,
        robot: RealRobot,
        limits: Limits,
        say: Callable[[str], None],
    ) -> None:
        self._socket = link
        self._connection = connection
        self._robot = robot
        self._limits = limits
        self._say = say
        self._link = SimulatorLink()
        # Sensor lines that have arrived since the last step; None when the robot is gone.
        self._heard: queue.SimpleQueue[bytes | None] = queue.SimpleQueue()
        self._step = 0
        self._ended: Ended | None = None

    def run(self, worker: BlockingWorker, order: Order) -> Outcome:
        began = time.perf_counter()
        listener = threading.Thread(target=self._listen, daemon=True)
        listener.start()
        try:
            outcome = self._drive(order)
        except _Stuck:
            worker.kill()
            gone = worker.gone()
            outcome = self._over("stuck", stuck(gone.firing if gone else None, self._limits.settle, self._time))
        except _Died:
            outcome = self._over("error", died(worker.gone(), self._time))
        except LinkError as error:
            worker.kill()
            outcome = self._over("error", broken_link(str(error), self._time))
        except (ConnectionClosed, OSError):
            worker.kill()
            outcome = self._over("error", lost_robot(self._time))
        finally:
            # Also when Ctrl-C ends us.
            with contextlib.suppress(ConnectionClosed, OSError):
                self._send(_STILL)
        outcome.steps, outcome.wall = self._step, time.perf_counter() - began
        return outcome

    @property
    def _time(self) -> float:
        return self._step / 50

    def _over(self, ended: str, problem: Problem) -> Outcome:
        return Outcome("stuck" if ended == "stuck" else "error", [problem])

    def _listen(self) -> None:
        try:
            for text in self._connection:
                line = self._robot.sensed(text)
                if line is not None:
                    self._heard.put(line)
        finally:
            self._heard.put(None)

    def _drive(self, order: Order) -> Outcome:
        self._socket.settimeout(self._limits.ready)
        self._socket.sendall(start_line(order.seed, False))
        self._until(lambda message: isinstance(message, Ready))
        for text in self._robot.greetings():
            self._connection.send(text)
        self._socket.settimeout(self._limits.settle)
        due = time.monotonic()
        while self._time < order.seconds:
            self._link.step = self._step
            self._socket.sendall(self._sensed() + step_line(self._step))
            self._until(lambda message: isinstance(message, Settled | Ended))
            if self._ended is not None:
                return self._program_ended(self._ended)
            self._step += 1
            due = max(due + STEP, time.monotonic() - STEP)
            time.sleep(max(0.0, due - time.monotonic()))
        self._socket.sendall(stop_line())
        return Outcome("time")

    def _program_ended(self, ended: Ended) -> Outcome:
        if ended.how == "error":
            return Outcome("error", [ended.problem] if ended.problem is not None else [died(None, self._time)])
        return Outcome("done")

    def _sensed(self) -> bytes:
        lines: list[bytes] = []
        while not self._heard.empty():
            line = self._heard.get()
            if line is None:
                raise ConnectionAbortedError
            lines.append(line)
        return b"".join(lines)

    def _until(self, wanted: Callable[[object], bool]) -> None:
        """Obey the program until it says something wanted."""
        found = False
        deadline = time.monotonic() + (self._socket.gettimeout() or 0.0)
        while not found:
            try:
                data = self._socket.recv(65536)
            except TimeoutError as error:
                raise _Stuck from error
            if not data:
                raise _Died
            for message in self._link.feed(data):
                found = found or wanted(message)
                if isinstance(message, Ended):
                    self._ended = message
                elif not isinstance(message, Ready | Settled):
                    self._send(message)
            if not found and time.monotonic() > deadline:
                raise _Stuck

    def _send(self, command: Command) -> None:
        if isinstance(command, Say):
            self._say(command.text)
        text = self._robot.command(command)
        if text is not None:
            self._connection.send(text)
