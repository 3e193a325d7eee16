"""
Each signal for each process of a drive on each link, and how long the robot drove on by its own clock.

The table that is printed is that of "What stops the robot" (rosy-hs/robots/README.md). Times are not judged, since this
machine may be busy; whether the robot stands is. Where nothing that still runs can reach the base, the base has a limit
of its own, and must have stopped by that alone. A share of the rows runs daily, all of them nightly.
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
from rosy_sim.ownership.driver_locks import active_drivers

from ..extent import rotated
from ..web.page_client import opened
from .robot_rig import Rig, Robot, kobuki, rosbridge, rospy

HERE = Path(__file__).resolve().parents[2]

LINKS: dict[str, Callable[[Path], AbstractAsyncContextManager[Robot]]] = {
    "serial": kobuki,
    "rosbridge": rosbridge,
    "ROS 1": rospy,
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
                # `./rosy run` that stands still leaves program and rosy-robot as they are (below).
                if (process, how) != ("./rosy run", "STOP"):
                    rows.append(Death(process, how, link))
        if link == "serial":
            rows.extend(Death("guardian", how, link) for how in SIGNALS if how != "STOP")
            rows.extend(Death("rosy-robot and guardian", how, link, reached=False) for how in ("KILL", "STOP"))
    return rows


Table = dict[str, dict[str, str]]


@pytest.fixture(scope="module")
def table(request: pytest.FixtureRequest) -> Iterator[Table]:
    """Process and signal, link, seconds; printed when all is measured."""
    measured: Table = {}
    yield measured
    with request.config.pluginmanager.getplugin("capturemanager").global_and_fixture_disabled():
        print(f"\n{'seconds until zero at the base':34}" + "".join(f"{link:>12}" for link in LINKS))
        for row, cells in measured.items():
            print(f"{row:34}" + "".join(f"{cells.get(link, ''):>12}" for link in LINKS))


def children(process: int) -> list[int]:
    """Of all its threads."""
    found: list[int] = []
    for threads in Path(f"/proc/{process}/task").glob("*/children"):
        with contextlib.suppress(FileNotFoundError, ProcessLookupError):
            found.extend(int(p) for p in threads.read_text().split())
    return found


def name_of(process: int) -> str:
    """As the process calls itself; empty when it has ended."""
    try:
        return Path(f"/proc/{process}/comm").read_text().strip()
    except OSError:
        return ""


def family(process: int) -> list[int]:
    """A process and all that it has started."""
    return [process, *(p for child in children(process) for p in family(child))]


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
        ours = [*family(process.pid), *([] if driver is None else family(driver))]
        for pid in ours:
            with contextlib.suppress(ProcessLookupError):
                os.kill(pid, signal.SIGKILL)
        await process.communicate()


def robot_driver(robot: Robot) -> int | None:
    """The process that drives this robot, if there is one."""
    return next((d.process for d in active_drivers() if d.address == robot.address), None)


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
                [program] = [p for p in family(service.pid) if name_of(p) == "program"]
                guardian = children(rig.driver)
                yield {
                    "service": [service.pid],
                    "rosy-robot": [rig.driver],
                    "program": [program],
                    "guardian": guardian,
                    # The one that would notice the other's end goes first, and stands still until both are told.
                    "rosy-robot and guardian": [*guardian, rig.driver],
                }
            finally:
                await rig.looks_away()


@pytest.mark.turns
@pytest.mark.long
@pytest.mark.skipif(discover().robot_executable is None, reason="rosy-robot is not built")
@pytest.mark.parametrize("death", rotated(deaths(), 16), ids=str)
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
            # On a network the base's own watchdog is part of the link; on a serial line this base has none of itself.
            assert by_itself != death.reached or death.link != "serial"
            table.setdefault(f"{death.process} -{death.how}", {})[death.link] = (
                f"{took:.2f}" if death.reached else "never"
            )

    asyncio.run(play())


@pytest.mark.turns
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
