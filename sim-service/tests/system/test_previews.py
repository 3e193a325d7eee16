"""Previews through the real worker: for every example, its path is that of a run with the same inputs."""

from __future__ import annotations

import os
import socket
import time
from collections.abc import Iterator
from dataclasses import replace
from statistics import median

import pytest

from rosy_sim.config import Limits, discover
from rosy_sim.previews.computing_budget import ComputingBudget
from rosy_sim.previews.preview import PreviewTask, RoomCache, preview_over_link, preview_settings
from rosy_sim.run.steps.hands import write_hands
from rosy_sim.run.steps.velocity_guard import OFF
from rosy_sim.wire.page import Previewed
from rosy_sim.wire.worker import Started
from rosy_sim.worker.blocking_worker import BlockingWorker
from rosy_sim.world.events import Lift, Press, UserAction
from rosy_sim.worlds.gallery import named_world

from .real_runs import LIMITS, example, program, worker_started

pytestmark = [pytest.mark.real, pytest.mark.skipif(not discover().worker, reason="the worker is not built")]

EXAMPLES = sorted(path.parent.name for path in discover().examples.glob("*/program.rosy"))

SECONDS = 10.0
"""The shortest run that a page has previewed."""

HANDS: list[tuple[int, UserAction]] = [
    (100, Press(0, True)), (110, Press(0, False)), (200, Lift("both", True)), (240, Lift("both", False)),
]  # fmt: skip
"""Hands, each with its step."""


@pytest.fixture(scope="module")
def worker() -> Iterator[BlockingWorker]:
    yield from worker_started()


def preview(worker: BlockingWorker, name: str, seed: int, source: str = "", limits: Limits = LIMITS) -> Previewed:
    own, world = program(name)
    ours, theirs = socket.socketpair()
    with ours:
        assert isinstance(worker.run(source or own, theirs), Started)
        task = PreviewTask(1, source or own, named_world(world), seed, SECONDS, OFF, write_hands(HANDS))
        budget, world_of_it = ComputingBudget(limits.preview), RoomCache().world(task.world, task.seed)
        found = preview_over_link(task, preview_settings(task, limits), world_of_it, ours, worker, budget.is_used_up)
    worker.kill()
    return found


@pytest.mark.parametrize("name", EXAMPLES)
def test_a_preview_is_the_run_with_the_same_inputs(worker: BlockingWorker, name: str) -> None:
    seed = 3
    run = example(worker, name, SECONDS, *((step / 50, action) for step, action in HANDS), seed=seed)
    found = preview(worker, name, seed)
    assert (found.ended, found.problems) == (run.outcome.ended, run.outcome.problems)
    assert found.pose == pytest.approx((run.world.x, run.world.y, run.world.theta), abs=1e-5)
    for at, x, y in found.path[:-1]:
        if round(at * 50) < len(run.lines):
            assert (x, y) == pytest.approx((run.at(at)["x"], run.at(at)["y"]), abs=0.0006)


def test_a_preview_ends_early_after_its_limit_of_computing(worker: BlockingWorker) -> None:
    whole = preview(worker, "move", 1)
    cut = preview(worker, "move", 1, limits=replace(LIMITS, preview=0.0))
    assert (cut.ended, cut.problems) == ("time", [])
    assert cut.time < whole.time == SECONDS
    assert cut.path[:-1] == whole.path[: len(cut.path) - 1]


def test_an_edited_number_takes_a_fraction_of_a_second(worker: BlockingWorker) -> None:
    """Prints the time from the text to the path for five programs; issue 16 wants 100 ms on a quiet machine."""
    names = ["move", "accelerate", "accelerateAndPlay", "randomWalk", "wander"]
    for name in names:
        times = []
        for edit in range(int(os.environ.get("ROSY_PREVIEWS", "3"))):
            source, _ = program(name)
            began = time.perf_counter()
            assert preview(worker, name, 1, source + "\n" * edit).path
            times.append(time.perf_counter() - began)
        print(f"{name}: {1000 * median(times):.0f} ms from the text to the path of {SECONDS:g} s")
