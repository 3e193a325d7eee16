"""
Robot discovery for as long as the service runs: a process for each address at which robots may appear.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Sequence

from ..ros2.nearby_robots import NearbyRobot, follow_robots
from ..ros2.transports.address import Ros2Address, parse_ros2_address

__all__ = ["discover_robots"]

_PAUSE = 2.0
"""Seconds until a process that has ended by itself is started again."""


async def discover_robots(addresses: Sequence[str], on_robots: Callable[[Sequence[NearbyRobot]], None]) -> None:
    """Calls ``on_robots`` with all robots whenever they change, until it is cancelled."""
    found: dict[Ros2Address, list[NearbyRobot]] = {}

    async def follow(place: Ros2Address) -> None:
        def show(robots: list[NearbyRobot]) -> None:
            found[place] = robots
            # An address in which another one is contained finds its robots too.
            on_robots(list({robot.bare: robot for robots in found.values() for robot in robots}.values()))

        while True:
            await follow_robots(place, show)
            show([])
            await asyncio.sleep(_PAUSE)

    async with asyncio.TaskGroup() as group:
        for address in addresses:
            place = parse_ros2_address(address)
            assert place is not None
            group.create_task(follow(place))
