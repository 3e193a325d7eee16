"""
Process that makes the simulated robot one of ROS 2: ``python -m rosy_sim.ros2.simulator_process ADDRESS``.

In, on standard input, a line each: the simulator's frames of rosbridge's protocol, its rooms (``room_frame``), and
nothing whenever another page's robot begins to be this one. Out, on standard output: the port of Foxglove's protocol as
the first line, then frames for the simulator. On the other side are DDS, Zenoh and the Foxglove app, with the bridge
that robots use too (``bridge.py``), in the other direction. It ends when its input does.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
import signal
import sys
import time
from collections.abc import Iterable

from .bridge import Bridge
from .simulated_topics import Frame, SimulatedTopics
from .transports.address import parse_ros2_address
from .transports.foxglove_transport import FoxgloveTransport
from .transports.open_transport import open_transport
from .transports.transport import Transports

__all__: list[str] = []

_MAX_LINE = 2_000_000
"""Bytes of a line: a map has six hundred thousand."""

_NAME = "Rosy"
"""As which the Foxglove app shows the robot."""


class _Client:
    """The simulator as a client of the bridge."""

    def __init__(self, topics: SimulatedTopics) -> None:
        self._topics = topics
        self._frames: asyncio.Queue[str] = asyncio.Queue()
        self.offer(topics.offers())

    def offer(self, frames: Iterable[Frame]) -> None:
        """For the bridge."""
        for frame in frames:
            self._frames.put_nowait(json.dumps(frame))

    async def __anext__(self) -> str:
        return await self._frames.get()

    def __aiter__(self) -> _Client:
        return self

    async def send(self, frame: str) -> None:
        """From the bridge."""
        _ask(self._topics.to_simulator(json.loads(frame)))

    async def close(self, code: int, reason: str) -> None:
        """The bridge closes only those that drive a robot."""


def _ask(frames: Iterable[Frame]) -> None:
    """The simulator; it may be gone."""
    with contextlib.suppress(OSError):
        for frame in frames:
            print(json.dumps(frame), flush=True)


async def _main(address: str) -> None:
    given = parse_ros2_address(address)
    assert given is not None
    # The service ends it, also after Ctrl-C.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    loop = asyncio.get_running_loop()
    lines = asyncio.StreamReader(limit=_MAX_LINE)
    await loop.connect_read_pipe(lambda: asyncio.StreamReaderProtocol(lines), sys.stdin)
    foxglove = FoxgloveTransport(_NAME)
    print(foxglove.port, flush=True)
    transport = Transports((open_transport(given.domain, given.host), foxglove))
    # It drives nothing, so there is nothing to guard.
    bridge = Bridge(transport, None)
    topics = SimulatedTopics(given.namespace, lambda: divmod(time.time_ns(), 10**9))
    client = _Client(topics)

    def follow(known: dict[str, str], _hosts: dict[str, list[str]]) -> None:
        offered, asked = topics.follow(known)
        client.offer(offered)
        _ask(asked)

    works = [asyncio.create_task(bridge.run(follow)), asyncio.create_task(bridge.serve(client))]
    for work in works:
        # Without its bridge the process ends, and the service starts it again.
        work.add_done_callback(lambda _: lines.feed_eof())
    while line := await lines.readline():
        if line.strip():
            client.offer(topics.from_simulator(json.loads(line)))
        else:
            _ask(topics.requests())
    for work in works:
        work.cancel()
    await asyncio.gather(*works, return_exceptions=True)
    transport.close()


if __name__ == "__main__":
    asyncio.run(_main(sys.argv[1]))
