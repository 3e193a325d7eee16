"""``./rosy run --robot``: a program drives a robot behind a rosbridge server: ours, whose robot is simulated."""

from __future__ import annotations

import asyncio
import json
import queue
import socket
import threading
from pathlib import Path
from typing import Any

import pytest

from rosy_sim.config import Config, discover
from rosy_sim.errors import BadInput, RobotMissing
from rosy_sim.ownership.headless_robot_run import run_on_robot
from rosy_sim.worker.blocking_worker import BlockingWorker

from ..conftest import PATIENCE
from ..web.page_client import Page, opened, serving

SPEAKER = discover().robot_executable

pytestmark = pytest.mark.skipif(SPEAKER is None, reason="rosy-robot is not built")


def test_a_program_drives_a_robot_until_it_bumps_and_is_done(config: Config, capfd: pytest.CaptureFixture[str]) -> None:
    """The service has a thread of its own: signals, which stop the robot, come to the main one."""
    robots: queue.Queue[str] = queue.Queue()
    through = threading.Event()

    async def serve() -> None:
        async with serving(config) as (address, _), opened(address) as page:
            hello = await page.op("hello")
            await page.send("input", teleport={"x": 4.7, "y": 2.0, "theta": 0.0})
            robots.put(f"ws://{address}/rosbridge/{hello['session']}?safety=off&rearm=off")
            await _sees(page)
            await asyncio.to_thread(through.wait)

    def drive(source: str, seconds: float = 60.0) -> int:
        with BlockingWorker(config) as worker:
            worker.ready()
            return run_on_robot(worker, SPEAKER, source, address, seconds)[1]

    service = threading.Thread(target=asyncio.run, args=(serve(),))
    service.start()
    address = robots.get(timeout=PATIENCE)
    try:
        assert drive("drive:0.5 bump led:2@3 say:hi@4 done@250") == 0
        *said, last = capfd.readouterr().out.splitlines()
        assert said == ["hi"]
        assert_ended(last, "done", 250)
        for source, status in (("error@3", 2), ("close@3", 2), ("refuse", 1)):
            assert drive(source) == status
        assert drive("", seconds=0.5) == 0
    finally:
        through.set()
        service.join()


def assert_ended(line: str, how: str, steps: int) -> None:
    outcome: dict[str, Any] = json.loads(line)
    assert (outcome["ended"], outcome["steps"]) == (how, steps)


async def _sees(page: Page) -> None:
    """It lights up, bumps, backs off and stands."""
    await page.until(lambda m: m["op"] == "frame" and m["channels"]["Led1"] == [2])
    await page.until(lambda m: m["op"] == "frame" and m["channels"]["Bumper"] == [0, 1, 0])
    await page.until(lambda m: m["op"] == "frame" and m["channels"]["Velocity"][0] < 0)
    await page.until(lambda m: m["op"] == "frame" and m["channels"]["Velocity"][0] == 0)


@pytest.mark.parametrize(
    ("address", "why"),
    [
        ("http://pi", "is no robot"),
        ("ws://pi?ros=3", "does not fit the option ros"),
    ],
)
def test_an_address_that_is_not_valid_is_refused_before_anything_is_compiled(
    address: str, why: str, config: Config
) -> None:
    with BlockingWorker(config) as worker, pytest.raises(BadInput, match=why):
        run_on_robot(worker, SPEAKER, "drive:0.5", address, 1.0)


def test_a_robot_that_does_not_answer_is_missing_before_anything_is_compiled(config: Config) -> None:
    with (
        BlockingWorker(config) as worker,
        pytest.raises(RobotMissing, match=r"No robot answers at ws://127\.0\.0\.1:1;"),
    ):
        run_on_robot(worker, SPEAKER, "drive:0.5", "ws://127.0.0.1:1", 1.0)
    assert RobotMissing.exit_status == 2


def test_a_program_whose_robot_never_comes_has_not_run(config: Config, capfd: pytest.CaptureFixture[str]) -> None:
    """Something listens there and says nothing: the seconds of the run are the robot's, and it is given up."""
    with socket.create_server(("127.0.0.1", 0)) as server, BlockingWorker(config) as worker:
        address = f"ws://127.0.0.1:{server.getsockname()[1]}?patience=0.2"
        assert run_on_robot(worker, SPEAKER, "drive:0.5", address, 0.1)[1] == 2
    said = capfd.readouterr()
    assert json.loads(said.out.splitlines()[-1])["pose"] is None
    assert "The program never ran, because the robot was not there." in said.err


ADDRESS = "serial:/dev/null"


def stand_in(folder: Path, drive: str) -> Path:
    """An executable in place of rosy-robot: it accepts every address, and drives by a line of shell."""
    script = folder / "rosy-robot"
    script.write_text(f'#!/bin/sh\n[ "$1" = check ] && exit 0\n{drive}\n')
    script.chmod(0o755)
    return script


def test_a_killed_driver_of_the_robot_is_reported(
    config: Config, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    with BlockingWorker(config) as worker:
        worker.ready()
        assert run_on_robot(worker, stand_in(tmp_path, "kill -9 $$"), "drive:0.5", ADDRESS, 60.0)[1] == 2
    assert "was ended by SIGKILL before it could stop the robot" in capfd.readouterr().err


def test_an_interrupt_of_the_command_alone_reaches_the_driver_of_the_robot(config: Config, tmp_path: Path) -> None:
    """The stand-in interrupts its parent only, and ends with 7 when it is asked to end."""
    waits = 'trap "exit 7" TERM; kill -INT $PPID; while :; do sleep 0.05; done'
    with BlockingWorker(config) as worker:
        worker.ready()
        assert run_on_robot(worker, stand_in(tmp_path, waits), "drive:0.5", ADDRESS, 60.0)[1] == 7


def test_a_program_that_needs_a_part_the_robot_lacks_is_told_so_before_it_starts(config: Config) -> None:
    with socket.create_server(("127.0.0.1", 0)) as server, BlockingWorker(config) as worker:
        worker.ready()
        address = f"ws://127.0.0.1:{server.getsockname()[1]}?robot=turtlebot3"
        problems, status = run_on_robot(worker, SPEAKER, "drive:0.5 bump done@100", address, 60.0)
    assert ([str(problem.message) for problem in problems], status) == (["The robot (TurtleBot 3) has no Bumper."], 1)
