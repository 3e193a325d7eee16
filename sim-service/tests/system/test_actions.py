"""Actions and services as tasks (rule R26): in the simulator, and over rosbridge with roslibpy at the other end."""

from __future__ import annotations

import asyncio
import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import roslibpy
from roslibpy.ros1.actionlib import SimpleActionServer

from rosy_sim.config import discover
from rosy_sim.worker.blocking_worker import BlockingWorker

from ..conftest import PATIENCE
from ..web.page_client import opened, serving
from .real_runs import LIMITS, ran, worker_started

pytestmark = [pytest.mark.real, pytest.mark.skipif(not discover().worker, reason="the worker is not built")]

COUNT = """
data Count = Count Int

newtype Counting = Counting [Int]

newtype Counted = Counted [Int]

instance Action Count Counting Counted where
  action = actionServer "/fibonacci" "actionlib_tutorials/Fibonacci" (\\(Count n) -> [("order", whole n)])
    (Counting <$> field "sequence") (Counted <$> field "sequence")

data Add = Add Int Int

newtype Sum = Sum Int

instance Service Add Sum where
  service = serviceServer "/add_two_ints" "rospy_tutorials/AddTwoInts"
    (\\(Add a b) -> [("a", whole a), ("b", whole b)]) (Sum <$> field "sum")

told :: Outcome a -> String
told outcome = case outcome of
  Succeeded _ -> "done"
  Rejected why -> "rejected: " ++ why
  Aborted why -> why
  Cancelled -> "cancelled"
  Unavailable why -> why
"""


@pytest.fixture(scope="module")
def worker() -> Iterator[BlockingWorker]:
    yield from worker_started()


def said(worker: BlockingWorker, steps: str) -> list[str]:
    """What a program of these steps says in a room without a dock."""
    run = ran(worker, f"main = simulate $ do\n{steps}\n{COUNT}", 20.0)
    return [
        text.removeprefix('Say "').removesuffix('"') for line in run.lines for text in line["commands"] if "Say" in text
    ]


def test_what_the_simulated_robot_does_not_have_is_told_as_a_value(worker: BlockingWorker) -> None:
    assert said(
        worker, "  dock >>= say . told\n  callAction (Count 5) >>= say . told\n  callService (Add 2 3) >>= say . told"
    ) == [
        "Aborted: no dock is in sight.",
        "No action server available",
        "Service /add_two_ints does not exist",
    ]


def test_what_the_robot_has_no_action_for_the_language_does(worker: BlockingWorker) -> None:
    run = ran(worker, "main = simulate $ do\n  driveDistance 0.3\n  rotateAngle 90", 20.0)
    last = run.lines[-1]
    assert (round(last["x"] - run.lines[0]["x"], 2), round(last["theta"] - run.lines[0]["theta"], 1)) == (0.3, 1.6)


ROBOT = f"""main = simulate $ do
  counted <- callAction (Count 5)
  say (case counted of Succeeded (Counted xs) -> show xs; other -> told other)
  docked <- race (wait 1) dock
  say (either (const "given up") told docked)
  added <- callService (Add 2 3)
  say (case added of Succeeded (Sum n) -> show n; other -> told other)
  unknown <- callAction (Missing 1)
  say (told unknown)

newtype Missing = Missing Int

instance Action Missing () () where
  action = actionServer "/missing" "actionlib_tutorials/Fibonacci" (const []) (pure ()) (pure ())
{COUNT}"""

ROOM = {
    "name": "dock",
    "size": [5, 4],
    "start": {"x": 2, "y": 2, "theta": 0},
    "dock": {"x": 4.7, "y": 2, "theta": 0},
}


@pytest.mark.skipif(discover().robot_executable is None, reason="rosy-robot is not built")
def test_over_rosbridge_with_servers_of_roslibpy(tmp_path: Path) -> None:
    program = tmp_path / "Main.hs"
    program.write_text(ROBOT)

    async def tell() -> None:
        async with serving(discover().with_limits(LIMITS)) as (address, _), opened(address) as page:
            session = (await page.op("hello"))["session"]
            await page.send("world", world=ROOM)
            run = await asyncio.to_thread(_run, f"ws://{address}/rosbridge/{session}", program)
            assert run.stdout.splitlines()[:4] == ["[0,1,1,2,3,5]", "given up", "5", "No action server available"], (
                run.stderr
            )
            # A person is told as well.
            assert "/missing" in run.stderr

    asyncio.run(tell())


def _run(url: str, program: Path) -> subprocess.CompletedProcess[str]:
    ros = roslibpy.Ros(url)
    ros.run(timeout=PATIENCE)
    server = SimpleActionServer(ros, "/fibonacci", "actionlib_tutorials/FibonacciAction")

    def count(goal: Any) -> None:
        numbers = [0, 1]
        while len(numbers) <= goal["order"]:
            numbers.append(numbers[-1] + numbers[-2])
            server.send_feedback({"sequence": numbers})
        server.set_succeeded({"sequence": numbers})

    def add(request: Any, response: Any) -> bool:
        response["sum"] = request["a"] + request["b"]
        return True

    server.start(count)
    service = roslibpy.Service(ros, "/add_two_ints", "rospy_tutorials/AddTwoInts")
    service.advertise(add)
    command = [sys.executable, "-m", "rosy_sim", "run", str(program), "--robot", f"{url}?ros=1", "--seconds", "60"]
    environment = {**os.environ, "XDG_DATA_HOME": str(program.parent)}
    run = subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE, env=environment)
    # Not terminate(): it ends the reactor, which all clients of a process share and which cannot be started again.
    ros.close()
    return run
