"""
Path search on a grid (A*), a few cells at a time, so that a large room delays no step.

In: two points and a test whether a robot fits at a point. Out: the corners of a way, or that there is none.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from heapq import heappop, heappush

__all__ = ["CELL", "PathSearch", "Point"]

CELL = 0.05
"""Side of a cell, m: in a corridor of half a metre one row of them has room for a robot of 35 cm."""

_DIAGONAL = math.sqrt(2)
_NEIGHBOURS = [(1, 0, 1.0), (0, 1, 1.0), (-1, 0, 1.0), (0, -1, 1.0)] + [
    (i, j, _DIAGONAL) for i in (1, -1) for j in (1, -1)
]

_CELLS = 100
"""Cells that a call looks at: some 3 ms, since other robots of the service make their steps on the same core."""

Point = tuple[float, float]
_Cell = tuple[int, int]


class PathSearch:
    """The search for one way. The grid has a cell around the start."""

    def __init__(self, start: Point, end: Point, fits: Callable[[float, float], bool]) -> None:
        self._start, self._end, self._fits = start, end, fits
        self._known: dict[_Cell, bool] = {(0, 0): True}
        self._costs: dict[_Cell, float] = {(0, 0): 0.0}
        self._before: dict[_Cell, _Cell] = {}
        self._done: set[_Cell] = set()
        self._target = (round((end[0] - start[0]) / CELL), round((end[1] - start[1]) / CELL))
        self._queue: list[tuple[float, _Cell]] = [(self._estimate((0, 0)), (0, 0))]

    def advance(self) -> list[Point] | None:
        """
        Look at some more cells. The corners of the way from behind the start to its end, none when there is no way;
        ``None`` while that is not known.
        """
        if not self._fits(*self._end):
            return []
        for _ in range(_CELLS):
            if not self._queue:
                return []
            _, cell = heappop(self._queue)
            if cell == self._target:
                return self._corners()
            if cell not in self._done:
                self._done.add(cell)
                self._look_around(cell)
        return None

    def _look_around(self, cell: _Cell) -> None:
        for i, j, length in _NEIGHBOURS:
            found = (cell[0] + i, cell[1] + j)
            cost = self._costs[cell] + length
            if cost < self._costs.get(found, math.inf) and self._is_free(found):
                self._costs[found] = cost
                self._before[found] = cell
                heappush(self._queue, (cost + self._estimate(found), found))

    def _is_free(self, cell: _Cell) -> bool:
        if cell not in self._known:
            self._known[cell] = cell == self._target or self._fits(*self._point(cell))
        return self._known[cell]

    def _estimate(self, cell: _Cell) -> float:
        dx, dy = abs(cell[0] - self._target[0]), abs(cell[1] - self._target[1])
        return max(dx, dy) + (_DIAGONAL - 1) * min(dx, dy)

    def _point(self, cell: _Cell) -> Point:
        return self._start[0] + cell[0] * CELL, self._start[1] + cell[1] * CELL

    def _corners(self) -> list[Point]:
        cells = [self._target]
        while cells[-1] in self._before:
            cells.append(self._before[cells[-1]])
        cells.reverse()
        turns = [
            here
            for before, here, after in zip(cells, cells[1:], cells[2:], strict=False)
            if (here[0] - before[0], here[1] - before[1]) != (after[0] - here[0], after[1] - here[1])
        ]
        return self._straightened([*(self._point(cell) for cell in turns), self._end])

    def _straightened(self, corners: list[Point]) -> list[Point]:
        """Without the corners that a straight way passes by."""
        kept: list[Point] = []
        here = self._start
        while corners:
            seen = max((n for n, corner in enumerate(corners) if n == 0 or self._is_straight(here, corner)), default=0)
            here = corners[seen]
            kept.append(here)
            corners = corners[seen + 1 :]
        return kept

    def _is_straight(self, start: Point, end: Point) -> bool:
        pieces = math.ceil(math.dist(start, end) / CELL)
        return all(
            self._fits(start[0] + (end[0] - start[0]) * n / pieces, start[1] + (end[1] - start[1]) * n / pieces)
            for n in range(1, pieces)
        )
