"""
A room and a Kobuki in it: physics and sensors, with no idea of time, files, sockets or JSON.

Axes, in the room (metres, radians, counter-clockwise positive)::

      y                          theta = 0 looks along x
      ^      . theta             odometry: the same axes, moved and turned so that
      |    /                     the start pose is x = 0, y = 0, theta = 0
      |  o======                 robot frame: x ahead, y to the left
      |
      +-----------> x            (0, 0) is the lower left corner of the room

Everything here is deterministic: the same arena, seed, commands and hands give the same floats.
"""

from __future__ import annotations

from .arena import Arena, ArenaError, Box, Pose, Wall, read_arena
from .events import Command, Event, Hand
from .facts import STEP
from .world import World

__all__ = [
    "STEP",
    "Arena",
    "ArenaError",
    "Box",
    "Command",
    "Event",
    "Hand",
    "Pose",
    "Wall",
    "World",
    "read_arena",
]
