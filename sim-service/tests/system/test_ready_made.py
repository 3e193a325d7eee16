"""
Ready-made definitions of the toolbox, by what the robot does with them in three rooms each.

Their text is that of codegen's snapshot.
"""

from __future__ import annotations

import itertools
import math
import re
from collections.abc import Iterator

import pytest

from rosy_sim.config import discover
from rosy_sim.worker.blocking_worker import BlockingWorker
from rosy_sim.world.events import Press
from rosy_sim.worlds.gallery import named_world

from .real_runs import Ran, ran, worker_started

pytestmark = [pytest.mark.real, pytest.mark.skipif(not discover().worker, reason="the worker is not built")]

SNAPSHOT = discover().root / "codegen/test/__snapshots__/readymade.test.ts.snap"
DEFINITIONS = {
    found[2]: found[1].strip()
    for found in re.finditer(
        r'^exports.*?= `\n"(.*?)^main :: IO \(\)\nmain = simulate (\w+)$',
        SNAPSHOT.read_text("utf-8"),
        re.DOTALL | re.MULTILINE,
    )
}
"""The text of each definition, by its name."""


@pytest.fixture(scope="module")
def worker() -> Iterator[BlockingWorker]:
    yield from worker_started()


def runs(
    worker: BlockingWorker, controller: str, room: dict[str, object], seconds: float, *hands: tuple[float, Press]
) -> Ran:
    """Run a controller with the definitions that it names."""
    used = [DEFINITIONS[name] for name in re.findall(r"[a-z]\w+", controller) if name in DEFINITIONS]
    return ran(worker, "\n\n".join([*used, f"main = simulate ({controller})\n"]), seconds, *hands, world=room)


def turned(room: str, degrees: float) -> dict[str, object]:
    """A room of the gallery whose robot starts in another direction."""
    world = named_world(room)
    return {**world, "start": {**world["start"], "theta": math.radians(degrees)}}


def fell(run: Ran) -> bool:
    return bool(run.heard("Wheel", "Air"))


EDGES = {"ahead": turned("table", 0), "at an angle": turned("table", 100), "of a pit": turned("pits", 60)}
"""Rooms with an edge before the robot."""


@pytest.mark.parametrize("room", EDGES.values(), ids=EDGES)
@pytest.mark.parametrize("drives", ["driveOn", "wander"])
def test_it_stops_at_an_edge_for_good(worker: BlockingWorker, room: dict[str, object], drives: str) -> None:
    run = runs(worker, f"priority 3600 stopAtEdge {drives}", room, 40)
    [edge, *_] = run.heard("Cliff", "Hole")
    assert not fell(run)
    assert math.dist(*((line["x"], line["y"]) for line in (run.at(edge + 1), run.lines[-1]))) < 0.001


OUTLINES = {"room": (0, 0, 5, 4), "table": (0.5, 0.5, 4.5, 3.5), "pits": (0.5, 0.5, 5.5, 5)}
"""Least and greatest x and y that each room's outer walls or edges leave, m."""


@pytest.mark.parametrize(("room", "outline"), OUTLINES.items(), ids=OUTLINES)
def test_it_follows_a_wall_and_an_edge_alike(
    worker: BlockingWorker, room: str, outline: tuple[float, float, float, float]
) -> None:
    run = runs(worker, "followWall", named_world(room), 150)
    left, bottom, right, top = outline
    [found, *_] = sorted(run.heard("Bumper", "Pressed") + run.heard("Cliff", "Hole"))
    along = run.between(found, 150)
    assert not fell(run)
    assert max(min(p["x"] - left, right - p["x"], p["y"] - bottom, top - p["y"]) for p in along) < 0.6
    angles = [math.atan2(p["y"] - (bottom + top) / 2, p["x"] - (left + right) / 2) for p in along]
    steps = [math.remainder(after - before, math.tau) for before, after in itertools.pairwise(angles)]
    # The wall is on its right, so that it goes round counter-clockwise.
    assert sum(steps) > 0.4 * math.tau


@pytest.mark.parametrize("room", ["room", "table", "two-rooms"])
def test_it_goes_to_a_place_and_stays(worker: BlockingWorker, room: str) -> None:
    alone = runs(worker, "goToPlace", named_world(room), 30)
    assert (alone.outcome.ended, alone.said) == ("done", ["here I am"])
    before = runs(worker, "priority 3600 goToPlace driveOn", named_world(room), 30)
    for run in (alone, before):
        first, last = run.lines[0], run.lines[-1]
        assert last["x"] - first["x"] == pytest.approx(1, abs=0.02)
        assert last["y"] - first["y"] == pytest.approx(0.5, abs=0.02)
