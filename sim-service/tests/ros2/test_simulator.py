"""``./rosy start --ros2``: a page's robot as one of ROS 2, for Fast DDS and for ``./rosy run --robot ros2:``."""

from __future__ import annotations

import asyncio
import contextlib
import json
import threading
from collections.abc import AsyncIterator, Iterator
from contextlib import asynccontextmanager, contextmanager
from dataclasses import replace

import pytest

from rosy_sim.config import Config, discover
from rosy_sim.errors import BadInput
from rosy_sim.ownership import robot_configuration
from rosy_sim.ownership.headless_robot_run import run_on_robot
from rosy_sim.ownership.robot_configuration import read_simulator_address
from rosy_sim.ros2 import robot_bridge
from rosy_sim.worker.blocking_worker import BlockingWorker

from ..conftest import PATIENCE
from ..web.page_client import opened, serving
from .fast_dds import compiled_driver, free_domain
from .test_bridge import Process, started

SPEAKER = discover().robot_executable


@asynccontextmanager
async def simulator(config: Config, address: str) -> AsyncIterator[None]:
    """A service with this option, and a page."""
    at_ros2 = replace(config, simulator_address=address)
    async with serving(at_ros2) as (page_address, _service), opened(page_address) as page:
        await page.op("hello")
        yield


@contextmanager
def kept_simulator(config: Config, address: str) -> Iterator[str]:
    """In a thread: runs on robots are those of the main thread, which signals reach."""
    pytest.importorskip("cyclonedds", reason="Cyclone DDS is not installed")
    ready, ended = threading.Event(), threading.Event()

    async def keep() -> None:
        async with simulator(config, address):
            ready.set()
            await asyncio.to_thread(ended.wait)

    thread = threading.Thread(target=lambda: asyncio.run(keep()))
    thread.start()
    try:
        assert ready.wait(PATIENCE)
        yield address
    finally:
        ended.set()
        thread.join()


async def moves(driver: Process) -> None:
    """Until the robot is elsewhere than at first."""
    first = await driver.says("odom odom base_footprint ")
    while (await driver.says("odom odom base_footprint ")) == first:
        continue


@pytest.mark.long
@pytest.mark.parametrize("kind", [(), ("stamped",)], ids=["Twist", "TwistStamped"])
def test_a_program_with_fast_dds_sees_the_robot_and_drives_it(kind: tuple[str, ...], config: Config) -> None:
    async def drive(domain: int) -> None:
        async with simulator(config, f"ros2:{domain}"), started(compiled_driver(), str(domain), *kind) as driver:
            driver.ask("drive 0.2 0")
            await moves(driver)
            while not {"tf odom base_footprint", "tf base_footprint base_scan", "scan base_scan 360"} <= {*driver.said}:
                await driver.says("")

    with free_domain() as domain:
        asyncio.run(drive(domain))


@pytest.mark.long
def test_the_next_page_has_the_robot_when_the_oldest_is_closed(config: Config) -> None:
    async def change(domain: int) -> None:
        at_ros2 = replace(config, simulator_address=f"ros2:{domain}")
        async with serving(at_ros2) as (address, service), contextlib.AsyncExitStack() as first:
            await (await first.enter_async_context(opened(address))).op("hello")
            async with opened(address) as page, started(compiled_driver(), str(domain)) as driver:
                await page.op("hello")
                await driver.says("odom ")
                await first.aclose()
                driver.ask("drive 0.2 0")
                while [session.simulator.world.v > 0 for session in service.sessions.values()] != [True]:
                    await driver.says("odom ")

    with free_domain() as domain:
        asyncio.run(change(domain))


@pytest.mark.long
@pytest.mark.skipif(SPEAKER is None, reason="rosy-robot is not built")
def test_a_program_of_another_process_drives_the_simulated_robot(
    config: Config, capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(robot_bridge, "_DISCOVERY", PATIENCE)
    with free_domain() as domain, kept_simulator(config, f"ros2:{domain}") as address, BlockingWorker(config) as worker:
        worker.ready()
        # Until the robot touches the wall.
        assert run_on_robot(worker, SPEAKER, "drive:0.7 done@touch", f"{address}?rearm=off", PATIENCE)[1] == 0
    last = json.loads(capfd.readouterr().out.splitlines()[-1])
    assert last["ended"] == "done"
    assert last["pose"]["x"] > 0


@pytest.fixture
def installed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(robot_configuration, "check_installed", lambda _installs: None)
    monkeypatch.delenv("ROS_DOMAIN_ID", raising=False)


@pytest.mark.usefixtures("installed")
def test_the_option_takes_a_domain_or_an_address() -> None:
    assert read_simulator_address("ros2:") == "ros2:0"
    assert read_simulator_address("7") == "ros2:7"
    assert read_simulator_address("ros2:7@192.168.1.5/lab") == "ros2:7@192.168.1.5/lab"
    for wrong in ("ws://localhost:9090", "233", "ros2:7?robot=create3", "seven"):
        with pytest.raises(BadInput, match="--ros2 takes a domain"):
            read_simulator_address(wrong)


def test_where_ros_2_is_not_installed_the_command_that_installs_it_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(robot_bridge, "find_spec", lambda _name: None)
    with pytest.raises(BadInput, match=r"\./rosy start --ros2 installs it"):
        read_simulator_address("7")
