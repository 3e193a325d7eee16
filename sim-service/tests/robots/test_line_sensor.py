"""The line sensor: on which side of the nose a line is, and that the rooms with a line can be followed with it."""

from __future__ import annotations

import math
from typing import Any

import pytest

from rosy_sim.robots.kobuki import KOBUKI
from rosy_sim.world.arena import read_arena
from rosy_sim.world.world import World
from rosy_sim.worlds.gallery import named_world

NO_LINE, LEFT, AHEAD, RIGHT = 0, 1, 2, 3

FOLLOW = {AHEAD: (0.2, 0.0), LEFT: (0.1, 1.0), RIGHT: (0.1, -1.0), NO_LINE: (0.0, 0.5)}
"""Speed and turn of the example `followLine`."""


def world(lines: list[dict[str, Any]], theta: float = 0.0) -> World:
    return World(read_arena({"size": [6, 6], "start": {"x": 3, "y": 3, "theta": theta}, "lines": lines}), KOBUKI)


def told(line: dict[str, Any], theta: float = 0.0) -> float | int | str:
    return world([line], theta).channels()["LineSensor"][0]


@pytest.mark.parametrize(
    ("beside", "place"),
    [
        (0.0, AHEAD),
        (0.02, AHEAD),
        (0.05, LEFT),
        (0.11, LEFT),
        (0.13, NO_LINE),
        (-0.05, RIGHT),
        (-0.11, RIGHT),
        (-0.13, NO_LINE),
    ],
)
def test_a_line_along_the_way_is_ahead_or_beside_the_nose(beside: float, place: int) -> None:
    assert told({"points": [[0, 3 + beside], [6, 3 + beside]]}) == place
    # The same, seen the other way round.
    assert told({"points": [[6, 3 - beside], [0, 3 - beside]]}, math.pi) == place


def test_a_line_behind_or_far_ahead_is_none() -> None:
    for x in (2.9, 3.1, 3.22):
        assert told({"points": [[x, 0], [x, 6]]}) == NO_LINE
    assert told({"points": [[3.156, 0], [3.156, 6]]}) == AHEAD


def test_a_wider_line_is_ahead_for_longer() -> None:
    assert told({"points": [[0, 3.09], [6, 3.09]], "width": 0.2}) == AHEAD


def test_a_room_without_a_line_has_none() -> None:
    assert world([]).channels()["LineSensor"] == (NO_LINE,)


@pytest.mark.parametrize(("room", "seconds"), [("oval", 80), ("crossing", 100)])
def test_the_line_of_a_room_is_followed_once_round_and_never_lost(room: str, seconds: int) -> None:
    run = World(read_arena(named_world(room)), KOBUKI)
    start = (run.x, run.y)
    farthest, back = 0.0, False
    for _ in range(seconds * 50):
        place = int(run.channels()["LineSensor"][0])
        assert place != NO_LINE
        run.drive(*FOLLOW[place])
        run.integrate()
        away = math.dist(start, (run.x, run.y))
        farthest = max(farthest, away)
        back = back or (farthest > 2 and away < 0.1)
    assert back
