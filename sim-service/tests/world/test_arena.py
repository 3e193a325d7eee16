"""Worlds that are none, each with the path to what is wrong, and the gallery, each of which is one."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import pytest

from rosy_sim.robots.kobuki import KOBUKI
from rosy_sim.world.arena import ArenaError, read_arena
from rosy_sim.world.events import velocity
from rosy_sim.world.world import World
from rosy_sim.worlds.gallery import named_world, usable_arena, world_names

_LINES = [
    json.loads(line) for line in (Path(__file__).parents[3] / "protocol/goldens/worlds.jsonl").read_text().splitlines()
]


@pytest.mark.parametrize("line", _LINES, ids=lambda line: json.dumps(line["world"])[:80])
def test_a_description_is_a_world_or_is_refused_with_its_path_and_the_pages_words(line: Any) -> None:
    if "path" not in line:
        World(read_arena(line["world"]), KOBUKI)
        return
    with pytest.raises(ArenaError) as caught:
        World(read_arena(line["world"]), KOBUKI)
    assert (caught.value.path, str(caught.value.why)) == (line["path"], line["why"])


def test_a_number_beyond_all_rooms_is_refused() -> None:
    with pytest.raises(ArenaError) as caught:
        read_arena({"size": [2, 2], "start": {"x": 1, "y": math.inf}})
    assert caught.value.path == "start.y"


def test_a_world_holds_only_so_many_things() -> None:
    with pytest.raises(ArenaError) as caught:
        read_arena({"size": [2, 2], "start": {"x": 1, "y": 1}, "boxes": [{"x": 0, "y": 0, "w": 1, "h": 1}] * 2001})
    assert caught.value.path == "walls"


@pytest.mark.parametrize("name", world_names())
def test_each_world_of_the_gallery_lets_the_robot_move(name: str) -> None:
    value = named_world(name)
    assert value["name"] == name
    world = World(usable_arena(value, name), KOBUKI)
    for _ in range(100):
        world.sense()
        world.command(velocity(0.5, 0.0))
        world.integrate()
    assert math.dist((world.x, world.y), world.arena.start[:2]) > 0.3
