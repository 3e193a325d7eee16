"""
Bridge between ROS 2 and the rosbridge protocol v2, for the clients of one computer.

In and out: frames of clients on a WebSocket, messages on DDS or Zenoh. It serves `advertise`, `unadvertise`, `publish`,
`subscribe`, `unsubscribe`, `call_service`, `send_action_goal` and `cancel_action_goal`, and of rosapi what is asked of
a graph. The quality of service follows what the other side offers, whenever that changes. A velocity is sent in the
type that the robot reads, Twist or TwistStamped, whichever the client says.

A robot whose client is gone or silent, or whose bridge was away for half a second, is stopped, and the goals of such a
client are cancelled; the guardian stops the robot when the bridge ends.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
import time
from collections.abc import AsyncIterator, Callable
from dataclasses import dataclass, field
from typing import Any, Protocol

from websockets.exceptions import ConnectionClosed

from ..boot_clock import boot_seconds
from .calls import Calls, soon
from .client_calls import ClientCalls
from .guardian_process import GuardianProcess
from .outgoing_frames import OutgoingFrames
from .transports.dds_messages import BadMessage, from_json, message_class, to_json
from .transports.dds_names import dds_topic
from .transports.graph import Graph, Quality
from .transports.transport import Reader, Transport, Writer
from .velocity_watch import REPEAT, STOPPED, TIMEOUT, VELOCITIES, VelocityWatch, as_type, is_moving

__all__ = ["Bridge", "Connection"]

_GRAPH_PERIOD = 0.1
"""Seconds between two looks at what was discovered."""

_HEARTBEAT = 0.05
"""Seconds between two signs of life to the guardian."""

_AWAY = 0.5
"""Seconds without a heartbeat after which this process was away: a tenth less than the guardian waits."""

_MATCH_TIMEOUT = 2.0
"""For a writer and a reader that the graph has to find each other, s."""

_WAS_AWAY, _NO_GUARDIAN = 4001, 4002
"""Why a connection is closed: the range for private use (RFC 6455, 7.4.2)."""


@dataclass(slots=True)
class _Subscription:
    kind: str
    quality: Quality
    # None until it is made, with a callback that knows this subscription.
    reader: Reader | None


@dataclass(slots=True)
class _Advertised:
    kind: str
    latched: bool
    # Writers by type, and the quality of each.
    writers: dict[str, tuple[Quality, Writer]] = field(default_factory=dict)
    # Of a velocity: whether the last one is not zero, and when a stop is to be sent, also again after the first.
    moving: bool = False
    watch: VelocityWatch | None = None


class Connection(Protocol):
    """Of a client: a WebSocket, or a robot in this process."""

    def __aiter__(self) -> AsyncIterator[str | bytes]:
        """The frames of the client."""

    async def send(self, frame: str, /) -> None:
        """A frame for the client."""

    async def close(self, code: int, reason: str, /) -> None:
        """End it, for a reason."""


class Bridge:
    """
    One domain; ``run`` keeps it up to date, ``serve`` handles a client. Without a ``guardian`` no client may drive a
    robot.
    """

    def __init__(self, transport: Transport, guardian: GuardianProcess | None) -> None:
        self._transport = transport
        self._guardian = guardian
        self._clients: set[_Client] = set()
        # Those that have gone and whose stop is still repeated.
        self._left: set[_Client] = set()
        self._beaten = boot_seconds()
        self.graph = transport.graph()
        self.calls = Calls(transport, lambda: self.graph)

    async def run(self, on_topics: Callable[[dict[str, str], dict[str, list[str]]], None]) -> None:
        """
        Until it is cancelled; ``on_topics`` is told the topics with their types, and those that publish them, whenever
        they change.
        """
        looked = 0.0
        told: tuple[dict[str, str], dict[str, list[str]]] | None = None
        while True:
            self.check_awake()
            if self._guardian is not None:
                if self._guardian.has_ended():
                    self._end_drives(_NO_GUARDIAN, "its guardian process has ended")
                self._guardian.beat()
            self._beaten = boot_seconds()
            for client in (*self._clients, *self._left):
                client.stop_when_due(self._beaten)
            self._left = {client for client in self._left if client.is_stopping(self._beaten)}
            if self._beaten - looked >= _GRAPH_PERIOD:
                looked = self._beaten
                self._look()
                topics = (self.graph.topics(), self.graph.hosts())
                if topics != told:
                    told = topics
                    on_topics(*topics)
            await asyncio.sleep(_HEARTBEAT)

    async def serve(self, socket: Connection) -> None:
        """Serves one client until it leaves, and then stops the robot that it drives."""
        client = _Client(self, socket)
        self._clients.add(client)
        sending = asyncio.create_task(client.send_queued())
        try:
            async for frame in socket:
                await client.receive(frame)
        except ConnectionClosed:
            pass
        finally:
            self._clients.discard(client)
            client.leave()
            self._left.add(client)
            sending.cancel()

    def stop(self) -> None:
        """Stops every robot that a client drives."""
        for client in self._clients:
            client.stop()

    def end_stops(self) -> None:
        """A client drives: the stops of those that have gone are not sent again."""
        self._left = set()

    def check_awake(self) -> None:
        """
        After a freeze or a sleep, what was sent before it is not passed on, and a client that drives is told that it
        lost the robot.
        """
        if boot_seconds() - self._beaten > _AWAY:
            self._beaten = boot_seconds()
            self._end_drives(_WAS_AWAY, "the bridge to the robot was away")

    async def guard(self, topic: str, kind: str) -> None:
        """Returns when the guardian would stop this topic."""
        assert self._guardian is not None
        await self._guardian.guard(topic, kind)

    def writer(self, topic: str, kind: str, quality: Quality) -> Writer:
        """Of a message type that has a definition."""
        return self._transport.writer(topic, kind, quality)

    def reader(self, topic: str, kind: str, quality: Quality, on_data: Callable[[], None]) -> Reader:
        """``on_data`` is called on the event loop."""
        loop = asyncio.get_running_loop()
        return self._transport.reader(topic, kind, quality, lambda: soon(loop, on_data))

    async def matched(self, writer: Writer) -> None:
        """Returns when something reads what is written, or after a while."""
        with contextlib.suppress(TimeoutError):
            async with asyncio.timeout(_MATCH_TIMEOUT):
                while not writer.is_matched():  # noqa: ASYNC110 a thread of the transport tells it
                    await asyncio.sleep(_HEARTBEAT)

    def _look(self) -> None:
        graph = self._transport.graph()
        if graph != self.graph:
            self.graph = graph
            self.calls.follow_graph()
            for client in self._clients:
                client.follow_graph()

    def _end_drives(self, code: int, why: str) -> None:
        for client in self._clients:
            if client.drives:
                client.end(code, why)


class _Client:
    def __init__(self, bridge: Bridge, socket: Connection) -> None:
        self._bridge = bridge
        self._socket = socket
        self._advertised: dict[str, _Advertised] = {}
        self._subscriptions: dict[str, _Subscription] = {}
        self._frames = OutgoingFrames()
        self._ended = False
        # It has sent a velocity, also one of zero.
        self.drives = False
        self._closing: asyncio.Task[None] | None = None
        self._calls = ClientCalls(bridge.calls, self._frames.put)

    async def receive(self, frame: str | bytes) -> None:
        """Serves a frame; one that cannot be served is answered with a `status`."""
        self._bridge.check_awake()
        if self._ended:
            return None
        try:
            message = json.loads(frame)
        except (ValueError, RecursionError):
            return self._complain("not JSON")
        if not isinstance(message, dict):
            return self._complain("a message is an object")
        topic = _absolute(message.get("topic"))
        kind = _short(message.get("type"))
        match message.get("op"):
            case "advertise" if topic:
                await self._advertise(topic, kind, message.get("latch") is True)
            case "unadvertise" if topic:
                self._unadvertise(topic)
            case "publish" if topic:
                self._publish(topic, message.get("msg"))
            case "subscribe" if topic:
                self._subscribe(topic, kind)
            case "unsubscribe" if topic:
                self._unsubscribe(topic)
            case "send_action_goal":
                self._calls.pursue(message, _absolute(message.get("action")))
            case "cancel_action_goal":
                self._calls.cancel(message.get("id"))
            case "call_service":
                self._call(message)
            case op:
                self._complain(f"unknown op {str(op)[:50]!r}")
        return None

    async def send_queued(self) -> None:
        """Sends frames in their order; a client that reads slowly delays only itself."""
        with contextlib.suppress(ConnectionClosed):
            while True:
                await self._socket.send(await self._frames.take())

    def stop_when_due(self, now: float) -> None:
        """A velocity that is not repeated is none. A stop is sent again: a best-effort reader may miss it."""
        for topic, advertised in self._advertised.items():
            if advertised.watch is not None and advertised.watch.due(now):
                advertised.moving = False
                self._write(topic, advertised, STOPPED)

    def is_stopping(self, now: float) -> bool:
        """Whether a stop is to be sent again."""
        return any(a.watch is not None and a.watch.wait(now) is not None for a in self._advertised.values())

    def leave(self) -> None:
        """Stops the robot that it drives, cancels its goals, and reads no more."""
        self.stop()
        self._calls.leave()
        for topic in list(self._subscriptions):
            self._unsubscribe(topic)

    def stop(self) -> None:
        """Stops the robot that it drives, if it moves."""
        for topic, advertised in self._advertised.items():
            if advertised.moving:
                self._write(topic, advertised, STOPPED)
                _stand(advertised)

    def end(self, code: int, why: str) -> None:
        """Stops the robot that it drives, and ignores what it sends from now on."""
        self.stop()
        self._calls.leave()
        self._ended = True
        self._closing = asyncio.create_task(self._socket.close(code, why))

    def follow_graph(self) -> None:
        """Reads again what is now offered in another quality."""
        for topic, subscription in list(self._subscriptions.items()):
            if self._bridge.graph.reading_quality(dds_topic(topic)) != subscription.quality:
                self._read(topic, subscription.kind)
        for topic, advertised in self._advertised.items():
            # A reader finds the writer that it needs before the first message.
            self._writer(topic, advertised)

    async def _advertise(self, topic: str, kind: str, latched: bool) -> None:
        kind = kind or self._bridge.graph.topics().get(topic, "")
        if message_class(kind) is None:
            return self._complain(f"there is no definition of {kind or topic}")
        advertised = _Advertised(kind, latched)
        if kind in VELOCITIES:
            await self._bridge.guard(dds_topic(topic), self._kind_to_write(topic, advertised))
        self._advertised[topic] = advertised
        _, writer = self._writer(topic, advertised)
        if kind in VELOCITIES and self._bridge.graph.reader_types(dds_topic(topic)):
            # What is written before the robot hears it is lost.
            await self._bridge.matched(writer)
        return None

    def _unadvertise(self, topic: str) -> None:
        advertised = self._advertised.pop(topic, None)
        if advertised is not None and advertised.moving:
            self._write(topic, advertised, STOPPED)

    def _publish(self, topic: str, message: Any) -> None:
        advertised = self._advertised.get(topic)
        if advertised is None:
            return self._complain(f"{topic} is not advertised")
        try:
            self._write(topic, advertised, message)
        except BadMessage as why:
            return self._complain(f"{topic}: {why}")
        if advertised.kind in VELOCITIES and not self._ended:
            self.drives = True
            if is_moving(message):
                self._bridge.end_stops()
                advertised.moving, advertised.watch = True, VelocityWatch(boot_seconds())
            elif advertised.moving:
                _stand(advertised)
        return None

    def _write(self, topic: str, advertised: _Advertised, message: Any) -> None:
        kind, writer = self._writer(topic, advertised)
        if kind not in VELOCITIES:
            writer.write(from_json(kind, message, _time_of_day))
            return
        sample = from_json(kind, as_type(message, kind), _time_of_day)
        if is_moving(message):
            # As late as it can be: this process may have been suspended since it read the frame.
            self.drives = True
            self._bridge.check_awake()
            if self._ended:
                return
        writer.write(sample)

    def _writer(self, topic: str, advertised: _Advertised) -> tuple[str, Writer]:
        kind = self._kind_to_write(topic, advertised)
        quality = self._bridge.graph.writing_quality(dds_topic(topic), advertised.latched)
        before = advertised.writers.get(kind)
        if before is None or before[0] != quality:
            advertised.writers[kind] = (quality, self._bridge.writer(dds_topic(topic), kind, quality))
        return kind, advertised.writers[kind][1]

    def _kind_to_write(self, topic: str, advertised: _Advertised) -> str:
        """The type in which a topic is read, if it is a velocity's and is read in only one."""
        if advertised.kind not in VELOCITIES:
            return advertised.kind
        read = self._bridge.graph.reader_types(dds_topic(topic)) & set(VELOCITIES)
        return advertised.kind if advertised.kind in read or not read else min(read)

    def _subscribe(self, topic: str, kind: str) -> None:
        kind = kind or self._bridge.graph.topics().get(topic, "")
        if message_class(kind) is None:
            return self._complain(f"there is no definition of {kind or topic}")
        if topic not in self._subscriptions or self._subscriptions[topic].kind != kind:
            self._read(topic, kind)
        return None

    def _unsubscribe(self, topic: str) -> None:
        subscription = self._subscriptions.pop(topic, None)
        if subscription is not None and subscription.reader is not None:
            subscription.reader.close()

    def _read(self, topic: str, kind: str) -> None:
        self._unsubscribe(topic)
        quality = self._bridge.graph.reading_quality(dds_topic(topic))
        subscription = self._subscriptions[topic] = _Subscription(kind, quality, None)
        subscription.reader = self._bridge.reader(
            dds_topic(topic), kind, quality, lambda: self._take(topic, subscription)
        )

    def _take(self, topic: str, subscription: _Subscription) -> None:
        if self._subscriptions.get(topic) is not subscription or subscription.reader is None:
            return
        for message in subscription.reader.take():
            if isinstance(message, BadMessage):
                self._complain(f"{topic}: {message}")
            else:
                self._send({"op": "publish", "topic": topic, "msg": to_json(subscription.kind, message)})

    def _call(self, message: dict[str, Any]) -> None:
        service, args = _absolute(message.get("service")), message.get("args") or {}
        values = _ask_graph(self._bridge.graph, service, args if isinstance(args, dict) else {})
        self._calls.call(message, service, args, values)

    def _complain(self, why: str) -> None:
        self._send({"op": "status", "level": "error", "msg": why})

    def _send(self, message: dict[str, Any]) -> None:
        self._frames.put(message)


def _stand(advertised: _Advertised) -> None:
    """A stop has been sent, which is repeated."""
    advertised.moving, advertised.watch = False, VelocityWatch(boot_seconds() - TIMEOUT + REPEAT)


def _ask_graph(graph: Graph, service: str, args: dict[str, Any]) -> dict[str, Any] | None:
    """The answer of one of rosapi's services (rosapi_msgs/srv); ``None`` for another."""
    topics, services = graph.topics(), graph.services()
    match service:
        case "/rosapi/topics":
            return {"topics": list(topics), "types": [_long(kind, "msg") for kind in topics.values()]}
        case "/rosapi/topic_type":
            return {"type": _long(topics.get(_absolute(args.get("topic")), ""), "msg")}
        case "/rosapi/topics_for_type":
            return {"topics": [topic for topic, kind in topics.items() if kind == _short(args.get("type"))]}
        case "/rosapi/services":
            return {"services": list(services)}
        case "/rosapi/service_type":
            return {"type": _long(services.get(_absolute(args.get("service")), ""), "srv")}
        case _:
            return None


def _absolute(name: Any) -> str:
    """A name with its slash; empty for what is no name."""
    if not isinstance(name, str) or not name:
        return ""
    return name if name.startswith("/") else f"/{name}"


def _short(kind: Any) -> str:
    return kind.replace("/msg/", "/").replace("/srv/", "/") if isinstance(kind, str) else ""


def _long(kind: str, between: str) -> str:
    return kind.replace("/", f"/{between}/")


def _time_of_day() -> tuple[int, int]:
    return divmod(time.time_ns(), 10**9)
