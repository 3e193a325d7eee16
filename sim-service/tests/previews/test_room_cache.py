"""The cache of a room: a run in it is as in a room that was read and built for this run."""

from __future__ import annotations

import pytest

from rosy_sim.previews.preview import RoomCache
from rosy_sim.robots import robot_in
from rosy_sim.world.arena import read_arena
from rosy_sim.world.events import Move
from rosy_sim.world.field_readers import Pose
from rosy_sim.world.world import World
from rosy_sim.worlds.gallery import named_world, world_names


def path(world: World) -> list[tuple[float, ...]]:
    """Where the robot and what it pushes are while it drives, and a hand moves one thing."""
    found = []
    for step in range(300):
        if step % 10 == 0:
            world.drive(0.4, 0.3)
        if step == 100 and world.obstacles.movables:
            world.apply(Move(0, Pose(1.0, 1.0, 0.5)))
        world.sense()
        world.integrate()
        found.append((world.x, world.y, world.theta, *(value for pose in world.obstacles.poses() for value in pose)))
    return found


@pytest.mark.parametrize("name", world_names())
def test_a_room_that_is_known_is_as_a_new_one(name: str) -> None:
    room = RoomCache()
    told = named_world(name)
    arena = read_arena(told)
    wanted = [path(World(arena, robot_in(arena), seed)) for seed in (1, 1, 2)]
    assert [path(room.world(dict(told), seed)) for seed in (1, 1, 2)] == wanted


def test_another_room_is_read() -> None:
    room = RoomCache()
    first = room.world(named_world("room"), 1)
    assert room.world(named_world("maze"), 1).arena != first.arena
    assert room.world(named_world("room"), 1).arena == first.arena
