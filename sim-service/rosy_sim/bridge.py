"""
The rosbridge clients of one session: what the robot senses goes out to them, what they command comes in.

Bounded like everything towards the outside: a client that does not read loses its oldest messages.
"""

from __future__ import annotations

import asyncio
from collections import deque
from collections.abc import Iterable

from .wire.rosbridge import LATCHED, BridgeClient
from .wire.topics import ODOM, event_message, full_odometry
from .world.events import Command, Event
from .world.world import Odometry

__all__ = ["MAX_CLIENTS", "Bridge", "Client"]

MAX_CLIENTS = 20
"""Connections of one session."""

_MAX_WAITING = 1_000
"""Messages that wait for a slow client, before the oldest are dropped."""


class Client:
    """One connection."""

    def __init__(self) -> None:
        self.protocol = BridgeClient()
        self._waiting: deque[str] = deque(maxlen=_MAX_WAITING)
        self._something = asyncio.Event()

    def put(self, texts: Iterable[str]) -> None:
        """Queue frames."""
        self._waiting.extend(texts)
        if self._waiting:
            self._something.set()

    async def get(self) -> str:
        """The next frame."""
        while not self._waiting:
            self._something.clear()
            await self._something.wait()
        return self._waiting.popleft()


class Bridge:
    """All connections of a session."""

    def __init__(self) -> None:
        self._clients: set[Client] = set()
        # Last message of each latched topic, for clients that come later.
        self._latched: dict[str, Event] = {}
        self._seq = 0

    def __len__(self) -> int:
        return len(self._clients)

    @property
    def full(self) -> bool:
        """Whether no more connections are taken."""
        return len(self._clients) >= MAX_CLIENTS

    def join(self) -> Client:
        """A new connection."""
        client = Client()
        for topic, event in self._latched.items():
            client.protocol.deliver(topic, event_message(event)[1], 0.0)
        self._clients.add(client)
        return client

    def leave(self, client: Client) -> None:
        """A connection is closed."""
        self._clients.discard(client)

    def receive(self, client: Client, text: str | bytes, now: float) -> list[Command]:
        """Serve a message; returns the commands in it."""
        reply = client.protocol.receive(text, now)
        client.put(reply.texts)
        return reply.commands

    def sensed(self, events: list[Event], odometry: Odometry, time: float, now: float) -> None:
        """Tell everybody what the robot sensed in a step at simulated ``time``."""
        for event in events:
            topic, msg = event_message(event)
            if topic in LATCHED:
                self._latched[topic] = event
            for client in self._clients:
                client.put(client.protocol.deliver(topic, msg, now))
        listeners = [client for client in self._clients if ODOM in client.protocol.topics]
        if listeners:
            self._seq += 1
            message = full_odometry(odometry, time, self._seq)
            for client in listeners:
                client.put(client.protocol.deliver(ODOM, message, now))
        for client in self._clients:
            client.put(client.protocol.drain(now))
