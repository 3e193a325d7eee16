"""
Each signal for each process of a drive on each link, and how long the robot drove on by its own clock.

The table that is printed is that of "What stops the robot" (rosy-hs/robots/README.md). Times are not judged, since this
machine may be busy; whether the robot stands is. Where nothing that still runs can reach the base, the base has a limit
of its own, and must have stopped by that alone.

Two busy cores: at most 0.1 s after each signal but -STOP, which takes 0.5 s (service) to 0.66 s (program,
``rosy-robot``, bridge to ROS 2); -KILL and -STOP of ``rosy-robot`` and its guardian at once on a serial line: never.
"""

from __future__ import annotations

import asyncio
import contextlib
import os
import signal
import sys
from collections.abc import AsyncIterator, Callable, Iterator
from contextlib import AbstractAsyncContextManager, asynccontextmanager
from dataclasses import dataclass
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from rosy_sim.config import discover
from rosy_sim.ownership.driver_locks import active_drivers, canonical_address

from ..processes import below, called, children, command_of
from ..web.page_client import opened
from .robot_rig import Rig, Robot, kobuki, ros2, rosbridge, rospy, zenoh

HERE = Path(__file__).resolve().parents[2]

LINKS: dict[str, Callable[[Path], AbstractAsyncContextManager[Robot]]] = {
    "serial": kobuki,
    "rosbridge": rosbridge,
    "ROS 1": rospy,
    "ROS 2": ros2,
    "ROS 2, Zenoh": zenoh,
}

SIGNALS = ("KILL", "STOP", "INT", "TERM", "HUP")

BASE_LIMIT = 3.0
"""Seconds without a word after which the base of a row that no process can end stops by itself."""


@dataclass(frozen=True)
class Death:
    """What happens to which process. ``reached``: whether a process that is left tells the base to stand."""

    process: str
    how: str
    link: str
    reached: bool = True

    def __str__(self) -> str:
        return f"{self.process} -{self.how}, {self.link}"


def deaths() -> list[Death]:
    rows: list[Death] = []
    for link in LINKS:
        for process in ("service", "rosy-robot", "program", "./rosy run"):
            for how in SIGNALS:
                # `./rosy run` that stands still leaves program and rosy-robot as they are (below). Over Zenoh only
                # the end of the way differs from that over DDS.
                if (process, how) != ("./rosy run", "STOP") and (link != "ROS 2, Zenoh" or how in ("KILL", "STOP")):
                    rows.append(Death(process, how, link))
        if link.startswith("ROS 2"):
            rows.extend(Death("bridge", how, link) for how in ("KILL", "STOP", "TERM"))
        if link == "serial":
            rows.append(Death("guardian", "KILL", link))
            rows.extend(Death("rosy-robot and guardian", how, link, reached=False) for how in ("KILL", "STOP"))
    return rows


@pytest.fixture(scope="module", autouse=True)
def no_signal_is_ignored() -> Iterator[None]:
    """A process inherits that -HUP (under ``nohup``) or -INT (in the background of a shell) is ignored."""
    ignored = [one for one in (signal.SIGHUP, signal.SIGINT) if signal.getsignal(one) == signal.SIG_IGN]
    for one in ignored:
        signal.signal(one, signal.SIG_DFL)
    yield
    for one in ignored:
        signal.signal(one, signal.SIG_IGN)


Table = dict[str, dict[str, str]]


@pytest.fixture(scope="module")
def table(request: pytest.FixtureRequest) -> Iterator[Table]:
    """Process and signal, link, seconds; printed when all is measured."""
    measured: Table = {}
    yield measured
    with request.config.pluginmanager.getplugin("capturemanager").global_and_fixture_disabled():
        print(f"\n{'seconds until zero at the base':34}" + "".join(f"{link:>13}" for link in LINKS))
        for row, cells in measured.items():
            print(f"{row:34}" + "".join(f"{cells.get(link, ''):>13}" for link in LINKS))


@asynccontextmanager
async def started(module: str, robot: Robot, *arguments: str) -> AsyncIterator[asyncio.subprocess.Process]:
    """A module of the tests as a process; ended with all that it has started, whatever stands still."""
    process = await asyncio.create_subprocess_exec(
        sys.executable, "-m", f"tests.ownership.{module}", robot.address, *arguments,
        stdin=asyncio.subprocess.DEVNULL, stdout=asyncio.subprocess.PIPE, cwd=HERE,
    )  # fmt: skip
    try:
        yield process
    finally:
        driver = robot_driver(robot)
        ours = {process.pid, *below(process.pid)}
        if driver is not None:
            ours |= {driver, *below(driver)}
        for pid in ours:
            with contextlib.suppress(ProcessLookupError):
                os.kill(pid, signal.SIGKILL)
        await process.communicate()


def robot_driver(robot: Robot) -> int | None:
    """The process that drives this robot, if there is one."""
    return next(
        (d.process for d in active_drivers() if canonical_address(d.address) == canonical_address(robot.address)), None
    )


@asynccontextmanager
async def driving(death: Death, robot: Robot, folder: Path) -> AsyncIterator[dict[str, list[int]]]:
    """A drive, from a page or by ``./rosy run``, and its processes by name."""
    if death.process == "./rosy run":
        async with started("robot_command", robot, str(folder), "drive:0.2") as command:
            await robot.moves(0.2)
            yield {death.process: [command.pid]}
        return
    async with started("robot_service", robot, str(folder)) as service:
        assert service.stdout is not None
        address, code = (await service.stdout.readline()).decode().split()
        async with opened(address) as page:
            known: Any = SimpleNamespace(robots=SimpleNamespace(code=code))
            rig = Rig(address, known, page, robot)
            await rig.takes()
            await rig.drives()
            try:
                [program] = [p for p in below(service.pid) if called(p) == "program"]
                guardian = list(children(rig.driver))
                bridges = [p for p in children(service.pid) if "rosy_sim.ros2.bridge_process" in command_of(p)]
                yield {
                    "bridge": bridges,
                    "service": [service.pid],
                    "rosy-robot": [rig.driver],
                    "program": [program],
                    "guardian": guardian,
                    # The one that would notice the other's end goes first, and stands still until both are told.
                    "rosy-robot and guardian": [*guardian, rig.driver],
                }
            finally:
                await rig.looks_away()


@pytest.mark.long
@pytest.mark.skipif(discover().robot_executable is None, reason="rosy-robot is not built")
@pytest.mark.parametrize("death", deaths(), ids=str)
def test_the_robot_stands_after(death: Death, tmp_path: Path, table: Table) -> None:
    async def play() -> None:
        async with LINKS[death.link](tmp_path) as robot, driving(death, robot, tmp_path) as processes:
            victims = processes[death.process]
            assert victims
            await robot.marked()
            heard = len(robot.said)
            if not death.reached:
                robot.ask("timeout", str(BASE_LIMIT))
            if len(victims) > 1:
                for pid in victims:
                    os.kill(pid, signal.SIGSTOP)
            for pid in victims:
                os.kill(pid, getattr(signal, f"SIG{death.how}"))
            took = await robot.stands()
            by_itself = "watchdog" in robot.said[heard:]
            never = by_itself and not death.reached
            # On a network the base's own watchdog is part of the link; on a serial line this base has none of itself.
            if death.link == "serial":
                # Of two processes that are stopped one after the other, the second may tell the base to stand first.
                speeds = [line for line in robot.said if line.startswith("control ")]
                was_told = speeds[-1].startswith(robot.told.format(0))
                assert by_itself == (not death.reached and not was_told)
            table.setdefault(f"{death.process} -{death.how}", {})[death.link] = "never" if never else f"{took:.2f}"

    asyncio.run(play())


@pytest.mark.long
@pytest.mark.skipif(discover().robot_executable is None, reason="rosy-robot is not built")
@pytest.mark.parametrize("how", [how for how in SIGNALS if how not in ("KILL", "STOP")])
def test_a_guardian_stays_when_it_is_told_to_end(how: str, tmp_path: Path) -> None:
    """What a terminal or a shell sends to all does not take the guardian away: it still stops the robot."""

    async def play() -> None:
        death = Death("guardian", how, "serial")
        async with kobuki(tmp_path) as robot, driving(death, robot, tmp_path) as processes:
            for pid in processes["guardian"]:
                os.kill(pid, getattr(signal, f"SIG{how}"))
            await robot.marked()
            [driver] = processes["rosy-robot"]
            os.kill(driver, signal.SIGKILL)
            await robot.stands()

    asyncio.run(play())


@pytest.mark.long
@pytest.mark.skipif(discover().robot_executable is None, reason="rosy-robot is not built")
def test_what_stands_still_beside_a_drive_does_not_keep_it_from_ending(tmp_path: Path) -> None:
    """A suspended ``./rosy run`` or guardian changes nothing: the drive's end still stops the robot."""

    async def play() -> None:
        for process in ("./rosy run", "guardian"):
            folder = tmp_path / process.strip("./").replace(" ", "-")
            folder.mkdir()
            death = Death(process, "STOP", "serial")
            async with kobuki(folder) as robot, driving(death, robot, folder) as processes:
                for pid in processes[process]:
                    os.kill(pid, signal.SIGSTOP)
                driver = robot_driver(robot)
                assert driver is not None
                await robot.marked()
                os.kill(driver, signal.SIGTERM)
                await robot.stands()

    asyncio.run(play())
