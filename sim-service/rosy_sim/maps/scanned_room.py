"""
Rooms from maps: a map file and its image in, a world as ``protocol/world.schema.json`` says out.

The axes of the room are those of the image, moved to the lower left corner of what is known; the yaw of a map turns
only the start. What no scan has seen becomes boxes marked as unknown: nothing enters them.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path

from ..errors import BadInput
from ..robots import ROBOTS
from ..sentences.sentence import tr
from ..world.arena import MAX_SHAPES, WALL_THICKNESS
from ..world.field_readers import MAX_SIDE, MIN_LENGTH
from .map_file import MapFile, read_map_file
from .map_image import read_map_image
from .occupancy import Occupancy, eroded, occupancy_of
from .outlines import Cell, edge_count, outlines, segments_of
from .unknown_areas import CellRectangle, unknown_areas

__all__ = ["SMALLEST", "ScannedRoom", "room_of_map"]

SMALLEST = 3
"""Fewest cells of an obstacle. Laser scanners leave single cells and pairs in the open that are nothing."""

_TOLERANCE = 1.0
"""How far a wall may be from the cells that it stands for, cells: the cells of a straight line are that far from it."""

_MAX_EDGES = 200_000
"""Most sides of cells that are traced: 10 km of wall in cells of 5 cm, some seconds. Noise has more."""

_DECIMALS = 4
"""Of lengths in the room, m."""

_WIDE = 2.0
"""Space around the start that is enough, m."""


@dataclass(frozen=True, slots=True)
class ScannedRoom:
    """A world as JSON has it, and how many obstacles were too small to be kept."""

    world: dict[str, object]
    width: float
    height: float
    walls: int
    start: tuple[float, float]
    specks: int
    # Area that no scan has seen, m².
    unknown: float


def room_of_map(path: Path) -> ScannedRoom:
    """
    The room of a map.

    Raises:
        BadInput: the map or its image cannot be read, or makes no room.
    """
    file = read_map_file(path)
    full = occupancy_of(read_map_image(file.image), file)
    if not any(full.free):
        raise BadInput(tr("{path} has no free cells, so there is no room in it.", path=path))
    if edge_count(full.occupied) > _MAX_EDGES:
        raise BadInput(tr("The obstacles in {path} are too ragged to be walls; smooth the image first.", path=path))
    found, specks = _without_specks(full)
    grid = full.cropped()
    size = file.resolution
    width, height = round(grid.width * size, _DECIMALS), round(grid.height * size, _DECIMALS)
    if max(width, height) > MAX_SIDE:
        raise BadInput(
            tr(
                "{path} is {width} by {height} metres; a room can be at most {most} metres long.",
                path=path,
                width=width,
                height=height,
                most=MAX_SIDE,
            )
        )
    lines = dict.fromkeys(line for outline in found for line in segments_of(outline, _TOLERANCE))
    if len(lines) > MAX_SHAPES:
        raise BadInput(
            tr(
                "{path} makes {walls} walls; a room can hold {most}. Cut a part out of its image.",
                path=path,
                walls=len(lines),
                most=MAX_SHAPES,
            )
        )
    areas = unknown_areas(grid, MAX_SHAPES - len(lines))
    if areas is None:
        raise BadInput(
            tr("The area that no scan has seen in {path} is too ragged; cut a part out of its image.", path=path)
        )
    for area in areas:
        for row in area.rows():
            grid.free[row] &= ~area.mask()
    x, y = _start(path, file, grid)
    world: dict[str, object] = {
        "name": path.stem,
        "size": [width, height],
        "start": {"x": x, "y": y, "theta": round(-file.origin[2], _DECIMALS) + 0.0},
        "walls": [{"from": _middle(a, grid, size), "to": _middle(b, grid, size)} for a, b in lines],
        **({"boxes": [_box(area, size) for area in areas]} if areas else {}),
    }
    unknown = sum(row.bit_count() for row in grid.unknown()) * size * size
    return ScannedRoom(world, width, height, len(lines), (x, y), specks, unknown)


def _without_specks(grid: Occupancy) -> tuple[list[list[Cell]], int]:
    """The outlines of what is large enough, and how many specks there were; their cells become what is around them."""
    kept: list[list[Cell]] = []
    specks = 0
    for outline in outlines(grid.occupied):
        cells = set(outline)
        # The outline of fewer than four cells passes through all of them, and a hole has at least four around it.
        if len(cells) >= SMALLEST:
            kept.append(outline)
            continue
        specks += 1
        beside = {(x + i, y + j) for x, y in cells for i, j in ((0, 1), (0, -1), (1, 0), (-1, 0))}
        in_the_open = any(0 <= y < grid.height and x >= 0 and grid.free[y] >> x & 1 for x, y in beside)
        for x, y in cells:
            grid.occupied[y] &= ~(1 << x)
            grid.free[y] |= in_the_open << x
    return kept, specks


def _middle(cell: Cell, grid: Occupancy, size: float) -> list[float]:
    x, y = cell
    return [round((x - grid.left + 0.5) * size, _DECIMALS), round((y - grid.bottom + 0.5) * size, _DECIMALS)]


def _box(area: CellRectangle, size: float) -> dict[str, object]:
    """A box of the room that stands for an unknown area."""
    return {
        "x": round((area.left + area.right) / 2 * size, _DECIMALS),
        "y": round((area.bottom + area.top) / 2 * size, _DECIMALS),
        "w": max(MIN_LENGTH, round((area.right - area.left) * size, _DECIMALS)),
        "h": max(MIN_LENGTH, round((area.top - area.bottom) * size, _DECIMALS)),
        "unknown": True,
    }


def _start(path: Path, file: MapFile, grid: Occupancy) -> tuple[float, float]:
    """The origin of the map when the robot has space there, or else the place with the most."""
    size = file.resolution
    radius = max(robot.body.radius for robot in ROBOTS.values())
    needed = math.ceil((radius + WALL_THICKNESS) / size) + 1
    rows, wide, space = grid.free, grid.free, 0
    while space < max(needed, math.ceil(_WIDE / size)):
        # Squares and crosses in turn make octagons, which hold a disc of as many cells.
        smaller = eroded(rows, square=space % 2 == 0)
        if not any(smaller):
            break
        rows, space = smaller, space + 1
        if space == needed:
            wide = rows
    if space < needed:
        raise BadInput(tr("No place in {path} is wide enough for the robot to stand on.", path=path))
    x, y = _map_origin(file, grid)
    column, row = math.floor(x / size), math.floor(y / size)
    if 0 <= row < grid.height and column >= 0 and wide[row] >> column & 1:
        return round(x, _DECIMALS), round(y, _DECIMALS)
    filled = [i for i, cells in enumerate(rows) if cells]
    row = filled[len(filled) // 2]
    columns = [column for column in range(grid.width) if rows[row] >> column & 1]
    column = columns[len(columns) // 2]
    return round((column + 0.5) * size, _DECIMALS), round((row + 0.5) * size, _DECIMALS)


def _map_origin(file: MapFile, grid: Occupancy) -> tuple[float, float]:
    """Where (0, 0) of the map is in the room, m."""
    x, y, yaw = file.origin
    c, s = math.cos(yaw), math.sin(yaw)
    return -c * x - s * y - grid.left * file.resolution, s * x - c * y - grid.bottom * file.resolution
