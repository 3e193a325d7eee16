"""
Robots nearby on ROS 2, as a process of their discovery reports them (``discovery_process.py``).
"""

from __future__ import annotations

from asyncio.subprocess import DEVNULL
from collections.abc import Callable

import msgspec

from ..worker.background_process import end_process, start_process
from .battery import Battery
from .transports.address import Ros2Address

__all__ = ["NearbyRobot", "decode_robots", "encode_robots", "follow_robots"]


class NearbyRobot(msgspec.Struct, frozen=True):
    """
    ``title`` is what it is, such as TurtleBot 3, and ``name`` what it is called: its namespace, which may be empty.
    ``bare`` is its address without the options that ``address`` has; the address names its computer where another
    robot of the domain has the same topics. ``zenoh`` is whether it speaks Zenoh in place of DDS, and ``several``
    whether several robots are there that nothing tells apart.
    """

    title: str
    name: str
    domain: int
    bare: str
    address: str
    battery: Battery
    zenoh: bool = False
    several: bool = False


_decoder = msgspec.json.Decoder(list[NearbyRobot])

encode_robots = msgspec.json.Encoder().encode
"""A line of the discovery's process, without its end."""

decode_robots = _decoder.decode
"""The robots of a line."""


async def follow_robots(place: Ros2Address, on_robots: Callable[[list[NearbyRobot]], None]) -> None:
    """
    Calls ``on_robots`` with the robots at an address, now and whenever they change, until the discovery ends by itself
    or this is cancelled.
    """
    process = await start_process("rosy_sim.ros2.discovery_process", place.text(), stderr=DEVNULL)
    assert process.stdout is not None
    try:
        while line := await process.stdout.readline():
            on_robots(decode_robots(line))
    finally:
        # It says on the network that it leaves.
        await end_process(process)
