"""
Sockets of ROS clients of a session's simulated robot, such as Foxglove or a learner's own page with roslib. Any client
may connect that knows the session's random name.
"""

from __future__ import annotations

import asyncio
from collections.abc import Mapping

from starlette.status import WS_1008_POLICY_VIOLATION, WS_1013_TRY_AGAIN_LATER
from starlette.websockets import WebSocket, WebSocketDisconnect

from ...token_bucket import TokenBucket
from ...wire.ros.rosbridge import crowded
from ..pacing.loop_scheduler import LoopScheduler, PageTurns
from ..pacing.reading_pace import message_cost
from ..sessions.page_session import PageSession
from ..sessions.simulator.ros_bridge import MAX_CLIENTS, RosClient
from ..sessions.simulator.simulated_robot import SimulatedRobot
from .first_completed import first_completed

__all__ = ["RosSockets"]

_RATE = 500.0
"""Messages that a ROS client may send, a second."""


class RosSockets:
    """Serves the sockets; ``sessions`` are the page sessions by their random names."""

    def __init__(self, sessions: Mapping[str, PageSession], scheduler: LoopScheduler) -> None:
        self._sessions = sessions
        self._scheduler = scheduler

    async def serve(self, socket: WebSocket) -> None:
        """Serve one client until it or the page disconnects."""
        session = self._sessions.get(socket.path_params["session"])
        if session is None:
            await socket.close(WS_1008_POLICY_VIOLATION)
            return
        await socket.accept()
        if session.simulator.bridge.is_full:
            # A client sees the reason only of a connection that was accepted.
            await socket.close(WS_1013_TRY_AGAIN_LATER, crowded(MAX_CLIENTS))
            return
        turns = PageTurns(self._scheduler, socket.client.host if socket.client is not None else "")
        robot = session.simulator
        client = robot.join()
        try:
            await first_completed(_receive(socket, robot, client, turns), _send(socket, client), session.closed.wait())
        finally:
            robot.leave(client)


async def _receive(socket: WebSocket, robot: SimulatedRobot, client: RosClient, turns: PageTurns) -> None:
    now = asyncio.get_running_loop().time
    limit = TokenBucket(_RATE, _RATE, now())
    while True:
        message = await socket.receive()
        if message["type"] == "websocket.disconnect":
            return
        text = message.get("text") or message.get("bytes") or ""
        async with turns.turn(len(text)):
            robot.receive_ros(client, text)
        if wait := limit.overdraw(message_cost(len(text)), now()):
            await asyncio.sleep(wait)


async def _send(socket: WebSocket, client: RosClient) -> None:
    try:
        while True:
            frame = await client.get()
            if isinstance(frame, bytes):
                await socket.send_bytes(frame)
            else:
                await socket.send_text(frame)
    except (WebSocketDisconnect, RuntimeError):
        # The client disconnected during a send.
        return
