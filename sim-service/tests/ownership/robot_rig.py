"""
Robots that are not there, for asyncio: the emulators of the robots' suite (rosy-hs/test-robots/peers and
rosy-hs/test-ros/peers), and a page that drives one.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
import os
import signal
import subprocess
from collections.abc import AsyncIterator, Callable
from contextlib import AbstractAsyncContextManager, asynccontextmanager
from pathlib import Path

import pytest

from rosy_sim.ownership.driver_locks import active_drivers, canonical_address
from rosy_sim.web.service import Service

from ..conftest import PATIENCE
from ..ports import kept_port
from ..ros2.bases import place
from ..web.page_client import Page

__all__ = ["LIMIT", "Rig", "Robot", "kobuki", "looking", "ros2", "rosbridge", "rospy", "zenoh"]

LIMIT = 0.7
"""Within so many s a robot that is not driven any more stands."""

HASKELL = Path(__file__).resolve().parents[3] / "rosy-hs"

PYTHON = "/usr/bin/python3"
"""Debian's, which has rospy."""

ODOMETRY = json.dumps(
    {
        "child_frame_id": "base_footprint",
        "pose": {
            "pose": {"orientation": {"x": 0.0, "y": 0.0, "z": 0.0, "w": 1.0}, "position": dict.fromkeys("xyz", 0.0)}
        },
        "twist": {"twist": {"linear": dict.fromkeys("xyz", 0.0), "angular": dict.fromkeys("xyz", 0.0)}},
    }
)


TWIST = 'got /mobile_base/commands/velocity {{"linear": {{"x": {},'
"""How both tell of a velocity."""


class Robot:
    """What it says is kept; ``address`` is how Rosy reaches it."""

    def __init__(self, process: asyncio.subprocess.Process) -> None:
        self.process = process
        self.address = ""
        self.said: list[str] = []
        # How it says that it was told a speed.
        self.told = "control {:.3f} "

    def ask(self, *words: str) -> None:
        assert self.process.stdin is not None
        self.process.stdin.write((" ".join(words) + "\n").encode())

    async def says(self, wanted: Callable[[str], bool]) -> str:
        """The next line that fits; waits long for it."""
        assert self.process.stdout is not None
        async with asyncio.timeout(PATIENCE):
            while True:
                line = (await self.process.stdout.readline()).decode().strip()
                assert line or not self.process.stdout.at_eof(), self.said
                self.said.append(line)
                if wanted(line):
                    return line

    async def begins(self, start: str) -> str:
        """What follows such a beginning of a line."""
        return (await self.says(lambda line: line.startswith(start))).removeprefix(start)

    async def moves(self, speed: float) -> None:
        await self.begins(self.told.format(speed))

    async def marked(self) -> None:
        """From now on it counts the seconds until it stands."""
        self.ask("mark")
        await self.begins("marked")

    async def stands(self) -> float:
        """Seconds from the mark to when it was told to stand, or its watchdog stopped it, by its own clock."""
        return float(await self.begins("stood "))

    def bumped(self) -> None:
        """Its left bumper is pressed."""
        self.ask("send", "/mobile_base/events/bumper", '{"bumper": 0, "state": 1}')

    def released(self) -> None:
        """It is not any more."""

    async def unplugged(self, driver: int) -> None:
        """Its cable is pulled: nothing goes to and fro, and nothing is closed. A driver that stands still looks so."""
        os.kill(driver, signal.SIGSTOP)

    async def plugged(self, driver: int) -> None:
        """And in again."""
        os.kill(driver, signal.SIGCONT)


class SerialRobot(Robot):
    """At the end of a pseudo-terminal, which can be pulled for real."""

    def bumped(self) -> None:
        self.ask("bump", "4")

    def released(self) -> None:
        self.ask("bump", "0")

    async def unplugged(self, driver: int) -> None:  # noqa: ARG002
        # Yujin documents no timeout of the firmware. This one has that of kobuki_node, so that there is one to be seen.
        self.ask("timeout", "0.6")
        self.ask("unplug")

    async def plugged(self, driver: int) -> None:  # noqa: ARG002
        self.ask("plug")


@asynccontextmanager
async def _started(kind: type[Robot], *command: str, **environment: str) -> AsyncIterator[Robot]:
    process = await asyncio.create_subprocess_exec(
        *command,
        stdin=asyncio.subprocess.PIPE,
        stdout=asyncio.subprocess.PIPE,
        env={**os.environ, **environment},
    )
    try:
        yield kind(process)
    finally:
        with contextlib.suppress(ProcessLookupError):
            process.kill()
        # To its last word: a pipe that is not read to its end is never closed.
        await process.communicate()


@asynccontextmanager
async def kobuki(folder: Path) -> AsyncIterator[Robot]:
    """A base on its cable."""
    emulator = str(HASKELL / "test-robots" / "peers" / "kobuki.py")
    async with _started(SerialRobot, PYTHON, emulator, str(folder / "kobuki")) as robot:
        # A busy machine may lose the robot for a moment: then it drives on.
        robot.address = f"serial:{await robot.begins('plugged ')}?rearm=off"
        yield robot


@asynccontextmanager
async def rosbridge(folder: Path) -> AsyncIterator[Robot]:
    """A base behind a strict rosbridge server."""
    _ros_in(folder)
    async with _started(Robot, PYTHON, str(HASKELL / "test-robots" / "peers" / "rosbridge.py"), "1") as robot:
        robot.address = f"ws://127.0.0.1:{await robot.begins('port ')}?safety=off&rearm=off"
        robot.told = TWIST
        robot.ask("stream", "/odom", ODOMETRY)
        yield robot


@asynccontextmanager
async def rospy(folder: Path) -> AsyncIterator[Robot]:
    """A base on ROS 1, with a master of its own."""
    _ros_in(folder)
    port = kept_port()
    uri = f"http://127.0.0.1:{port}"
    ros = {"ROS_MASTER_URI": uri, "ROS_IP": "127.0.0.1", "ROS_HOME": f"{folder}/home", "PYTHONPATH": str(folder)}
    peer = str(HASKELL / "test-ros" / "peers" / "peer.py")
    async with (
        _started(Robot, "/usr/bin/rosmaster", "--core", "-p", str(port), "-w", "3", **ros),
        _started(Robot, PYTHON, peer, "mobile_base", **ros, PYTHONUNBUFFERED="1") as robot,
    ):
        robot.address = f"ros://127.0.0.1:{port}?safety=off&rearm=off"
        robot.told = TWIST
        await robot.begins("ready")
        robot.ask("pub", "/odom", "nav_msgs/Odometry")
        robot.ask("pub", "/mobile_base/events/bumper", "kobuki_msgs/BumperEvent")
        robot.ask("watchdog", "/mobile_base/commands/velocity")
        robot.ask("stream", "/odom", ODOMETRY)
        await robot.begins("streaming")
        yield robot


@asynccontextmanager
async def ros2(_folder: Path, transport: str = "DDS") -> AsyncIterator[Robot]:
    """A base on ROS 2, with another vendor's DDS and without a limit of its own."""
    with place(transport) as where:
        async with _started(Robot, *where.command, "", "turtlebot3", "stamped", "no_watchdog") as robot:
            robot.address = f"{where.address}?safety=off&rearm=off"
            robot.told = "got {:.1f} 0 "
            await robot.begins("ready")
            yield robot


def zenoh(folder: Path) -> AbstractAsyncContextManager[Robot]:
    """One with Zenoh."""
    return ros2(folder, "Zenoh")


def _ros_in(folder: Path) -> None:
    """Debian's ROS 1 and the base's messages; skips with a word where they cannot be had."""
    made = subprocess.run(
        [str(HASKELL / "test-ros" / "setup-ros"), str(folder)], capture_output=True, text=True, check=False
    )
    if made.returncode != 0:
        pytest.skip(made.stdout.strip() or "ROS 1 cannot be installed")


async def _send_alive(page: Page) -> None:
    with contextlib.suppress(Exception):
        await page.look()


@asynccontextmanager
async def looking(page: Page) -> AsyncIterator[None]:
    """The person at the page looks at the robot, as long as there is a page."""
    look = asyncio.create_task(_send_alive(page))
    try:
        yield
    finally:
        look.cancel()


class Rig:
    """A service with one robot, called Kitchen, and a page that knows the code."""

    def __init__(self, address: str, service: Service, page: Page, robot: Robot | None = None) -> None:
        self.address = address
        self.service = service
        self.page = page
        # Called Kitchen; without one only the simulated robot is there.
        self._robot = robot
        self._looking: asyncio.Task[None] | None = None

    @property
    def robot(self) -> Robot:
        """The real one."""
        assert self._robot is not None
        return self._robot

    async def takes(self) -> None:
        await self.page.send("unlock", code=self.service.robots.code)
        await self.page.until(lambda m: m["op"] == "robots" and not m["locked"] and not m["robots"][0]["holder"])
        await self.page.send("take", robot="Kitchen", who="Anna")
        await self.page.op("robot", link="connected")

    async def drives(self, script: str = "drive:0.2", run: int = 1) -> None:
        self.looks()
        await self.page.send("run", run=run, source=script, speed=1)
        await self.page.op("state", run=run, state="running")
        await self.robot.moves(0.2)

    def looks(self) -> None:
        """The person at the page looks at the robot."""
        self._looking = self._looking or asyncio.create_task(_send_alive(self.page))

    async def pressed(self) -> None:
        """A hand touches the robot."""
        if self._robot is None:
            await self.page.send("input", press="Button0")
        else:
            self._robot.bumped()

    async def looks_away(self) -> None:
        assert self._looking is not None
        self._looking.cancel()
        self._looking = None

    @property
    def driver(self) -> int:
        """The process that drives the robot."""
        mine = canonical_address(self.robot.address)
        [driver] = [d for d in active_drivers() if canonical_address(d.address) == mine]
        return driver.process
