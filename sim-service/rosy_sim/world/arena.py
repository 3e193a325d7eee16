"""
The description of a room, and its reader: plain values in (as JSON gives them), an ``Arena`` out, or
an ``ArenaError`` that says where the description is wrong and why.

Messages are for learners who draw rooms by hand. The format is ``protocol/world.schema.json``; what a
schema cannot say (rows of one length, a start on the floor) is checked here and in ``world.py``.
"""

from __future__ import annotations

from dataclasses import dataclass

from ..sentences.sentence import tr
from .field_readers import (
    MAX_SIDE,
    ArenaError,
    Pose,
    flag,
    items,
    number,
    object_fields,
    point,
    points,
    positive,
    required,
)
from .goals import Goal, read_goals
from .realism import Realism, read_realism

__all__ = [
    "DEFAULT_BOX_MASS",
    "DEFAULT_TILE",
    "MAX_LINES",
    "MAX_MOVABLE",
    "MAX_SHAPES",
    "MAX_SIDE",
    "MAX_TILES",
    "WALL_THICKNESS",
    "Arena",
    "ArenaError",
    "Box",
    "FloorLine",
    "Pose",
    "Round",
    "Wall",
    "read_arena",
]

WALL_THICKNESS = 0.05
"""Of a wall drawn as a line, m. protocol/README.md, World."""

DEFAULT_TILE = 0.5
"""Side of a tile when the world does not say, m. protocol/README.md, World."""

DEFAULT_BOX_MASS = 1.0
"""Of a movable thing when the world does not say, kg: light enough for a small robot to push."""

MAX_TILES = 40_000
"""Largest tile grid."""

MAX_SHAPES = 2_000
"""Most walls, boxes and rounds together."""

DEFAULT_LINE_WIDTH = 0.05
"""Of a line on the floor when the world does not say, m."""

MAX_LINES = 10
"""Most lines on the floor; each has at most 200 points."""

MAX_MOVABLE = 200
"""Most boxes and rounds that can be pushed. They take some 15 ms to build; 2,000 took 400 to 900 ms."""


@dataclass(frozen=True, slots=True)
class Wall:
    """A straight wall, ``WALL_THICKNESS`` wide with round ends."""

    x0: float
    y0: float
    x1: float
    y1: float


@dataclass(frozen=True, slots=True)
class Box:
    """
    A block given by its centre; ``mass`` in kg matters only when it is movable. ``unknown`` marks an area that no scan
    has seen, which is shown hatched and blocks like a block that stands fast.
    """

    x: float
    y: float
    w: float
    h: float
    theta: float = 0.0
    movable: bool = False
    mass: float = DEFAULT_BOX_MASS
    unknown: bool = False


@dataclass(frozen=True, slots=True)
class Round:
    """A post or a drum of radius ``r``, given by its centre."""

    x: float
    y: float
    r: float
    movable: bool = False
    mass: float = DEFAULT_BOX_MASS


@dataclass(frozen=True, slots=True)
class FloorLine:
    """A black line on the floor from point to point, ``width`` m wide with round ends. It blocks nothing."""

    points: tuple[tuple[float, float], ...]
    width: float = DEFAULT_LINE_WIDTH


@dataclass(frozen=True, slots=True)
class Arena:
    """A room. ``tiles`` has its first row at the top; it is empty when the whole room is floor."""

    name: str
    width: float
    height: float
    start: Pose
    tile: float = DEFAULT_TILE
    tiles: tuple[str, ...] = ()
    walls: tuple[Wall, ...] = ()
    boxes: tuple[Box, ...] = ()
    rounds: tuple[Round, ...] = ()
    goals: tuple[Goal, ...] = ()
    # None for an ideal robot.
    realism: Realism | None = None
    # Where a docked robot stands; None without a dock.
    dock: Pose | None = None
    # Charge of the battery at the start, 0 to 1.
    battery: float = 1.0
    # Whether the robot carries a laser scanner.
    scanner: bool = True
    lines: tuple[FloorLine, ...] = ()
    # Name of the robot; None for the usual one.
    robot: str | None = None

    def tile_at(self, x: float, y: float) -> str:
        """``#``, ``.`` or ``O`` under a point; the world outside is wall."""
        if not (0 <= x < self.width and 0 <= y < self.height):
            return "#"
        if not self.tiles:
            return "."
        row = len(self.tiles) - 1 - int(y / self.tile)
        column = int(x / self.tile)
        if not (0 <= row < len(self.tiles) and column < len(self.tiles[0])):
            return "#"
        return self.tiles[row][column]

    def is_hole(self, x: float, y: float) -> bool:
        """Whether a point has no floor under it."""
        return bool(self.tiles) and self.tile_at(x, y) == "O"


def read_arena(value: object) -> Arena:
    """
    Check a world as JSON gives it and build the arena.

    Raises:
        ArenaError: the first thing that is wrong, with its path.
    """
    fields = object_fields(value, "")
    known = {
        "name",
        "size",
        "start",
        "tile",
        "tiles",
        "walls",
        "boxes",
        "rounds",
        "goals",
        "title",
        "realism",
        "dock",
        "battery",
        "scanner",
        "lines",
        "robot",
    }
    for key in fields:
        if key not in known:
            raise ArenaError(key, tr("a world has nothing of that name; perhaps it is of a newer Rosy."))
    name = fields.get("name", "")
    if not isinstance(name, str):
        raise ArenaError("name", tr("the name must be text."))
    if not isinstance(fields.get("title", ""), str):
        raise ArenaError("title", tr("the title must be text."))
    tile = number(fields.get("tile", DEFAULT_TILE), "tile")
    if not 0.05 <= tile <= 10:
        raise ArenaError("tile", tr("a tile must be between 0.05 and 10 metres wide."))
    tiles = _tiles(fields.get("tiles", []))
    width, height = _size(fields.get("size"), tile, tiles)
    lists = [items(fields, key) for key in ("walls", "boxes", "rounds")]
    if sum(map(len, lists)) > MAX_SHAPES:
        # Before they are read, which takes long.
        raise ArenaError("walls", tr("a world can hold at most {most} things.", most=MAX_SHAPES))
    if sum(isinstance(v, dict) and v.get("movable") is True for v, _ in (*lists[1], *lists[2])) > MAX_MOVABLE:
        raise ArenaError("boxes", tr("a world can hold at most {most} things that can be pushed.", most=MAX_MOVABLE))
    walls = tuple(_wall(v, p) for v, p in lists[0])
    boxes = tuple(_box(v, p) for v, p in lists[1])
    rounds = tuple(_round(v, p) for v, p in lists[2])
    goals = read_goals(fields)
    realism = read_realism(fields["realism"]) if "realism" in fields else None
    if "start" not in fields:
        raise ArenaError("start", tr("the world does not say where the robot starts."))
    start = _pose(fields["start"], "start")
    dock = _pose(fields["dock"], "dock") if "dock" in fields else None
    if dock is not None and not (0 <= dock.x < width and 0 <= dock.y < height):
        raise ArenaError("dock", tr("the dock is outside the room."))
    battery = number(fields.get("battery", 1.0), "battery")
    if not 0 <= battery <= 1:
        raise ArenaError("battery", tr("the battery must be between 0, empty, and 1, full."))
    scanner = flag(fields, "scanner", missing=True)
    robot = fields.get("robot")
    if robot is not None and not isinstance(robot, str):
        raise ArenaError("robot", tr("the robot must be text."))
    things = (tile, tiles, walls, boxes, rounds, goals)
    parts = (realism, dock, battery, scanner, _lines(fields), robot)
    return Arena(name, width, height, start, *things, *parts)


def _lines(fields: dict[str, object]) -> tuple[FloorLine, ...]:
    found = items(fields, "lines")
    if len(found) > MAX_LINES:
        raise ArenaError("lines", tr("a world can have at most {most} lines on the floor.", most=MAX_LINES))
    return tuple(_line(object_fields(value, path), path) for value, path in found)


def _line(fields: dict[str, object], path: str) -> FloorLine:
    width = positive(fields, "width", path) if "width" in fields else DEFAULT_LINE_WIDTH
    return FloorLine(points(fields, path, 2), width)


def _tiles(value: object) -> tuple[str, ...]:
    if not isinstance(value, list):
        raise ArenaError("tiles", tr("expected a list of rows."))
    if sum(len(row) for row in value if isinstance(row, str)) > MAX_TILES:
        # Before they are read, which takes long.
        raise ArenaError("tiles", tr("a world can have at most {most} tiles.", most=MAX_TILES))
    rows: list[str] = []
    for i, row in enumerate(value):
        path = f"tiles[{i}]"
        if not isinstance(row, str):
            raise ArenaError(path, tr("a row must be text."))
        if rows and len(row) != len(rows[0]):
            raise ArenaError(
                path, tr("this row has {count} tiles, the first one has {first}.", count=len(row), first=len(rows[0]))
            )
        for column, char in enumerate(row):
            if char not in "#.O":
                raise ArenaError(
                    path,
                    tr(
                        "tile {number} is {char}; use # for wall, . for floor and O for a hole.",
                        number=column + 1,
                        char=repr(char),
                    ),
                )
        rows.append(row)
    if rows and not rows[0]:
        raise ArenaError("tiles[0]", tr("the row is empty."))
    if rows and not any("." in row for row in rows):
        raise ArenaError("tiles", tr("there is no floor; the robot needs at least some tiles marked with a dot."))
    return tuple(rows)


def _size(value: object, tile: float, tiles: tuple[str, ...]) -> tuple[float, float]:
    grid = (len(tiles[0]) * tile, len(tiles) * tile) if tiles else None
    if value is None:
        if grid is None:
            raise ArenaError("size", tr("a world needs a size or tiles; without them there is no floor."))
        width, height = grid
    else:
        if not isinstance(value, list) or len(value) != 2:
            raise ArenaError("size", tr("expected two numbers, width and height."))
        width, height = number(value[0], "size[0]"), number(value[1], "size[1]")
        if grid is not None and (abs(width - grid[0]) > 1e-3 or abs(height - grid[1]) > 1e-3):
            raise ArenaError(
                "size",
                tr(
                    "the tiles fill {width} by {height} metres; leave the size out or make it the same.",
                    width=grid[0],
                    height=grid[1],
                ),
            )
    for i, side in enumerate((width, height)):
        if not 0 < side <= MAX_SIDE:
            raise ArenaError(
                f"size[{i}]" if value is not None else "tiles",
                tr("a room must be more than 0 and at most {most} metres long.", most=MAX_SIDE),
            )
    return width, height


def _pose(value: object, path: str) -> Pose:
    fields = object_fields(value, path)
    theta = number(fields.get("theta", 0.0), f"{path}.theta")
    return Pose(required(fields, "x", path), required(fields, "y", path), theta)


def _wall(value: object, path: str) -> Wall:
    fields = object_fields(value, path)
    return Wall(*point(fields.get("from"), f"{path}.from"), *point(fields.get("to"), f"{path}.to"))


def _mass(fields: dict[str, object], path: str) -> float:
    value = number(fields.get("mass", DEFAULT_BOX_MASS), f"{path}.mass")
    if not 0.05 <= value <= 1000:
        raise ArenaError(f"{path}.mass", tr("it must weigh between 0.05 and 1000 kilograms."))
    return value


def _box(value: object, path: str) -> Box:
    fields = object_fields(value, path)
    movable, unknown = flag(fields, "movable", path), flag(fields, "unknown", path)
    if movable and unknown:
        raise ArenaError(f"{path}.movable", tr("an unknown area cannot be pushed."))
    return Box(
        required(fields, "x", path),
        required(fields, "y", path),
        positive(fields, "w", path),
        positive(fields, "h", path),
        number(fields.get("theta", 0.0), f"{path}.theta"),
        movable,
        _mass(fields, path),
        unknown,
    )


def _round(value: object, path: str) -> Round:
    fields = object_fields(value, path)
    return Round(
        required(fields, "x", path),
        required(fields, "y", path),
        positive(fields, "r", path),
        flag(fields, "movable", path),
        _mass(fields, path),
    )
