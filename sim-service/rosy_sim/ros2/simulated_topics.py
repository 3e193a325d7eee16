"""
Topics of the simulated robot on ROS 2: its rosbridge messages, which are those of ROS 1, as a robot on ROS 2 has them,
and the commands on ROS 2 as the simulator takes them. Pure.

The topics are those of the robot's own driver on ROS 2, by its description in ``protocol/robots``, those that every
base has, ``/cmd_vel`` and ``/tf``, and ``/map``, the room. What is measured on demand is asked for while a process of
ROS 2 has its topic.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from ..maps.room_map import room_map
from ..robot_description import simulated
from ..wire.channels import Channel
from ..wire.topics import CHANNELS, ODOMETRY
from ..world.arena import Arena
from .velocity_watch import VELOCITIES, as_type

__all__ = ["Frame", "SimulatedTopics", "room_frame"]

Frame = dict[str, Any]
"""A message of rosbridge's protocol."""

_VELOCITY = "cmd_vel"
"""Where teleoperation and navigation on ROS 2 send a Twist or a TwistStamped (teleop_twist_keyboard, Nav2)."""

_TRANSFORMS = "tf"
_TRANSFORMS_TYPE = "tf2_msgs/TFMessage"

_MAP = "map"
"""The topic, and the frame of the room (ROS REP 105)."""

_MAP_TYPE = "nav_msgs/OccupancyGrid"

_REPEAT = 50
"""Messages of odometry between two of each state, a second of the robot's time: a real base sends them all the time."""


@dataclass(frozen=True, slots=True)
class _Topic:
    """On ROS 2."""

    name: str
    type: str


class SimulatedTopics:
    """
    Of one robot. ``namespace`` is empty or has a slash first; ``now`` is the time of day, s since 1970 and ns, which
    all stamps have.
    """

    def __init__(self, namespace: str, now: Callable[[], tuple[int, int]]) -> None:
        self._now = now
        channels = [channel for channel in CHANNELS.values() if not channel.derived]
        self._sensors = {c.topic: _on_ros2(namespace, c) for c in channels if not c.is_command}
        self._latched = {c.topic for c in channels if c.latched and not c.is_command}
        self._states = {c.topic for c in channels if c.kind == "state"}
        self._on_demand = {c.topic for c in channels if c.on_demand}
        # The simulator's topic of each command.
        self._commands = {_on_ros2(namespace, c): c.topic for c in channels if c.is_command}
        self._velocity = f"{namespace}/{_VELOCITY}"
        self._velocity_type = VELOCITIES[0]
        self._transforms = f"{namespace}/{_TRANSFORMS}"
        self._map = f"{namespace}/{_MAP}"
        # Where odometry began in the room; None until the room is known.
        self._start: Frame | None = None
        self._scans = {channel.header for channel in channels if channel.on_demand and channel.header}
        # Topics measured on demand that something reads.
        self._read: set[str] = set()
        # The last message of each state, and messages of odometry since these were sent.
        self._last: dict[str, Frame] = {}
        self._steps = 0

    def offers(self) -> Iterator[Frame]:
        """For the bridge: what the robot publishes and reads."""
        for topic, there in self._sensors.items():
            yield {"op": "advertise", "topic": there.name, "type": there.type, "latch": topic in self._latched}
        yield {"op": "advertise", "topic": self._transforms, "type": _TRANSFORMS_TYPE}
        yield {"op": "advertise", "topic": self._map, "type": _MAP_TYPE, "latch": True}
        for there in self._commands:
            yield {"op": "subscribe", "topic": there.name, "type": there.type}
        yield {"op": "subscribe", "topic": self._velocity, "type": self._velocity_type}

    def requests(self) -> Iterator[Frame]:
        """For the simulator, when it begins to listen: the sensors."""
        for topic in self._sensors:
            if topic not in self._on_demand or topic in self._read:
                yield {"op": "subscribe", "topic": topic}

    def follow(self, topics: Mapping[str, str]) -> tuple[list[Frame], list[Frame]]:
        """
        Other processes of ROS 2 have these topics, with their types: what that changes, for the bridge and for the
        simulator.
        """
        read = {topic for topic in self._on_demand if self._sensors[topic].name in topics}
        asked: list[Frame] = [{"op": "subscribe", "topic": topic} for topic in sorted(read - self._read)]
        asked += [{"op": "unsubscribe", "topic": topic} for topic in sorted(self._read - read)]
        self._read = read
        kind = topics.get(self._velocity, self._velocity_type)
        offered: list[Frame] = []
        if kind in VELOCITIES and kind != self._velocity_type:
            self._velocity_type = kind
            offered.append({"op": "subscribe", "topic": self._velocity, "type": kind})
        return offered, asked

    def from_simulator(self, frame: Frame) -> Iterator[Frame]:
        """What the bridge publishes for a message of the simulator, or for its ``room`` (``room_frame``)."""
        topic = frame.get("topic")
        if frame.get("op") == "room":
            self._start = frame["start"]
            yield _published(self._map, frame["map"] | {"header": {"frame_id": _MAP}})
        if frame.get("op") != "publish" or topic not in self._sensors:
            return
        stamp = dict(zip(("sec", "nanosec"), self._now(), strict=True))
        message = _stamped(frame["msg"], stamp)
        if topic in self._states:
            self._last[topic] = message
        yield _published(self._sensors[topic].name, message)
        if topic == ODOMETRY.topic:
            yield _published(self._transforms, {"transforms": list(self._placed(message))})
            self._steps += 1
            if self._steps % _REPEAT == 0:
                for state, last in self._last.items():
                    yield _published(self._sensors[state].name, _stamped(last, stamp))

    def to_simulator(self, frame: Frame) -> Iterator[Frame]:
        """What the simulator takes for a message of ROS 2."""
        if frame.get("op") != "publish":
            return
        for there, topic in self._commands.items():
            is_velocity = frame["topic"] == self._velocity and there.type in VELOCITIES
            if is_velocity or frame["topic"] == there.name:
                yield _published(topic, as_type(frame["msg"], there.type) if is_velocity else frame["msg"])

    def _placed(self, odometry: Frame) -> Iterator[Frame]:
        """
        The transforms of a message of odometry: its frame in the room, the robot in its frame, and the scanner in the
        middle of the robot.
        """
        pose, header, base = odometry["pose"]["pose"], odometry["header"], odometry["child_frame_id"]
        if self._start is not None:
            in_room = header | {"frame_id": _MAP}
            yield {"header": in_room, "child_frame_id": header["frame_id"], "transform": self._start}
        transform = {"translation": pose["position"], "rotation": pose["orientation"]}
        yield {"header": header, "child_frame_id": base, "transform": transform}
        for frame in sorted(self._scans):
            same = {"rotation": {"w": 1.0}}
            yield {"header": header | {"frame_id": base}, "child_frame_id": frame, "transform": same}


def room_frame(arena: Arena) -> Frame:
    """A room, for ``SimulatedTopics.from_simulator``: its map, and where odometry begins in it."""
    start = arena.start
    rotation = {"x": 0.0, "y": 0.0, "z": math.sin(start.theta / 2), "w": math.cos(start.theta / 2)}
    placed = {"translation": {"x": start.x, "y": start.y, "z": 0.0}, "rotation": rotation}
    return {"op": "room", "map": room_map(arena), "start": placed}


def _published(topic: str, message: Any) -> Frame:
    return {"op": "publish", "topic": topic, "msg": message}


def _stamped(message: Frame, stamp: Frame) -> Frame:
    """With a header of ROS 2, if it has one."""
    if "header" not in message:
        return message
    return message | {"header": {"stamp": stamp, "frame_id": message["header"]["frame_id"]}}


def _on_ros2(namespace: str, channel: Channel) -> _Topic:
    """Where the driver of the robot on ROS 2 has a channel."""
    given = simulated()["profiles"]["ros2"]
    variables = {**given, "prefix": namespace + given["prefix"]}
    variables |= {name: given[name].format_map(variables) for name in ("odometry", "velocity")}
    ros = next(c["ros"] for c in simulated()["channels"] if c["name"] == channel.name)
    name, kind = (ros[part].format_map(variables) for part in ("topic", "type"))
    return _Topic(name if name.startswith(f"{namespace}/") else namespace + name, kind)
