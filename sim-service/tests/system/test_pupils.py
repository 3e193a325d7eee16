"""
Programs of bright pupils, who use Haskell as they find it in a book: records, maps, classes, types with parameters,
guards, local functions, recursion, and all of Rosy's shapes. Each one in `pupils` checks without a word, and says what
it would say in Haskell.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import pi
from pathlib import Path

import pytest

from rosy_sim.config import discover
from rosy_sim.robots.kobuki.facts import RADIUS
from rosy_sim.worker.blocking_worker import BlockingWorker
from rosy_sim.world.events import Press, Teleport, UserAction
from rosy_sim.world.field_readers import Pose

from .real_runs import ran, worker_started

pytestmark = [pytest.mark.real, pytest.mark.skipif(not discover().worker, reason="the worker is not built")]

PUPILS = Path(__file__).parent / "pupils"

TOUCH: list[tuple[float, UserAction]] = [
    (0.5, Teleport(Pose(20 - RADIUS - 0.05, 10, 0))),
    (1.5, Teleport(Pose(10, 10, pi))),
]
"""A robot that drives presses its front bumper at the wall of the empty world, and lets it go."""

PUSH: list[tuple[float, UserAction]] = [
    (0.1 + 0.4 * k + 0.2 * up, Press(k, not up)) for k in range(3) for up in (False, True)
]
"""The three buttons one after the other, each pressed and let go."""

SAID: dict[str, tuple[list[tuple[float, UserAction]], list[str]]] = {
    "score": ([*TOUCH, (2.0, Press(0, True))], ["CenterBumper=1"]),
    "tells": (PUSH[:2], ["yes&?", "no&?"]),
    "recursion": ([], ["ping 2", "pong", "ping 1", "pong", "(100,Right True,100,8)", "1", "2", "3", "big"]),
    "call": ([(0.1, Press(0, True))], ["got 3"]),
    "nine": (TOUCH, ["(0,0,0,0)", "four", "C0", "C1"]),
    "shapes": (PUSH, ["FROMLIST [CIRCLE {RADIUS = 1.0},SQUARE 2.0]7"]),
    "fibonacci": ([], ["2:1", "4:3", "6:8", "8:21", "10:55"]),
    "legs": ([], ["[0.5,0.5,0.5]"]),
    "tagged": (TOUCH, ["fast 1", "slow 0", "fast 1", "slow 1"]),
    "dice": ([], ["ten dice"]),
    "bag": (PUSH, ["1", "2", "3"]),
    "tree": ([], ["(True,True)"]),
    "guarded": ([], ["both", "again", "again"]),
    "pick": ([], ["none"]),
    "parser": ([], ["there"]),
    "names": ([], ["<2><4><Right><4/2>"]),
}


@pytest.fixture(scope="module")
def worker() -> Iterator[BlockingWorker]:
    yield from worker_started()


@pytest.mark.parametrize("name", sorted(path.stem for path in PUPILS.glob("*.hs")))
def test_it_means_what_it_means_in_haskell(name: str, worker: BlockingWorker) -> None:
    source = (PUPILS / f"{name}.hs").read_text("utf-8")
    hands, said = SAID[name]
    assert worker.check(source).problems == []
    assert ran(worker, source, 15, *hands).said == said
