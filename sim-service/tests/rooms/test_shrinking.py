"""
Shrinking against brute force: for planted faults no room of the family with fewer things fails.

A planted fault is a drive without a program, so that thousands of rooms can be tried: its commands are a function of
the step and of what is pressed.
"""

from __future__ import annotations

import itertools
import random
from collections.abc import Callable, Sequence
from typing import Any

import pytest

from rosy_sim.robots.kobuki import KOBUKI
from rosy_sim.rooms.generation.families import generate_room, read_family
from rosy_sim.rooms.generation.reductions import Reduction, reduction_of
from rosy_sim.rooms.generation.shrinking import shrink
from rosy_sim.world.arena import read_arena
from rosy_sim.world.events import velocity
from rosy_sim.world.goals import Observation
from rosy_sim.world.properties import PropertyTracker, read_properties
from rosy_sim.world.world import World

from ..extent import SEED

Drive = Callable[[int, World], tuple[float, float]]
"""The speed and turn in a step."""


def straight(_step: int, _world: World) -> tuple[float, float]:
    return 0.4, 0.0


def circle(_step: int, _world: World) -> tuple[float, float]:
    return 0.4, 0.35


def spiral(step: int, _world: World) -> tuple[float, float]:
    return min(0.5, 0.001 * step), 0.8


def bounce(step: int, world: World) -> tuple[float, float]:
    """Turn away from bumps, but too little."""
    return (-0.2, 1.2) if world.sensors.bumpers or step % 50 < 12 else (0.4, 0.0)


def forgetful(step: int, world: World) -> tuple[float, float]:
    """Back off from holes for the first five seconds only."""
    return (-0.3, 0.9) if world.sensors.cliffs and step < 250 else (0.3, 0.05)


FAULTS: list[tuple[str, str, Drive]] = [
    ("obstacles", "never-pushes 0.2 s", straight),
    ("obstacles", "reaches-goal", circle),
    ("obstacles", "never-pushes 0.5 s", spiral),
    ("obstacles", "covers 12 %", bounce),
    ("obstacles", "returns-to-start", bounce),
    ("pits", "never-falls", straight),
    ("pits", "never-falls", circle),
    ("pits", "never-falls", forgetful),
    ("maze", "reaches-goal", bounce),
    ("like:pits", "never-falls", straight),
]

SECONDS = 12

MOST_THINGS = 7
"""Of a room that is searched by brute force."""


def fails(room: dict[str, Any], words: str, drive: Drive) -> bool:
    arena = read_arena(room)
    world = World(arena, KOBUKI)
    tracker = PropertyTracker(read_properties(words), arena, KOBUKI.body)
    for step in range(SECONDS * 50):
        world.sense()
        world.command(velocity(*drive(step, world)))
        world.integrate()
        bits = world.sensors
        now = Observation((step + 1) / 50, world.x, world.y, 0, 0, bits.wheels, world.is_blocked)
        tracker.observe(now)
        if tracker.is_decided:
            break
    tracker.finish(SECONDS)
    return tracker.verdicts[0].state == "failed"


def failing_reduction(family: str, words: str, drive: Drive) -> Reduction:
    """Of the first room of some things in which the fault shows."""
    wanted = read_family(family)
    for number in range(1, 100):
        world = generate_room(wanted, SEED, number).world
        reduction = reduction_of(family, world)
        if 3 <= reduction.things <= MOST_THINGS and fails(world, words, drive):
            return reduction
    raise AssertionError("the fault shows nowhere")


@pytest.mark.parametrize("index", range(len(FAULTS)))
def test_the_smallest_failing_room_is_minimal_in_its_family(index: int) -> None:
    family, words, drive = FAULTS[index]
    reduction = failing_reduction(family, words, drive)

    def first_failing(rooms: Sequence[dict[str, Any]]) -> int | None:
        return next((i for i, room in enumerate(rooms) if fails(room, words, drive)), None)

    found = shrink(reduction, first_failing)
    assert found.is_minimal
    assert found.of == reduction.things
    assert fails(found.world, words, drive)
    assert reduction_of(family, found.world).things == found.things
    for count in range(found.things):
        for kept in itertools.combinations(range(reduction.things), count):
            room = reduction.room(frozenset(kept))
            assert room is None or not fails(room, words, drive), f"smaller: {kept}"


class _Numbers:
    """A reduction whose rooms are their things, so that any predicate can be planted."""

    def __init__(self, things: int) -> None:
        self.things = things

    def room(self, kept: frozenset[int]) -> dict[str, Any] | None:
        return {"kept": sorted(kept)}


@pytest.mark.parametrize("seed", range(20))
def test_any_predicate_shrinks_to_a_minimal_set(seed: int) -> None:
    dice = random.Random(seed)
    reasons = [frozenset(dice.sample(range(8), dice.randint(0, 5))) for _ in range(dice.randint(1, 4))]

    def first_failing(rooms: Sequence[dict[str, Any]]) -> int | None:
        return next((i for i, room in enumerate(rooms) if any(r <= set(room["kept"]) for r in reasons)), None)

    found = shrink(_Numbers(8), first_failing)
    assert (found.things, found.is_minimal) == (min(map(len, reasons)), True)


def test_a_search_that_becomes_too_long_says_so() -> None:
    def first_failing(rooms: Sequence[dict[str, Any]]) -> int | None:
        return next((i for i, room in enumerate(rooms) if len(room["kept"]) >= 12), None)

    found = shrink(_Numbers(24), first_failing, 300)
    assert (found.things, found.is_minimal) == (12, False)
    assert found.trials <= 300
