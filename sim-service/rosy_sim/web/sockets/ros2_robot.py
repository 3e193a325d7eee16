"""
Simulated robot of a page as a robot of ROS 2 (``./rosy start --ros2``): a process that speaks ROS 2
(``ros2/simulator_process.py``), and the page whose robot it is: the one that is open for the longest time.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
from asyncio.subprocess import DEVNULL, Process
from collections.abc import Callable, Mapping

from ...ros2.simulated_topics import room_frame
from ...sentences.sentence import Sentence, tr
from ...token_bucket import TokenBucket
from ...worker.background_process import end_process, start_process
from ...world.arena import Arena
from ..sessions.page_session import PageSession
from ..sessions.simulator.ros_bridge import RosClient
from ..sessions.simulator.simulated_robot import SimulatedRobot
from .first_completed import first_completed

__all__ = ["Ros2Robot"]

_PAUSE = 2.0
"""Seconds until the process is started again when it has ended by itself."""

_RATE = 500.0
"""Commands a second that are taken: what a ROS client may send."""


class Ros2Robot:
    """
    Args:
        address: ``ros2:`` and its domain, computer and namespace.
        sessions: of the pages, the oldest first.
        tell: the person who started Rosy.
    """

    def __init__(self, address: str, sessions: Mapping[str, PageSession], tell: Callable[[Sentence], None]) -> None:
        self._address = address
        self._sessions = sessions
        self._tell = tell
        self._opened = asyncio.Event()
        # Of Foxglove's protocol, as it was said.
        self._port = ""

    def page_opened(self) -> None:
        """There is one more page."""
        self._opened.set()

    async def run(self) -> None:
        """Until it is cancelled."""
        while True:
            process = await start_process("rosy_sim.ros2.simulator_process", self._address, stderr=DEVNULL)
            try:
                # A line of the process may be too long to be read: then it begins anew, too.
                with contextlib.suppress(ValueError):
                    await self._announce(process)
                    await first_completed(self._serve(process), process.wait())
            finally:
                await end_process(process)
            self._tell(tr("The process that speaks ROS 2 has ended; it is started again."))
            await asyncio.sleep(_PAUSE)

    async def _announce(self, process: Process) -> None:
        """Say where the Foxglove app finds the robot, once, and again when that is elsewhere."""
        assert process.stdout is not None
        port = (await process.stdout.readline()).decode().strip()
        if port and port != self._port:
            self._port = port
            self._tell(tr("The Foxglove app shows the robot at ws://localhost:{port}.", port=port))

    async def _serve(self, process: Process) -> None:
        """One page after the other."""
        assert process.stdin is not None
        while True:
            session = await self._oldest()
            client = session.simulator.join()
            try:
                # It subscribes to the sensors of this robot.
                process.stdin.write(b"\n")
                await first_completed(
                    _receive(process, session.simulator, client),
                    _send(process, client),
                    _show_rooms(process, session.simulator),
                    session.closed.wait(),
                )
            finally:
                session.simulator.leave(client)

    async def _oldest(self) -> PageSession:
        while True:
            self._opened.clear()
            for session in self._sessions.values():
                if not session.closed.is_set():
                    return session
            await self._opened.wait()


async def _receive(process: Process, robot: SimulatedRobot, client: RosClient) -> None:
    assert process.stdout is not None
    now = asyncio.get_running_loop().time
    limit = TokenBucket(_RATE, _RATE, now())
    while line := await process.stdout.readline():
        robot.receive_ros(client, line)
        if wait := limit.overdraw(1, now()):
            await asyncio.sleep(wait)
    # The process ends, which the one who waits for it notices.
    await asyncio.Event().wait()


async def _show_rooms(process: Process, robot: SimulatedRobot) -> None:
    assert process.stdin is not None
    with contextlib.suppress(ConnectionError):
        while True:
            robot.room_changed.clear()
            line = await asyncio.to_thread(_encoded_room, robot.world.arena)
            process.stdin.write(line)
            await process.stdin.drain()
            await robot.room_changed.wait()
    await asyncio.Event().wait()


def _encoded_room(arena: Arena) -> bytes:
    return json.dumps(room_frame(arena)).encode() + b"\n"


async def _send(process: Process, client: RosClient) -> None:
    assert process.stdin is not None
    with contextlib.suppress(ConnectionError):
        while True:
            frame = await client.get()
            process.stdin.write(frame.encode() if isinstance(frame, str) else frame)
            process.stdin.write(b"\n")
            await process.stdin.drain()
    await asyncio.Event().wait()
