"""How obstacles are built, refused and freed."""

from __future__ import annotations

import gc
import weakref

import pytest

from rosy_sim.robots.kobuki import KOBUKI
from rosy_sim.world.arena import Arena, ArenaError, read_arena
from rosy_sim.world.obstacles import MAX_WALLS, Obstacles
from rosy_sim.world.world import World


def checkerboard(side: int) -> Arena:
    """A room whose wall tiles have no neighbours, so each is a wall of its own."""
    rows = ["".join("#" if (x + y) % 2 and (x > 9 or y > 9) else "." for x in range(side)) for y in range(side)]
    return read_arena({"tiles": rows, "start": {"x": 2.5, "y": side / 2 - 2.5}})


def test_wall_tiles_that_make_too_many_walls_are_refused_before_one_is_built() -> None:
    pieces = Obstacles(KOBUKI.body).add(checkerboard(200))
    with pytest.raises(ArenaError, match=f"more than {MAX_WALLS} walls"):
        next(pieces)


def test_a_grid_of_joined_wall_tiles_may_be_as_large_as_ever() -> None:
    rows = ["#" * 200, *["#" + "." * 198 + "#"] * 198, "#" * 200]
    World(read_arena({"tiles": rows, "start": {"x": 5, "y": 5}}), KOBUKI)


def test_a_room_is_freed_when_nothing_refers_to_it_without_the_garbage_collector() -> None:
    things = [{"x": 1 + i, "y": 3, "r": 0.2, "movable": bool(i % 2)} for i in range(6)]
    tiles = ["#.#.#.#.#.#.#.#.#.#.#.#.", *["." * 24] * 15]
    arena = read_arena({"tiles": tiles, "rounds": things, "start": {"x": 1, "y": 1}})
    gc.disable()
    try:
        world = World(arena, KOBUKI)
        for _ in range(10):
            world.sense()
            world.integrate()
        shapes = [weakref.ref(shape) for shape in world.obstacles._space.shapes]
        assert len(shapes) > 20
        del world
        assert [shape() for shape in shapes] == [None] * len(shapes)
    finally:
        gc.enable()


@pytest.mark.parametrize("movable", [False, True])
def test_a_free_position_is_the_same_whatever_was_asked_before(movable: bool) -> None:
    """A question that was just asked is not computed again, unless things could have moved meanwhile."""
    things = [{"x": 1 + i, "y": 1.5, "r": 0.2, "movable": movable} for i in range(3)]
    arena = read_arena({"size": [4, 3], "rounds": things, "start": {"x": 0.5, "y": 0.5}})
    asked = World(arena, KOBUKI).obstacles
    # In the open, in a wall, in a thing, between two, and far outside.
    points = [(0.5, 0.5), (0.1, 0.5), (1.05, 1.4), (1.5, 1.5), (-3.0, 0.5)]
    for x, y in [point for point in points for _ in range(3)] + points:
        assert asked.free_position(x, y) == World(arena, KOBUKI).obstacles.free_position(x, y)
    if movable:
        before = asked.free_position(1.05, 1.4)
        asked.drag(0, 1.0, 2.4, 0.0, (0.5, 0.5))
        assert asked.free_position(1.05, 1.4) == (1.05, 1.4) != before
