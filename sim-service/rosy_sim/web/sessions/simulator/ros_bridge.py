"""
ROS bridge of one page session: sends what the robot senses to rosbridge clients, and takes their commands.

A client that does not read loses its oldest messages.
"""

from __future__ import annotations

import asyncio
from collections import deque
from collections.abc import Iterable

from ....robot_description import simulated_actions
from ....robots import ROBOTS
from ....wire.channels import Values
from ....wire.ros.actionlib import ACTIONLIB, KEPT_RESULTS, STATUS_STEPS, goal_of, reply_message, status_message
from ....wire.ros.ros_messages import completed
from ....wire.ros.rosbridge import Frame, Reply, RosbridgeClient, RosbridgeGraph
from ....wire.topics import CHANNELS, COMMAND_TOPICS, LATCHED, ODOMETRY, TopicMessage, on_demand, topic_message
from ....world.action_goals import ActionGoals
from ....world.events import Command, GiveGoal, Reading, TakeBackGoal
from ....world.world import Odometry

__all__ = ["MAX_CLIENTS", "RosBridge", "RosClient"]

_ACTIONS = frozenset(action for robot in ROBOTS.values() for action in robot.actions) & set(
    simulated_actions("ros1").values()
)
"""Those of any robot of the simulator that ROS 1 has as topics."""

MAX_CLIENTS = 20
"""Connections of one session."""

_MAX_WAITING = 1_000
"""Messages that wait for a slow client, before the oldest are dropped."""


class RosClient:
    """One connection."""

    def __init__(self, shared: RosbridgeGraph) -> None:
        self.protocol = RosbridgeClient(shared)
        self._waiting: deque[Frame] = deque(maxlen=_MAX_WAITING)
        self._not_empty = asyncio.Event()

    def put(self, frames: Iterable[Frame]) -> None:
        """Queue frames."""
        self._waiting.extend(frames)
        if self._waiting:
            self._not_empty.set()

    async def get(self) -> Frame:
        """The next frame."""
        while not self._waiting:
            self._not_empty.clear()
            await self._not_empty.wait()
        return self._waiting.popleft()


class RosBridge:
    """All connections of a session."""

    def __init__(self) -> None:
        self._clients: set[RosClient] = set()
        self._shared = RosbridgeGraph()
        # Latched topics that have had a message, for clients that come later; and the latest values of each channel.
        self._latched: dict[str, None] = {}
        self._latest: dict[str, Values] = {}
        self._seq = 0
        # The latest results of goals on topics, and the calls of `post_replies`.
        self._results: deque[TopicMessage] = deque(maxlen=KEPT_RESULTS)
        self._steps = 0

    def __len__(self) -> int:
        return len(self._clients)

    @property
    def is_full(self) -> bool:
        """Whether no more connections are taken."""
        return len(self._clients) >= MAX_CLIENTS

    def wanted(self) -> list[str]:
        """The channels measured on demand to which a client listens."""
        return on_demand({topic for client in self._clients for topic in client.protocol.topics})

    def join(self) -> RosClient:
        """A new connection."""
        client = RosClient(self._shared)
        for topic in self._latched:
            client.protocol.deliver(topic, topic_message(self._latest, topic, 0.0, self._seq), 0.0)
        self._clients.add(client)
        return client

    def leave(self, client: RosClient) -> None:
        """A connection is closed."""
        self._clients.discard(client)
        self._forward(client.protocol.leave())

    def receive(
        self, client: RosClient, text: str | bytes, now: float
    ) -> list[Command | TopicMessage | GiveGoal | TakeBackGoal]:
        """Serve a message; returns the commands and goals in it, and the messages for others."""
        reply = client.protocol.receive(text, now)
        client.put(reply.texts)
        self._forward(reply)
        for message in reply.commanded:
            self._post_completed(message, now)
        for command in reply.commands:
            goal = goal_of(command, _ACTIONS) if isinstance(command, TopicMessage) else None
            if goal is not None:
                reply.goals.append(goal)
        return [*reply.commands, *reply.goals]

    def post_replies(self, actions: ActionGoals, now: float) -> None:
        """Send to the clients how their goals get on, after a step."""
        for client in self._clients:
            for reply in actions.take_replies(client.protocol.name):
                client.put(client.protocol.deliver_reply(reply))
        graph = self._shared.graph
        for reply in actions.take_replies(ACTIONLIB):
            message = reply_message(reply, graph.time)
            if reply.kind == "result":
                self._results.append(message)
            self.post(message, now)
        self._steps += 1
        if self._steps % STATUS_STEPS == 0:
            for action in actions.names:
                if f"{action}/status" in graph.own_topics:
                    self.post(status_message(action, actions.pursued_for(ACTIONLIB), [*self._results], graph.time), now)

    def post_command(self, command: Command, now: float) -> None:
        """Send a command of the program to the clients that have subscribed to its topic."""
        channel = CHANNELS[command.channel]
        if any(channel.topic in client.protocol.topics for client in self._clients):
            message = channel.full(command.values, self._shared.graph.time, self._seq)
            self._post_completed(TopicMessage(channel.topic, message), now)

    def _post_completed(self, message: TopicMessage, now: float) -> None:
        self.post(TopicMessage(message.topic, completed(COMMAND_TOPICS[message.topic], message.msg)), now)

    def _forward(self, reply: Reply) -> None:
        """Queue the frames of a reply that are for other clients."""
        for protocol, frame in reply.forwards:
            for client in self._clients:
                if client.protocol is protocol:
                    client.put([frame])

    def post(self, message: TopicMessage, now: float) -> None:
        """Send a message on a topic that is none of the robot's to all clients."""
        for client in self._clients:
            client.put(client.protocol.deliver(message.topic, message.msg, now))

    def publish(self, readings: list[Reading], odometry: Odometry, time: float, now: float) -> None:
        """Send to all clients what the robot sensed in a step at simulated ``time``."""
        self._shared.graph.time = time
        self._latest[ODOMETRY.name] = odometry
        topics: list[str] = []
        for reading in readings:
            if CHANNELS[reading.channel].derived:
                continue
            topic = CHANNELS[reading.channel].topic
            self._latest[reading.channel] = reading.values
            if topic not in LATCHED:
                self._deliver(topic, time, now)
            elif topic not in topics:
                # Several channels of a state share its message.
                topics.append(topic)
        for topic in topics:
            self._latched[topic] = None
            self._deliver(topic, time, now)
        if any(ODOMETRY.topic in client.protocol.topics for client in self._clients):
            self._seq += 1
            self._deliver(ODOMETRY.topic, time, now)
        for client in self._clients:
            client.put(client.protocol.drain(now))

    def _deliver(self, topic: str, time: float, now: float) -> None:
        message = topic_message(self._latest, topic, time, self._seq)
        for client in self._clients:
            client.put(client.protocol.deliver(topic, message, now))
