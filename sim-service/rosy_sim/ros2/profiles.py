"""
Which robots a ROS 2 graph has, by its topics and their types, and their namespaces. Pure.

A robot is there when a topic of its own is, by its description in ``protocol/robots``: one below its prefix, of a type
of its own package. A TurtleBot 4 has the topics of a Create 3, which is its base.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache

from ..robot_description import description, known_robots
from .velocity_watch import VELOCITIES

__all__ = ["FoundRobot", "are_several", "find_robots", "hosts_of", "title_of"]


@dataclass(frozen=True, slots=True)
class FoundRobot:
    """
    A robot of a graph. ``options`` are those of an address that say where its topics are called otherwise. ``host`` is
    its computer, where robots on several have the same topics: a command without it reaches all of them.
    """

    kind: str
    namespace: str
    options: tuple[tuple[str, str], ...] = ()
    host: str | None = None


@dataclass(frozen=True, slots=True)
class _Topic:
    """A topic of a robot's description: its name below the prefix, and its type."""

    ending: str
    type: str


@dataclass(frozen=True, slots=True)
class _Topics:
    """Those of one robot: those that only it has, and those that launch files rename."""

    marks: frozenset[_Topic]
    odometry: _Topic
    velocity: _Topic


_NO_HOSTS: Mapping[str, Sequence[str]] = {}

_HIDDEN = "/_"
"""
In a namespace that is hidden (design.ros2.org, "Topic and Service Names"): that of a TurtleBot 4's base is, and its
computer repeats the topics (create3_republisher).
"""

_CARRIERS = {"turtlebot4_msgs": "TurtleBot 4"}
"""Robots that stand on another one, by the package of their messages (turtlebot4_node, src/turtlebot4.cpp)."""


def find_robots(topics: Mapping[str, str], hosts: Mapping[str, Sequence[str]] = _NO_HOSTS) -> list[FoundRobot]:
    """The robots with these topics, by namespace; ``hosts`` are the computers that publish each topic."""
    places: dict[FoundRobot, Sequence[str]] = {}
    for kind, own in _descriptions().items():
        for mark in own.marks:
            for topic in topics:
                namespace = topic.removesuffix(mark.ending)
                if namespace != topic and topics[topic] == mark.type and _HIDDEN not in namespace:
                    robot = FoundRobot(kind, namespace)
                    # A robot may have several computers, but each of its topics comes from one.
                    places[robot] = max(places.get(robot, ()), hosts.get(topic, ()), key=len)
    # Of several robots a topic with another name may be any one's.
    if len(places) == 1:
        places = {replace(robot, options=tuple(_renamed(robot, topics))): found for robot, found in places.items()}
    return [
        replace(robot, host=host)
        for robot in sorted(places, key=lambda robot: (robot.namespace, robot.kind))
        for host in (places[robot] if len(places[robot]) > 1 else (None,))
    ]


def hosts_of(robot: FoundRobot, hosts: Mapping[str, Sequence[str]]) -> set[str]:
    """Those of a graph's computers that publish what only such a robot does, or the one that it is told apart by."""
    if robot.host is not None:
        return {robot.host}
    return {host for topic in _own_topics(robot) for host in hosts.get(topic, ())}


def are_several(robot: FoundRobot, processes: Mapping[str, Mapping[str, int]]) -> bool:
    """
    Whether several robots answer as this one: more than one process of a computer, or behind a router, publishes what
    only such a robot does. Nothing tells them apart, and a command reaches all of them.
    """
    counts = (processes.get(topic, {}) for topic in _own_topics(robot))
    return any(count > 1 for found in counts for host, count in found.items() if robot.host in (None, host))


def title_of(robot: FoundRobot, topics: Mapping[str, str]) -> str:
    """What people call a robot of a graph with these topics."""
    own = (kind.partition("/")[0] for topic, kind in topics.items() if topic.startswith(f"{robot.namespace}/"))
    carriers = [_CARRIERS[package] for package in own if package in _CARRIERS]
    return carriers[0] if carriers else str(description(robot.kind)["title"])


def _own_topics(robot: FoundRobot) -> list[str]:
    return [f"{robot.namespace}{mark.ending}" for mark in _descriptions()[robot.kind].marks]


def _renamed(robot: FoundRobot, topics: Mapping[str, str]) -> Iterator[tuple[str, str]]:
    """The options for topics that are not where they usually are, if there is only one that they can be."""
    own = _descriptions()[robot.kind]
    for option, usual, types in (
        ("odometry", own.odometry, (own.odometry.type,)),
        ("velocity", own.velocity, VELOCITIES),
    ):
        others = [topic for topic, kind in topics.items() if kind in types]
        below = [topic for topic in others if topic.startswith(f"{robot.namespace}/")] or others
        if f"{robot.namespace}{usual.ending}" not in topics and len(below) == 1:
            yield option, below[0]


@cache
def _descriptions() -> dict[str, _Topics]:
    """The topics of the robots that are on ROS 2."""
    found = {}
    for kind in known_robots():
        robot = description(kind)
        given = robot["profiles"].get("ros2")
        if given is None:
            continue
        variables = {**given, "prefix": "", "velocityType": VELOCITIES[0]}
        variables |= {name: variables[name].format_map(variables) for name in ("odometry", "velocity")}
        topics = {
            channel["name"]: _Topic(*(channel["ros"][part].format_map(variables) for part in ("topic", "type")))
            for channel in robot["channels"]
        }
        sensors = [topics[c["name"]] for c in robot["channels"] if c["kind"] != "command"]
        marks = frozenset(topic for topic in sensors if topic.type.startswith(f"{given['messages']}/"))
        found[kind] = _Topics(marks, topics["Odometry"], topics["Velocity"])
    return found
