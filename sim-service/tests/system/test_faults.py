"""
Faults that earlier versions of Rosy had, each through the worker and the simulator: a learner's program must not meet
them again. Faults of the language alone are in the library's suite, faults of the robot's physics in `test_world.py`.
"""

from __future__ import annotations

import asyncio
import math
from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise

import pytest

from rosy_sim.config import discover
from rosy_sim.robots.kobuki.facts import MAX_SPEED
from rosy_sim.wire.problem import Place
from rosy_sim.worker.blocking_worker import BlockingWorker
from rosy_sim.world.events import Press
from rosy_sim.worlds.gallery import named_world

from ..web.page_client import opened, serving
from .real_runs import LIMITS, program, ran, worker_started

pytestmark = [pytest.mark.real, pytest.mark.skipif(not discover().worker, reason="the worker is not built")]

SMALL = replace(LIMITS, memory=4 * 1024 * 1024)
"""Limits of a program that may not have much memory."""

GO_ON = """
goOn :: Position -> Velocity
goOn _ = Velocity 0.3 0

driving :: Task ()
driving = task () goOn
"""
"""A task that drives and never ends."""


@pytest.fixture(scope="module")
def worker() -> Iterator[BlockingWorker]:
    yield from worker_started()


def test_the_loser_of_a_race_drives_no_more(worker: BlockingWorker) -> None:
    run = ran(worker, GO_ON + "\nmain = simulate (race driving (wait 1) >> wait 3)\n", 10)
    assert run.outcome.ended == "done"
    assert run.at(0.9)["v"] == pytest.approx(0.3)
    assert max(time for time, v, _ in run.velocities() if v != 0) <= 1.0
    assert run.at(3.9)["v"] == 0.0


def test_a_sequence_that_loses_a_race_after_its_first_step_is_stopped_as_well(worker: BlockingWorker) -> None:
    run = ran(worker, GO_ON + "\nmain = simulate (race (wait 0.5 >> driving) (wait 1.5) >> wait 3)\n", 10)
    assert run.outcome.ended == "done"
    assert run.at(1.4)["v"] == pytest.approx(0.3)
    assert max(time for time, v, _ in run.velocities() if v != 0) <= 1.5
    assert run.at(4.4)["v"] == 0.0


def test_the_robot_is_told_to_stop_at_the_end_of_the_last_task(worker: BlockingWorker) -> None:
    run = ran(worker, GO_ON + "\nmain = simulate (race driving (wait 2))\n", 10)
    assert run.outcome.ended == "done"
    assert run.velocities()[-1][1:] == (0.0, 0.0)
    assert run.lines[-1]["v"] == pytest.approx(0.3)
    world = run.world
    world.integrate(0.2)
    assert (world.v, world.w) == (0.0, 0.0)


def test_a_run_ends_at_an_empty_place_when_it_needs_it(worker: BlockingWorker) -> None:
    source = """
main = simulate (Velocity 0.5 0, back)

back :: Button -> Seconds -> Velocity
back (Button _ Pressed) t = Velocity _speed 0
back _ _ = Velocity 0 _
"""
    run = ran(worker, source, 10, (2.0, Press(0, True)))
    assert run.outcome.ended == "error"
    (found,) = run.outcome.problems
    assert (found.kind, found.function, found.start, found.end) == ("hole", "back", Place(5, 38), Place(5, 44))
    assert found.message == "The run came to the empty place ‘_speed’ in ‘back’ (line 5)."
    assert found.hint == "It needs a ‘Double’; you have ‘t :: Seconds’."
    assert run.velocities()[-1][1:] == (0.0, 0.0)


def test_the_robot_is_told_to_stop_when_a_function_fails(worker: BlockingWorker) -> None:
    source = """
boom :: Button -> Sound
boom _ = error "no such sound"

main = simulate (Velocity 0.5 0, boom)
"""
    run = ran(worker, source, 10, (2.0, Press(0, True)))
    assert run.outcome.ended == "error"
    assert run.outcome.problems[0].function == "boom"
    assert run.velocities()[-1][1:] == (0.0, 0.0)


def test_parallel_of_two_tasks_with_results_of_one_type_waits_for_both(worker: BlockingWorker) -> None:
    source = """
later :: Seconds -> Int -> Task Int
later time n = wait time >> return n

main = simulate $ do
  (a, b) <- parallel (later 1 10) (later 2 20)
  say (show (a, b))
"""
    run = ran(worker, source, 10)
    assert run.said == ["(10,20)"]
    assert run.lines[-1]["t"] == pytest.approx(2.0, abs=0.1)


def test_what_is_remembered_begins_with_the_first_constructor_though_it_has_fields(worker: BlockingWorker) -> None:
    source = """
data H = HA Int | HB

look :: Button -> Memory H -> Say
look _ (Memory (HA n)) = Say ("HA " ++ show n)
look _ (Memory HB) = Say "HB"

main = simulate look
"""
    assert ran(worker, source, 1, (0.5, Press(1, True))).said == ["HA 0"]


def test_an_event_that_nobody_took_does_not_arrive_in_a_later_task(worker: BlockingWorker) -> None:
    source = """
data Ping = Ping Int

hear :: Ping -> Say
hear (Ping n) = Say (show n)

again :: Button -> Ping
again (Button _ _) = Ping 2

main = simulate $ do
  once (Ping 1)
  wait 0.5
  task () (again, hear) :: Task ()
"""
    assert ran(worker, source, 2, (1.0, Press(0, True))).said == ["2"]


@pytest.mark.parametrize("theta", [0.0, 1.2, math.pi, -2.0])
def test_position_and_heading_are_in_the_frame_of_the_start_however_the_robot_is_turned(
    theta: float, worker: BlockingWorker
) -> None:
    source = """
look :: Button -> Position -> Orientation -> Say
look _ (Position x y) angle = Say (unwords [show x, show y, show (realToFrac angle :: Double)])

main = simulate (Velocity 0.5 0, look)
"""
    hall = {**named_world("empty"), "start": {"x": 10, "y": 10, "theta": theta}}
    run = ran(worker, source, 4, (3.0, Press(0, True)), (3.1, Press(0, False)), world=hall)
    x, y, angle = map(float, run.said[0].split())
    # An event comes before the odometry of its packet, so what it reads is a packet old.
    driven = math.dist((run.at(2.98)["x"], run.at(2.98)["y"]), (10.0, 10.0))
    assert driven > 1
    assert x == pytest.approx(driven, abs=1e-6)
    assert y == pytest.approx(0.0, abs=1e-6)
    assert angle == pytest.approx(0.0, abs=1e-6)


@pytest.mark.parametrize("theta", [0.0, 2.0])
def test_backward_drives_backwards_and_ends(theta: float, worker: BlockingWorker) -> None:
    source, _ = program("moveAhead")
    only = source[: source.index("main =")] + "main = simulate (move (Backward 50))\n"
    hall = {**named_world("empty"), "start": {"x": 10, "y": 10, "theta": theta}}
    run = ran(worker, only, 20, world=hall)
    assert run.outcome.ended == "done"
    ahead = (run.world.x - 10) * math.cos(theta) + (run.world.y - 10) * math.sin(theta)
    assert ahead == pytest.approx(-0.5, abs=0.03)
    assert max(line["v"] for line in run.lines) == 0.0


def test_no_program_drives_faster_or_brakes_harder_than_the_motors_can(worker: BlockingWorker) -> None:
    source = """
flee :: Clock -> Velocity
flee (Clock _ _ second _)
  | even second = Velocity 9 0
  | otherwise = Velocity (-9) 0

main = simulate flee
"""
    speeds = [line["v"] for line in ran(worker, source, 10).lines]
    assert (max(speeds), min(speeds)) == (MAX_SPEED, -MAX_SPEED)
    steps = [later - earlier for earlier, later in pairwise(speeds)]
    assert max(map(abs, steps)) == pytest.approx(0.04)


@pytest.mark.parametrize(
    "name", ["r", "g", "b", "red", "green", "reset", "kill", "cancel", "swap", "seconds", "race", "turn", "call"]
)
def test_a_program_may_call_its_own_function(name: str, worker: BlockingWorker) -> None:
    source = f"""
{name} :: Button -> Say
{name} _ = Say "mine"

main = simulate {name}
"""
    assert ran(worker, source, 1, (0.5, Press(0, True))).said == ["mine"]


def test_the_list_function_init_means_what_it_means_in_haskell(worker: BlockingWorker) -> None:
    assert ran(worker, 'main = simulate (say (init "abc"))\n', 1).said == ["ab"]


@pytest.mark.parametrize(
    ("source", "line"),
    [
        ("main = simulate stop\n\nstop = Velocity 0 True\n", 3),
        ("stop :: Velocity\nstop = Velocity 0 (0 +\n\nmain = simulate stop\n", 2),
    ],
    ids=["a wrong type", "a missing bracket"],
)
def test_a_problem_is_in_the_line_that_the_learner_wrote(source: str, line: int, worker: BlockingWorker) -> None:
    first = worker.check(source).problems[0]
    assert first.start is not None
    assert first.start.line == line


_HIT = "hit :: Button -> Done ()\nhit _ = Done ()\n\npush :: Task ()\npush = task () hit\n\n"


@pytest.mark.parametrize(
    ("function", "source"),
    [
        ("dizzy", 'main = simulate (dizzy >> say "never")\n\ndizzy :: Task ()\ndizzy = forever (pure ())\n'),
        (
            "dizzy",
            "main = simulate (push >> dizzy 1)\n\n" + _HIT + 'dizzy n = if n > 0 then dizzy n else say "never"\n',
        ),
        (
            "dizzy",
            "main = simulate (parallel (wait 9) (dizzy 2))\n\n" + _HIT + "dizzy :: Int -> Task ()\n"
            "dizzy n = do\n  push\n  say (show n)\n  go 1\n  where\n    go m = if m > n then pure () else go (m - 1)\n",
        ),
        ("main", "main = simulate (push >> forever (pure ()))\n\n" + _HIT),
    ],
    ids=["from the start", "after another task", "in a local function", "in main"],
)
def test_tasks_that_never_let_time_pass_are_stopped_and_blamed_on_the_definition_they_stand_in(
    function: str, source: str, worker: BlockingWorker
) -> None:
    run = ran(worker, source, 5, (0.5, Press(0, True)), limits=replace(LIMITS, settle=1.0))
    assert run.outcome.ended == "stuck"
    [problem] = run.outcome.problems
    assert problem.function == function
    assert "`wait`" in problem.hint


EAT = """
eat :: Bumper -> Velocity
eat _ = Velocity (fromIntegral (length xs + last xs)) 0
  where
    xs = [1 .. 6000000 :: Int]

main = simulate (Velocity 0.7 0, eat)
"""
"""A program that dies of its memory at the first bump, without a word."""

NO_MEMORY = ("memory", "eat", "eat needed too much memory.", "It may build something without end.")
"""What is said of that."""


def test_a_program_that_dies_of_its_memory_leaves_the_name_of_the_function_and_the_time() -> None:
    with BlockingWorker(discover().with_limits(SMALL)) as worker:
        worker.ready()
        run = ran(worker, EAT, 20)
    [problem] = run.outcome.problems
    assert run.outcome.ended == "error"
    assert (problem.kind, problem.function, problem.message, problem.hint) == NO_MEMORY
    # It died at the bump. A step that it died in without a word is not in the trace.
    bumps = [line["t"] for line in run.lines if any(event.startswith("Bumper") for event in line["events"])]
    assert problem.time == pytest.approx(bumps[0] if bumps else len(run.lines) * 0.02)


def test_a_page_is_told_which_function_a_program_died_of_and_when() -> None:
    async def play() -> None:
        async with serving(discover().with_limits(SMALL)) as (address, _), opened(address) as page:
            await page.send("run", run=1, source=EAT, speed="max")
            ended = await page.ended(1)
            [problem] = ended["problems"]
            assert ended["ended"] == "error"
            assert tuple(problem[key] for key in ("kind", "function", "message", "hint")) == NO_MEMORY
            assert problem["time"] > 0

    asyncio.run(play())
