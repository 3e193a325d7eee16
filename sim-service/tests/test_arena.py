"""Worlds that are none, each with the path to what is wrong, and the gallery, each of which is one."""

from __future__ import annotations

import math
from typing import Any

import pytest

from rosy_sim.library import named_world, usable_arena, world_names
from rosy_sim.world.arena import ArenaError, read_arena
from rosy_sim.world.events import Velocity
from rosy_sim.world.world import World

START = {"x": 1, "y": 1}


@pytest.mark.parametrize(
    ("world", "path"),
    [
        (None, ""),
        ([], ""),
        ({}, "size"),
        ({"size": [2, 2]}, "start"),
        ({"size": [2], "start": START}, "size"),
        ({"size": [2, "a"], "start": START}, "size[1]"),
        ({"size": [2, True], "start": START}, "size[1]"),
        ({"size": [2, -1], "start": START}, "size[1]"),
        ({"size": [2, 1e9], "start": START}, "size[1]"),
        ({"size": [2, 2], "start": {"x": 1}}, "start.y"),
        ({"size": [2, 2], "start": {"x": 1, "y": math.inf}}, "start.y"),
        ({"size": [2, 2], "start": START, "sise": 1}, "sise"),
        ({"size": [2, 2], "start": START, "name": 1}, "name"),
        ({"size": [2, 2], "start": START, "tile": 0}, "tile"),
        ({"size": [2, 2], "start": START, "tiles": "##"}, "tiles"),
        ({"start": START, "tiles": ["..", 3]}, "tiles[1]"),
        ({"start": START, "tiles": ["..", "..."]}, "tiles[1]"),
        ({"start": START, "tiles": [".x"]}, "tiles[0]"),
        ({"start": START, "tiles": [""]}, "tiles[0]"),
        ({"start": START, "tiles": ["##", "#O"]}, "tiles"),
        ({"start": START, "tiles": ["...", "..."], "size": [2, 2]}, "size"),
        ({"size": [2, 2], "start": START, "walls": [{"from": [0, 0]}]}, "walls[0].to"),
        ({"size": [2, 2], "start": START, "walls": [{"from": [0], "to": [1, 1]}]}, "walls[0].from"),
        ({"size": [2, 2], "start": START, "walls": {}}, "walls"),
        ({"size": [2, 2], "start": START, "boxes": [{"x": 1, "y": 1, "w": 1}]}, "boxes[0].h"),
        ({"size": [2, 2], "start": START, "boxes": [{"x": 1, "y": 1, "w": 0, "h": 1}]}, "boxes[0].w"),
        ({"size": [2, 2], "start": START, "boxes": [{"x": 1, "y": 1, "w": 1, "h": 1, "movable": 1}]},
         "boxes[0].movable"),
        ({"size": [2, 2], "start": START, "boxes": [7]}, "boxes[0]"),
        ({"size": [2, 2], "start": START, "rounds": [{"x": 1, "y": 1}]}, "rounds[0].r"),
        ({"size": [2, 2], "start": START, "boxes": [{"x": 0, "y": 0, "w": 1, "h": 1}] * 2001}, "walls"),
    ],
)  # fmt: skip
def test_a_bad_description_is_refused_with_its_path(world: Any, path: str) -> None:
    with pytest.raises(ArenaError) as caught:
        read_arena(world)
    assert caught.value.path == path
    assert caught.value.why.endswith((".", "floor."))


@pytest.mark.parametrize(
    "start", [{"x": -1, "y": 1}, {"x": 0.1, "y": 1}, {"x": 0.75, "y": 0.25}, {"x": 1.75, "y": 0.75}, {"x": 9, "y": 0.5}]
)
def test_a_robot_cannot_start_outside_in_a_wall_or_over_a_hole(start: dict[str, float]) -> None:
    arena = read_arena({"tiles": ["......", "...O..", ".#...."], "start": start})
    with pytest.raises(ArenaError) as caught:
        World(arena)
    assert caught.value.path == "start"


@pytest.mark.parametrize("name", world_names())
def test_each_world_of_the_gallery_lets_the_robot_move(name: str) -> None:
    value = named_world(name)
    assert value["name"] == name
    world = World(usable_arena(value, name))
    for _ in range(100):
        world.sense()
        world.command(Velocity(0.5, 0.0))
        world.integrate()
    assert math.dist((world.x, world.y), world.arena.start[:2]) > 0.3
