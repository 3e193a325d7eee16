"""
The clock of a simulated robot without a program: rolls it to rest, and serves ROS clients.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable

from .bridge import Bridge
from .showing import Showing
from .world.events import Event
from .world.facts import STEP
from .world.world import World

__all__ = ["IdleClock"]


class IdleClock:
    """Takes 20 ms at a time while there is something to do; wake() it when that may have changed."""

    def __init__(self, bridge: Bridge, showing: Showing, sensed: Callable[[list[Event]], None]) -> None:
        self._loop = asyncio.get_running_loop()
        self._bridge = bridge
        self._showing = showing
        self._sensed = sensed
        self._next: asyncio.Handle | None = None
        # When the next 20 ms are due, on the loop's clock.
        self._due = 0.0
        # The world it moves; None while a run does.
        self._world: World | None = None
        self._closed = False

    def hold(self) -> None:
        """A run moves the world now."""
        self._world = None

    def wake(self, world: World) -> None:
        """No run moves this world; go if there is something to do."""
        self._world = world
        if self._next is None and not self._closed:
            self._due = self._loop.time()
            self._next = self._loop.call_soon(self._roll)

    def close(self) -> None:
        """Never go again."""
        self._closed = True
        if self._next is not None:
            self._next.cancel()

    def _roll(self) -> None:
        """Until the robot is at rest and no ROS client listens."""
        self._next = None
        world = self._world
        if world is None:
            return
        moving = world.v or world.w or world.room.awake
        if not (moving or self._bridge):
            return
        events = world.sense()
        world.integrate()
        self._sensed(events)
        self._showing.frame(force=bool(moving) and not (world.v or world.w))
        self._due = max(self._due + STEP, self._loop.time() - STEP)
        self._next = self._loop.call_at(self._due, self._roll)
