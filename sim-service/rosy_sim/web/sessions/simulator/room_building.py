"""
Rooms that pages ask for, built in turns on the event loop. ``loop_scheduler.py``
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from ....errors import BadInput
from ....robots import robot_in
from ....sentences.sentence import tr
from ....wire.page import Companion
from ....world.arena import Arena, ArenaError, Pose, read_arena
from ....world.obstacles import Obstacles
from ....world.robot import Robot
from ....world.shared_world import SharedWorld
from ....world.world import World
from ....worlds.gallery import named_world, refusing_worlds
from ...pacing.loop_scheduler import PageTurns
from ..page_view import Room

__all__ = ["BuiltRoom", "build_room", "rebuild_room"]


@dataclass(frozen=True, slots=True)
class BuiltRoom:
    """A room that lacks its robot."""

    # As the page gave it.
    json: object
    arena: Arena
    obstacles: Obstacles

    def with_robot(self, seed: int = 0, robot: Robot | None = None) -> Room:
        """
        The room as it is before a run; once, for a run moves the obstacles.

        Args:
            seed: of the world.
            robot: that of the room with other limits, if they are others.

        Raises:
            BadInput: the robot cannot stand at the start.
        """
        with refusing_worlds(tr("This")):
            return Room(self.json, World(self.arena, robot or robot_in(self.arena), seed, self.obstacles))

    def with_robots(self, seed: int, companions: Sequence[Companion]) -> Room:
        """
        The same with more robots.

        Raises:
            BadInput: a robot cannot stand at its start.
        """
        if not companions:
            return self.with_robot(seed)
        starts = [Pose(one.x, one.y, one.theta) for one in companions]
        try:
            return Room(self.json, SharedWorld(self.arena, robot_in(self.arena), seed, self.obstacles, starts))
        except ArenaError as error:
            raise BadInput(
                tr("One of the other robots has no room where it should start. Drag it to free floor.")
            ) from error


async def build_room(wanted: object, turns: PageTurns) -> BuiltRoom:
    """
    A room by its name or as JSON.

    Raises:
        BadInput: there is no such room, or it is none.
    """
    with refusing_worlds(tr("This")):
        async with turns.turn():
            json = named_world(wanted) if isinstance(wanted, str) else wanted
            arena = read_arena(json)
        return BuiltRoom(json, arena, await _build_obstacles(arena, turns))


async def rebuild_room(room: Room, turns: PageTurns) -> BuiltRoom:
    """A room once more, as it was before anything moved."""
    arena = room.world.arena
    return BuiltRoom(room.json, arena, await _build_obstacles(arena, turns))


async def _build_obstacles(arena: Arena, turns: PageTurns) -> Obstacles:
    obstacles = Obstacles(robot_in(arena).body)
    await turns.complete(obstacles.add(arena))
    return obstacles
