"""Fairness of a room: the robot can stand at its start, and can reach every place that a goal asks for."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any

from ...robots import robot_in
from ...world.arena import Arena, ArenaError, read_arena
from ...world.floor_grid import FloorGrid
from ...world.goals import Reach, Visit
from ...world.world import World

__all__ = ["MARGIN", "far_place", "is_fair"]

MARGIN = 0.04
"""Room beside the robot in every passage that it needs, m. Our choice: a quarter of its radius."""


def is_fair(world: dict[str, Any], margin: float = MARGIN) -> bool:
    """Whether the start is free and each place of a goal can be reached, past obstacles and holes."""
    try:
        arena = read_arena(world)
        World(arena, robot_in(arena))
    except ArenaError:
        return False
    grid = FloorGrid(arena, robot_in(arena).body.radius, margin)
    reachable = grid.distances(arena.start.x, arena.start.y)
    centres = [grid.centre(cell) for cell in reachable]
    return all(any(math.dist(centre, (x, y)) <= r for centre in centres) for x, y, r in _places(arena))


def _places(arena: Arena) -> Iterable[tuple[float, float, float]]:
    for goal in arena.goals:
        if isinstance(goal, Reach):
            yield goal.x, goal.y, goal.r
        elif isinstance(goal, Visit):
            for x, y in goal.points:
                yield x, y, goal.r


def far_place(world: dict[str, Any], margin: float = MARGIN) -> tuple[float, float] | None:
    """The position that is farthest from the start along free floor; None when the robot cannot leave its start."""
    arena = read_arena(world)
    grid = FloorGrid(arena, robot_in(arena).body.radius, margin)
    reachable = grid.distances(arena.start.x, arena.start.y)
    if not reachable:
        return None
    x, y = grid.centre(max(reachable, key=lambda cell: (reachable[cell], cell)))
    return round(x, 2), round(y, 2)
