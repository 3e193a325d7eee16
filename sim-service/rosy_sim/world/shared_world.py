"""
Shared world: the world of a robot with other robots in its room.

Each robot is a ``World`` of its own, with its sensors, motors and odometry. They share the floor: the robots are
obstacles to each other, and all push the same things. A step moves the first robot and then the others in their order,
so the same calls give the same floats. A robot that drives into another one is stopped by it, as by a wall: the motors
of a robot that stands hold its wheels.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from .arena import Arena, Pose
from .events import UserAction
from .obstacles import Obstacles
from .robot import Robot
from .time_step import STEP
from .world import SUBSTEPS, Push, World

__all__ = ["SharedWorld"]


class SharedWorld(World):
    """
    The first robot's world, which moves the others as well.

    Args:
        arena: the room.
        robot: the first robot; the others are of the same kind.
        seed: of all random numbers of the first robot; the next ones are those of the others.
        obstacles: those of the arena.
        starts: where the other robots start.

    Raises:
        ArenaError: a robot cannot stand at its start.
    """

    def __init__(self, arena: Arena, robot: Robot, seed: int, obstacles: Obstacles, starts: Sequence[Pose]) -> None:
        super().__init__(arena, robot, seed, obstacles)
        obstacles.share(1)
        obstacles.place(self.x, self.y)
        # Their owners may sense and command them, but this one lets their time pass.
        for number, start in enumerate(starts, 1):
            around = Obstacles(robot.body, obstacles)
            around.share(number + 1)
            # What is to be done in the room, the first robot does.
            other = World(replace(arena, start=start, goals=()), robot, seed + number, around)
            around.place(other.x, other.y)
            self.others.append(other)

    def apply(self, action: UserAction) -> None:
        """
        A hand does something to the first robot or to the room.

        Raises:
            ActionRefused: it is not possible.
        """
        super().apply(action)
        self.obstacles.place(self.x, self.y)

    def integrate(self, dt: float = STEP) -> None:
        """Let ``dt`` seconds pass for all robots, a step at most."""
        worlds: list[World] = [self, *self.others]
        for world in worlds:
            world.begin_step(dt)
        if any(world.may_push() for world in worlds):
            self._push_together(worlds, dt)
        else:
            for world in worlds:
                world.update_clearance()
                world.move(dt)
                world.obstacles.place(world.x, world.y)
        for world in worlds:
            # What the robots touch depends on where the others are now.
            world.update_clearance()
            world.end_step(dt)

    def _push_together(self, worlds: list[World], dt: float) -> None:
        pushes = [Push(world, dt) for world in worlds]
        for piece in range(1, SUBSTEPS + 1):
            for push in pushes:
                push.begin(piece)
            self.obstacles.push(dt / SUBSTEPS)
            for world, push in zip(worlds, pushes, strict=True):
                push.end()
                world.obstacles.place(world.x, world.y)
        for world in worlds:
            world.obstacles.awake = self.obstacles.awake
            world.after_push()
