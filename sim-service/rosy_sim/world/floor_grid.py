"""
Grid over the floor of a room: which cells a round robot can reach, and which its body can cover.

Only sums, products, square roots and comparisons are used for axis-parallel things, so that every machine computes the
same cells for a generated room. Things that can be pushed count as obstacles: nothing here depends on pushing.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Iterator

from .arena import WALL_THICKNESS, Arena, Box, Round, Wall

__all__ = ["CELL", "FloorGrid"]

CELL = 0.1
"""Side of a cell in rooms of ordinary size, m: a quarter of the robot, so that no gap it fits through is lost."""

_MAX_CELLS = 40_000
"""Of a grid; the cells of larger rooms are larger."""

_Cell = tuple[int, int]


class FloorGrid:
    """
    The floor of an arena for a robot of ``radius`` m that keeps ``margin`` m from obstacles and holes.

    A cell is a column and a row from the lower left corner; positions are in m.
    """

    def __init__(self, arena: Arena, radius: float, margin: float = 0.0) -> None:
        self.arena = arena
        self.radius = radius
        # Side of a cell, m.
        self.cell = max(CELL, math.sqrt(arena.width * arena.height / _MAX_CELLS))
        self.columns = max(1, math.ceil(arena.width / self.cell))
        self.rows = max(1, math.ceil(arena.height / self.cell))
        self._blocked = bytearray(self.columns * self.rows)
        self._mark_obstacles(radius + margin)

    def cell_at(self, x: float, y: float) -> _Cell:
        """The cell of a position; positions outside belong to the nearest cell."""
        column, row = int(x / self.cell), int(y / self.cell)
        return max(0, min(self.columns - 1, column)), max(0, min(self.rows - 1, row))

    def centre(self, cell: _Cell) -> tuple[float, float]:
        """The middle of a cell."""
        return (cell[0] + 0.5) * self.cell, (cell[1] + 0.5) * self.cell

    def is_free(self, cell: _Cell) -> bool:
        """Whether the robot can stand with its centre in the middle of a cell."""
        return not self._blocked[cell[1] * self.columns + cell[0]]

    def distances(self, x: float, y: float) -> dict[_Cell, int]:
        """
        The free cells that the robot can reach from a position, nearest first, with the number of cells on the way.

        When the cell of the position itself is too near to something, the way begins at its free neighbours.
        """
        start = self.cell_at(x, y)
        first = [start] if self.is_free(start) else [cell for cell in self._around(start) if self.is_free(cell)]
        found = dict.fromkeys(first, 0)
        queue = deque(first)
        while queue:
            cell = queue.popleft()
            for other in self._beside(cell):
                if other not in found and self.is_free(other):
                    found[other] = found[cell] + 1
                    queue.append(other)
        return found

    def covered_from(self, cells: Iterator[_Cell]) -> set[_Cell]:
        """The cells whose middle is under the robot's body when its centre is in the middle of one of some cells."""
        stamp = self._stamp()
        return {
            (column + i, row + j)
            for column, row in cells
            for i, j in stamp
            if 0 <= column + i < self.columns and 0 <= row + j < self.rows
        }

    def _stamp(self) -> list[_Cell]:
        reach = int(self.radius / self.cell)
        around = range(-reach, reach + 1)
        most = (self.radius / self.cell) ** 2
        return [(i, j) for i in around for j in around if i * i + j * j <= most]

    def _beside(self, cell: _Cell) -> Iterator[_Cell]:
        column, row = cell
        for i, j in ((1, 0), (0, 1), (-1, 0), (0, -1)):
            if 0 <= column + i < self.columns and 0 <= row + j < self.rows:
                yield column + i, row + j

    def _around(self, cell: _Cell) -> Iterator[_Cell]:
        column, row = cell
        for j in (-1, 0, 1):
            for i in (-1, 0, 1):
                if (i or j) and 0 <= column + i < self.columns and 0 <= row + j < self.rows:
                    yield column + i, row + j

    def _mark_obstacles(self, reach: float) -> None:
        arena = self.arena
        self._mark_border(reach)
        tile = arena.tile
        for i, line in enumerate(arena.tiles):
            y = (len(arena.tiles) - 1 - i) * tile
            for j, char in enumerate(line):
                if char != ".":
                    self._mark_rectangle(j * tile, y, (j + 1) * tile, y + tile, reach)
        for wall in arena.walls:
            self._mark_wall(wall, reach + WALL_THICKNESS / 2)
        for box in arena.boxes:
            self._mark_box(box, reach)
        for post in arena.rounds:
            self._mark_round(post, reach)

    def _mark_border(self, reach: float) -> None:
        for row in range(self.rows):
            for column in range(self.columns):
                x, y = self.centre((column, row))
                if min(x, self.arena.width - x, y, self.arena.height - y) < reach:
                    self._blocked[row * self.columns + column] = 1

    def _cells_between(self, x0: float, y0: float, x1: float, y1: float) -> Iterator[tuple[int, float, float]]:
        """Index and middle of the cells around a rectangle; the marks decide which of them are too near."""
        left, low = self.cell_at(x0, y0)
        right, high = self.cell_at(x1, y1)
        for row in range(low, high + 1):
            for column in range(left, right + 1):
                yield row * self.columns + column, (column + 0.5) * self.cell, (row + 0.5) * self.cell

    def _mark_rectangle(self, x0: float, y0: float, x1: float, y1: float, reach: float) -> None:
        for index, x, y in self._cells_between(x0 - reach, y0 - reach, x1 + reach, y1 + reach):
            dx, dy = max(x0 - x, 0.0, x - x1), max(y0 - y, 0.0, y - y1)
            if dx * dx + dy * dy < reach * reach:
                self._blocked[index] = 1

    def _mark_box(self, box: Box, reach: float) -> None:
        if box.theta == 0:
            x0, y0 = box.x - box.w / 2, box.y - box.h / 2
            self._mark_rectangle(x0, y0, x0 + box.w, y0 + box.h, reach)
            return
        c, s = math.cos(box.theta), math.sin(box.theta)
        far = math.sqrt(box.w * box.w + box.h * box.h) / 2 + reach
        for index, x, y in self._cells_between(box.x - far, box.y - far, box.x + far, box.y + far):
            along, across = c * (x - box.x) + s * (y - box.y), c * (y - box.y) - s * (x - box.x)
            dx, dy = max(abs(along) - box.w / 2, 0.0), max(abs(across) - box.h / 2, 0.0)
            if dx * dx + dy * dy < reach * reach:
                self._blocked[index] = 1

    def _mark_round(self, post: Round, reach: float) -> None:
        far = post.r + reach
        for index, x, y in self._cells_between(post.x - far, post.y - far, post.x + far, post.y + far):
            if (x - post.x) ** 2 + (y - post.y) ** 2 < far * far:
                self._blocked[index] = 1

    def _mark_wall(self, wall: Wall, reach: float) -> None:
        dx, dy = wall.x1 - wall.x0, wall.y1 - wall.y0
        length = dx * dx + dy * dy
        x0, x1 = sorted((wall.x0, wall.x1))
        y0, y1 = sorted((wall.y0, wall.y1))
        for index, x, y in self._cells_between(x0 - reach, y0 - reach, x1 + reach, y1 + reach):
            part = ((x - wall.x0) * dx + (y - wall.y0) * dy) / length if length else 0.0
            part = max(0.0, min(1.0, part))
            if (x - wall.x0 - part * dx) ** 2 + (y - wall.y0 - part * dy) ** 2 < reach * reach:
                self._blocked[index] = 1
