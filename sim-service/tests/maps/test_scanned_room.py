"""Rooms from drawn maps: rays in the room end where they end in the map; starts, crops, specks, limits."""

from __future__ import annotations

import math
import random
from pathlib import Path

import pytest

from rosy_sim.errors import BadInput
from rosy_sim.maps.scanned_room import ScannedRoom, room_of_map
from rosy_sim.world.arena import Arena
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
    occupied = room_of_map(map_file(tmp_path, binary(rows, gray), occupied_thresh=0.39))
    free = room_of_map(map_file(tmp_path, binary(rows, gray), free_thresh=0.41))
    assert unknown.walls == free.walls == 4
    assert occupied.walls == 8


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
