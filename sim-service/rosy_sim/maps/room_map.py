"""
Map of a room as ROS has it, ``nav_msgs/OccupancyGrid``: what a scan of the empty room would have found.

Everything that stands fast is occupied, and so are holes, where no robot may go; what can be pushed is left out, and
what no scan has seen is unknown. The origin of the map is the lower left corner of the room.
"""

from __future__ import annotations

import math
from typing import Any

from PIL import Image, ImageDraw

from ..world.arena import WALL_THICKNESS, Arena, Box

__all__ = ["RESOLUTION", "room_map"]

RESOLUTION = 0.05
"""Side of a cell, m: the default of slam_toolbox and of Cartographer's nodes for ROS. Large rooms have larger ones."""

_MOST_CELLS = 160_000
"""Of a map: 20 by 20 m in cells of 5 cm."""

_FREE, _OCCUPIED, _UNKNOWN = 0, 100, 255
"""As the message has them; as signed bytes the last is -1."""

_SCALE = 4
"""Points of the drawing on a side of a cell: a cell is occupied that has anything of an obstacle in it."""


def room_map(arena: Arena) -> dict[str, Any]:
    """The message without its header; the first row of ``data`` is the lowest."""
    resolution = max(RESOLUTION, math.sqrt(arena.width * arena.height / _MOST_CELLS))
    width, height = math.ceil(arena.width / resolution), math.ceil(arena.height / resolution)
    drawing = _Drawing(width, height, _SCALE / resolution)
    drawing.draw(arena)
    data = drawing.cells()
    origin = {"position": {"x": 0.0, "y": 0.0, "z": 0.0}, "orientation": {"x": 0.0, "y": 0.0, "z": 0.0, "w": 1.0}}
    return {
        "info": {"resolution": resolution, "width": width, "height": height, "origin": origin},
        "data": [-1 if cell == _UNKNOWN else cell for cell in data],
    }


class _Drawing:
    """An image whose first row is the lowest of the room; ``points`` are those on a metre."""

    def __init__(self, width: int, height: int, points: float) -> None:
        self._size = (width, height)
        self._points = points
        self._image = Image.new("L", (width * _SCALE, height * _SCALE), _FREE)
        self._draw = ImageDraw.Draw(self._image)

    def draw(self, arena: Arena) -> None:
        for box in arena.boxes:
            if box.unknown:
                self._box(box, _UNKNOWN)
        corners = [(0.0, 0.0), (arena.width, 0.0), (arena.width, arena.height), (0.0, arena.height)]
        for (x0, y0), (x1, y1) in zip(corners, corners[1:] + corners[:1], strict=True):
            self._line(x0, y0, x1, y1)
        for row, tiles in enumerate(reversed(arena.tiles)):
            for column, tile in enumerate(tiles):
                if tile != ".":
                    self._tile(column * arena.tile, row * arena.tile, arena.tile)
        for wall in arena.walls:
            self._line(wall.x0, wall.y0, wall.x1, wall.y1)
        for box in arena.boxes:
            if not box.movable and not box.unknown:
                self._box(box, _OCCUPIED)
        for post in arena.rounds:
            if not post.movable:
                self._disc(post.x, post.y, post.r)

    def cells(self) -> bytes:
        """The largest of the levels in each cell: what is occupied goes before what is free."""
        image = self._image
        # A cell of both is occupied.
        unknown = image.point(lambda level: 255 if level == _UNKNOWN else 0).reduce(_SCALE)
        occupied = image.point(lambda level: 255 if level == _OCCUPIED else 0).reduce(_SCALE)
        pairs = zip(occupied.tobytes(), unknown.tobytes(), strict=True)
        return bytes(_OCCUPIED if hit else _UNKNOWN if unseen > 127 else _FREE for hit, unseen in pairs)

    def _box(self, box: Box, level: int) -> None:
        c, s = math.cos(box.theta), math.sin(box.theta)
        sides = [(box.w / 2 * i, box.h / 2 * j) for i, j in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
        self._polygon([(box.x + c * x - s * y, box.y + s * x + c * y) for x, y in sides], level)

    def _line(self, x0: float, y0: float, x1: float, y1: float) -> None:
        """A wall, with its round ends."""
        self._draw.line([self._at(x0, y0), self._at(x1, y1)], _OCCUPIED, max(1, round(WALL_THICKNESS * self._points)))
        for x, y in ((x0, y0), (x1, y1)):
            self._disc(x, y, WALL_THICKNESS / 2)

    def _disc(self, x: float, y: float, radius: float) -> None:
        (left, low), (right, high) = self._at(x - radius, y - radius), self._at(x + radius, y + radius)
        self._draw.ellipse((left, low, right, high), _OCCUPIED)

    def _tile(self, x: float, y: float, side: float) -> None:
        # Its last points are those before the next tile.
        (left, low), (right, high) = self._at(x, y), self._at(x + side, y + side)
        self._draw.rectangle((round(left), round(low), round(right) - 1, round(high) - 1), _OCCUPIED)

    def _polygon(self, corners: list[tuple[float, float]], level: int) -> None:
        self._draw.polygon([self._at(x, y) for x, y in corners], level)

    def _at(self, x: float, y: float) -> tuple[float, float]:
        return x * self._points, y * self._points
