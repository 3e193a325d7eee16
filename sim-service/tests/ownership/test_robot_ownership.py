"""Real robots from the page: a real service, a real rosy-robot, and a Kobuki at the end of a pseudo-terminal."""

from __future__ import annotations

import asyncio
import contextlib
import json
import os
import signal
import socket
import sys
import time
from collections.abc import AsyncIterator, Awaitable, Callable
from contextlib import AbstractAsyncContextManager, asynccontextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from rosy_sim.config import Config, Limits, discover
from rosy_sim.errors import BadInput
from rosy_sim.ownership.driver_locks import active_drivers, canonical_address
from rosy_sim.ownership.robot_configuration import read_robot_configuration
from rosy_sim.ownership.robot_registry import RobotRegistry
from rosy_sim.recordings.mcap_file import open_recording
from rosy_sim.wire.robot_process import CommandsLine, EndedLine

from ..conftest import PATIENCE
from ..extent import NIGHTLY
from ..processes import descriptors
from ..web.page_client import Page, opened, serving
from .robot_rig import LIMIT, Rig, Robot, kobuki, looking

pytestmark = pytest.mark.skipif(discover().robot_executable is None, reason="rosy-robot is not built")

HERE = Path(__file__).resolve().parents[2]

Story = Callable[[Rig], Awaitable[None]]


def story(
    tell: Story,
    config: Config,
    folder: Path,
    options: str | None = None,
    link: Callable[[Path], AbstractAsyncContextManager[Robot]] = kobuki,
) -> None:
    async def play() -> None:
        async with link(folder) as robot:
            if options is not None:
                robot.address = f"{robot.address.partition('?')[0]}{options}"
            robots = replace(config, robots={"Kitchen": robot.address}, robot_executable=discover().robot_executable)
            async with serving(robots) as (address, service), opened(address) as page:
                await tell(Rig(address, service, page, robot))

    asyncio.run(play())


def test_robots_are_locked_until_the_page_knows_the_code(config: Config, tmp_path: Path) -> None:
    async def tell(rig: Rig) -> None:
        page = rig.page
        assert (await page.op("robots"))["robots"] == []
        await page.send("take", robot="Kitchen", who="Eve")
        assert "locked" in (await page.op("refusal"))["message"]
        await page.send("unlock", code="guessed")
        assert "not the code" in (await page.op("refusal"))["message"]
        await page.send("unlock", code=f"{rig.service.robots.code[:4]} - {rig.service.robots.code[4:].upper()}")
        found = await page.op("robots", locked=False)
        assert found["robots"] == [{"name": "Kitchen", "holder": None, "yours": False}]

    story(tell, config, tmp_path)


def test_runs_of_a_page_are_recorded_each_in_its_file(
    config: Config, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    async def tell(rig: Rig) -> None:
        await rig.takes()
        for run in (1, 2):
            await rig.drives(f"drive:0.2 say:run{run}@2", run)
            await rig.page.send("stop")
            await rig.page.op("state", run=run, state="ended")
            # The next run begins with the same speed, of which the base says nothing when it did not stand in between.
            await rig.robot.moves(0)
        assert rig.service.recorder is not None
        await rig.service.recorder.close()

    story(tell, config, tmp_path)
    said, found = capfd.readouterr().err, []
    for path in sorted((tmp_path / "recordings").iterdir()):
        assert f"The run is recorded in {path}." in said
        with open_recording(path) as recording:
            topics = {message["topic"] for line in recording.lines() if "topic" in (message := json.loads(line.text))}
            assert {"/odom", "/mobile_base/commands/velocity"} <= topics
            found.append((recording.details.program, recording.details.name, recording.details.ended))
            assert recording.is_complete
    assert sorted(found) == [(f"drive:0.2 say:run{run}@2", "Kitchen", "stopped") for run in (1, 2)]


def test_a_service_that_does_not_record_makes_no_folder(config: Config, tmp_path: Path) -> None:
    async def tell(rig: Rig) -> None:
        await rig.takes()
        await rig.drives()

    story(tell, replace(config, records=False), tmp_path)
    assert not (tmp_path / "recordings").exists()


def test_a_page_that_guesses_the_code_does_not_lock_the_right_code_out(config: Config, tmp_path: Path) -> None:
    async def tell(rig: Rig) -> None:
        # No time passes: a page that has guessed is heard again after a while.
        began = time.monotonic()
        rig.service.robots._now = lambda: began
        async with opened(rig.address) as guesser:
            for n in range(150):
                await guesser.send("unlock", code=f"guess{n}")
            for _ in range(150):
                await guesser.op("refusal")
            for _ in range(20):
                async with opened(rig.address) as page:
                    await page.send("unlock", code=rig.service.robots.code)
                    await page.op("robots", locked=False)
            # Also when it is right, a page that has guessed so often is not heard for a while, and is told so.
            await guesser.send("unlock", code=rig.service.robots.code)
            assert "Too many wrong codes" in (await guesser.op("refusal"))["message"]

    story(tell, config, tmp_path)


def test_a_page_without_robots_hears_nothing_of_them(config: Config) -> None:
    async def play() -> None:
        async with serving(config) as (address, _), opened(address) as page:
            await page.op("frame")
            await page.send("estop")
            await page.send("alive")
            await page.send("take", robot="Kitchen", who="Eve")
            await page.op("refusal")
            assert not [m for m in page.seen if m["op"] in ("robots", "robot")]

    asyncio.run(play())


def test_a_program_drives_the_robot_and_the_page_sees_it(config: Config, tmp_path: Path) -> None:
    async def tell(rig: Rig) -> None:
        await rig.takes()
        state = next(m for m in rig.page.seen if m["op"] == "robot" and m["max_speed"])
        assert state["max_speed"] == 0.7
        assert {"op": "safety", "on": True} in rig.page.seen
        await rig.drives("drive:0.2 led:2@3 say:hi@4 sound:4@5")
        assert (await rig.page.op("said"))["text"] == "hi"
        assert (await rig.page.op("sound"))["sound"] == 4
        frame = await rig.page.until(
            lambda m: m["op"] == "frame" and m["pose"]["x"] > 0.15 and 0.15 < m["channels"]["Velocity"][0] < 0.25
        )
        assert frame["run"] == 1
        assert frame["channels"]["Led1"] == [2]
        await rig.page.until(lambda m: m["op"] == "frame" and "move" in m["fired"])
        rig.robot.ask("bump", "4")
        assert (await rig.page.until(lambda m: m["op"] == "safety" and "since" in m))["run"] == 1
        await rig.robot.says(lambda line: line.startswith("control -0.1"))
        rig.robot.ask("bump", "0")
        await rig.robot.marked()
        await rig.page.send("stop")
        await rig.robot.stands()
        assert (await rig.page.ended(1))["ended"] == "stopped"
        # Where the next one begins is the origin again. It stays there: a page is not shown every frame.
        await rig.page.send("run", run=2, source="led:2@3", speed=1)
        await rig.page.until(lambda m: m["op"] == "frame" and m["run"] == 2 and abs(m["pose"]["x"]) < 0.1)

    story(tell, config, tmp_path)


def test_a_run_on_the_robot_is_recorded_and_answers_why_and_why_not(config: Config, tmp_path: Path) -> None:
    async def tell(rig: Rig) -> None:
        await rig.takes()
        await rig.page.send("observe", on=True, frames=True)
        rig.looks()
        await rig.page.send("run", run=1, source="drive:0.5 tell count", speed=1)
        frame = await rig.page.until(lambda m: m["op"] == "frame" and "firings" in m)
        firing = frame["firings"][-1]
        assert (firing["function"], firing["gave"][0]["value"]) == ("f", "Velocity 0.5 0.0")
        await rig.page.until(lambda m: m["op"] == "frame" and "memory" in m)
        await rig.page.send("why", id=1, time=firing["time"])
        found = await rig.page.op("because", id=1)
        assert [one["said"]["id"] for one in found["sentences"]] == ["sent", "ran-tick"]
        assert found["sentences"][0]["said"]["value"] == "Velocity 0.5 0.0"
        assert found["path"][-1]["function"] == "f"
        await rig.page.send("why", id=2, function="f", time=firing["time"])
        assert (await rig.page.op("because", id=2))["sentences"][0]["said"]["id"] == "gave"
        await rig.page.send("whyNot", id=3, command="Led1", since=0, until=firing["time"])
        assert (await rig.page.op("because", id=3))["sentences"][0]["said"]["id"] == "no-sender"
        # A page that does not observe gets none, and its robot's run is not recorded.
        await rig.page.send("observe", on=False)
        await rig.page.send("run", run=2, source="drive:0.5 tell", speed=1)
        await rig.page.until(lambda m: m["op"] == "frame" and m["run"] == 2 and m["fired"])
        await rig.page.send("why", id=4)
        assert (await rig.page.op("because", id=4))["sentences"][0]["said"]["id"] == "not-recorded"
        # Neither does one that sends no command; nothing is told of its steps.
        await rig.page.send("run", run=3, source="", speed=1)
        await rig.page.op("state", run=3, state="running")
        await rig.page.send("why", id=5)
        assert (await rig.page.op("because", id=5))["sentences"][0]["said"]["id"] == "not-recorded"

    story(tell, config, tmp_path)


def test_functions_that_override_each_other_on_the_robot_are_reported(config: Config, tmp_path: Path) -> None:
    async def tell(rig: Rig) -> None:
        await rig.takes()
        rig.looks()
        await rig.page.send("run", run=1, source="drive:0.2 led:2@3 fight", speed=1)
        found = await rig.page.op("conflict")
        assert (found["run"], found["command"], found["winner"], found["loser"]) == (1, "Velocity", "hold", "move")
        await rig.page.send("stop")
        assert (await rig.page.ended(1))["ended"] == "stopped"
        # One function alone is in no conflict.
        await rig.drives("drive:0.2 done@40", run=2)
        assert (await rig.page.ended(2))["ended"] == "done"
        assert [m["run"] for m in rig.page.seen if m["op"] == "conflict"] == [1]

    story(tell, config, tmp_path)


def test_one_page_has_a_robot_and_the_others_see_who(config: Config, tmp_path: Path) -> None:
    async def tell(rig: Rig) -> None:
        await rig.takes()
        async with opened(rig.address) as other:
            await other.send("unlock", code=rig.service.robots.code)
            found = await other.op("robots", locked=False)
            assert found["robots"] == [{"name": "Kitchen", "holder": "Anna", "yours": False}]
            await other.send("take", robot="Kitchen", who="Ben")
            assert "Anna has Kitchen" in (await other.op("refusal"))["message"]
            await rig.page.send("leave")
            await rig.page.op("robot", link="gone")
            await rig.page.op("world")
            await other.until(lambda m: m["op"] == "robots" and m["robots"][0]["holder"] is None)
            await other.send("take", robot="Kitchen", who="Ben")
            await other.op("robot", link="connected")
            await rig.page.until(lambda m: m["op"] == "robots" and m["robots"][0]["holder"] == "Ben")

    story(tell, config, tmp_path)


@pytest.mark.parametrize(
    ("script", "ended", "kind"),
    [
        ("error@touch", "error", "exception"),
        ("hang@touch", "stuck", "stuck"),
        ("close@touch", "error", "died"),
        ("done@touch", "done", None),
    ],
)
def test_the_robot_stands_and_the_page_is_told_when_a_program_ends(
    script: str, ended: str, kind: str | None, config: Config, impatient: Limits, tmp_path: Path
) -> None:
    async def tell(rig: Rig) -> None:
        await rig.takes()
        await rig.drives(f"drive:0.2 {script}")
        rig.robot.ask("press", "1")
        told = await rig.page.ended(1)
        assert told["ended"] == ended
        assert [p["kind"] for p in told["problems"]] == ([kind] if kind else [])
        await rig.robot.moves(0.0)

    story(tell, config.with_limits(impatient) if ended == "stuck" else config, tmp_path)


def test_after_an_emergency_stop_nothing_drives_until_the_robot_is_freed(config: Config, tmp_path: Path) -> None:
    async def tell(rig: Rig) -> None:
        await rig.takes()
        await rig.drives()
        await rig.page.send("estop")
        await rig.page.op("robot", stopped=True)
        assert (await rig.page.ended(1))["ended"] == "stopped"
        await rig.robot.moves(0.0)
        await rig.page.send("run", run=2, source="drive:0.2", speed=1)
        assert (await rig.page.ended(2))["ended"] == "stopped"
        await rig.page.send("free")
        await rig.page.op("robot", stopped=False)
        await rig.drives(run=3)

    story(tell, config, tmp_path)


class FirstEnd:
    """A run's listener that keeps how it ended."""

    def __init__(self) -> None:
        self.ended: asyncio.Future[str] = asyncio.get_running_loop().create_future()

    def on_commands(self, line: CommandsLine) -> None:
        raise AssertionError(line)

    def on_ended(self, line: EndedLine) -> None:
        self.ended.set_result(line.how)

    def on_lost(self) -> None:
        self.ended.set_result("lost")


def test_a_stop_that_comes_before_the_run_has_begun_is_not_lost(config: Config, tmp_path: Path) -> None:
    async def tell(rig: Rig) -> None:
        await rig.takes()
        [session] = rig.service.sessions.values()
        process = session.ownership.process
        assert process is not None
        for _ in range(10):
            # A program that never answers: one that drove on would end as stuck.
            program, link = socket.socketpair()
            listener = FirstEnd()
            process.run(link, listener)
            process.stop()
            # A busy machine may lose the robot for a moment.
            assert await listener.ended in ("stopped", "lost")
            program.close()

    story(tell, config, tmp_path)


def test_wheels_turn_again_when_somebody_looks_again(config: Config, tmp_path: Path) -> None:
    async def tell(rig: Rig) -> None:
        await rig.takes()
        await rig.drives()
        await rig.looks_away()
        await rig.robot.moves(0.0)
        rig.looks()
        await rig.robot.moves(0.2)

    story(tell, config, tmp_path)


def test_a_pulled_cable_is_told_and_found_again(config: Config, tmp_path: Path) -> None:
    async def tell(rig: Rig) -> None:
        await rig.takes()
        await rig.drives()
        rig.robot.ask("unplug")
        lost = await rig.page.op("robot", link="lost")
        assert lost["why"]
        assert lost["sentence"]["id"] == lost["why"]
        rig.robot.ask("plug")
        await rig.page.op("robot", link="connected")

    story(tell, config, tmp_path)


def test_a_robot_that_was_lost_stands_until_the_page_lets_it_drive(config: Config, tmp_path: Path) -> None:
    def states(page: Page) -> list[dict[str, Any]]:
        return [message for message in page.seen if message["op"] == "robot"]

    async def let_drive(page: Page) -> None:
        """Let it drive whenever it was stopped: a busy machine may lose the robot for a moment, too."""
        stopped = states(page)[-1]["stopped"]
        while True:
            if stopped:
                await page.send("free")
            stopped = (await page.op("robot", link="connected"))["stopped"]

    async def moves(rig: Rig) -> None:
        letting = asyncio.create_task(let_drive(rig.page))
        await rig.robot.moves(0.2)
        letting.cancel()
        with contextlib.suppress(asyncio.CancelledError):
            await letting

    async def tell(rig: Rig) -> None:
        await rig.takes()
        rig.looks()
        await rig.page.send("run", run=1, source="drive:0.2", speed=1)
        await rig.page.op("state", run=1, state="running")
        await moves(rig)
        rig.robot.ask("unplug")
        await rig.page.op("robot", link="lost")
        rig.robot.ask("plug")
        await rig.page.op("robot", link="connected", stopped=True)
        told = len(states(rig.page))
        await moves(rig)
        if all(state["stopped"] for state in states(rig.page)[told:]):
            await rig.page.op("robot", stopped=False)

    story(tell, config, tmp_path, "?patience=600")


def test_the_page_is_told_when_the_part_that_drives_dies(config: Config, tmp_path: Path) -> None:
    async def tell(rig: Rig) -> None:
        await rig.takes()
        await rig.drives()
        os.kill(rig.driver, signal.SIGKILL)
        assert (await rig.page.ended(1))["problems"][0]["kind"] == "lost-robot"
        await rig.page.op("robot", link="gone")
        await rig.page.until(lambda m: m["op"] == "robots" and m["robots"][0]["holder"] is None)

    story(tell, config, tmp_path)


@asynccontextmanager
async def service_of_its_own(robot: Robot, folder: Path) -> AsyncIterator[tuple[asyncio.subprocess.Process, str, str]]:
    """A service in another process, its address and its code."""
    process = await asyncio.create_subprocess_exec(
        sys.executable, "-m", "tests.ownership.robot_service", robot.address, str(folder),
        stdout=asyncio.subprocess.PIPE, cwd=HERE,
    )  # fmt: skip
    assert process.stdout is not None
    try:
        address, code = (await process.stdout.readline()).decode().split()
        yield process, address, code
    finally:
        with contextlib.suppress(ProcessLookupError):
            process.kill()
        # Until all that it had started has let go of its output, too.
        await process.communicate()


def test_the_robot_stands_when_the_service_is_killed(tmp_path: Path) -> None:
    async def play() -> None:
        async with (
            kobuki(tmp_path) as robot,
            service_of_its_own(robot, tmp_path) as (process, address, code),
            opened(address) as page,
        ):
            await page.send("unlock", code=code)
            await page.send("take", robot="Kitchen", who="Anna")
            await page.op("robot", link="connected")
            await page.send("run", run=1, source="drive:0.2", speed=1)
            async with looking(page):
                await robot.moves(0.2)
                await robot.marked()
                process.kill()
                print(f"service killed: stood after {await robot.stands()} s (allowed: {LIMIT} s)")

    asyncio.run(play())


def test_the_operator_names_robots(tmp_path: Path) -> None:
    robot_executable = discover().robot_executable
    file = tmp_path / "robots.json"
    file.write_text('{"Kitchen": "serial:/dev/kobuki?max_speed=0.1"}')
    found = read_robot_configuration(robot_executable, ["Lab=ws://lab:9090?ros=2"], file)
    assert found == {"Kitchen": "serial:/dev/kobuki?max_speed=0.1", "Lab": "ws://lab:9090?ros=2"}


@pytest.mark.parametrize(
    ("given", "why"),
    [
        (["ws://lab:9090"], "name and an address"),
        (["ws://lab:9090?ros=2"], "name and an address"),
        (["=ws://lab"], "1 to 40"),
        (["a=ws://lab", "a=ws://pi"], "twice"),
        (["a=ws://lab", "b=ws://lab"], "twice"),
        (["a=ws://lab", "b=ws://lab:9090/?safety=off"], "twice"),
        (["a=http://lab"], "is no robot"),
        (["a=ws://lab?speed=9"], "no option"),
    ],
)
def test_a_robot_that_cannot_be_is_refused_at_the_start(given: list[str], why: str) -> None:
    with pytest.raises(BadInput, match=why):
        read_robot_configuration(discover().robot_executable, given, None)


def test_the_files_of_the_dead_are_cleared_away(tmp_path: Path) -> None:
    (tmp_path / "12345").write_text("ws://pi:9090")
    assert active_drivers(tmp_path) == []
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("one", "same"),
    [
        ("ros://pi", "ros://pi:11311"),
        ("ws://pi", "ws://pi:9090/"),
        ("ws://Pi:9090/robot/?ros=2", "ws://pi/robot"),
        ("serial:/dev/ttyUSB0?safety=off", "serial:/dev/ttyUSB0"),
        ("ws://pi:port", "ws://pi:port?max_speed=0.1"),
    ],
)
def test_two_addresses_of_one_way_are_one_robot(one: str, same: str) -> None:
    assert canonical_address(one) == canonical_address(same)


@pytest.mark.parametrize(
    ("one", "other"),
    [("ros://pi", "ws://pi:11311"), ("ws://pi", "ws://pi:9091"), ("ws://pi/a", "ws://pi/b"), ("ros://pi", "ros://lab")],
)
def test_robots_elsewhere_are_others(one: str, other: str) -> None:
    assert canonical_address(one) != canonical_address(other)


def test_a_device_is_the_same_by_whatever_name(tmp_path: Path) -> None:
    (tmp_path / "ttyUSB0").touch()
    (tmp_path / "kobuki").symlink_to("ttyUSB0")
    assert canonical_address(f"serial:{tmp_path}/kobuki?max_speed=0.1") == canonical_address(
        f"serial:{tmp_path}/ttyUSB0"
    )


def test_a_robot_that_a_terminal_drives_cannot_be_taken_by_any_of_its_names(config: Config, tmp_path: Path) -> None:
    async def tell(rig: Rig) -> None:
        await rig.takes()
        addresses = {"Again": f"{canonical_address(rig.robot.address)}?safety=off"}
        robots = RobotRegistry(addresses, None, time.monotonic, lambda: None)
        with pytest.raises(BadInput, match="driven from a terminal"):
            robots.acquire("Again", "another page", "Ben")

    story(tell, config, tmp_path)


RUNS = 50 if NIGHTLY else 8
"""One descriptor that each leaves would be seen after one of them."""


def test_many_runs_leave_no_descriptor_open(config: Config, tmp_path: Path) -> None:
    async def tell(rig: Rig) -> None:
        await rig.takes()
        rig.looks()

        async def driven(runs: range) -> None:
            for run in runs:
                await rig.page.send("run", run=run, source="drive:0.1 done@1", speed=1)
                assert (await rig.page.ended(run))["ended"] == "done"

        await driven(range(1, 2))
        ours, theirs = descriptors(os.getpid()), descriptors(rig.driver)
        await driven(range(2, RUNS + 2))
        # What the last one had may still be closing.
        async with asyncio.timeout(PATIENCE):
            while descriptors(os.getpid()) > ours or descriptors(rig.driver) > theirs:
                await asyncio.sleep(0.01)

    story(tell, config, tmp_path)
