"""
Zenoh session: discovery, writers and readers of one domain, as rmw_zenoh has them (its design document), by a router.

The session is opened in the background, and again when the router was away; until then the graph is empty. Messages
have the encoding that they have in DDS (CDR).
"""

from __future__ import annotations

import itertools
import json
import socket
import threading
import time
import uuid
from collections import deque
from collections.abc import Callable
from typing import Any

import zenoh
from zenoh.ext import HistoryConfig, Int64, declare_advanced_subscriber, z_serialize
from zenoh.handlers import Callback

from .dds_messages import BadMessage, decode, encode
from .dds_names import dds_message_type, dds_request_topic, ros_topic
from .graph import Graph, Quality
from .transport import MOST_TAKEN, Answer, Caller, Reader, Writer
from .zenoh_names import ZenohEndpoint, node_token, parse_token, token_for, topic_key

__all__ = ["ZenohTransport"]

_RETRY = 1.0
"""Seconds between two attempts to reach the router."""

_REVIEW = 1.0
"""Seconds until the announcement of a writer that is gone is taken back."""

_NODE = "rosy"
"""As which ``ros2 node list`` and ``ros2 topic info --verbose`` show this process."""

_DEPTH = 10
"""Of what a reader keeps until it is taken: that of DDS."""

_NEVER = 1e9
"""For the answer of a service, s: an action answers when it has ended (rmw_zenoh waits as long as it can)."""


class ZenohTransport:
    """``router`` is ``HOST:PORT``; it is also the host of all that is known over it."""

    def __init__(self, domain: int, router: str) -> None:
        self.domain = str(domain)
        self._router = router
        # Set once, when the router is reached. Zenoh itself reaches it again later.
        self._session: zenoh.Session | None = None
        self._closing = threading.Event()
        # Set when there may be something to announce, or the transport is closed.
        self._changed = threading.Event()
        # A writer may be collected, and say so, wherever the lock is held.
        self._lock = threading.RLock()
        # Of other sessions, by their tokens.
        self._others: dict[str, ZenohEndpoint] = {}
        # How many own writers there are of a DDS topic and type.
        self._writers: dict[tuple[str, str], int] = {}
        # Tokens of own readers and writers, by the key and kind of what they are for.
        self._announced: dict[tuple[str, bool], zenoh.LivelinessToken] = {}
        self._readers: list[_Reader] = []
        self._numbers = itertools.count(1)
        self._liveliness: Any = None
        self._node: zenoh.LivelinessToken | None = None
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def graph(self) -> Graph:
        """What has been discovered of other sessions."""
        with self._lock:
            others = list(self._others.values())
        return Graph(
            (other.endpoint(self._router) for other in others if not other.is_reader),
            (other.endpoint(self._router) for other in others if other.is_reader),
        )

    def writer(self, topic: str, kind: str, quality: Quality) -> Writer:  # noqa: ARG002 each reader hears each writer
        """Of a DDS topic."""
        return _Writer(self, topic, dds_message_type(kind))

    def caller(self, service: str, kind: str) -> Caller | None:
        """Of a service."""
        topic = dds_request_topic(service)
        with self._lock:
            is_there = any(other.is_reader and self._dds_names(other)[0] == topic for other in self._others.values())
        return _Caller(self, topic, kind) if is_there else None

    def reader(self, topic: str, kind: str, quality: Quality, on_data: Callable[[], None]) -> Reader:
        """``on_data`` is called in a thread of Zenoh whenever there is something to take."""
        reader = _Reader(self, topic, kind, quality, on_data)
        with self._lock:
            self._readers.append(reader)
            session = self._session
        self._changed.set()
        if session is not None:
            reader.declare(session)
        return reader

    def close(self) -> None:
        """Leave the domain. What was written is sent first."""
        self._closing.set()
        self._changed.set()
        self._thread.join()
        if self._session is not None:
            self._session.close()

    def session(self) -> zenoh.Session | None:
        """``None`` until the router has been reached."""
        return self._session

    def keys(self, topic: str, type_name: str) -> set[str]:
        """Under which a DDS topic of a type is read now: one for each hash of the type that its readers have."""
        with self._lock:
            return {
                other.key
                for other in self._others.values()
                if other.is_reader and self._dds_names(other) == (topic, type_name)
            }

    def count_writer(self, topic: str, type_name: str, change: int) -> None:
        """There is one more own writer of a DDS topic and type, or one less."""
        with self._lock:
            self._writers[topic, type_name] = self._writers.get((topic, type_name), 0) + change

    def add_writer(self, topic: str, type_name: str) -> None:
        """There is one more own writer of a DDS topic and type."""
        self.count_writer(topic, type_name, 1)
        self._changed.set()

    def forget(self, reader: _Reader) -> None:
        """A reader is closed."""
        with self._lock:
            if reader in self._readers:
                self._readers.remove(reader)
        self._changed.set()

    def _dds_names(self, other: ZenohEndpoint) -> tuple[str, str]:
        endpoint = other.endpoint(self._router)
        return endpoint.topic, endpoint.type

    def _run(self) -> None:
        self._connect()
        while not self._closing.is_set():
            self._announce()
            # A writer that was collected does not say so: it may be in the middle of anything.
            self._changed.wait(_REVIEW)
            self._changed.clear()

    def _connect(self) -> None:
        while not self._closing.is_set():
            if not _is_there(self._router):
                self._closing.wait(_RETRY)
                continue
            try:
                session = zenoh.open(_configuration(self._router))
            except zenoh.ZError:
                continue
            with self._lock:
                self._session = session
                readers = list(self._readers)
            for reader in readers:
                reader.declare(session)
            key = f"@ros2_lv/{self.domain}/**"
            self._liveliness = session.liveliness().declare_subscriber(key, self._take_token, history=True)
            self._node = session.liveliness().declare_token(node_token(self.domain, str(session.zid()), _NODE))
            return

    def _take_token(self, sample: zenoh.Sample) -> None:
        key = str(sample.key_expr)
        if sample.kind == zenoh.SampleKind.DELETE:
            with self._lock:
                self._others.pop(key, None)
            self._changed.set()
            return
        other = parse_token(key)
        session = self._session
        if other is not None and session is not None and other.session != str(session.zid()):
            with self._lock:
                self._others[key] = other
            self._changed.set()

    def _announce(self) -> None:
        session = self._session
        if session is None:
            return
        with self._lock:
            others = list(self._others.values())
            written = {endpoint for endpoint, count in self._writers.items() if count > 0}
            read = {(reader.topic, reader.type) for reader in self._readers}
        wanted = {
            (other.key, other.is_reader): other
            for other in others
            if self._dds_names(other) in (written if other.is_reader else read)
        }
        for known in self._announced.keys() - wanted.keys():
            self._announced.pop(known).undeclare()
        for new in wanted.keys() - self._announced.keys():
            mine = token_for(wanted[new], str(session.zid()), next(self._numbers), _NODE)
            self._announced[new] = session.liveliness().declare_token(mine)


class _Writer:
    """Writes under each key that the topic's readers have; the numbers in an attachment begin with 1."""

    def __init__(self, transport: ZenohTransport, topic: str, type_name: str) -> None:
        self._transport = transport
        self._topic = topic
        self._type = type_name
        self._sequence = itertools.count(1)
        # What tells writers apart, in place of rmw_zenoh's hash of a token: it need only be unique.
        self._identity = uuid.uuid4().bytes
        transport.add_writer(topic, type_name)

    def __del__(self) -> None:
        self._transport.count_writer(self._topic, self._type, -1)

    def write(self, message: Any) -> None:
        session, keys = self._transport.session(), self._transport.keys(self._topic, self._type)
        if session is None or not keys:
            return
        payload, attachment = encode(message), self._attachment()
        for key in keys:
            self._send(session, key, payload, attachment)

    def is_matched(self) -> bool:
        return bool(self._transport.keys(self._topic, self._type))

    def flush(self) -> None:
        """A message is handed to the router in its order at once; closing the session sends the rest."""

    def _attachment(self) -> zenoh.ZBytes:
        """rmw_zenoh, attachment_helpers.cpp, since 0.6 (April 2025): i64, i64 in ns, 16 bytes."""
        return z_serialize((Int64(next(self._sequence)), Int64(time.time_ns()), self._identity))

    def _send(self, session: zenoh.Session, key: str, payload: bytes, attachment: zenoh.ZBytes) -> None:
        # A message that finds the way blocked is dropped: an old velocity is worse than none.
        drop = zenoh.CongestionControl.DROP
        session.put(key, payload, attachment=attachment, congestion_control=drop, express=True)


class _Caller(_Writer):
    is_exact = True

    def __init__(self, transport: ZenohTransport, topic: str, kind: str) -> None:
        super().__init__(transport, topic, dds_message_type(f"{kind}_Request"))
        self._kind = kind

    def call(self, request: Any, on_answer: Answer) -> None:
        session, keys = self._transport.session(), self._transport.keys(self._topic, self._type)
        if session is None or not keys:
            on_answer(None)
            return
        answers = _Answers(f"{self._kind}_Response", on_answer)
        session.get(
            min(keys),
            Callback(answers.take, answers.end),
            payload=encode(request),
            attachment=self._attachment(),
            # Whose server rmw_zenoh declares complete (rmw_zenoh, rmw_client_data.cpp).
            target=zenoh.QueryTarget.ALL_COMPLETE,
            consolidation=zenoh.ConsolidationMode.NONE,
            timeout=_NEVER,
        )


class _Answers:
    """To one request: the first counts."""

    def __init__(self, kind: str, on_answer: Answer) -> None:
        self._kind = kind
        self._on_answer: Answer | None = on_answer

    def take(self, reply: zenoh.Reply) -> None:
        if reply.ok is None:
            return
        try:
            self._give(decode(self._kind, reply.ok.payload.to_bytes()))
        except BadMessage as why:
            self._give(why)

    def end(self) -> None:
        """There are no more."""
        self._give(None)

    def _give(self, answer: Any) -> None:
        on_answer, self._on_answer = self._on_answer, None
        if on_answer is not None:
            on_answer(answer)


class _Reader:
    def __init__(
        self, transport: ZenohTransport, topic: str, kind: str, quality: Quality, on_data: Callable[[], None]
    ) -> None:
        self.topic = topic
        self.type = dds_message_type(kind)
        self._transport = transport
        self._kind = kind
        self._latched = quality.latched
        self._on_data = on_data
        self._arrived: deque[bytes] = deque(maxlen=_DEPTH)
        self._lock = threading.Lock()
        self._subscriber: Any = None
        self._closed = False

    def declare(self, session: zenoh.Session) -> None:
        """Begin to listen; once. A latched topic's last messages are asked from its writers."""
        key = topic_key(self._transport.domain, ros_topic(self.topic) or "", self.type, "*")
        with self._lock:
            if self._closed or self._subscriber is not None:
                return
            if self._latched:
                history = HistoryConfig(detect_late_publishers=True)
                self._subscriber = declare_advanced_subscriber(session, key, self._take_sample, history=history)
            else:
                self._subscriber = session.declare_subscriber(key, self._take_sample)

    def take(self) -> list[Any]:
        messages: list[Any] = []
        while self._arrived and len(messages) < MOST_TAKEN:
            try:
                messages.append(decode(self._kind, self._arrived.popleft()))
            except BadMessage as why:
                messages.append(why)
        return messages

    def close(self) -> None:
        with self._lock:
            subscriber, self._closed = self._subscriber, True
        if subscriber is not None:
            subscriber.undeclare()
        self._transport.forget(self)

    def _take_sample(self, sample: zenoh.Sample) -> None:
        self._arrived.append(sample.payload.to_bytes())
        self._on_data()


def _is_there(router: str) -> bool:
    """Whether something listens. A process cannot end while Zenoh itself tries to reach a router."""
    host, _, port = router.rpartition(":")
    try:
        with socket.create_connection((host.strip("[]"), int(port)), _RETRY):
            return True
    except (OSError, ValueError):
        return False


def _configuration(router: str) -> zenoh.Config:
    """
    A client of the router, as rmw_zenoh's documentation has it for a session on another computer. The router sends on
    what a client writes; sessions of peers would have to reach each other.
    """
    configuration = zenoh.Config()
    for key, value in (
        ("mode", "client"),
        ("connect/endpoints", [f"tcp/{router}"]),
        ("connect/timeout_ms", 1000),
        ("scouting/multicast/enabled", False),
    ):
        configuration.insert_json5(key, json.dumps(value))
    return configuration
