"""Runs without their quiet steps, beside the same runs in which the program is asked in every step: equal bytes."""

from __future__ import annotations

import io
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import pytest

from rosy_sim.config import discover
from rosy_sim.robots.kobuki import KOBUKI
from rosy_sim.run.headless_run import RunOutput, RunSettings, run_program
from rosy_sim.run.steps.lockstep import Lockstep
from rosy_sim.worker.blocking_worker import BlockingWorker
from rosy_sim.world.arena import Pose
from rosy_sim.world.events import Lift, Press, Teleport, UserAction
from rosy_sim.world.world import World
from rosy_sim.worlds.gallery import named_world, usable_arena

from ..mailboxes import CAN_HAVE_MAILBOX
from .real_runs import LIMITS, program, worker_started
from .test_real import PROGRAMS

pytestmark = [pytest.mark.real, pytest.mark.skipif(not discover().worker, reason="the worker is not built")]

EXAMPLES = sorted(path.parent.name for path in discover().examples.glob("*/program.rosy"))

HANDS: list[tuple[float, UserAction]] = [
    (1.02, Press(0, True)), (1.3, Press(0, False)), (2.22, Lift("both", True)), (3.1, Lift("both", False)),
    (4.26, Teleport(Pose(1.0, 1.0, 1.0))), (6.14, Press(1, True)),
]  # fmt: skip
"""Hands, each with its time, s."""

PATIENT = {
    "a pause, and what is read after it": """
main = simulate (do { putVelocity; wait 0.73; report; wait 1.5; report })

putVelocity :: Task ()
putVelocity = once (Velocity 0.3 0.4)

report :: Task ()
report = once tell

tell :: Position -> Orientation -> Seconds -> Say
tell p o s = Say (show (p, o, s))
""",
    "events that read states": """
main = simulate (tell, turns)

tell :: Button -> Velocity -> Position -> Seconds -> Say
tell b v p s = Say (show (b, v, p, s))

turns :: Wheel -> Orientation -> (Velocity, Say)
turns _ o = (Velocity 0.2 0.3, Say (show o))
""",
    "a race against time": """
main = simulate (forever (race (task (Velocity 0.3 0) pressed) (wait 0.9) >>= announce))

pressed :: Button -> Position -> Done Position
pressed _ p = Done p

announce :: Either Position () -> Task ()
announce found = once (tell found)

tell :: Either Position () -> Seconds -> Say
tell found s = Say (show (either show show found, s))
""",
    "a tick and a light": """
main = simulate (blink, tell)

blink :: Memory Bool -> (Led1, Memory Bool)
blink (Memory on) = (if on then Led1 Green else Led1 Black, Memory (not on))

tell :: Button -> Memory Bool -> Velocity -> Say
tell b m v = Say (show (b, v))
""",
}


@pytest.fixture(scope="module")
def worker() -> Iterator[BlockingWorker]:
    yield from worker_started()


def ran(worker: BlockingWorker, source: str, world: dict[str, Any], *, skips: bool) -> tuple[Any, int]:
    """All that is seen of a run, and in how many steps the program was asked."""
    place = World(usable_arena(world, "world"), KOBUKI, 3)
    trace = io.BytesIO()
    said: list[str] = []
    asked = 0

    def observe(lockstep: Lockstep) -> None:
        nonlocal asked
        asked += not lockstep.was_quiet
        assert lockstep.state == "ended" or lockstep.uses_mailbox is (settings.busy_waits and CAN_HAVE_MAILBOX)

    settings = replace(RunSettings(8.0, 3, None, tuple(HANDS), LIMITS), skips_quiet=skips, busy_waits=not skips)
    outcome = run_program(worker, source, place, settings, RunOutput(said.append, trace, observe))
    worker.kill()
    assert outcome.ended != "refused", outcome.problems
    pose = (place.x, place.y, place.theta, place.v, place.w, dict(place.outputs))
    return (outcome.ended, outcome.problems, outcome.goals, outcome.steps, trace.getvalue(), said, pose), asked


@pytest.mark.parametrize("name", EXAMPLES)
def test_an_example_leaves_the_same_trace_with_quiet_steps_as_without(worker: BlockingWorker, name: str) -> None:
    source, world = program(name)
    # The one on a core with its program; the other is asked in each step, and both wait in the mailbox.
    with_quiet, _ = ran(worker, source, named_world(world), skips=True)
    without, asked = ran(worker, source, named_world(world), skips=False)
    assert with_quiet == without
    assert asked >= without[3]


@pytest.mark.parametrize("name", PATIENT)
@pytest.mark.parametrize("realism", [{}, {"realism": {"slip": 0.1, "drift": 0.05, "noise": 0.02, "latency": 0.1}}])
def test_a_program_that_waits_reads_what_it_would_have_read(
    worker: BlockingWorker, name: str, realism: dict[str, Any]
) -> None:
    world = {**named_world("obstacles"), **realism}
    with_quiet, asked = ran(worker, PATIENT[name], world, skips=True)
    without, _ = ran(worker, PATIENT[name], world, skips=False)
    assert with_quiet == without
    assert with_quiet[5], "it says something"
    assert asked < without[3] / 2, "most steps are quiet"


def test_a_program_at_the_default_rate_is_asked_in_every_fifth_step(worker: BlockingWorker) -> None:
    (_, _, _, steps, *_), asked = ran(worker, PROGRAMS["move"], named_world("empty"), skips=True)
    assert steps == 400
    assert 80 <= asked <= 80 + 2 * len(HANDS)
