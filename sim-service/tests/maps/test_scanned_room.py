"""Rooms from drawn maps: rays in the room end where they end in the map; starts, crops, specks, limits."""

from __future__ import annotations

import io
import math
import random
from pathlib import Path

import pytest
from PIL import Image

from rosy_sim.errors import BadInput
from rosy_sim.maps.scanned_room import ScannedRoom, room_of_map
from rosy_sim.world.arena import MAX_SHAPES, Arena
from rosy_sim.worlds.gallery import usable_arena

from .drawn_map import CELL, GRAY, as_text, binary, cast, map_file, obstacles, put, rectangle

ROOM = rectangle(60, 40)
PILLAR = ["####"] * 4
SHAPES = {
    "rectangle": ROOM,
    "L": put(ROOM, 30, 0, ["#" + " " * 29] * 19 + ["#" * 30]),
    "pillar": put(ROOM, 40, 10, PILLAR),
    "thick wall": put(ROOM, 30, 0, ["#####"] * 20),
    "two rooms": put(ROOM, 30, 1, ["#"] * 20),
}


def made(path: Path) -> tuple[ScannedRoom, Arena]:
    room = room_of_map(path)
    return room, usable_arena(room.world, "the map")


@pytest.mark.parametrize("shape", SHAPES)
def test_rays_end_within_a_cell_of_where_they_end_in_the_map(shape: str, tmp_path: Path) -> None:
    rows = SHAPES[shape]
    room, arena = made(map_file(tmp_path, binary(rows)))
    assert (arena.width, arena.height) == pytest.approx((60 * CELL, 40 * CELL))
    assert room.walls == len(arena.walls) <= 16
    built = obstacles(arena)
    x, y = room.start
    for direction in range(0, 360, 5):
        angle = math.radians(direction)
        assert built.distance(x, y, angle, 10.0) == pytest.approx(cast(rows, x, y, angle), abs=CELL)


def test_a_slanted_wall_is_a_few_straight_ones(tmp_path: Path) -> None:
    rows = ROOM
    for column in range(1, 59):
        rows = put(rows, column, 2 + column // 3, ["##"])
    room, arena = made(map_file(tmp_path, binary(rows)))
    assert room.walls <= 12
    built = obstacles(arena)
    x, y = room.start
    for direction in range(0, 360, 10):
        angle = math.radians(direction)
        far = built.distance(x, y, angle, 10.0)
        hit_x, hit_y = (x + far * math.cos(angle)) / CELL - 0.5, (y + far * math.sin(angle)) / CELL - 0.5
        nearest = min(
            math.hypot(max(0, abs(column - hit_x) - 0.5), max(0, abs(39 - row - hit_y) - 0.5))
            for row, text in enumerate(rows)
            for column, cell in enumerate(text)
            if cell == "#"
        )
        assert nearest <= 1


def test_unknown_margins_are_cropped_and_the_robot_starts_at_the_origin_of_the_map(tmp_path: Path) -> None:
    blank = " " * 100
    rows = [blank] * 7 + [" " * 25 + row + " " * 15 for row in ROOM] + [blank] * 13
    # The corner of the image is 2 m left of and 1.5 m below the origin, the room begins 25 and 13 cells from there.
    room, arena = made(map_file(tmp_path, binary(rows), origin="[-2.0, -1.5, 0]"))
    assert (arena.width, arena.height) == pytest.approx((3.0, 2.0))
    assert room.start == pytest.approx((2.0 - 25 * CELL, 1.5 - 13 * CELL))
    assert (arena.start.x, arena.start.y, arena.start.theta) == (*room.start, 0.0)


def test_yaw_turns_the_start_and_not_the_room(tmp_path: Path) -> None:
    # Turned by a quarter: the lower left corner of the image is at (1, -1.5), so its columns go up in the map.
    room, arena = made(map_file(tmp_path, binary(ROOM), origin=f"[1.0, -1.5, {math.pi / 2}]"))
    assert (arena.width, arena.height) == pytest.approx((3.0, 2.0))
    assert room.start == pytest.approx((1.5, 1.0))
    assert arena.start.theta == pytest.approx(-math.pi / 2, abs=1e-4)


def test_without_space_at_the_origin_the_robot_starts_where_there_is_most(tmp_path: Path) -> None:
    rows = put(ROOM, 30, 1, ["#"] * 38)
    rows = put(rows, 31, 1, ["#" * 10] * 10)
    room, _ = made(map_file(tmp_path, binary(rows)))
    x, y = room.start
    assert min(cast(rows, x, y, math.radians(a)) for a in range(0, 360, 5)) >= 0.6
    assert x < 1.5


def test_an_image_as_text_makes_the_same_room(tmp_path: Path) -> None:
    written = room_of_map(map_file(tmp_path, as_text(SHAPES["L"])))
    assert written == room_of_map(map_file(tmp_path, binary(SHAPES["L"])))


def test_negate_swaps_black_and_white(tmp_path: Path) -> None:
    inverse = {cell: 255 - gray for cell, gray in GRAY.items()}
    plain = room_of_map(map_file(tmp_path / "a", binary(SHAPES["pillar"])))
    negated = room_of_map(map_file(tmp_path / "b", binary(SHAPES["pillar"], inverse), negate=1))
    assert plain == negated


def test_thresholds_say_what_is_occupied(tmp_path: Path) -> None:
    # A pillar of 40 % black.
    rows = put(ROOM, 40, 10, ["oooo"] * 4)
    gray = {**GRAY, "o": 153}
    path = map_file(tmp_path, binary(rows, gray))
    unknown = room_of_map(path)
    assert unknown.unknown == pytest.approx(16 * CELL * CELL)
    occupied = room_of_map(map_file(tmp_path, binary(rows, gray), occupied_thresh=0.39))
    free = room_of_map(map_file(tmp_path, binary(rows, gray), free_thresh=0.41))
    assert unknown.walls == free.walls == 4
    assert occupied.walls == 8


UNKNOWN = put(put(ROOM, 40, 10, PILLAR), 14, 1, ["  ", " .", "  "] * 12 + ["  "] * 2)
"""A room with a pillar and a strip across it that no scan has seen, with single free cells in it."""

AROUND = [" " * 70] * 5 + [" " * 6 + row + " " * 4 for row in put(UNKNOWN, 59, 12, [" ", ".", " "])] + [" " * 70] * 3
"""The same within a margin that no scan has seen, and a hole in its outer wall."""


def saved(rows: list[str], mode: str, kind: str, negate: bool) -> bytes:
    """An image as ROS 2's saver writes it (nav2_map_server/src/map_io.cpp), or its negative."""
    levels = {
        "trinary": {"#": 0, ".": 254, " ": 205},
        "scale": {"#": 0, ".": 255, " ": 128},
        "raw": {"#": 100, ".": 0, " ": 255},
    }[mode]
    cells = "".join(rows)
    pixels = bytes(levels[cell] ^ (255 if negate and mode != "raw" else 0) for cell in cells)
    image = Image.frombytes("L", (len(rows[0]), len(rows)), pixels)
    if mode == "scale" and kind == "PNG":
        image.putalpha(Image.frombytes("L", image.size, bytes(0 if cell == " " else 255 for cell in cells)))
    file = io.BytesIO()
    image.save(file, kind)
    return file.getvalue()


THRESHOLDS = [(0.65, 0.196), (0.65, 0.25), (0.65, 0.65), (0.9, 0.6), (0.3, 0.2), (1, 0.99)]


@pytest.mark.parametrize("kind", ["PNG", "BMP", "PPM"])
@pytest.mark.parametrize("negate", [False, True])
@pytest.mark.parametrize("mode", ["trinary", "scale", "raw"])
@pytest.mark.parametrize(("occupied", "free"), THRESHOLDS)
def test_unknown_is_never_floor(
    kind: str, negate: bool, mode: str, occupied: float, free: float, tmp_path: Path
) -> None:
    image = saved(AROUND, mode, kind, negate)
    path = map_file(tmp_path, image, mode=mode, negate=int(negate), occupied_thresh=occupied, free_thresh=free)
    room, arena = made(path)
    # What surrounds the room is cropped.
    assert (arena.width, arena.height) == pytest.approx((60 * CELL, 40 * CELL))
    inner = [row[6:66] for row in AROUND[5:45]]
    cells = {
        cell: [(x, 39 - y) for y, row in enumerate(inner) for x, c in enumerate(row) if c == cell] for cell in ". "
    }
    assert room.unknown == pytest.approx(len(cells[" "]) * CELL * CELL)

    def is_covered(x: int, y: int) -> bool:
        px, py = (x + 0.5) * CELL, (y + 0.5) * CELL
        return any(abs(px - b.x) < b.w / 2 and abs(py - b.y) < b.h / 2 for b in arena.boxes if b.unknown)

    assert all(is_covered(*cell) for cell in cells[" "])
    assert not any(is_covered(*cell) for cell in cells["."])
    start = math.floor(arena.start.x / CELL), math.floor(arena.start.y / CELL)
    assert start in cells["."]


def test_a_robot_cannot_enter_what_is_unknown(tmp_path: Path) -> None:
    _, arena = made(map_file(tmp_path, binary(UNKNOWN), free_thresh=0.25, origin="[-1.5, -1, 0]"))
    built = obstacles(arena)
    assert built.distance(1.5, 0.3, math.pi, 10.0) == pytest.approx(1.5 - 16 * CELL, abs=CELL)


def test_a_ragged_edge_of_the_unknown_is_smoothed_until_its_areas_are_few_enough(tmp_path: Path) -> None:
    dice = random.Random(2)
    rows = rectangle(500, 300)
    for y in range(1, 299):
        length = 200 + dice.randrange(6)
        holes = "".join(dice.choice("  .") for _ in range(length))
        rows = put(rows, 1, y, [holes])
    room, arena = made(map_file(tmp_path, binary(rows)))
    assert len(arena.boxes) + len(arena.walls) <= MAX_SHAPES
    covered = [
        [range(round((b.x - b.w / 2) / CELL), round((b.x + b.w / 2) / CELL)) for b in arena.boxes
         if round((b.y - b.h / 2) / CELL) <= y < round((b.y + b.h / 2) / CELL)]
        for y in range(300)
    ]  # fmt: skip
    for row, text in enumerate(rows):
        runs = covered[299 - row]
        for x, cell in enumerate(text):
            if cell == " ":
                assert any(x in run for run in runs)
            elif x > 215:
                assert not any(x in run for run in runs)
    assert room.start[0] > 206 * CELL


def test_specks_are_left_out_and_counted(tmp_path: Path) -> None:
    rows = put(put(put(ROOM, 10, 10, ["#"]), 20, 20, ["#.", ".#"]), 40, 20, ["##", "#."])
    room, arena = made(map_file(tmp_path, binary(rows)))
    clean = room_of_map(map_file(tmp_path, binary(put(ROOM, 40, 20, ["##", "#."]))))
    assert room.specks == 2
    assert clean.specks == 0
    assert room.world == clean.world
    # The three cells are there.
    assert obstacles(arena).distance(1.5, (40 - 20.5) * CELL, 0.0, 10.0) == pytest.approx(0.5, abs=CELL)


def test_cells_of_one_centimetre_keep_half_the_thickness_of_a_wall(tmp_path: Path) -> None:
    rows = rectangle(200, 150)
    room, arena = made(map_file(tmp_path, binary(rows), resolution=0.01))
    x, y = room.start
    for angle in (0, math.pi / 2, math.pi, -math.pi / 2):
        difference = cast(rows, x, y, angle, 0.01) - obstacles(arena).distance(x, y, angle, 10.0)
        assert 0 <= difference <= 0.025


def refusal(path: Path) -> str:
    with pytest.raises(BadInput) as refused:
        room_of_map(path)
    return str(refused.value).replace(str(path.parent), "")


def test_maps_without_a_room_are_refused(tmp_path: Path) -> None:
    path = map_file(tmp_path, binary(["##", "  "]))
    assert refusal(path) == "/scan.yaml has no free cells, so there is no room in it."
    path = map_file(tmp_path, binary(rectangle(9, 9)))
    assert refusal(path) == "No place in /scan.yaml is wide enough for the robot to stand on."
    path = map_file(tmp_path, binary(ROOM), resolution=2)
    assert refusal(path) == "/scan.yaml is 120 by 80 metres; a room can be at most 100 metres long."


def test_noise_is_refused(tmp_path: Path) -> None:
    dice = random.Random(1)
    rows = [f"{dice.getrandbits(500):0500b}".replace("0", ".").replace("1", "#") for _ in range(500)]
    expected = "The obstacles in /scan.yaml are too ragged to be walls; smooth the image first."
    assert refusal(map_file(tmp_path, binary(rows))) == expected
    many = rectangle(400, 400)
    for y in range(20, 380, 6):
        many = put(many, 20, y, ["##...." * 60, "##...." * 60])
    told = refusal(map_file(tmp_path, binary(many)))
    assert told.startswith("/scan.yaml makes 3604 walls; a room can hold 2000.")
