"""Properties: each on a run that has it and on one that has not, their words, and words that are none."""

from __future__ import annotations

from typing import Any

import pytest

from rosy_sim.robots.kobuki import KOBUKI
from rosy_sim.world.arena import read_arena
from rosy_sim.world.events import velocity
from rosy_sim.world.floor_grid import FloorGrid
from rosy_sim.world.goals import Observation
from rosy_sim.world.properties import BadProperty, PropertyTracker, Verdict, judge, read_properties
from rosy_sim.world.world import World

ROOM: dict[str, Any] = {"size": [4, 3], "start": {"x": 1, "y": 1.5}}
PIT: dict[str, Any] = {"tiles": ["########", "#...OOO#", "########"], "start": {"x": 0.75, "y": 0.75}}
GOAL = {"kind": "reach", "x": 3, "y": 1.5, "r": 0.3}

Drive = list[tuple[float, float, float]]
"""Speed (m/s), turn (rad/s) and for how long (s)."""


def drive(room: dict[str, Any], way: Drive, words: str) -> Verdict:
    """The verdict about one property when the robot is driven some way."""
    arena = read_arena(room)
    world = World(arena, KOBUKI)
    tracker = PropertyTracker(read_properties(words), arena, KOBUKI.body)
    recorded: list[Observation] = []
    time = 0.0
    for v, w, seconds in way:
        for _ in range(round(seconds * 50)):
            world.sense()
            world.command(velocity(v, w))
            world.integrate()
            time += 0.02
            bits = world.sensors
            now = Observation(time, world.x, world.y, bits.bumpers, bits.cliffs, bits.wheels, world.is_blocked)
            recorded.append(now)
            tracker.observe(now)
    tracker.finish(time)
    assert judge(read_properties(words), arena, KOBUKI.body, recorded, time) == tracker.verdicts
    return tracker.verdicts[0]


@pytest.mark.parametrize(
    ("words", "room", "way", "state"),
    [
        ("reaches-goal", {**ROOM, "goals": [GOAL]}, [(0.5, 0, 5)], "held"),
        ("reaches-goal", {**ROOM, "goals": [GOAL]}, [(0.5, 0, 2)], "failed"),
        ("reaches-goal", {**ROOM, "goals": [GOAL, {"kind": "avoid", "what": "bumps"}]}, [(0.5, 0, 9)], "held"),
        ("room-goals", {**ROOM, "goals": [GOAL, {"kind": "avoid", "what": "bumps"}]}, [(0.5, 0, 9)], "failed"),
        ("room-goals", {**ROOM, "goals": [GOAL, {"kind": "avoid", "what": "bumps"}]}, [(0.5, 0, 4)], "held"),
        ("never-falls", PIT, [(0.5, 0, 1)], "held"),
        ("never-falls", PIT, [(0.5, 0, 5)], "failed"),
        ("never-pushes 1 s", ROOM, [(0.5, 0, 4)], "held"),
        ("never-pushes 1 s", ROOM, [(0.5, 0, 9)], "failed"),
        ("never-pushes 1 s", ROOM, [(-0.5, 0, 9)], "failed"),
        ("never-pushes 1 s", ROOM, [(0.5, 0, 6), (0.0, 0, 5)], "held"),
        ("returns-to-start", ROOM, [(0.5, 0, 3.5), (-0.5, 0, 3.5)], "held"),
        ("returns-to-start", ROOM, [(0.5, 0, 3.5)], "failed"),
        ("returns-to-start", ROOM, [(0.0, 1.0, 9)], "failed"),
        ("covers 8 %", ROOM, [(0.5, 0, 7)], "held"),
        ("covers 9 %", ROOM, [(0.5, 0, 7)], "failed"),
    ],
)
def test_a_property_holds_or_fails(words: str, room: dict[str, Any], way: Drive, state: str) -> None:
    assert drive(room, way, words).state == state


def test_a_verdict_tells_when_and_how_much() -> None:
    push = drive(ROOM, [(0.5, 0, 9)], "never-pushes 2 s")
    assert push.time is not None
    # The wall is 2.8 m ahead and the robot needs a second to reach its speed; then it pushes for 2 s.
    assert 7.5 < push.time < 8.6
    assert push.amount == pytest.approx(2.02, abs=0.021)
    assert push.shortfall == 1.0
    swept = drive(ROOM, [(0.5, 0, 7)], "covers 90 %")
    # The robot, 0.35 m wide, sweeps 2.8 m of 4 m by 3 m.
    assert 8 < swept.amount < 9
    assert swept.shortfall == pytest.approx(1 - swept.amount / 100)


def test_a_box_that_is_pushed_is_pushed() -> None:
    box = {"x": 2, "y": 1.5, "w": 0.3, "h": 0.3, "movable": True, "mass": 2.0}
    assert drive({**ROOM, "boxes": [box]}, [(0.3, 0, 6)], "never-pushes 0.5 s").state == "failed"


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("never-falls", "never-falls"),
        ("never-pushes 1 s covers 50 %", "never-pushes 1 s, covers 50 %"),
        ("never-pushes 0.5s,covers 50%", "never-pushes 0.5 s, covers 50 %"),
        ("never-pushes covers", "never-pushes 1 s, covers 50 %"),
        ("covers 30 percent reaches-goal", "covers 30 %, reaches-goal"),
    ],
)
def test_properties_are_words(text: str, words: str) -> None:
    found = read_properties(text)
    assert ", ".join(map(str, found)) == words
    assert read_properties(words) == found


@pytest.mark.parametrize(
    "text",
    ["", "flies", "never-falls 3", "never-falls never-falls", "covers 0 %", "covers 101", "never-pushes -1 s",
     "never-pushes inf", "1 s"],
)  # fmt: skip
def test_other_words_are_refused_with_a_sentence(text: str) -> None:
    with pytest.raises(BadProperty, match=r"^[A-Z].*\.$"):
        read_properties(text)


def test_the_floor_that_can_be_reached_ends_at_what_blocks() -> None:
    divided = {**ROOM, "walls": [{"from": [2, 0], "to": [2, 3]}]}
    grid = FloorGrid(read_arena(divided), KOBUKI.body.radius)
    reached = grid.distances(1, 1.5)
    assert all(grid.centre(cell)[0] < 2 - 0.025 - KOBUKI.body.radius for cell in reached)
    gap = FloorGrid(read_arena({**ROOM, "walls": [{"from": [2, 0], "to": [2, 2.4]}]}), KOBUKI.body.radius)
    assert gap.cell_at(3, 1.5) in gap.distances(1, 1.5)
    narrow = FloorGrid(read_arena({**ROOM, "walls": [{"from": [2, 0], "to": [2, 2.7]}]}), KOBUKI.body.radius)
    assert narrow.cell_at(3, 1.5) not in narrow.distances(1, 1.5)


@pytest.mark.parametrize(
    "thing",
    [
        {"boxes": [{"x": 2, "y": 1.5, "w": 0.6, "h": 0.4, "theta": 0.7}]},
        {"boxes": [{"x": 2, "y": 1.5, "w": 0.6, "h": 0.4}]},
        {"rounds": [{"x": 2, "y": 1.5, "r": 0.3}]},
        {"walls": [{"from": [1.5, 1], "to": [3, 2]}]},
    ],
)
def test_free_cells_are_where_the_physics_lets_the_robot_stand(thing: dict[str, Any]) -> None:
    arena = read_arena({**ROOM, **thing, "start": {"x": 0.5, "y": 0.5}})
    grid = FloorGrid(arena, KOBUKI.body.radius)
    obstacles = World(arena, KOBUKI).obstacles
    for row in range(grid.rows):
        for column in range(grid.columns):
            gap = obstacles.clearance_at(*grid.centre((column, row))).free + KOBUKI.body.contact_gap
            # What lies within a tenth of a millimetre of the limit may go either way.
            assert grid.is_free((column, row)) == (gap >= 0) or abs(gap) < 1e-4
