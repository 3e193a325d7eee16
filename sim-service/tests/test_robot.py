"""``./rosy run --robot``: a program drives a robot behind a rosbridge server: ours, whose robot is simulated."""

from __future__ import annotations

import asyncio
import json
import queue
import threading
from typing import Any

import pytest

from rosy_sim.config import Config, discover
from rosy_sim.errors import BadInput
from rosy_sim.native import run_natively
from rosy_sim.worker.blocking import BlockingWorker

from .conftest import PATIENCE
from .test_app import Page, opened, serving

SPEAKER = discover().speaker

pytestmark = pytest.mark.skipif(SPEAKER is None, reason="rosy-robot is not built")


def test_a_program_drives_a_robot_until_it_bumps_and_is_done(config: Config, capfd: pytest.CaptureFixture[str]) -> None:
    """The service has a thread of its own: signals, which stop the robot, come to the main one."""
    robots: queue.Queue[str] = queue.Queue()
    through = threading.Event()

    async def serve() -> None:
        async with serving(config) as (address, _), opened(address) as page:
            hello = await page.op("hello")
            await page.send("input", teleport={"x": 4.7, "y": 2.0, "theta": 0.0})
            robots.put(f"ws://{address}/rosbridge/{hello['session']}?safety=off")
            await _sees(page)
            await asyncio.to_thread(through.wait)

    def drive(source: str, seconds: float = 60.0) -> int:
        with BlockingWorker(config) as worker:
            worker.ready()
            return run_natively(worker, SPEAKER, source, address, seconds)[1]

    service = threading.Thread(target=asyncio.run, args=(serve(),))
    service.start()
    address = robots.get(timeout=PATIENCE)
    try:
        assert drive("drive:0.5 bump led:2@3 say:hi@4 done@100") == 0
        *said, last = capfd.readouterr().out.splitlines()
        assert said == ["hi"]
        assert_ended(last, "done", 100)
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
    await page.until(lambda m: m["op"] == "frame" and m["led1"] == 2)
    await page.until(lambda m: m["op"] == "frame" and m["bumpers"] == 2)
    await page.until(lambda m: m["op"] == "frame" and m["x"] < 4.6 and m["v"] < 0)
    await page.until(lambda m: m["op"] == "frame" and m["v"] == 0)


@pytest.mark.parametrize(
    ("address", "why"),
    [
        ("http://pi", "is no robot"),
        ("ws://pi?ros=3", "does not fit the option ros"),
        ("ws://127.0.0.1:1", "No robot answers"),
    ],
)
def test_an_address_where_no_robot_is_is_refused_before_anything_is_compiled(
    address: str, why: str, config: Config
) -> None:
    with BlockingWorker(config) as worker, pytest.raises(BadInput, match=why):
        run_natively(worker, SPEAKER, "drive:0.5", address, 1.0)
