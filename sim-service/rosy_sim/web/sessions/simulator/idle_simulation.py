"""
Simulation of a robot without a program: lets it roll to a stop, and serves ROS clients.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable

from ....world.events import Reading
from ....world.time_step import STEP
from ....world.world import World
from ..page_view import PageView
from .ros_bridge import RosBridge

__all__ = ["IdleSimulation"]


class IdleSimulation:
    """Makes a step every 20 ms while the robot moves or a ROS client listens; wake() it when that may have changed."""

    def __init__(self, bridge: RosBridge, view: PageView, on_events: Callable[[list[Reading]], None]) -> None:
        self._loop = asyncio.get_running_loop()
        self._bridge = bridge
        self._view = view
        self._on_events = on_events
        self._next: asyncio.Handle | None = None
        # When the next step is due, on the loop's clock.
        self._due = 0.0
        # None while a run moves the world.
        self._world: World | None = None
        self._closed = False

    def pause(self) -> None:
        """A run moves the world from now on."""
        self._world = None

    def wake(self, world: World) -> None:
        """No run moves this world; make steps while they are needed."""
        self._world = world
        if self._next is None and not self._closed:
            self._due = self._loop.time()
            self._next = self._loop.call_soon(self._step)

    def close(self) -> None:
        """Make no more steps."""
        self._closed = True
        if self._next is not None:
            self._next.cancel()

    def _step(self) -> None:
        self._next = None
        world = self._world
        if world is None:
            return
        moving = world.v or world.w or world.obstacles.awake
        if not (moving or self._bridge):
            return
        events = world.sense()
        world.integrate()
        self._on_events(events)
        self._view.show_frame(force=bool(moving) and not (world.v or world.w))
        self._due = max(self._due + STEP, self._loop.time() - STEP)
        self._next = self._loop.call_at(self._due, self._step)
