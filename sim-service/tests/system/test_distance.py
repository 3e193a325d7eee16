"""Programs that listen to the distance sensor, compiled and run: what they hear, when, and what without a sensor."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest

from rosy_sim.config import discover
from rosy_sim.robots.kobuki import KOBUKI
from rosy_sim.run.headless_run import RunOutput, RunResult, RunSettings, run_program
from rosy_sim.worker.blocking_worker import BlockingWorker
from rosy_sim.world.arena import read_arena
from rosy_sim.world.world import World
from rosy_sim.worlds.gallery import named_world, usable_world

from .real_runs import LIMITS, worker_started

pytestmark = [pytest.mark.real, pytest.mark.skipif(not discover().worker, reason="the worker is not built")]

ROOM = {"size": [4, 4], "start": {"x": 1, "y": 2}}
"""Three metres from the wall ahead."""

EARS = """telling :: Ahead -> Say
telling (Ahead metres) = Say (show metres)

main = simulate telling
"""


@pytest.fixture(scope="module")
def worker() -> Iterator[BlockingWorker]:
    yield from worker_started()


def run(worker: BlockingWorker, source: str, seconds: float, **room: Any) -> tuple[World, RunResult, list[str]]:
    world = World(read_arena({**ROOM, **room}), KOBUKI)
    said: list[str] = []
    result = run_program(worker, source, world, RunSettings(seconds, 1, limits=LIMITS), RunOutput(say=said.append))
    return world, result, said


def test_a_function_of_ahead_fires_five_times_a_second(worker: BlockingWorker) -> None:
    _, result, said = run(worker, EARS, 1.1)
    assert (result.ended, said) == ("time", ["3.0"] * 5)


def test_a_scan_has_360_distances(worker: BlockingWorker) -> None:
    source = """around :: Scan -> Say
around scan = Say (show (length (scanDistances scan), minimum (scanDistances scan), scanFarthest scan))

main = simulate around
"""
    _, _, said = run(worker, source, 0.5)
    assert said == ["(360,1.0,3.5)"] * 2


def test_the_example_stands_half_a_metre_from_the_wall(worker: BlockingWorker) -> None:
    world, result, _ = run(worker, (discover().examples / "keepDistance" / "Main.hs").read_text(), 20)
    assert (result.ended, result.problems) == ("time", [])
    assert world.x == pytest.approx(3.5, abs=0.01)
    assert world.v == pytest.approx(0, abs=0.01)


def test_the_example_with_a_scanner_turns_to_the_gap_and_drives_out(worker: BlockingWorker) -> None:
    source = (discover().examples / "findGap" / "Main.hs").read_text()
    world = usable_world(named_world("gap"), "gap")
    result = run_program(worker, source, world, RunSettings(20, 1, limits=LIMITS), RunOutput())
    assert world.robot.name == "turtlebot3"
    assert (result.ended, [goal.state for goal in result.goals]) == ("time", ["done", "done"])


def test_a_program_with_a_bumper_is_refused_for_a_robot_without_one(worker: BlockingWorker) -> None:
    world = usable_world(named_world("gap"), "gap")
    source = "main = simulate stop\n\nstop :: Bumper -> Velocity\nstop _ = Velocity 0 0\n"
    result = run_program(worker, source, world, RunSettings(20, 1, limits=LIMITS), RunOutput())
    assert (result.ended, result.steps) == ("refused", 0)
    [found] = result.problems
    assert found.message == "The robot (TurtleBot 3) has no Bumper."


def test_a_task_ends_when_something_is_near(worker: BlockingWorker) -> None:
    source = """near :: Ahead -> Maybe (Done ())
near (Ahead metres) = if metres < 1 then Just (Done ()) else Nothing

main = simulate (task (Velocity 0.4 0) near)
"""
    world, result, _ = run(worker, source, 20)
    assert result.ended == "done"
    assert 0.85 < 4 - world.x < 1


def test_only_a_program_that_listens_is_measured_for(worker: BlockingWorker) -> None:
    quiet, _, _ = run(worker, "main = simulate (Velocity 0.2 0)\n", 1)
    assert "Ahead" not in quiet.channels()
    # A task that waits does not listen; the function after it does.
    source = """telling :: Ahead -> Say
telling (Ahead metres) = Say (show metres)

stay :: Bumper -> Done ()
stay _ = Done ()

main = simulate (wait 1 >> task () (telling, stay))
"""
    early, _, _ = run(worker, source, 0.9)
    assert "Ahead" not in early.channels()
    late, _, said = run(worker, source, 2)
    assert said == ["3.0"] * len(said) != []
    # The scanner rests when the program has ended.
    assert late.channels()["Ahead"] == ()


def test_a_program_that_needs_the_sensor_is_told_by_name_before_it_starts(worker: BlockingWorker) -> None:
    _, result, said = run(worker, EARS, 1, scanner=False)
    assert (result.ended, result.steps, said) == ("refused", 0, [])
    [problem] = result.problems
    assert (problem.kind, problem.message) == ("missing-part", "The robot in this room has no Ahead.")
    # The worker is ready for the next program.
    assert run(worker, EARS, 0.3)[2] == ["3.0"]
