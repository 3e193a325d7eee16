"""
The robot as a rosbridge v2 server, one client's side of it, without any I/O.

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

from ..world.events import Command
from .messages import typedefs
from .topics import COMMAND_TOPICS, SENSOR_TOPICS, BadMessage, read_command

__all__ = ["LATCHED", "MAX_SUBSCRIPTIONS", "BridgeClient", "Reply"]

MAX_SUBSCRIPTIONS = 200
"""Of one client; more are ignored."""

MAX_WAITING = 100
"""Longest throttling queue a client can ask for, messages."""

LATCHED = frozenset({"/mobile_base/events/robot_state"})
"""Topics whose last value a new subscriber gets. kobuki_node, src/library/kobuki_ros.cpp."""

_NODE = "/mobile_base"
_TYPES = {**SENSOR_TOPICS, **COMMAND_TOPICS}
_LEVELS = {"none": 0, "error": 1, "warning": 2, "info": 3}


@dataclass(slots=True)
class Reply:
    """What a message of the client leads to."""

    texts: list[str] = field(default_factory=list)
    commands: list[Command] = field(default_factory=list)


@dataclass(slots=True)
class _Wish:
    """One `subscribe`."""

    throttle: float
    queue: int


@dataclass(slots=True)
class _Subscription:
    """All wishes for one spelling of a topic. The smallest throttle and queue win, as in the real server."""

    wishes: dict[str | None, _Wish] = field(default_factory=dict)
    # When a message was last sent, s on the caller's clock; negative before the first.
    sent: float = -1e9
    waiting: deque[Any] = field(default_factory=deque)

    @property
    def throttle(self) -> float:
        return min(wish.throttle for wish in self.wishes.values())

    @property
    def queue(self) -> int:
        return min(wish.queue for wish in self.wishes.values())


class BridgeClient:
    """What the server knows of one client."""

    def __init__(self) -> None:
        self._subscriptions: dict[str, _Subscription] = {}
        # Last message per latched topic; set by deliver().
        self._latched: dict[str, Any] = {}
        self._level = 0

    @property
    def topics(self) -> set[str]:
        """Topics somebody listens to, in their plain form."""
        return {_plain(name) for name in self._subscriptions}

    def receive(self, text: str | bytes, now: float) -> Reply:
        """Serve a message; ``now`` is any clock in s that only goes forward."""
        reply = Reply()
        try:
            message = msgspec.json.decode(text)
        except (msgspec.DecodeError, UnicodeError, RecursionError) as error:
            self._complain(reply, None, f"not JSON: {error}")
            return reply
        if not isinstance(message, dict) or not isinstance(message.get("op"), str):
            self._complain(reply, None, "a message needs an op")
            return reply
        handler = _HANDLERS.get(message["op"])
        if handler is None:
            self._complain(reply, message, f"unknown op {message['op'][:50]!r}")
        else:
            handler(self, message, now, reply)
        return reply

    def deliver(self, topic: str, msg: Any, now: float) -> list[str]:
        """The frames that a message on a topic (in its plain form) is for this client."""
        if topic in LATCHED:
            self._latched[topic] = msg
        texts: list[str] = []
        for name, subscription in self._subscriptions.items():
            if _plain(name) == topic:
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

    def _complain(self, reply: Reply, message: dict[str, Any] | None, text: str) -> None:
        if self._level >= 1:
            status = {"op": "status", "level": "error", "msg": text}
            if message is not None and isinstance(message.get("id"), str):
                status["id"] = message["id"]
            reply.texts.append(_text(status))

    # One method per operation

    def _subscribe(self, message: dict[str, Any], now: float, reply: Reply) -> None:
        topic = message.get("topic")
        if not isinstance(topic, str) or _plain(topic) not in _TYPES:
            self._complain(reply, message, "no such topic")
            return
        subscription = self._subscriptions.setdefault(topic, _Subscription())
        if sum(len(s.wishes) for s in self._subscriptions.values()) >= MAX_SUBSCRIPTIONS:
            if not subscription.wishes:
                del self._subscriptions[topic]
            self._complain(reply, message, "too many subscriptions")
            return
        throttle = _number(message.get("throttle_rate")) / 1000
        queue = min(MAX_WAITING, int(_number(message.get("queue_length"))))
        ident = message.get("id")
        subscription.wishes[ident if isinstance(ident, str) else None] = _Wish(throttle, queue)
        if _plain(topic) in self._latched:
            reply.texts += self._send(topic, subscription, self._latched[_plain(topic)], now)

    def _unsubscribe(self, message: dict[str, Any], _now: float, _reply: Reply) -> None:
        topic, ident = message.get("topic"), message.get("id")
        if not isinstance(topic, str) or topic not in self._subscriptions:
            return
        if ident is None:
            del self._subscriptions[topic]
            return
        wishes = self._subscriptions[topic].wishes
        if isinstance(ident, str):
            wishes.pop(ident, None)
        if not wishes:
            del self._subscriptions[topic]

    def _advertise(self, message: dict[str, Any], _now: float, reply: Reply) -> None:
        topic, kind = message.get("topic"), message.get("type")
        if not isinstance(topic, str) or _plain(topic) not in COMMAND_TOPICS:
            self._complain(reply, message, "the robot does not listen to that topic")
        elif not isinstance(kind, str) or _kind(kind) != COMMAND_TOPICS[_plain(topic)]:
            self._complain(reply, message, f"the type of {topic} is {COMMAND_TOPICS[_plain(topic)]}")

    def _publish(self, message: dict[str, Any], _now: float, reply: Reply) -> None:
        topic = message.get("topic")
        if not isinstance(topic, str):
            self._complain(reply, message, "no topic")
            return
        try:
            # As the real server: a float where the type says integer spoils the message.
            reply.commands.append(read_command(_plain(topic), msgspec.json.encode(message.get("msg"))))
        except (BadMessage, msgspec.MsgspecError, TypeError) as error:
            self._complain(reply, message, str(error))

    def _set_level(self, message: dict[str, Any], _now: float, _reply: Reply) -> None:
        level = message.get("level")
        self._level = _LEVELS.get(level, 1) if isinstance(level, str) else 1

    def _ignore(self, _message: dict[str, Any], _now: float, _reply: Reply) -> None:
        return

    def _call(self, message: dict[str, Any], now: float, reply: Reply) -> None:
        service = message.get("service")
        if not isinstance(service, str):
            self._complain(reply, message, "no service")
            return
        args = message.get("args")
        values = _service(_plain(service), args if args is not None else {}, now)
        answer: dict[str, Any] = {"op": "service_response", "service": service}
        if "id" in message:
            answer["id"] = message["id"]
        if values is None:
            answer |= {"values": f"Service {service} does not exist", "result": False}
        else:
            answer |= {"values": values, "result": True}
        reply.texts.append(_text(answer))


_HANDLERS = {
    "subscribe": BridgeClient._subscribe,
    "unsubscribe": BridgeClient._unsubscribe,
    "advertise": BridgeClient._advertise,
    "unadvertise": BridgeClient._ignore,
    "publish": BridgeClient._publish,
    "set_level": BridgeClient._set_level,
    "auth": BridgeClient._ignore,
    "call_service": BridgeClient._call,
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
            return {"type": _TYPES.get(_plain(_argument(args, "topic")), "")}
        case "topics_for_type":
            wanted = _kind(_argument(args, "type"))
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
            return {"publishers": [_NODE] if _plain(_argument(args, "topic")) in SENSOR_TOPICS else []}
        case "subscribers":
            return {"subscribers": [_NODE] if _plain(_argument(args, "topic")) in COMMAND_TOPICS else []}
        case "get_time":
            return {"time": {"secs": int(now), "nsecs": int((now - int(now)) * 1e9)}}
        case "get_param":
            return {"value": "null"}
        case "get_param_names":
            return {"names": []}
        case "has_param":
            return {"exists": False}
        case "message_details":
            return {"typedefs": typedefs(_kind(_argument(args, "type")))}
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


def _plain(name: str) -> str:
    """Names with and without a leading slash are the same."""
    return name if name.startswith("/") else f"/{name}"


def _kind(name: str) -> str:
    """``kobuki_msgs/msg/Led`` and ``kobuki_msgs/Led`` are the same."""
    return name.replace("/msg/", "/")


def _publish(name: str, msg: Any) -> str:
    return _text({"op": "publish", "topic": name, "msg": msg})


_encoder = msgspec.json.Encoder()


def _text(message: dict[str, Any]) -> str:
    return _encoder.encode(message).decode()
