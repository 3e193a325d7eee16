"""
Families of rooms: each room is a pure function of the family, a seed and its number.

``obstacles``  a hall of 4 to 7 m with 3 to 9 boxes and posts
``maze``       a perfect maze of 3 to 5 by 3 to 5 cells of 0.6 m
``pits``       a walled floor of tiles with 3 to 7 pits
``like:ROOM``  a room of the gallery or of a file: mirrored, its things, start and heading moved a little
``in:ROOM``    room 1 is that room itself, the others are those of ``like:ROOM``

Every room is fair (``fairness``) and has a place to reach, but for rooms like one with goals of its own. Lengths are
multiples of 5 cm, so that a saved room reads like one drawn by hand.
"""

from __future__ import annotations

import copy
import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from ...errors import BadInput
from ...sentences.sentence import tr
from ...worlds.gallery import load_world, usable_arena
from .dice import Dice
from .fairness import far_place, is_fair
from .variation import vary

__all__ = ["FAMILIES", "Family", "Room", "family_like", "generate_room", "read_family"]

GOAL_RADIUS = 0.3
"""Of the place to reach, m."""

_TILE, _MAZE_TILE = 0.5, 0.6
"""Sides of the tiles of a pit room and of a maze, m. A maze leaves the robot, 0.35 m wide, 0.25 m."""

FAMILIES = ("obstacles", "maze", "pits")
"""Families that need no room to begin with."""

_Json = dict[str, Any]


@dataclass(frozen=True, slots=True)
class Room:
    """A generated room: its number from 1, the world as JSON, and the seed of the run in it."""

    number: int
    world: _Json
    seed: int


@dataclass(frozen=True, slots=True)
class Family:
    """``base`` is the room of ``like:ROOM`` and ``in:ROOM``; None for the others."""

    name: str
    base: _Json | None = None


def read_family(text: str) -> Family:
    """
    The family of a name such as ``maze`` or ``like:room``.

    Raises:
        BadInput: there is no such family, or its room cannot be used.
    """
    if text in FAMILIES:
        return Family(text)
    kind, colon, room = text.partition(":")
    if kind not in ("like", "in") or not colon or not room:
        raise BadInput(
            tr(
                "There is no family of rooms called {text}; there are {families}, like:ROOM and in:ROOM.",
                text=repr(text),
                families=list(FAMILIES),
            )
        )
    return family_like(load_world(room), text)


def family_like(world: _Json, name: str) -> Family:
    """
    The family of rooms like one; with a ``name`` that begins with ``in:``, room 1 is the room itself.

    Raises:
        BadInput: the room is none, or its goals cannot be reached.
    """
    usable_arena(world, name)
    if not is_fair(world, 0.0):
        raise BadInput(tr("The robot cannot get to the goals of this room, so rooms like it would be unfair."))
    return Family(name, world)


def generate_room(family: Family, seed: int, number: int) -> Room:
    """The room of a family with this number, from 1."""
    dice = Dice(f"{family.name if family.base is None else 'like'}:{seed}:{number}")
    run_seed = dice.seed()
    if family.base is None:
        world = _GENERATORS[family.name](dice)
    elif number == 1 and family.name.startswith("in:"):
        world = _with_goal(copy.deepcopy(family.base))
    else:
        world = _like(dice, family.base)
    return Room(number, {"name": f"{family.name} {number}", **world}, run_seed)


def _reach(x: float, y: float) -> _Json:
    return {"kind": "reach", "x": x, "y": y, "r": GOAL_RADIUS, "title": str(tr("Reach the goal"))}


def _heading(dice: Dice, steps: int = 8) -> float:
    """A multiple of a full turn divided by ``steps``, rad."""
    return round(dice.whole(0, steps - 1) * math.tau / steps, 4)


def _obstacles(dice: Dice) -> _Json:
    width, height = dice.step(4.0, 7.0, 0.5), dice.step(4.0, 6.0, 0.5)
    start = (dice.step(0.5, 1.0, 0.1), dice.step(0.5, height - 0.5, 0.1))
    goal = (dice.step(width - 1.2, width - 0.6, 0.1), dice.step(0.6, height - 0.6, 0.1))
    boxes: list[_Json] = []
    rounds: list[_Json] = []
    for _ in range(dice.whole(3, 9)):
        x, y = dice.step(0.3, width - 0.3, 0.05), dice.step(0.3, height - 0.3, 0.05)
        if dice.whole(0, 2):
            w, h = dice.step(0.2, 1.0, 0.1), dice.step(0.2, 1.0, 0.1)
            if _is_clear(x, y, max(w, h) * 0.75, start, goal):
                boxes.append({"x": x, "y": y, "w": w, "h": h})
        else:
            r = dice.step(0.1, 0.3, 0.05)
            if _is_clear(x, y, r, start, goal):
                rounds.append({"x": x, "y": y, "r": r})
    world: _Json = {
        "size": [width, height],
        "start": {"x": start[0], "y": start[1], "theta": _heading(dice)},
        "boxes": boxes,
        "rounds": rounds,
        "goals": [_reach(*goal)],
    }
    # Without any thing every such room is fair.
    while not is_fair(world):
        (boxes or rounds).pop()
    return world


def _is_clear(x: float, y: float, size: float, *places: tuple[float, float]) -> bool:
    """Whether a thing leaves the robot space at some places."""
    return all(math.dist((x, y), place) > size + 0.4 for place in places)


def _maze(dice: Dice) -> _Json:
    columns, rows = dice.whole(3, 5), dice.whole(3, 5)
    grid = [["#"] * (2 * columns + 1) for _ in range(2 * rows + 1)]
    first = (dice.choice((0, columns - 1)), dice.choice((0, rows - 1)))
    grid[2 * first[1] + 1][2 * first[0] + 1] = "."
    distance = {first: 0}
    stack = [first]
    while stack:
        column, row = stack[-1]
        beside = ((column + 1, row), (column, row + 1), (column - 1, row), (column, row - 1))
        new = [(i, j) for i, j in beside if 0 <= i < columns and 0 <= j < rows and (i, j) not in distance]
        if not new:
            stack.pop()
            continue
        i, j = dice.choice(new)
        grid[2 * j + 1][2 * i + 1] = grid[row + j + 1][column + i + 1] = "."
        distance[i, j] = distance[column, row] + 1
        stack.append((i, j))
    goal = max(distance, key=lambda cell: (distance[cell], cell))

    def middle(cell: tuple[int, int]) -> tuple[float, float]:
        return round((2 * cell[0] + 1.5) * _MAZE_TILE, 3), round((2 * rows - 2 * cell[1] - 0.5) * _MAZE_TILE, 3)

    (x, y), place = middle(first), middle(goal)
    return {
        "tile": _MAZE_TILE,
        "tiles": ["".join(line) for line in grid],
        "start": {"x": x, "y": y, "theta": _heading(dice, 4)},
        "goals": [_reach(*place)],
    }


def _pits(dice: Dice) -> _Json:
    columns, rows = dice.whole(8, 12), dice.whole(7, 10)
    start, goal = (dice.whole(1, 2), dice.whole(1, rows - 2)), (columns - 2, dice.whole(1, rows - 2))
    pits: list[list[tuple[int, int]]] = []
    for _ in range(dice.whole(3, 7)):
        i, j = dice.whole(1, columns - 2), dice.whole(1, rows - 2)
        w, h = dice.choice(((1, 1), (2, 1), (1, 2), (2, 2)))
        tiles = [(a, b) for a in range(i, min(i + w, columns - 1)) for b in range(j, min(j + h, rows - 1))]
        if all(max(abs(a - c), abs(b - d)) > 1 for a, b in tiles for c, d in (start, goal)):
            pits.append(tiles)

    def middle(tile: tuple[int, int]) -> tuple[float, float]:
        return (tile[0] + 0.5) * _TILE, (rows - tile[1] - 0.5) * _TILE

    (x, y), place = middle(start), middle(goal)
    heading = _heading(dice)
    while True:
        holes = {tile for pit in pits for tile in pit}
        border = "#" * columns
        inner = [
            "#" + "".join("O" if (i, j) in holes else "." for i in range(1, columns - 1)) + "#"
            for j in range(1, rows - 1)
        ]
        world: _Json = {
            "tile": _TILE,
            "tiles": [border, *inner, border],
            "start": {"x": x, "y": y, "theta": heading},
            "goals": [_reach(*place)],
        }
        # Without any pit every such room is fair.
        if is_fair(world):
            return world
        pits.pop()


_GENERATORS: dict[str, Callable[[Dice], _Json]] = {"obstacles": _obstacles, "maze": _maze, "pits": _pits}


def _like(dice: Dice, base: _Json) -> _Json:
    """A variation of a room; smaller ones are tried when larger ones are not fair."""
    for scale in (1.0, 1.0, 1.0, 1.0, 0.5, 0.5, 0.5, 0.25, 0.25, 0.0):
        world = vary(dice, base, scale)
        if is_fair(world, 0.0):
            break
    return _with_goal(world)


def _with_goal(world: _Json) -> _Json:
    """The room with a place to reach, if it has no goals."""
    if not world.get("goals"):
        place = far_place(world, 0.0)
        if place is not None:
            world["goals"] = [_reach(*place)]
    return world
