"""
A real robot behind a rosbridge server, seen from a program that waits for simulator lines: names of its topics,
its messages as sensor lines, commands as messages for it. No I/O.

A TurtleBot 2 with ROS 1 has its Kobuki under ``/mobile_base`` and speaks kobuki_msgs; kobuki_ros for ROS 2 has relative
names and kobuki_ros_interfaces (kobuki_ros, kobuki_node/src/kobuki_ros.cpp).
"""

from __future__ import annotations

import math
from typing import Any, Literal

import msgspec

from ..world.events import Command, Led, Say, Sound, Velocity
from .topics import BASE, COMMAND_TOPICS, ODOM, SENSOR_TOPICS, odometry_line

__all__ = ["RealRobot", "Ros"]

Ros = Literal[1, 2]


class _Xy(msgspec.Struct):
    x: float = 0.0
    y: float = 0.0
    z: float = 0.0
    w: float = 1.0


class _Pose(msgspec.Struct):
    position: _Xy
    orientation: _Xy


class _PoseWithCovariance(msgspec.Struct):
    pose: _Pose


class _Twist(msgspec.Struct):
    linear: _Xy
    angular: _Xy


class _TwistWithCovariance(msgspec.Struct):
    twist: _Twist


class _Odometry(msgspec.Struct):
    pose: _PoseWithCovariance
    twist: _TwistWithCovariance


class RealRobot:
    """What is known of the robot at the other end."""

    def __init__(self, ros: Ros) -> None:
        self._ros = ros
        # Our name of a topic by the robot's.
        self._ours = {self._name(topic): topic for topic in SENSOR_TOPICS}
        # Where its odometry began, so that ours begins at the origin; set by the first message.
        self._origin: tuple[float, float, float] | None = None

    def _name(self, topic: str) -> str:
        return topic.removeprefix(BASE) if self._ros == 2 else topic

    def _type(self, kind: str) -> str:
        if self._ros == 1:
            return kind
        package, _, name = kind.partition("/")
        return f"{package.replace('kobuki_msgs', 'kobuki_ros_interfaces')}/msg/{name}"

    def greetings(self) -> list[str]:
        """What to send first: the topics we use."""
        wanted = [("subscribe", topic, kind) for topic, kind in SENSOR_TOPICS.items()]
        wanted += [
            ("advertise", topic, kind) for topic, kind in COMMAND_TOPICS.items() if not topic.startswith("/rosy/")
        ]
        return [_text({"op": op, "topic": self._name(topic), "type": self._type(kind)}) for op, topic, kind in wanted]

    def sensed(self, text: str | bytes) -> bytes | None:
        """The sensor line in a frame of the robot; ``None`` when it holds none."""
        try:
            message = msgspec.json.decode(text)
        except (msgspec.DecodeError, UnicodeError, RecursionError):
            return None
        if not isinstance(message, dict) or message.get("op") != "publish":
            return None
        topic, msg = self._ours.get(str(message.get("topic"))), message.get("msg")
        if topic is None or not isinstance(msg, dict):
            return None
        if topic == ODOM:
            return self._odometry(msg)
        return msgspec.json.encode({"op": "publish", "topic": topic, "msg": msg}) + b"\n"

    def _odometry(self, msg: dict[str, Any]) -> bytes | None:
        try:
            odometry = msgspec.convert(msg, _Odometry)
        except msgspec.ValidationError:
            return None
        pose, twist = odometry.pose.pose, odometry.twist.twist
        x, y = pose.position.x, pose.position.y
        theta = 2 * math.atan2(pose.orientation.z, pose.orientation.w)
        if self._origin is None:
            self._origin = (x, y, theta)
        ox, oy, otheta = self._origin
        c, s = math.cos(otheta), math.sin(otheta)
        dx, dy = x - ox, y - oy
        return odometry_line((c * dx + s * dy, c * dy - s * dx, theta - otheta, twist.linear.x, twist.angular.z))

    def command(self, command: Command) -> str | None:
        """A command as a frame for the robot; ``None`` for words, which it cannot say."""
        match command:
            case Velocity(linear, angular):
                msg: dict[str, Any] = {
                    "linear": {"x": linear, "y": 0.0, "z": 0.0},
                    "angular": {"x": 0.0, "y": 0.0, "z": angular},
                }
                topic = f"{BASE}/commands/velocity"
            case Led(led, colour):
                topic, msg = f"{BASE}/commands/led{led}", {"value": colour}
            case Sound(sound):
                topic, msg = f"{BASE}/commands/sound", {"value": sound}
            case Say():
                return None
        return _text({"op": "publish", "topic": self._name(topic), "msg": msg})


def _text(message: dict[str, Any]) -> str:
    return msgspec.json.encode(message).decode()
