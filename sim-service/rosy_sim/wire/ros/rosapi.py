"""
The services of rosapi: what a ROS client may ask about topics, types, services and parameters.

In: the name of a service, its arguments, and the graph that all clients of one session share. Out: the fields of its
answer (rosapi/srv/*.srv, ros1 0.11.17). Pure but for the parameters, which ``set_param`` and ``delete_param`` change.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import msgspec

from ..topics import COMMAND_TOPICS, SENSOR_TOPICS
from .ros_messages import definition_text, typedefs

__all__ = ["MAX_PARAMETERS", "RosGraph", "absolute_name", "call_rosapi", "short_type"]

MAX_PARAMETERS = 200
"""Of one session; more are not stored."""

_MAX_VALUE = 10_000
"""Longest value of a parameter, characters of JSON."""

_NODE = "/mobile_base"
_ROSBRIDGE = "/rosbridge_websocket"
"""The node that speaks for all clients."""

_PREFIX = "/rosapi/"
_ROBOT_TOPICS = {**SENSOR_TOPICS, **COMMAND_TOPICS}


@dataclass(slots=True)
class RosGraph:
    """What all clients of a session share."""

    # Types of the topics that are none of the robot's, by the first client that named one.
    own_topics: dict[str, str] = field(default_factory=dict)
    # Types of the services that clients offer.
    offered: dict[str, str] = field(default_factory=dict)
    # JSON by absolute name.
    parameters: dict[str, str] = field(default_factory=dict)
    # Simulated, s: the clock of all stamps.
    time: float = 0.0

    def type_of(self, topic: str) -> str | None:
        """The type of a topic, if it is known."""
        return _ROBOT_TOPICS.get(topic) or self.own_topics.get(topic)

    @property
    def topics(self) -> dict[str, str]:
        """All topics with their types."""
        return {**_ROBOT_TOPICS, **self.own_topics}


def absolute_name(name: str) -> str:
    """Names with and without a leading slash are the same."""
    return name if name.startswith("/") else f"/{name}"


def short_type(name: str) -> str:
    """``std_msgs/msg/String`` and ``std_msgs/String`` are the same."""
    return name.replace("/msg/", "/").replace("/srv/", "/")


class _Arguments:
    """Of one call: by name, or in a list by place."""

    def __init__(self, args: Any) -> None:
        self._args = args

    def text(self, name: str, place: int = 0) -> str:
        value = None
        if isinstance(self._args, dict):
            value = self._args.get(name)
        elif isinstance(self._args, list) and place < len(self._args):
            value = self._args[place]
        return value if isinstance(value, str) else ""

    def name(self, name: str) -> str:
        return absolute_name(self.text(name))


def call_rosapi(graph: RosGraph, service: str, args: Any) -> dict[str, Any] | None:
    """The answer of a service; ``None`` when rosapi has none of this name."""
    answer = _SERVICES.get(service.removeprefix(_PREFIX)) if service.startswith(_PREFIX) else None
    return None if answer is None else answer(graph, _Arguments(args))


def _topics(graph: RosGraph, _args: _Arguments) -> dict[str, Any]:
    return {"topics": list(graph.topics), "types": list(graph.topics.values())}


def _topics_and_raw_types(graph: RosGraph, args: _Arguments) -> dict[str, Any]:
    texts = [definition_text(kind) for kind in graph.topics.values()]
    return {**_topics(graph, args), "typedefs_full_text": texts}


def _topics_for_type(graph: RosGraph, args: _Arguments) -> dict[str, Any]:
    wanted = short_type(args.text("type"))
    return {"topics": [topic for topic, kind in graph.topics.items() if kind == wanted]}


def _services(graph: RosGraph) -> dict[str, str]:
    """All services with their types."""
    own = {_PREFIX + name: f"rosapi/{_TYPES.get(name, _camel_case(name))}" for name in _SERVICES}
    return {**own, **graph.offered}


def _node_details(graph: RosGraph, args: _Arguments) -> dict[str, Any]:
    if args.name("node") == _ROSBRIDGE:
        own = list(graph.own_topics)
        return {"subscribing": own, "publishing": own, "services": list(_services(graph))}
    is_robot = args.name("node") in (_NODE, "/")
    return {
        "subscribing": list(COMMAND_TOPICS) if is_robot else [],
        "publishing": list(SENSOR_TOPICS) if is_robot else [],
        "services": list(_services(graph)) if args.name("node") == "/" else [],
    }


def _provider(graph: RosGraph, args: _Arguments) -> str:
    return _ROSBRIDGE if args.name("service") in _services(graph) else ""


def _providers(graph: RosGraph, args: _Arguments) -> dict[str, Any]:
    wanted = short_type(args.text("service"))
    return {"providers": [_ROSBRIDGE] if wanted in _services(graph).values() else []}


def _nodes_of(topics: dict[str, str], graph: RosGraph, topic: str) -> list[str]:
    return [_NODE] if topic in topics else [_ROSBRIDGE] if topic in graph.own_topics else []


def _time(graph: RosGraph, _args: _Arguments) -> dict[str, Any]:
    secs = int(graph.time)
    return {"time": {"secs": secs, "nsecs": round((graph.time - secs) * 1e9)}}


def _set_param(graph: RosGraph, args: _Arguments) -> dict[str, Any]:
    name, value = args.name("name"), args.text("value", 1)
    if len(value) <= _MAX_VALUE and (name in graph.parameters or len(graph.parameters) < MAX_PARAMETERS):
        # As the real one: what is no JSON is a text (rosapi/params.py).
        try:
            msgspec.json.decode(value)
        except (msgspec.DecodeError, RecursionError):
            value = msgspec.json.encode(value).decode()
        graph.parameters[name] = value
    return {}


def _delete_param(graph: RosGraph, args: _Arguments) -> dict[str, Any]:
    graph.parameters.pop(args.name("name"), None)
    return {}


def _search_param(graph: RosGraph, args: _Arguments) -> dict[str, Any]:
    name = args.name("name")
    return {"global_name": name if name in graph.parameters else ""}


_SERVICES: dict[str, Callable[[RosGraph, _Arguments], dict[str, Any]]] = {
    "topics": _topics,
    "topics_and_raw_types": _topics_and_raw_types,
    "topics_for_type": _topics_for_type,
    "topic_type": lambda graph, args: {"type": graph.topics.get(args.name("topic"), "")},
    "services": lambda graph, _args: {"services": list(_services(graph))},
    "services_for_type": lambda graph, args: {
        "services": [name for name, kind in _services(graph).items() if kind == short_type(args.text("type"))]
    },
    "service_type": lambda graph, args: {"type": _services(graph).get(args.name("service"), "")},
    "service_node": lambda graph, args: {"node": _provider(graph, args)},
    "service_host": lambda graph, args: {"host": "localhost" if _provider(graph, args) else ""},
    "service_providers": _providers,
    "nodes": lambda _graph, _args: {"nodes": [_NODE, _ROSBRIDGE]},
    "node_details": _node_details,
    "action_servers": lambda _graph, _args: {"action_servers": []},
    "publishers": lambda graph, args: {"publishers": _nodes_of(SENSOR_TOPICS, graph, args.name("topic"))},
    "subscribers": lambda graph, args: {"subscribers": _nodes_of(COMMAND_TOPICS, graph, args.name("topic"))},
    "message_details": lambda _graph, args: {"typedefs": typedefs(short_type(args.text("type")))},
    "get_time": _time,
    "get_param": lambda graph, args: {
        "value": graph.parameters.get(args.name("name"), args.text("default", 1) or "null")
    },
    "set_param": _set_param,
    "has_param": lambda graph, args: {"exists": args.name("name") in graph.parameters},
    "search_param": _search_param,
    "delete_param": _delete_param,
    "get_param_names": lambda graph, _args: {"names": list(graph.parameters)},
}

_TYPES = {"action_servers": "GetActionServers"}
"""Services whose type has another name."""


def _camel_case(name: str) -> str:
    return "".join(word.capitalize() for word in name.split("_"))
