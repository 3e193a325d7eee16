"""
Physics of a room and a robot in it, without clocks, files, sockets or JSON.

Axes, in the room (metres, radians, counter-clockwise positive)::

      y                          theta = 0 looks along x
      ^      . theta             odometry: the same axes, moved and turned so that
      |    /                     the start pose is x = 0, y = 0, theta = 0
      |  o======                 robot frame: x ahead, y to the left
      |
      +-----------> x            (0, 0) is the lower left corner of the room

Everything here is deterministic: the same arena, seed, commands and actions give the same floats.
"""

from __future__ import annotations

from .arena import Arena, ArenaError, Box, Pose, Wall, read_arena
from .events import Command, Reading, UserAction
from .time_step import STEP
from .world import World

__all__ = [
    "STEP",
    "Arena",
    "ArenaError",
    "Box",
    "Command",
    "Pose",
    "Reading",
    "UserAction",
    "Wall",
    "World",
    "read_arena",
]
