"""
Rosbridge v2 server for one client, without any I/O.

Follows the protocol as RobotWebTools' rosbridge_suite (ROBOT side: ros1 0.11.17) does it where clients can
tell: topics are echoed as the client wrote them, `status` is only sent to clients that asked with `set_level`,
latched values come at once, throttling is per topic. Plain JSON is always sent; a client that asked for
compression can read it. What a client sends wrong is ignored, like there, and told to those who listen.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass, field
from typing import Any

import msgspec

from ..sentence import tr
from ..world.events import Command
from .ros_messages import typedefs
from .topics import COMMAND_TOPICS, LATCHED, SENSOR_TOPICS, BadMessage, TopicMessage, read_message

__all__ = ["LATCHED", "MAX_SUBSCRIPTIONS", "Reply", "RosbridgeClient"]

MAX_SUBSCRIPTIONS = 200
"""Of one client; more are ignored."""

MAX_WAITING = 100
"""Longest throttling queue a client can ask for, messages."""

_NODE = "/mobile_base"
_TYPES = {**SENSOR_TOPICS, **COMMAND_TOPICS}
_LEVELS = {"none": 0, "error": 1, "warning": 2, "info": 3}


@dataclass(slots=True)
class Reply:
    """Frames for the client, commands for the robot and messages for others that a message leads to."""

    texts: list[str] = field(default_factory=list)
    commands: list[Command | TopicMessage] = field(default_factory=list)


@dataclass(slots=True)
class _Options:
    """One `subscribe`."""

    throttle: float
    queue: int


@dataclass(slots=True)
class _Subscription:
    """All requests for one spelling of a topic. The smallest throttle and queue win, as in the real server."""

    requests: dict[str | None, _Options] = field(default_factory=dict)
    # When a message was last sent, s on the caller's clock; negative before the first.
    sent: float = -1e9
    waiting: deque[Any] = field(default_factory=deque)

    @property
    def throttle(self) -> float:
        return min(request.throttle for request in self.requests.values())

    @property
    def queue(self) -> int:
        return min(request.queue for request in self.requests.values())


class RosbridgeClient:
    """Protocol state of one client."""

    def __init__(self) -> None:
        self._subscriptions: dict[str, _Subscription] = {}
        # Last message per latched topic; set by deliver().
        self._latched: dict[str, Any] = {}
        # Topics of its own that the client publishes.
        self._advertised: set[str] = set()
        self._level = 0

    @property
    def topics(self) -> set[str]:
        """Subscribed topics, with a leading slash."""
        return {_absolute_name(name) for name in self._subscriptions}

    def receive(self, text: str | bytes, now: float) -> Reply:
        """Serve a message; ``now`` is any clock in s that only goes forward."""
        reply = Reply()
        try:
            message = msgspec.json.decode(text)
        except (msgspec.DecodeError, UnicodeError, RecursionError) as error:
            self._report_error(reply, None, f"not JSON: {error}")
            return reply
        if not isinstance(message, dict) or not isinstance(message.get("op"), str):
            self._report_error(reply, None, "a message needs an op")
            return reply
        handler = _HANDLERS.get(message["op"])
        if handler is None:
            self._report_error(reply, message, f"unknown op {message['op'][:50]!r}")
        else:
            handler(self, message, now, reply)
        return reply

    def deliver(self, topic: str, msg: Any, now: float) -> list[str]:
        """The frames that a message on a topic (in its plain form) is for this client."""
        if topic in LATCHED:
            self._latched[topic] = msg
        texts: list[str] = []
        for name, subscription in self._subscriptions.items():
            if _absolute_name(name) == topic:
                texts += self._send(name, subscription, msg, now)
        return texts

    def drain(self, now: float) -> list[str]:
        """Frames that throttling held back and that are due by now."""
        texts: list[str] = []
        for name, subscription in self._subscriptions.items():
            if subscription.waiting and now - subscription.sent >= subscription.throttle:
                subscription.sent = now
                texts.append(_publish(name, subscription.waiting.popleft()))
        return texts

    def _send(self, name: str, subscription: _Subscription, msg: Any, now: float) -> list[str]:
        due = now - subscription.sent >= subscription.throttle
        if due and not subscription.waiting:
            subscription.sent = now
            return [_publish(name, msg)]
        if subscription.queue:
            subscription.waiting.append(msg)
            while len(subscription.waiting) > subscription.queue:
                subscription.waiting.popleft()
        return []

    def _report_error(self, reply: Reply, message: dict[str, Any] | None, text: str) -> None:
        if self._level >= 1:
            status = {"op": "status", "level": "error", "msg": text}
            if message is not None and isinstance(message.get("id"), str):
                status["id"] = message["id"]
            reply.texts.append(_text(status))

    # One method per operation

    def _subscribe(self, message: dict[str, Any], now: float, reply: Reply) -> None:
        topic = message.get("topic")
        # As the real server: a topic that nothing publishes yet needs a type.
        known = isinstance(topic, str) and (_absolute_name(topic) in _TYPES or isinstance(message.get("type"), str))
        if not isinstance(topic, str) or not known:
            self._report_error(reply, message, "no such topic")
            return
        subscription = self._subscriptions.setdefault(topic, _Subscription())
        if sum(len(s.requests) for s in self._subscriptions.values()) >= MAX_SUBSCRIPTIONS:
            if not subscription.requests:
                del self._subscriptions[topic]
            self._report_error(reply, message, "too many subscriptions")
            return
        throttle = _number(message.get("throttle_rate")) / 1000
        queue = min(MAX_WAITING, int(_number(message.get("queue_length"))))
        ident = message.get("id")
        subscription.requests[ident if isinstance(ident, str) else None] = _Options(throttle, queue)
        if _absolute_name(topic) in self._latched:
            reply.texts += self._send(topic, subscription, self._latched[_absolute_name(topic)], now)

    def _unsubscribe(self, message: dict[str, Any], _now: float, _reply: Reply) -> None:
        topic, ident = message.get("topic"), message.get("id")
        if not isinstance(topic, str) or topic not in self._subscriptions:
            return
        if ident is None:
            del self._subscriptions[topic]
            return
        requests = self._subscriptions[topic].requests
        if isinstance(ident, str):
            requests.pop(ident, None)
        if not requests:
            del self._subscriptions[topic]

    def _advertise(self, message: dict[str, Any], _now: float, reply: Reply) -> None:
        topic, kind = message.get("topic"), message.get("type")
        if not isinstance(topic, str):
            self._report_error(reply, message, "no topic")
        elif _absolute_name(topic) in SENSOR_TOPICS:
            self._report_error(reply, message, "the robot itself publishes that topic")
        elif _absolute_name(topic) not in COMMAND_TOPICS:
            if isinstance(kind, str) and len(self._advertised) < MAX_SUBSCRIPTIONS:
                self._advertised.add(_absolute_name(topic))
            else:
                self._report_error(reply, message, "a topic needs a type")
        elif not isinstance(kind, str) or _short_type(kind) != COMMAND_TOPICS[_absolute_name(topic)]:
            self._report_error(reply, message, f"the type of {topic} is {COMMAND_TOPICS[_absolute_name(topic)]}")

    def _publish(self, message: dict[str, Any], _now: float, reply: Reply) -> None:
        topic = message.get("topic")
        if not isinstance(topic, str):
            self._report_error(reply, message, "no topic")
            return
        try:
            # As the real server: a float where the type says integer spoils the message.
            read = read_message(_absolute_name(topic), message.get("msg"))
            if isinstance(read, TopicMessage) and read.topic not in self._advertised:
                raise BadMessage(tr("{topic} is not advertised", topic=topic))
            reply.commands.append(read)
        except (BadMessage, msgspec.MsgspecError, TypeError) as error:
            self._report_error(reply, message, str(error))

    def _set_level(self, message: dict[str, Any], _now: float, _reply: Reply) -> None:
        level = message.get("level")
        self._level = _LEVELS.get(level, 1) if isinstance(level, str) else 1

    def _ignore(self, _message: dict[str, Any], _now: float, _reply: Reply) -> None:
        return

    def _call(self, message: dict[str, Any], now: float, reply: Reply) -> None:
        service = message.get("service")
        if not isinstance(service, str):
            self._report_error(reply, message, "no service")
            return
        args = message.get("args")
        values = _service(_absolute_name(service), args if args is not None else {}, now)
        answer: dict[str, Any] = {"op": "service_response", "service": service}
        if "id" in message:
            answer["id"] = message["id"]
        if values is None:
            answer |= {"values": f"Service {service} does not exist", "result": False}
        else:
            answer |= {"values": values, "result": True}
        reply.texts.append(_text(answer))


_HANDLERS = {
    "subscribe": RosbridgeClient._subscribe,
    "unsubscribe": RosbridgeClient._unsubscribe,
    "advertise": RosbridgeClient._advertise,
    "unadvertise": RosbridgeClient._ignore,
    "publish": RosbridgeClient._publish,
    "set_level": RosbridgeClient._set_level,
    "auth": RosbridgeClient._ignore,
    "call_service": RosbridgeClient._call,
}

_SERVICES = (
    "topics", "topic_type", "topics_for_type", "nodes", "node_details", "services", "service_type", "publishers",
    "subscribers", "get_time", "get_param", "get_param_names", "has_param", "message_details",
)  # fmt: skip


def _service(name: str, args: Any, now: float) -> dict[str, Any] | None:
    """rosapi, as far as a robot without parameters has it. rosapi/srv/*.srv names the fields."""
    if not name.startswith("/rosapi/"):
        return None
    match name.removeprefix("/rosapi/"):
        case "topics":
            return {"topics": list(_TYPES), "types": list(_TYPES.values())}
        case "topic_type":
            return {"type": _TYPES.get(_absolute_name(_argument(args, "topic")), "")}
        case "topics_for_type":
            wanted = _short_type(_argument(args, "type"))
            return {"topics": [topic for topic, kind in _TYPES.items() if kind == wanted]}
        case "nodes":
            return {"nodes": [_NODE]}
        case "node_details":
            return {
                "subscribing": list(COMMAND_TOPICS),
                "publishing": list(SENSOR_TOPICS),
                "services": [f"/rosapi/{service}" for service in _SERVICES],
            }
        case "services":
            return {"services": [f"/rosapi/{service}" for service in _SERVICES]}
        case "service_type":
            return {"type": ""}
        case "publishers":
            return {"publishers": [_NODE] if _absolute_name(_argument(args, "topic")) in SENSOR_TOPICS else []}
        case "subscribers":
            return {"subscribers": [_NODE] if _absolute_name(_argument(args, "topic")) in COMMAND_TOPICS else []}
        case "get_time":
            return {"time": {"secs": int(now), "nsecs": int((now - int(now)) * 1e9)}}
        case "get_param":
            return {"value": "null"}
        case "get_param_names":
            return {"names": []}
        case "has_param":
            return {"exists": False}
        case "message_details":
            return {"typedefs": typedefs(_short_type(_argument(args, "type")))}
        case _:
            return None


def _argument(args: Any, name: str) -> str:
    """Arguments come by name or, in a list, by place."""
    value = args.get(name) if isinstance(args, dict) else args[0] if isinstance(args, list) and args else None
    return value if isinstance(value, str) else ""


def _number(value: Any) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float):
        return 0.0
    return max(0.0, min(1e9, float(value)))


def _absolute_name(name: str) -> str:
    """Names with and without a leading slash are the same."""
    return name if name.startswith("/") else f"/{name}"


def _short_type(name: str) -> str:
    """``std_msgs/msg/String`` and ``std_msgs/String`` are the same."""
    return name.replace("/msg/", "/")


def _publish(name: str, msg: Any) -> str:
    return _text({"op": "publish", "topic": name, "msg": msg})


_encoder = msgspec.json.Encoder()


def _text(message: dict[str, Any]) -> str:
    return _encoder.encode(message).decode()
