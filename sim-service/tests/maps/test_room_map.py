"""Maps of rooms: what is occupied, free and unknown, against the obstacles that a robot meets there."""

from __future__ import annotations

import math
from itertools import islice

import pytest

from rosy_sim.maps.room_map import RESOLUTION, room_map
from rosy_sim.world.arena import Arena, read_arena
from rosy_sim.worlds.gallery import named_world, usable_world, world_names

Cell = tuple[float, float]


def cells(arena: Arena) -> dict[Cell, int]:
    """The value of each cell by its middle, m."""
    found = room_map(arena)
    info, data = found["info"], found["data"]
    assert len(data) == info["width"] * info["height"]
    side, width = info["resolution"], info["width"]
    return {((n % width + 0.5) * side, (n // width + 0.5) * side): value for n, value in enumerate(data)}


def value_at(arena: Arena, x: float, y: float) -> int:
    found = cells(arena)
    return found[min(found, key=lambda at: math.dist(at, (x, y)))]


@pytest.mark.parametrize("name", world_names())
def test_what_is_free_and_occupied_in_the_gallery_is_what_a_robot_meets(name: str) -> None:
    still = named_world(name)
    for kind in ("boxes", "rounds"):
        still[kind] = [thing for thing in still.get(kind, []) if not thing.get("movable")]
    world = usable_world(still, name)
    # From the middle of a cell to its corner, and the thickness of the lines.
    near = RESOLUTION
    # A part of the cells that is in all rows and columns.
    for (x, y), value in islice(cells(world.arena).items(), 0, None, 7):
        if not (near < x < world.arena.width - near and near < y < world.arena.height - near):
            continue
        surface = min(world.obstacles.distance(x, y, math.tau * n / 16, 2 * near) for n in range(16))
        if world.arena.is_hole(x, y):
            assert value == 100
        elif value == 0:
            assert surface > near / 4, (x, y)
        else:
            assert surface < 2 * near, (x, y)


def test_what_can_be_pushed_is_not_in_the_map_and_what_no_scan_has_seen_is_unknown() -> None:
    arena = read_arena(
        {
            "name": "x",
            "size": [4, 3],
            "start": {"x": 0.5, "y": 0.5},
            "boxes": [
                {"x": 1, "y": 2, "w": 0.4, "h": 0.4, "movable": True},
                {"x": 2, "y": 2, "w": 0.4, "h": 0.4, "unknown": True},
                {"x": 3, "y": 2, "w": 1, "h": 0.2, "theta": math.pi / 2},
            ],
            "rounds": [{"x": 3, "y": 0.8, "r": 0.2}, {"x": 2, "y": 0.8, "r": 0.2, "movable": True}],
        }
    )
    assert [value_at(arena, x, 2) for x in (1, 2, 3)] == [0, -1, 100]
    assert [value_at(arena, 3, y) for y in (2.4, 2.6)] == [100, 0]
    assert [value_at(arena, x, 0.8) for x in (2, 3)] == [0, 100]
    assert [value_at(arena, x, 1.2) for x in (0.0, 3.99)] == [100, 100]


def test_a_large_room_has_larger_cells() -> None:
    info = room_map(read_arena({"name": "x", "size": [100, 80], "start": {"x": 1, "y": 1}}))["info"]
    assert info["resolution"] > RESOLUTION
    assert info["width"] * info["height"] < 170_000
    assert info["width"] * info["resolution"] == pytest.approx(100, abs=info["resolution"])
