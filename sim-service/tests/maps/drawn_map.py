"""Maps drawn as text: ``#`` occupied, ``.`` free, a blank unknown; the first row is the top."""

from __future__ import annotations

import math
from pathlib import Path

from rosy_sim.robots.kobuki import KOBUKI
from rosy_sim.world.arena import Arena
from rosy_sim.world.obstacles import Obstacles

GRAY = {"#": 0, ".": 254, " ": 205}
"""What map_saver writes."""

CELL = 0.05


def rectangle(width: int, height: int) -> list[str]:
    """A room with walls of one cell."""
    return ["#" * width, *["#" + "." * (width - 2) + "#"] * (height - 2), "#" * width]


def put(rows: list[str], x: int, y: int, part: list[str]) -> list[str]:
    """With a part whose upper left cell is in column ``x`` of row ``y`` from the top."""
    changed = list(rows)
    for i, text in enumerate(part, y):
        changed[i] = changed[i][:x] + text + changed[i][x + len(text) :]
    return changed


def binary(rows: list[str], gray: dict[str, int] = GRAY) -> bytes:
    """A P5 image, with a comment as map_saver writes it."""
    head = f"P5\n# CREATOR: map_saver.cpp 0.050 m/pix\n{len(rows[0])} {len(rows)}\n255\n"
    return head.encode() + bytes(gray[cell] for row in rows for cell in row)


def as_text(rows: list[str]) -> bytes:
    """A P2 image with comments in odd places."""
    lines = [" ".join(str(GRAY[cell]) for cell in row) + " # a row\n" for row in rows]
    return f"P2 # text\n# size\n{len(rows[0])}\n{len(rows)} 255\n{''.join(lines)}".encode()


def map_file(folder: Path, pixels: bytes, /, **changed: object) -> Path:
    """The YAML file of a map whose image is beside it; a key that is None is left out."""
    fields: dict[str, object] = {
        "image": "scan.pgm",
        "resolution": CELL,
        "origin": "[0.0, 0.0, 0.0]",
        "negate": 0,
        "occupied_thresh": 0.65,
        "free_thresh": 0.196,
        **changed,
    }
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "scan.pgm").write_bytes(pixels)
    path = folder / "scan.yaml"
    path.write_text("".join(f"{key}: {value}\n" for key, value in fields.items() if value is not None))
    return path


def obstacles(arena: Arena) -> Obstacles:
    """What is in a room, for casting rays."""
    built = Obstacles(KOBUKI.body)
    for _ in built.add(arena):
        pass
    return built


def cast(rows: list[str], x: float, y: float, direction: float, cell: float = CELL) -> float:
    """How far it is in the map itself to an occupied cell or its end, m, by small steps."""
    step = cell / 20
    for i in range(100_000):
        column = math.floor((x + i * step * math.cos(direction)) / cell)
        row = len(rows) - 1 - math.floor((y + i * step * math.sin(direction)) / cell)
        if not (0 <= row < len(rows) and 0 <= column < len(rows[0])) or rows[row][column] == "#":
            return i * step
    raise AssertionError("the map has no end")
