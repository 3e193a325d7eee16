"""
Rosbridge v2 server for one client, without any I/O.

Follows the protocol as RobotWebTools' rosbridge_suite (ROBOT side: ros1 0.11.17) does it where clients can
tell: topics are echoed as the client wrote them, `status` is only sent to clients that asked with `set_level`,
latched values come at once, throttling is per topic, a subscription with another type than the topic's and a message
with an unknown field are refused. What a client sends wrong is ignored, like there, and told to those who listen.
`png` goes to clients only (its section 2): from clients it is refused as unknown. Actions are called as at a server of
ROS 2 (3.2.12 to 3.2.15), and by the topics of ``actionlib.py``; clients offer none.
Types without a definition in ``rosy-hs/ros/msg`` are taken as the client says.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass, field
from typing import Any

import msgspec

from ...sentences.sentence import tr
from ...world.action_goals import ActionReply
from ...world.events import Command, GiveGoal, TakeBackGoal
from ..action_frames import reply_frame
from ..topics import COMMAND_TOPICS, LATCHED, RESET_ODOMETRY, SENSOR_TOPICS, BadMessage, TopicMessage, read_message
from .ros_messages import message_fault
from .rosapi import RosGraph, absolute_name, call_rosapi, short_type
from .rosbridge_encodings import ENCODINGS, encode_publish, fragments, json_text
from .rosbridge_fragments import FragmentBuffer
from .rosbridge_services import Call, ClientServices

__all__ = ["LATCHED", "MAX_SUBSCRIPTIONS", "Frame", "Reply", "RosbridgeClient", "RosbridgeGraph", "crowded"]

MAX_SUBSCRIPTIONS = 200
"""Of one client; more are ignored. The same for its calls without an answer yet, and for a session's own topics."""

MAX_WAITING = 100
"""Longest throttling queue a client can ask for, messages."""

_MIN_FRAGMENT = 100
"""Smallest fragment a client can ask for, characters."""

_LEVELS = {"none": 0, "error": 1, "warning": 2, "info": 3}

Frame = str | bytes
"""A text frame or a binary one."""


@dataclass(slots=True)
class Reply:
    """What a message leads to: frames for the client and for others, commands for the robot, messages for others."""

    texts: list[Frame] = field(default_factory=list)
    commands: list[Command | TopicMessage] = field(default_factory=list)
    # Goals for the robot's own programs.
    goals: list[GiveGoal | TakeBackGoal] = field(default_factory=list)
    forwards: list[tuple[RosbridgeClient, Frame]] = field(default_factory=list)
    # The messages on command topics, whole, for their subscribers.
    commanded: list[TopicMessage] = field(default_factory=list)


@dataclass(slots=True)
class _Options:
    """One `subscribe`."""

    throttle: float
    queue: int
    encoding: str
    fragment: int | None


@dataclass(slots=True)
class _Subscription:
    """All requests for one spelling of a topic. The smallest throttle, queue and fragments win, as there."""

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

    @property
    def encoding(self) -> str:
        return max((request.encoding for request in self.requests.values()), key=ENCODINGS.index)

    @property
    def fragment(self) -> int | None:
        return min((r.fragment for r in self.requests.values() if r.fragment is not None), default=None)


class RosbridgeGraph:
    """What all clients of a session share."""

    def __init__(self) -> None:
        self.graph = RosGraph()
        self.services: ClientServices[RosbridgeClient] = ClientServices(self.graph.offered, MAX_SUBSCRIPTIONS)
        # The last message of each latched topic of clients.
        self.latched: dict[str, Any] = {}
        # The clients that publish or have subscribed to each topic of clients.
        self._users: dict[str, set[int]] = {}
        self._clients = 0

    def next_name(self) -> str:
        """A name that no client has had."""
        self._clients += 1
        return f"client {self._clients}"

    def use(self, topic: str, client: RosbridgeClient) -> None:
        """A client publishes a topic that is none of the robot's, or has subscribed to it."""
        if topic in self.graph.own_topics:
            self._users.setdefault(topic, set()).add(id(client))

    def release(self, topic: str, client: RosbridgeClient) -> None:
        """A client no longer uses a topic; the topic ends with its last client, and may have another type later."""
        users = self._users.get(topic, set())
        users.discard(id(client))
        if not users:
            self._users.pop(topic, None)
            self.graph.own_topics.pop(topic, None)
            self.latched.pop(topic, None)


class RosbridgeClient:
    """Protocol state of one client."""

    def __init__(self, shared: RosbridgeGraph | None = None) -> None:
        self._shared = shared if shared is not None else RosbridgeGraph()
        self._subscriptions: dict[str, _Subscription] = {}
        # Last message per latched topic; set by deliver().
        self._latched: dict[str, Any] = {}
        # Topics of its own that the client publishes, and those of them whose last message later subscribers get.
        self._advertised: set[str] = set()
        self._latching: set[str] = set()
        # The name of this client as one that gives goals, and those of its goals that want feedback: their actions as
        # it wrote them.
        self.name = self._shared.next_name()
        self._goals: dict[str, tuple[str, bool]] = {}
        self._fragments = FragmentBuffer()
        self._fragments_sent = 0
        self._level = 0

    @property
    def topics(self) -> set[str]:
        """Subscribed topics, with a leading slash."""
        return {absolute_name(name) for name in self._subscriptions}

    def receive(self, text: str | bytes, now: float) -> Reply:
        """Serve a message; ``now`` is any clock in s that only goes forward."""
        reply = Reply()
        self._serve(text, now, reply)
        return reply

    def _serve(self, text: str | bytes, now: float, reply: Reply, assembled: bool = False) -> None:
        try:
            message = msgspec.json.decode(text)
        except (msgspec.DecodeError, UnicodeError, RecursionError) as error:
            self._report(reply, None, f"not JSON: {error}")
            return
        if not isinstance(message, dict) or not isinstance(message.get("op"), str):
            self._report(reply, None, "a message needs an op")
            return
        handler = _HANDLERS.get(message["op"])
        if assembled and message["op"] == "fragment":
            # They would nest without end.
            self._report(reply, message, "fragments do not make a fragment")
        elif handler is None:
            self._report(reply, message, f"unknown op {message['op'][:50]!r}")
        else:
            handler(self, message, now, reply)

    def deliver(self, topic: str, msg: Any, now: float) -> list[Frame]:
        """The frames that a message on a topic (in its plain form) is for this client."""
        if topic in LATCHED:
            self._latched[topic] = msg
        frames: list[Frame] = []
        for name, subscription in self._subscriptions.items():
            if absolute_name(name) == topic:
                frames += self._send(name, subscription, msg, now)
        return frames

    def drain(self, now: float) -> list[Frame]:
        """Frames that throttling held back and that are due by now."""
        frames: list[Frame] = []
        for name, subscription in self._subscriptions.items():
            if subscription.waiting and now - subscription.sent >= subscription.throttle:
                subscription.sent = now
                frames += self._encode(name, subscription, subscription.waiting.popleft())
        return frames

    def leave(self) -> Reply:
        """The client has disconnected: its services end, and calls of them fail."""
        services = self._shared.services
        services.leave(self)
        for topic in self.topics | self._advertised:
            self._shared.release(topic, self)
        return Reply(
            forwards=self._failed(services.cancelled(), "The client that offered the service has disconnected")
        )

    def _send(self, name: str, subscription: _Subscription, msg: Any, now: float) -> list[Frame]:
        due = now - subscription.sent >= subscription.throttle
        if due and not subscription.waiting:
            subscription.sent = now
            return self._encode(name, subscription, msg)
        if subscription.queue:
            subscription.waiting.append(msg)
            while len(subscription.waiting) > subscription.queue:
                subscription.waiting.popleft()
        return []

    def _encode(self, name: str, subscription: _Subscription, msg: Any) -> list[Frame]:
        graph = self._shared.graph
        kind = graph.type_of(absolute_name(name))
        frame = encode_publish(name, kind, msg, subscription.encoding, graph.time)
        return [frame] if isinstance(frame, bytes) else self._fragmented(frame, subscription.fragment)

    def _fragmented(self, text: str, size: int | None, ident: Any = None) -> list[Frame]:
        if size is None:
            return [text]
        if not isinstance(ident, str):
            self._fragments_sent += 1
            ident = str(self._fragments_sent)
        return [*fragments(text, size, ident)]

    def _report(self, reply: Reply, message: dict[str, Any] | None, text: str, level: str = "error") -> None:
        if self._level >= _LEVELS[level]:
            status = {"op": "status", "level": level, "msg": text}
            if message is not None and isinstance(message.get("id"), str):
                status["id"] = message["id"]
            reply.texts.append(json_text(status))

    def deliver_reply(self, answer: ActionReply) -> list[Frame]:
        """The frames that say how a goal of this client gets on."""
        action, wants_feedback = self._goals.get(answer.ident, (answer.action, False))
        if answer.kind == "result":
            self._goals.pop(answer.ident, None)
        elif not wants_feedback:
            return []
        return [json_text(reply_frame(answer, action))]

    # One method per operation

    def _send_goal(self, message: dict[str, Any], _now: float, reply: Reply) -> None:
        action, ident, goal = message.get("action"), message.get("id"), message.get("args", {})
        if not isinstance(action, str) or not isinstance(message.get("action_type"), str) or not isinstance(ident, str):
            self._report(reply, message, "a goal needs an id, an action and an action_type")
        elif not isinstance(goal, dict):
            self._report(reply, message, "the args of a goal are an object")
        elif ident in self._goals or len(self._goals) >= MAX_SUBSCRIPTIONS:
            self._report(reply, message, "a goal with this id is pursued, or there are too many goals")
        else:
            self._goals[ident] = (action, message.get("feedback") is True)
            reply.goals.append(GiveGoal(self.name, ident, absolute_name(action), goal))

    def _cancel_goal(self, message: dict[str, Any], _now: float, reply: Reply) -> None:
        ident = message.get("id")
        if isinstance(ident, str) and ident in self._goals:
            reply.goals.append(TakeBackGoal(self.name, ident))
        else:
            self._report(reply, message, "no goal has this id")

    def _subscribe(self, message: dict[str, Any], now: float, reply: Reply) -> None:
        topic = message.get("topic")
        if not isinstance(topic, str):
            self._report(reply, message, "no topic")
            return
        why = self._type_fault(absolute_name(topic), message.get("type"))
        encoding = message.get("compression", "none")
        if encoding not in ENCODINGS:
            why = f"the compression {str(encoding)[:50]} is none of {', '.join(ENCODINGS)}"
        if why is not None:
            self._report(reply, message, why)
            return
        subscription = self._subscriptions.setdefault(topic, _Subscription())
        if sum(len(s.requests) for s in self._subscriptions.values()) >= MAX_SUBSCRIPTIONS:
            if not subscription.requests:
                self._end_subscription(topic)
            self._report(reply, message, "too many subscriptions")
            return
        throttle = _number(message.get("throttle_rate")) / 1000
        queue = min(MAX_WAITING, int(_number(message.get("queue_length"))))
        ident = message.get("id")
        options = _Options(throttle, queue, encoding, _fragment_size(message))
        subscription.requests[ident if isinstance(ident, str) else None] = options
        name = absolute_name(topic)
        self._shared.use(name, self)
        for latched in (self._latched, self._shared.latched):
            if name in latched:
                reply.texts += self._send(topic, subscription, latched[name], now)

    def _type_fault(self, topic: str, kind: Any) -> str | None:
        """Why a topic cannot have this type, or none; a topic that is new gets it."""
        types = self._shared.graph
        known = types.type_of(topic)
        if kind is None:
            return None if known is not None else f"{topic} is not published and needs a type"
        if not isinstance(kind, str) or short_type(kind).count("/") != 1:
            return f"{str(kind)[:50]!r} is no type"
        if known is None:
            if len(types.own_topics) >= MAX_SUBSCRIPTIONS:
                return "too many topics"
            types.own_topics[topic] = short_type(kind)
        elif short_type(kind) != known:
            return f"Tried to register topic {topic} with type {kind} but it is already established with type {known}"
        return None

    def _unsubscribe(self, message: dict[str, Any], _now: float, _reply: Reply) -> None:
        topic, ident = message.get("topic"), message.get("id")
        if not isinstance(topic, str) or topic not in self._subscriptions:
            return
        if ident is None:
            self._end_subscription(topic)
            return
        requests = self._subscriptions[topic].requests
        if isinstance(ident, str):
            requests.pop(ident, None)
        if not requests:
            self._end_subscription(topic)

    def _end_subscription(self, topic: str) -> None:
        del self._subscriptions[topic]
        self._release(absolute_name(topic))

    def _release(self, name: str) -> None:
        if name not in self._advertised and name not in self.topics:
            self._shared.release(name, self)

    def _advertise(self, message: dict[str, Any], _now: float, reply: Reply) -> None:
        topic = message.get("topic")
        if not isinstance(topic, str):
            self._report(reply, message, "no topic")
            return
        name = absolute_name(topic)
        why = "the robot itself publishes that topic" if name in SENSOR_TOPICS else None
        if why is None and message.get("type") is None:
            why = "a topic needs a type"
        why = why or self._type_fault(name, message.get("type"))
        if why is not None:
            self._report(reply, message, why)
        elif name not in COMMAND_TOPICS:
            self._advertised.add(name)
            self._shared.use(name, self)
            if message.get("latch") is True:
                self._latching.add(name)

    def _unadvertise(self, message: dict[str, Any], _now: float, reply: Reply) -> None:
        topic = message.get("topic")
        name = absolute_name(topic) if isinstance(topic, str) else ""
        if name not in self._advertised and name not in COMMAND_TOPICS:
            self._report(reply, message, f"{name} is not advertised", "warning")
        self._advertised.discard(name)
        self._latching.discard(name)
        self._release(name)

    def _publish(self, message: dict[str, Any], _now: float, reply: Reply) -> None:
        topic = message.get("topic")
        if not isinstance(topic, str):
            self._report(reply, message, "no topic")
            return
        name, msg = absolute_name(topic), message.get("msg")
        try:
            kind = self._shared.graph.type_of(name)
            why = None if kind is None else message_fault(kind, msg)
            if why is not None:
                self._report(reply, message, why)
                return
            read = read_message(name, msg)
            if isinstance(read, TopicMessage) and read.topic not in (*self._advertised, RESET_ODOMETRY):
                raise BadMessage(tr("{topic} is not advertised", topic=topic))
            reply.commands.append(read)
            if isinstance(read, TopicMessage) and (message.get("latch") is True or name in self._latching):
                self._shared.latched[name] = msg
            if isinstance(read, Command):
                reply.commanded.append(TopicMessage(name, msg))
        except (BadMessage, msgspec.MsgspecError, TypeError) as error:
            self._report(reply, message, str(error))

    def _set_level(self, message: dict[str, Any], _now: float, reply: Reply) -> None:
        level = message.get("level")
        if isinstance(level, str) and level in _LEVELS:
            self._level = _LEVELS[level]
        else:
            self._report(reply, message, f"the level is one of {', '.join(_LEVELS)}")

    def _ignore(self, _message: dict[str, Any], _now: float, _reply: Reply) -> None:
        return

    def _fragment(self, message: dict[str, Any], now: float, reply: Reply) -> None:
        whole, why = self._fragments.add(message)
        if why is not None:
            self._report(reply, message, why)
        elif whole is not None:
            self._serve(whole, now, reply, assembled=True)

    def _call(self, message: dict[str, Any], _now: float, reply: Reply) -> None:
        service = message.get("service")
        if not isinstance(service, str):
            self._report(reply, message, "no service")
            return
        args = message.get("args")
        name, services = absolute_name(service), self._shared.services
        call = Call(self, service, message.get("id"), _fragment_size(message))
        provider = services.provider(name)
        if provider is not None:
            ident = services.called(name, call)
            if ident is None:
                reply.texts += _answer(call, "too many calls are not answered yet", False)
                return
            request = {"op": "call_service", "id": ident, "service": name, "args": args or {}}
            reply.forwards.append((provider, json_text(request)))
            return
        values = call_rosapi(self._shared.graph, name, args if args is not None else {})
        if values is None:
            reply.texts += _answer(call, f"Service {service} does not exist", False)
        else:
            reply.texts += _answer(call, values, True)

    def _advertise_service(self, message: dict[str, Any], _now: float, reply: Reply) -> None:
        service, kind = message.get("service"), message.get("type")
        if not isinstance(service, str) or not isinstance(kind, str):
            self._report(reply, message, "a service needs a name and a type")
            return
        name, services = absolute_name(service), self._shared.services
        if services.provider(name) is not None:
            self._report(reply, message, f"Duplicate service advertised. Overwriting {name}.", "warning")
        if services.offer(name, short_type(kind), self):
            reply.forwards += self._failed(services.cancelled(), f"Service {name} has ended")
        else:
            self._report(reply, message, f"{name} cannot be offered")

    def _unadvertise_service(self, message: dict[str, Any], _now: float, reply: Reply) -> None:
        service = message.get("service")
        name = absolute_name(service) if isinstance(service, str) else ""
        services = self._shared.services
        if services.provider(name) is self:
            services.withdraw(name)
            reply.forwards += self._failed(services.cancelled(), f"Service {name} has ended")
        else:
            self._report(reply, message, f"Service {name} has not been advertised via rosbridge")

    def _service_response(self, message: dict[str, Any], _now: float, reply: Reply) -> None:
        ident = message.get("id")
        call = self._shared.services.answered(ident, self) if isinstance(ident, str) else None
        if call is None:
            self._report(reply, message, "no call has this id")
            return
        values = message.get("values")
        frames = _answer(call, values if values is not None else {}, message.get("result") is not False)
        reply.forwards += [(call.caller, frame) for frame in frames]

    @staticmethod
    def _failed(calls: list[Call[RosbridgeClient]], why: str) -> list[tuple[RosbridgeClient, Frame]]:
        return [(call.caller, frame) for call in calls for frame in _answer(call, why, False)]


_HANDLERS = {
    "subscribe": RosbridgeClient._subscribe,
    "unsubscribe": RosbridgeClient._unsubscribe,
    "advertise": RosbridgeClient._advertise,
    "unadvertise": RosbridgeClient._unadvertise,
    "publish": RosbridgeClient._publish,
    "set_level": RosbridgeClient._set_level,
    "auth": RosbridgeClient._ignore,
    "fragment": RosbridgeClient._fragment,
    "call_service": RosbridgeClient._call,
    "send_action_goal": RosbridgeClient._send_goal,
    "cancel_action_goal": RosbridgeClient._cancel_goal,
    "advertise_service": RosbridgeClient._advertise_service,
    "unadvertise_service": RosbridgeClient._unadvertise_service,
    "service_response": RosbridgeClient._service_response,
}


def _answer(call: Call[RosbridgeClient], values: Any, result: bool) -> list[Frame]:
    """The frames of a service's answer."""
    answer: dict[str, Any] = {"op": "service_response", "service": call.service}
    if call.ident is not None:
        answer["id"] = call.ident
    text = json_text(answer | {"values": values, "result": result})
    return call.caller._fragmented(text, call.fragment, call.ident)


def crowded(most: int) -> str:
    """Why a client is not served: the robot has as many as it may."""
    return f"this robot has {most} clients, which is the most"


def _fragment_size(message: dict[str, Any]) -> int | None:
    """Longest frame that the client wants, characters."""
    size = message.get("fragment_size")
    return max(_MIN_FRAGMENT, size) if isinstance(size, int) and not isinstance(size, bool) else None


def _number(value: Any) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float):
        return 0.0
    # Compared first: a whole number may be larger than any float.
    return float(max(0.0, min(1e9, value)))
