"""
Reductions of a room: the rooms of its family that lack some of its things.

The things of a room are its walls drawn as lines, boxes and posts, its pits and blocks of tiles; of a generated maze
they are the side cells, which are not on the way from the start to the goal. A fair room stays fair without some of its
things; only a maze would fall apart without cells on the way to others, so those are no rooms of the family.
"""

from __future__ import annotations

from typing import Any, Protocol

from .tile_groups import inner_groups, with_groups

__all__ = ["Reduction", "reduction_of"]

_Json = dict[str, Any]

_Cell = tuple[int, int]


class Reduction(Protocol):
    """``things`` counts those that may be left out; they are numbered from 0."""

    things: int

    def room(self, kept: frozenset[int]) -> _Json | None:
        """The room with only these things, or None when it is not of the family."""


def reduction_of(family: str, world: _Json) -> Reduction:
    """The reduction of a room that ``families`` generated."""
    return _MazeReduction(world) if family == "maze" else _ThingReduction(world)


class _ThingReduction:
    """Leaves out walls, boxes, posts, pits and blocks, but no unknown area, which would become floor."""

    def __init__(self, world: _Json) -> None:
        self._world = world
        self._listed = [
            (key, i)
            for key in ("walls", "boxes", "rounds")
            for i, thing in enumerate(world.get(key, ()))
            if not thing.get("unknown")
        ]
        self._groups = inner_groups(world.get("tiles", ()))
        self.things = len(self._listed) + len(self._groups)

    def room(self, kept: frozenset[int]) -> _Json | None:
        world = dict(self._world)
        left_out = {item for n, item in enumerate(self._listed) if n not in kept}
        for key in ("walls", "boxes", "rounds"):
            if key in world:
                world[key] = [thing for i, thing in enumerate(self._world[key]) if (key, i) not in left_out]
        if self._groups:
            first = len(self._listed)
            world["tiles"] = with_groups(
                world["tiles"],
                [group if first + i in kept else frozenset() for i, group in enumerate(self._groups)],
            )
        return world


class _MazeReduction:
    """
    Walls up side cells of a perfect maze, together with the passages to them.

    A cell is (row, column) in the grid of tiles, both odd; the passage between two cells is the tile between them.
    """

    def __init__(self, world: _Json) -> None:
        self._world = world
        self._tiles: list[str] = world["tiles"]
        start, goal = self._cell(world["start"]), self._cell(world["goals"][0])
        # Each cell with the one before it on the way from the start; None for the start.
        self._before: dict[_Cell, _Cell | None] = {start: None}
        order = [start]
        for cell in order:
            for other in self._open_neighbours(cell):
                if other not in self._before:
                    self._before[other] = cell
                    order.append(other)
        self._way: set[_Cell] = set()
        step: _Cell | None = goal
        while step is not None:
            self._way.add(step)
            step = self._before[step]
        self._sides = [cell for cell in order if cell not in self._way]
        self.things = len(self._sides)

    def _cell(self, place: _Json) -> _Cell:
        tile = self._world["tile"]
        return len(self._tiles) - 1 - int(place["y"] / tile), int(place["x"] / tile)

    def _open_neighbours(self, cell: _Cell) -> list[_Cell]:
        row, column = cell
        ways = ((0, 1), (1, 0), (0, -1), (-1, 0))
        return [(row + 2 * i, column + 2 * j) for i, j in ways if self._tiles[row + i][column + j] == "."]

    def room(self, kept: frozenset[int]) -> _Json | None:
        cells = self._way | {self._sides[i] for i in kept}
        rows = [["#"] * len(line) for line in self._tiles]
        for cell in cells:
            before = self._before[cell]
            if before is None:
                rows[cell[0]][cell[1]] = "."
                continue
            if before not in cells:
                return None
            rows[cell[0]][cell[1]] = rows[(cell[0] + before[0]) // 2][(cell[1] + before[1]) // 2] = "."
        return {**self._world, "tiles": ["".join(row) for row in rows]}
