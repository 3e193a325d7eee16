"""
Variations of a room: mirrored, with its things, its start and the robot's heading moved a little.

Goals, walls drawn as lines and unknown areas only take part in the mirroring: they say what the room is about. The
result may be unfair; ``families`` looks at that.
"""

from __future__ import annotations

import copy
import math
from typing import Any

from ...world.arena import read_arena
from .dice import Dice
from .tile_groups import inner_groups, with_groups

__all__ = ["vary"]

_SHIFT = 0.4
"""Largest shift of a thing or of the start along an axis, m."""

_TURN = math.pi / 12
"""Unit of a turn, rad: things turn by up to one and the start by up to three of them."""

_Json = dict[str, Any]


def vary(dice: Dice, base: _Json, scale: float) -> _Json:
    """A room like ``base``; ``scale`` is from 0, which only mirrors it, to 1."""
    world = copy.deepcopy(base)
    for key in ("name", "title"):
        world.pop(key, None)
    arena = read_arena(world)
    if dice.whole(0, 1):
        _mirror(world, arena.width, "x")
    if dice.whole(0, 1):
        _mirror(world, arena.height, "y")
    boxes = [box for box in world.get("boxes", ()) if not box.get("unknown")]
    for thing in (*boxes, *world.get("rounds", ())):
        _shift(dice, thing, scale)
    for box in boxes:
        turn = dice.whole(-1, 1) * _TURN
        if scale and turn:
            box["theta"] = round(box.get("theta", 0.0) + turn, 4)
    _shift(dice, world["start"], scale)
    if turn := dice.whole(-3, 3) * scale:
        world["start"]["theta"] = round(world["start"].get("theta", 0.0) + turn * _TURN, 4)
    if "tiles" in world and scale == 1:
        moved = [
            frozenset((row + down, column + right) for row, column in group)
            for group in inner_groups(world["tiles"])
            for down, right in [(dice.whole(-1, 1), dice.whole(-1, 1))]
        ]
        world["tiles"] = with_groups(world["tiles"], moved)
    return world


def _shift(dice: Dice, thing: _Json, scale: float) -> None:
    for axis in ("x", "y"):
        shift = dice.step(-_SHIFT, _SHIFT, 0.1) * scale
        if shift:
            thing[axis] = round(thing[axis] + shift, 3)


def _mirror(world: _Json, side: float, axis: str) -> None:
    """Turn left and right (``x``) or up and down (``y``) round."""
    index = 0 if axis == "x" else 1

    def flip(point: list[float]) -> list[float]:
        return [side - point[0], point[1]] if index == 0 else [point[0], side - point[1]]

    poses = [world["start"], *([world["dock"]] if "dock" in world else [])]
    goals = world.get("goals", [])
    for thing in (*poses, *world.get("boxes", ()), *world.get("rounds", ()), *goals):
        if axis in thing:
            thing[axis] = round(side - thing[axis], 6)
    for pose in (*poses, *world.get("boxes", ())):
        theta = pose.get("theta", 0.0)
        pose["theta"] = round(math.pi - theta if index == 0 else -theta, 6)
    for wall in (*world.get("walls", ()), *(goal["line"] for goal in goals if "line" in goal)):
        wall["from"], wall["to"] = flip(wall["from"]), flip(wall["to"])
    for goal in goals:
        if "points" in goal:
            goal["points"] = [flip(point) for point in goal["points"]]
    if "tiles" in world:
        rows = world["tiles"]
        world["tiles"] = [row[::-1] for row in rows] if index == 0 else rows[::-1]
