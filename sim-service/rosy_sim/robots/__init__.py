"""Robots that the simulator has, one package each: body, limits, sensors and order of events."""

from __future__ import annotations

from ..robot_description import description, known_robots
from ..sentences.sentence import tr
from ..world.arena import Arena, ArenaError
from ..world.robot import Robot
from .kobuki import KOBUKI
from .turtlebot3 import TURTLEBOT3

__all__ = ["ROBOTS", "robot_in", "robot_names"]

ROBOTS: dict[str, Robot] = {robot.name: robot for robot in (KOBUKI, TURTLEBOT3)}
"""By name."""


def robot_in(arena: Arena) -> Robot:
    """
    The robot of a room: the one that the room names, or else the first of the registry.

    Raises:
        ArenaError: the simulator has no robot of that name.
    """
    name = arena.robot if arena.robot is not None else known_robots()[0]
    if name not in ROBOTS:
        raise ArenaError(
            "robot", tr("the simulator has no robot {name}; it has {names}.", name=repr(name), names=robot_names())
        )
    return ROBOTS[name]


def robot_names() -> str:
    """The names of all robots of the simulator, each with what it is called."""
    return ", ".join(f"{name} ({description(name)['title']})" for name in ROBOTS)
