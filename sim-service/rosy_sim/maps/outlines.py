"""
Outlines of the occupied cells of a grid, and their simplification to few straight lines.

An outline runs through the middles of the cells at the edge of an occupied region, so that a wall with the thickness of
a cell along it covers these cells. Cells that touch at a corner belong together. A wall of one cell has an outline that
goes there and back.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator

from .occupancy import bits

__all__ = ["Cell", "edge_count", "outlines", "segments_of"]

Cell = tuple[int, int]
"""Column and row."""

_Edge = tuple[int, int, int]
"""Between an occupied cell, on its left, and another one: the corner where it begins, and its direction."""

_EAST, _NORTH, _WEST, _SOUTH = range(4)
_STEPS = ((1, 0), (0, 1), (-1, 0), (0, -1))
_LEFT_CELL = ((0, 0), (-1, 0), (-1, -1), (0, -1))
_RIGHT, _AHEAD, _LEFT = -1, 0, 1


def edge_count(rows: list[int]) -> int:
    """How many sides of cells are at the edge of the occupied regions: the work of tracing them."""
    return sum(row.bit_count() for parts in _edge_rows(rows) for row in parts)


def outlines(rows: list[int]) -> Iterator[list[Cell]]:
    """The outlines of all occupied regions, around them and around the holes in them, as closed chains of cells."""
    left = dict.fromkeys(_edges(rows))
    for start in list(left):
        if start in left:
            yield _trace(rows, start, left)


def segments_of(outline: list[Cell], tolerance: float) -> list[tuple[Cell, Cell]]:
    """Straight lines that are nowhere farther than ``tolerance`` cells from an outline (Douglas and Peucker)."""
    if len(set(outline)) < 2:
        return []
    # Two ends that are corners of the outline, wherever it began.
    first = max(outline, key=lambda cell: (math.dist(cell, outline[0]), cell))
    begin = outline.index(first)
    ring = [*outline[begin:], *outline[:begin], first]
    middle = max(range(len(ring)), key=lambda i: (math.dist(ring[i], first), ring[i], -i))
    corners = [*_simplified(ring[: middle + 1], tolerance), *_simplified(ring[middle:], tolerance)[1:]]
    return [(min(pair), max(pair)) for pair in itertools.pairwise(corners)]


def _edge_rows(rows: list[int]) -> Iterator[tuple[int, int, int, int]]:
    """Per row the cells with nothing below, to the right, above and to the left of them."""
    around = [0, *rows, 0]
    for y, row in enumerate(rows):
        yield row & ~around[y], row & ~(row >> 1), row & ~around[y + 2], row & ~(row << 1)


def _edges(rows: list[int]) -> Iterator[_Edge]:
    for y, (below, right, above, left) in enumerate(_edge_rows(rows)):
        yield from ((x, y, _EAST) for x in bits(below))
        yield from ((x + 1, y, _NORTH) for x in bits(right))
        yield from ((x + 1, y + 1, _WEST) for x in bits(above))
        yield from ((x, y + 1, _SOUTH) for x in bits(left))


def _trace(rows: list[int], start: _Edge, left: dict[_Edge, None]) -> list[Cell]:
    """Follow an outline from an edge back to it, and take its edges out of ``left``."""
    cells: list[Cell] = []
    edge = start
    while True:
        del left[edge]
        _append(cells, _cell_of(edge))
        x, y, direction = edge
        corner = (x + _STEPS[direction][0], y + _STEPS[direction][1])
        # To the right first: two cells that touch at a corner are one region.
        for turn in (_RIGHT, _AHEAD, _LEFT):
            edge = (*corner, (direction + turn) % 4)
            if edge in left or edge == start:
                break
        ahead = _cell_of((*corner, direction))
        if turn == _RIGHT and rows[ahead[1]] >> ahead[0] & 1:
            _append(cells, ahead)
        if edge == start:
            return cells[:-1] if len(cells) > 1 and cells[-1] == cells[0] else cells


def _cell_of(edge: _Edge) -> Cell:
    """The cell to the left of an edge."""
    x, y, direction = edge
    return x + _LEFT_CELL[direction][0], y + _LEFT_CELL[direction][1]


def _append(cells: list[Cell], cell: Cell) -> None:
    if not cells or cells[-1] != cell:
        cells.append(cell)


def _simplified(chain: list[Cell], tolerance: float) -> list[Cell]:
    kept = {0, len(chain) - 1}
    pending = [(0, len(chain) - 1)]
    while pending:
        begin, end = pending.pop()
        # By place among equals: the way back along a wall is simplified as the way there.
        farthest, _, index = max(
            ((_distance(chain[i], chain[begin], chain[end]), chain[i], i) for i in range(begin + 1, end)),
            default=(0.0, (0, 0), 0),
        )
        if farthest > tolerance:
            kept.add(index)
            pending += [(begin, index), (index, end)]
    return [chain[i] for i in sorted(kept)]


def _distance(cell: Cell, a: Cell, b: Cell) -> float:
    """From the line between two cells."""
    (x, y), (x0, y0), (x1, y1) = cell, min(a, b), max(a, b)
    dx, dy = x1 - x0, y1 - y0
    squared = dx * dx + dy * dy
    along = max(0.0, min(1.0, ((x - x0) * dx + (y - y0) * dy) / squared)) if squared else 0.0
    return math.hypot(x - x0 - along * dx, y - y0 - along * dy)
