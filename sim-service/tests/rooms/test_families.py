"""Generated rooms: the same for the same seed, different for different ones, and fair."""

from __future__ import annotations

import hashlib
import json

import pytest

from rosy_sim.errors import BadInput
from rosy_sim.robots.kobuki import KOBUKI
from rosy_sim.rooms.generation.dice import Dice
from rosy_sim.rooms.generation.fairness import is_fair
from rosy_sim.rooms.generation.families import FAMILIES, generate_room, read_family
from rosy_sim.rooms.generation.reductions import reduction_of
from rosy_sim.rooms.generation.variation import vary
from rosy_sim.world.arena import read_arena
from rosy_sim.world.goals import Reach
from rosy_sim.world.world import World
from rosy_sim.worlds.gallery import named_world, world_names

from ..extent import SEED

ALL = [*FAMILIES, "like:obstacles", "like:pits", "like:maze", "like:slalom", "like:boxes", "like:room"]

DIGESTS = {
    "obstacles": "679d4df4fe5a94b9",
    "maze": "293a117b0f21dce4",
    "pits": "b50c0b4d190ce1e7",
    "like:obstacles": "b36caf50b670b919",
    "like:pits": "1df01f8f4d9eccb2",
}


@pytest.mark.parametrize("name", DIGESTS)
def test_the_same_seed_gives_the_same_rooms_on_every_machine(name: str) -> None:
    family = read_family(name)
    rooms = [generate_room(family, 1, number) for number in range(1, 9)]
    text = json.dumps([(room.number, room.seed, room.world) for room in rooms], sort_keys=True)
    assert hashlib.sha256(text.encode()).hexdigest()[:16] == DIGESTS[name]


@pytest.mark.parametrize("name", ALL)
def test_rooms_are_fair_and_differ(name: str) -> None:
    family = read_family(name)
    rooms = [generate_room(family, SEED, number) for number in range(1, 13)]
    for room in rooms:
        arena = read_arena(room.world)
        world = World(arena, KOBUKI)
        assert not world.sensors.bumpers
        assert any(isinstance(goal, Reach) for goal in arena.goals)
        assert is_fair(room.world, 0.0)
    assert len({json.dumps({**room.world, "name": ""}) for room in rooms}) >= 11
    assert len({room.seed for room in rooms}) == 12
    other = generate_room(family, SEED + 1, 1)
    assert other.seed != rooms[0].seed


def test_a_room_behind_a_wall_is_not_fair() -> None:
    room = {"size": [4, 3], "start": {"x": 1, "y": 1}, "goals": [{"kind": "reach", "x": 3, "y": 1, "r": 0.3}]}
    assert is_fair(room)
    assert not is_fair({**room, "walls": [{"from": [2, 0], "to": [2, 3]}]})
    assert not is_fair({**room, "start": {"x": 0.1, "y": 1}})
    assert not is_fair({"size": [4, 3]})
    # A gap as wide as the robot and a little is enough without a margin only.
    gap = {**room, "walls": [{"from": [2, 0], "to": [2, 2.55]}]}
    assert is_fair(gap, 0.0)
    assert not is_fair(gap, 0.1)


def test_every_room_of_the_gallery_has_rooms_like_it() -> None:
    for name in world_names():
        room = generate_room(read_family(f"like:{name}"), SEED, 1)
        assert is_fair(room.world, 0.0)


@pytest.mark.parametrize("name", ["caves", "like:", "like:atlantis", "like", "maze:3", ""])
def test_other_names_are_refused(name: str) -> None:
    with pytest.raises(BadInput, match=r"^There is no .*\.$"):
        read_family(name)


@pytest.mark.parametrize("name", ["slalom", "room"])
def test_the_first_room_in_a_room_is_that_room_and_the_others_are_like_it(name: str) -> None:
    family, like = read_family(f"in:{name}"), read_family(f"like:{name}")
    base = named_world(name)
    first = generate_room(family, SEED, 1).world
    assert {key: value for key, value in first.items() if key != "goals"} == {
        key: value for key, value in base.items() if key != "goals"
    }
    assert first["goals"] == base["goals"] if base.get("goals") else first["goals"][0]["kind"] == "reach"
    assert named_world(name) == base == family.base
    for number in (2, 3):
        own, other = generate_room(family, SEED, number), generate_room(like, SEED, number)
        assert own.seed == other.seed
        assert {**own.world, "name": ""} == {**other.world, "name": ""}


def test_unknown_areas_stay_where_they_are_and_are_never_left_out() -> None:
    areas = [
        {"x": 5.0, "y": 2.0, "w": 1.0, "h": 4.0, "unknown": True},
        {"x": 1.0, "y": 3.9, "w": 2, "h": 0.2, "unknown": True},
    ]
    base = {
        "size": [6, 4],
        "start": {"x": 2, "y": 2},
        "boxes": [areas[0], {"x": 3.5, "y": 1, "w": 0.3, "h": 0.3}, areas[1]],
    }
    mirrored = {(x, y) for x, y in ((5.0, 2.0), (1.0, 3.9), (1.0, 2.0), (5.0, 3.9), (5.0, 0.1), (1.0, 0.1))}
    for seed in range(20):
        room = vary(Dice(str(seed)), base, 1.0)
        unknown = [box for box in room["boxes"] if box.get("unknown")]
        assert len(unknown) == 2
        assert all((box["x"], box["y"]) in mirrored for box in unknown)
        reduction = reduction_of("room", room)
        assert reduction.things == 1
        smallest = reduction.room(frozenset())
        assert smallest is not None
        assert smallest["boxes"] == unknown
