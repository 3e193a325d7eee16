"""
Bridge to a robot on ROS 2, for ``rosy-robot``: starts the process of the bridge, waits until the robot is found, and
knows its address there.

The bridge is started again, at the same port, when it has ended by itself: ``rosy-robot`` tells that the robot was
lost, and finds it again.
"""

from __future__ import annotations

import contextlib
import json
import queue
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from importlib.util import find_spec

from ..errors import BadInput, RobotMissing, RosyError
from ..robot_description import description, known_robots
from ..sentences.sentence import tr
from .profiles import FoundRobot, find_robots
from .transports.address import Ros2Address, parse_ros2_address

__all__ = ["bridged", "check_installed", "recognised", "robot_address"]

_Topics = tuple[dict[str, str], dict[str, list[str]]]
"""Topics with their types, and with the computers that publish them."""

_DISCOVERY = 10.0
"""
For a robot to be found, s. Participants of DDS announce themselves every 3 s at first (Fast DDS), and every 30 s
later.
"""

_POLL = 0.1
"""Polling interval while the robot is not discovered, s."""


@contextmanager
def bridged(address: str, is_wanted: Callable[[], bool] = lambda: True) -> Iterator[str]:
    """
    The address at which ``rosy-robot`` reaches a robot, as long as it is used: one on ROS 2 gets a bridge, and a
    profile by what its topics are. Other addresses stay as they are.

    Raises:
        BadInput: there are several robots, or one that Rosy does not know.
        RobotMissing: there is none.
        RosyError: the bridge does not start.
    """
    given = parse_ros2_address(address)
    if given is None:
        yield address
        return
    check_installed()
    bridge = _Bridge(given)
    try:
        yield bridge.address(is_wanted)
    finally:
        bridge.close()


def check_installed(installs: str = "./rosy run --robot ros2:") -> None:
    """
    Whether this computer speaks ROS 2; ``installs`` is the command that sees to it.

    Raises:
        BadInput: it does not.
    """
    if any(find_spec(part) is None for part in ("cyclonedds", "zenoh", "foxglove")):
        raise BadInput(
            tr(
                "The part of Rosy that speaks ROS 2 is not installed yet; {command} installs it.",
                command=installs,
            )
        )


class _Bridge:
    def __init__(self, given: Ros2Address) -> None:
        self._given = given
        self._closed = False
        self._port = 0
        # None when the process has ended before it listened.
        self._news: queue.SimpleQueue[_Topics | None] = queue.SimpleQueue()
        self._process = self._start()
        self._following = threading.Thread(target=self._follow, daemon=True)
        self._following.start()

    def address(self, is_wanted: Callable[[], bool]) -> str:
        """With options for what was found; blocks until it is."""
        until = time.monotonic() + _DISCOVERY
        topics: Mapping[str, str] = {}
        found = None
        while found is None and time.monotonic() < until and is_wanted():
            with contextlib.suppress(queue.Empty):
                news = self._news.get(timeout=_POLL)
                if news is None:
                    raise RosyError(tr("The process that speaks ROS 2 did not start."))
                topics, hosts = news
                found = recognised(self._given, topics, hosts)
        if found is None:
            raise _unrecognised(self._given, topics)
        place = robot_address(self._given, found)
        return replace(place, options=(*place.options, ("bridge", str(self._port)))).text()

    def close(self) -> None:
        """What it drives stands."""
        self._closed = True
        self._end()
        self._following.join()
        self._process.wait()

    def _end(self) -> None:
        assert self._process.stdin is not None
        self._process.stdin.close()

    def _start(self) -> subprocess.Popen[str]:
        arguments = [str(self._given.domain), self._given.host or "", str(self._port)]
        return subprocess.Popen(
            [sys.executable, "-m", "rosy_sim.ros2.bridge_process", *arguments],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
            # Ctrl-C in the terminal ends rosy-robot first, whose last word the bridge passes on.
            start_new_session=True,
        )

    def _follow(self) -> None:
        """Takes its lines, and starts it again when it has ended by itself."""
        while True:
            assert self._process.stdout is not None
            for line in self._process.stdout:
                word, _, rest = line.partition(" ")
                if word == "port":
                    self._port = int(rest)
                elif word == "topics":
                    topics, hosts = json.loads(rest)
                    self._news.put((topics, hosts))
            self._process.stdout.close()
            if self._closed or not self._port:
                self._news.put(None)
                return
            self._end()
            self._process.wait()
            self._process = self._start()
            if self._closed:
                # close() has seen the process before this one.
                self._end()


def recognised(given: Ros2Address, topics: Mapping[str, str], hosts: Mapping[str, Sequence[str]]) -> FoundRobot | None:
    """
    The robot that an address means; ``None`` when it is not there yet. One that the address names need not be
    recognised.

    Raises:
        BadInput: it may mean several.
    """
    named = dict(given.options).get("robot")
    if named is not None:
        return FoundRobot(named, given.namespace)
    found = [r for r in find_robots(topics, hosts) if not given.namespace or r.namespace == given.namespace]
    if len(found) > 1:
        places = [f"{robot_address(given, robot).bare()} ({description(robot.kind)['title']})" for robot in found]
        raise BadInput(
            tr(
                "There are several robots at {address}; choose one: {robots}.",
                address=given.bare(),
                robots=", ".join(places),
            )
        )
    return found[0] if found else None


def robot_address(given: Ros2Address, robot: FoundRobot) -> Ros2Address:
    """The address of a robot that was found at another one, with the same options."""
    options = {**dict(robot.options), "robot": robot.kind, **dict(given.options)}
    return Ros2Address(given.domain, robot.host or given.host, robot.namespace, tuple(options.items()))


def _unrecognised(given: Ros2Address, topics: Mapping[str, str]) -> RosyError:
    if not topics:
        return RobotMissing(
            given.bare(),
            tr(
                "No robot is found at {address}: is it on, in the same network, and in this domain of ROS 2?",
                address=given.bare(),
            ),
        )
    return BadInput(
        tr(
            "There is ROS 2 at {address}, and no robot that Rosy knows by its topics. "
            "Say which one it is, such as {example}.",
            address=given.bare(),
            example=f"{given.bare()}?robot={known_robots()[0]}",
        )
    )
