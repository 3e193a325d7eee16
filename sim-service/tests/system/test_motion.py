"""Motion of the simulated base under programs of each kind (rules R9 and R21) and under the ready-made tasks."""

from __future__ import annotations

import math
from collections.abc import Iterator

import pytest

from rosy_sim.config import discover
from rosy_sim.worker.blocking_worker import BlockingWorker
from rosy_sim.world.events import Press
from rosy_sim.worlds.gallery import named_world

from .real_runs import ran, worker_started

pytestmark = [pytest.mark.real, pytest.mark.skipif(not discover().worker, reason="the worker is not built")]


@pytest.fixture(scope="module")
def worker() -> Iterator[BlockingWorker]:
    yield from worker_started()


EVENT_ONLY = """
go :: Button -> Maybe Velocity
go (Button Button0 Pressed) = Just (Velocity 0.2 0)
go (Button Button1 Pressed) = Just (Velocity 0 0)
go _ = Nothing

main = simulate go
"""

FIVE_SECONDS = """
go :: Seconds -> Velocity
go now = if now < 5 then Velocity 0.2 0 else Velocity 0 0

main = simulate go
"""

STATES = """
go :: Position -> Velocity
go (Position x _) = if x < 1 then Velocity 0.2 0 else Velocity 0 0

main = simulate go
"""

ONCE_IN_A_TASK = "main = simulate $ once (Velocity 0.2 0) >> wait 5 >> once (Velocity 0 0) >> wait 1"

PRESSES = ((1.0, Press(0, True)), (6.0, Press(1, True)))


@pytest.mark.parametrize("source", [EVENT_ONLY, FIVE_SECONDS, STATES, ONCE_IN_A_TASK])
def test_a_velocity_holds_whatever_kind_of_program_commands_it(worker: BlockingWorker, source: str) -> None:
    run = ran(worker, source, 10, *PRESSES)
    assert run.world.x - run.lines[0]["x"] == pytest.approx(1.0, abs=0.03)
    assert run.world.v == 0.0


CENTIMETRE, DEGREE = 0.01, math.radians(1)


@pytest.mark.parametrize(
    ("steps", "x", "y", "theta"),
    [
        ("drive 50", 0.5, 0, 0),
        ("drive (-50)", -0.5, 0, 0),
        ("drive 3", 0.03, 0, 0),
        ("drive 0", 0, 0, 0),
        ("drive 200", 2, 0, 0),
        ("turn 90", 0, 0, 90),
        ("turn (-90)", 0, 0, -90),
        ("turn 5", 0, 0, 5),
        ("turn 180", 0, 0, 180),
        ("turn 720", 0, 0, 720),
        ("turn 90 >> drive 50", 0, 0.5, 90),
        ("replicateM_ 4 (drive 50 >> turn 90)", 0, 0, 360),
        ("goTo 1 0", 1, 0, 0),
        ("goTo 0 (-1)", 0, -1, None),
        ("goTo (-1) 0", -1, 0, None),
        ("goTo 0 0", 0, 0, 0),
        ("turn 90 >> drive 50 >> goTo 0 0", 0, 0, None),
        ("race (wait 1) (drive 500) >> wait 1 >> drive 0", None, 0, 0),
        ("drive 20 >> beep >> blink Orange >> drive 20", 0.4, 0, 0),
        ("driveUntil (\\(Button _ _) -> Done ()) >> turn 90", 0.19, 0, 90),
    ],
)
def test_ready_made_tasks_are_accurate(
    worker: BlockingWorker, steps: str, x: float | None, y: float, theta: float | None
) -> None:
    run = ran(worker, f"main = simulate ({steps})\n", 60, (1.0, Press(0, True)))
    first, world = run.lines[0], run.rest()
    assert run.outcome.ended == "done"
    assert (world.v, world.w) == (0.0, 0.0)
    if x is not None:
        assert world.x - first["x"] == pytest.approx(x, abs=CENTIMETRE)
    assert world.y - first["y"] == pytest.approx(y, abs=CENTIMETRE)
    if theta is not None:
        assert world.theta - first["theta"] == pytest.approx(math.radians(theta), abs=DEGREE)


def test_drive_until_bump_gives_the_side_and_stands(worker: BlockingWorker) -> None:
    run = ran(worker, "main = simulate (driveUntilBump >>= say . show)\n", 60, world=named_world("room"))
    assert run.outcome.ended == "done"
    assert run.said == ["CenterBumper"]
    assert run.rest().v == 0.0


def test_a_program_may_define_these_names_itself(worker: BlockingWorker) -> None:
    source = "turn :: Velocity\nturn = Velocity 0 1\n\ndrive = 5\n\nmain = simulate (turn, Say (show drive))\n"
    run = ran(worker, source, 2)
    assert run.outcome.ended == "time"
    assert run.said[0] == "5"
    assert run.at(1.9)["w"] == pytest.approx(1.0)
