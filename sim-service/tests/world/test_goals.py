"""Goals: each kind on a path that reaches it and on one that does not, and descriptions that are none."""

from __future__ import annotations

import itertools
import math
from typing import Any

import pytest

from rosy_sim.world.arena import ArenaError, read_arena
from rosy_sim.world.goals import GoalTracker, Observation

Path = list[tuple[float, float]]


def follow(goal: dict[str, Any], path: Path, bumpers: int = 0, wheels: int = 0, speed: float = 0.5) -> GoalTracker:
    """Walk along a path in small steps."""
    goals = GoalTracker(read_arena({"size": [20, 20], "start": {"x": 1, "y": 1}, "goals": [goal]}).goals)
    time = 0.0
    goals.observe(Observation(time, *path[0], 0, 0, 0))
    for (x0, y0), (x1, y1) in itertools.pairwise(path):
        steps = max(1, round(math.dist((x0, y0), (x1, y1)) / (speed * 0.02)))
        for i in range(1, steps + 1):
            time += 0.02
            x, y = x0 + (x1 - x0) * i / steps, y0 + (y1 - y0) * i / steps
            goals.observe(Observation(time, x, y, bumpers, 0, wheels))
    goals.finish(time)
    return goals


SQUARE: Path = [(2, 2), (4, 2), (4, 4), (2, 4), (2, 2)]
LAP = {"kind": "lap", "line": {"from": [3, 1], "to": [3, 3]}}


@pytest.mark.parametrize(
    ("goal", "path", "more", "state"),
    [
        ({"kind": "reach", "x": 5, "y": 1, "r": 0.5}, [(1, 1), (6, 1)], {}, "done"),
        ({"kind": "reach", "x": 5, "y": 5, "r": 0.5}, [(1, 1), (6, 1)], {}, "missed"),
        ({"kind": "reach", "x": 5, "y": 1, "r": 0.5, "within": 5}, [(1, 1), (6, 1)], {}, "missed"),
        ({"kind": "reach", "x": 5, "y": 1, "r": 0.5, "within": 9.5}, [(1, 1), (6, 1)], {}, "done"),
        ({"kind": "touch", "x": 5, "y": 1, "r": 0.5}, [(1, 1), (6, 1)], {}, "missed"),
        ({"kind": "touch", "x": 5, "y": 1, "r": 0.5}, [(1, 1), (6, 1)], {"bumpers": 2}, "done"),
        ({"kind": "avoid", "what": "bumps"}, [(1, 1), (2, 1)], {}, "done"),
        ({"kind": "avoid", "what": "bumps"}, [(1, 1), (2, 1)], {"bumpers": 1}, "missed"),
        ({"kind": "avoid", "what": "holes"}, [(1, 1), (2, 1)], {"wheels": 1}, "missed"),
        ({"kind": "avoid", "x": 5, "y": 5, "r": 1}, [(1, 1), (6, 6)], {}, "missed"),
        ({"kind": "visit", "points": [[1, 1], [5, 1]], "r": 0.3}, [(5, 1), (1, 1)], {}, "done"),
        ({"kind": "visit", "points": [[1, 1], [5, 4]], "r": 0.3}, [(5, 1), (1, 1)], {}, "missed"),
        (LAP, SQUARE, {}, "missed"),
        (LAP, SQUARE + SQUARE, {}, "done"),
        ({**LAP, "laps": 2}, SQUARE + SQUARE, {}, "missed"),
        ({**LAP, "within": 10}, SQUARE + SQUARE, {}, "missed"),
        ({**LAP, "within": 17}, SQUARE + SQUARE, {}, "done"),
        (LAP, [(2, 2), (4, 2), (2, 2), (4, 2), (2, 2)], {}, "missed"),
        ({"kind": "draw", "points": [[2, 2], [4, 2], [4, 4]], "tolerance": 0.1}, SQUARE[:3], {}, "done"),
        ({"kind": "draw", "points": [[2, 2], [4, 2], [4, 4]], "tolerance": 0.1}, SQUARE[:2], {}, "missed"),
        ({"kind": "draw", "points": [[2, 2], [4, 2], [4, 4]], "tolerance": 0.1}, SQUARE[::2], {}, "missed"),
    ],
)  # fmt: skip
def test_a_path_reaches_a_goal_or_misses_it(goal: dict[str, Any], path: Path, more: dict[str, int], state: str) -> None:
    goals = follow(goal, path, **more)
    assert goals.states[0].state == state
    assert goals.reached == (state == "done")
    assert 0 <= goals.states[0].progress <= 1


@pytest.mark.parametrize(
    ("goals", "path"),
    [
        (7, "goals"),
        ([7], "goals[0]"),
        ([{}], "goals[0].kind"),
        ([{"kind": "fly"}], "goals[0].kind"),
        ([{"kind": "reach", "x": 1, "y": 1}], "goals[0].r"),
        ([{"kind": "reach", "y": 1, "r": 1}], "goals[0].x"),
        ([{"kind": "reach", "x": 1, "y": 1, "r": 1, "title": 1}], "goals[0].title"),
        ([{"kind": "reach", "x": 1, "y": 1, "r": 1, "within": -1}], "goals[0].within"),
        ([{"kind": "avoid", "what": "cats"}], "goals[0].what"),
        ([{"kind": "visit", "points": [], "r": 1}], "goals[0].points"),
        ([{"kind": "visit", "points": [[1]], "r": 1}], "goals[0].points[0]"),
        ([{"kind": "lap"}], "goals[0].line"),
        ([{"kind": "lap", "line": {"from": [1, 1]}}], "goals[0].line.to"),
        ([{**LAP, "laps": 1.5}], "goals[0].laps"),
        ([{"kind": "draw", "points": [[1, 1]], "tolerance": 1}], "goals[0].points"),
        ([{"kind": "avoid", "what": "bumps"}] * 11, "goals"),
    ],
)
def test_a_goal_that_is_none_is_refused_with_its_path(goals: object, path: str) -> None:
    with pytest.raises(ArenaError) as caught:
        read_arena({"size": [20, 20], "start": {"x": 1, "y": 1}, "goals": goals})
    assert caught.value.path == path
