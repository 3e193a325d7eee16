"""
Foxglove as a transport: what is written is shown by the Foxglove app, and what its panels publish is read.

A server of Foxglove's WebSocket protocol on this computer (the Foxglove SDK). Messages have the encoding that they have
in DDS (CDR), and each channel has the definition of its type, so the app needs no ROS.
"""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable
from typing import Any

import foxglove
from foxglove.websocket import Capability, ChannelView, Client, ClientChannel, ServerListener

from .dds_messages import BadMessage, decode, encode
from .dds_names import dds_message_type, dds_topic, ros_topic
from .definitions import ros2_schema
from .graph import Endpoint, Graph, Quality
from .transport import MOST_TAKEN, Caller, Reader, Writer

__all__ = ["FOXGLOVE_PORT", "FoxgloveTransport"]

FOXGLOVE_PORT = 8765
"""Where the app looks first (Foxglove SDK, ``start_server``)."""

_DEPTH = 10
"""Of what a reader keeps until it is taken: that of DDS."""

_BEST_EFFORT = Quality(reliable=False, latched=False)


class FoxgloveTransport(ServerListener):  # type: ignore[misc]
    """
    Args:
        name: what the app calls the data source.

    Raises:
        RuntimeError: no port of this computer is free.
    """

    def __init__(self, name: str) -> None:
        self._context = foxglove.Context()
        self._lock = threading.Lock()
        # By topic.
        self._writers: dict[str, _Writer] = {}
        self._readers: list[_Reader] = []
        # Topics that a client shows, with their types, by client and channel.
        self._shown: dict[tuple[int, int], str] = {}
        # What clients publish.
        self._published: dict[tuple[int, int], ClientChannel] = {}
        try:
            self._server = self._serve(name, FOXGLOVE_PORT)
        except RuntimeError:
            # Another program has that port, or another Rosy.
            self._server = self._serve(name, 0)

    @property
    def port(self) -> int:
        """Where it listens."""
        return int(self._server.port)

    def graph(self) -> Graph:
        """What the panels of all clients show and publish now."""
        with self._lock:
            shown = [writer for topic in set(self._shown.values()) if (writer := self._writers.get(topic))]
            published = list(self._published.values())
        return Graph(
            (_endpoint(channel.topic, _short(channel.schema_name)) for channel in published),
            (_endpoint(writer.topic, writer.kind) for writer in shown),
        )

    def writer(self, topic: str, kind: str, quality: Quality) -> Writer:
        """Of a DDS topic."""
        name = ros_topic(topic) or topic
        with self._lock:
            known = self._writers.get(name)
            if known is None or known.kind != kind:
                schema = foxglove.Schema(name=_long(kind), encoding="ros2msg", data=ros2_schema(kind).encode())
                channel = foxglove.Channel(name, message_encoding="cdr", schema=schema, context=self._context)
                known = self._writers[name] = _Writer(name, kind, channel, quality.latched)
            return known

    def caller(self, service: str, kind: str) -> Caller | None:  # noqa: ARG002 no panel offers a service
        """There is none."""
        return None

    def reader(self, topic: str, kind: str, quality: Quality, on_data: Callable[[], None]) -> Reader:  # noqa: ARG002
        """``on_data`` is called in a thread of the server."""
        reader = _Reader(ros_topic(topic) or topic, kind, on_data, self._forget)
        with self._lock:
            self._readers.append(reader)
        return reader

    def close(self) -> None:
        """Clients lose their connection."""
        self._server.stop()

    # What the server calls, in threads of its own

    def on_subscribe(self, client: Client, channel: ChannelView) -> None:
        """A panel shows a topic."""
        with self._lock:
            self._shown[client.id, channel.id] = channel.topic
            writer = self._writers.get(channel.topic)
        if writer is not None:
            writer.repeat()

    def on_unsubscribe(self, client: Client, channel: ChannelView) -> None:
        """No panel of a client shows it any more."""
        with self._lock:
            self._shown.pop((client.id, channel.id), None)

    def on_client_advertise(self, client: Client, channel: ClientChannel) -> None:
        """A panel is going to publish."""
        with self._lock:
            self._published[client.id, channel.id] = channel

    def on_client_unadvertise(self, client: Client, client_channel_id: int) -> None:
        """It publishes no more."""
        with self._lock:
            self._published.pop((client.id, client_channel_id), None)

    def on_message_data(self, client: Client, client_channel_id: int, data: bytes) -> None:
        """A panel publishes a message."""
        with self._lock:
            channel = self._published.get((client.id, client_channel_id))
            readers = list(self._readers)
        if channel is None:
            return
        for reader in readers:
            if reader.topic == channel.topic and reader.kind == _short(channel.schema_name):
                reader.arrived(data)

    def _serve(self, name: str, port: int) -> Any:
        return foxglove.start_server(
            name=name,
            host="127.0.0.1",
            port=port,
            capabilities=[Capability.ClientPublish],
            supported_encodings=["cdr"],
            server_listener=self,
            context=self._context,
        )

    def _forget(self, reader: _Reader) -> None:
        with self._lock:
            self._readers.remove(reader)


class _Writer:
    def __init__(self, topic: str, kind: str, channel: foxglove.Channel, latched: bool) -> None:
        self.topic = topic
        self.kind = kind
        self._channel = channel
        self._latched = latched
        self._last: bytes | None = None

    def write(self, message: Any) -> None:
        if self._latched:
            self._last = encode(message)
            self._channel.log(self._last)
        elif self._channel.has_sinks():
            self._channel.log(encode(message))

    def repeat(self) -> None:
        """The last message of a latched topic, for one that begins to read it."""
        if self._last is not None:
            self._channel.log(self._last)

    def is_matched(self) -> bool:
        return bool(self._channel.has_sinks())

    def flush(self) -> None:
        """The server sends in its own threads."""


class _Reader:
    def __init__(self, topic: str, kind: str, on_data: Callable[[], None], forget: Callable[[_Reader], None]) -> None:
        self.topic = topic
        self.kind = kind
        self._on_data = on_data
        self._forget = forget
        self._arrived: deque[bytes] = deque(maxlen=_DEPTH)

    def arrived(self, data: bytes) -> None:
        """A message of this topic and type."""
        self._arrived.append(data)
        self._on_data()

    def take(self) -> list[Any]:
        messages: list[Any] = []
        while self._arrived and len(messages) < MOST_TAKEN:
            try:
                messages.append(decode(self.kind, self._arrived.popleft()))
            except BadMessage as why:
                messages.append(why)
        return messages

    def close(self) -> None:
        self._forget(self)


def _endpoint(topic: str, kind: str) -> Endpoint:
    return Endpoint(dds_topic(topic), dds_message_type(kind), _BEST_EFFORT, b"", "")


def _long(kind: str) -> str:
    return kind.replace("/", "/msg/")


def _short(kind: str) -> str:
    return kind.replace("/msg/", "/")
