"""
Topics of the simulated robot: sensor readings as rosbridge ``publish`` lines and full messages, command messages as
values.

The channels and their messages are those of ``protocol/robots`` (see ``channels``).
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from functools import lru_cache
from typing import Any, NamedTuple

import msgspec

from ..sentences.sentence import tr
from ..world.events import Command, Reading
from ..world.world import Odometry
from .channels import BadMessage, Channel, Values, simulated_channels

__all__ = [
    "COMMAND_TOPICS",
    "LATCHED",
    "ODOMETRY",
    "RESET_ODOMETRY",
    "SENSOR_TOPICS",
    "BadMessage",
    "TopicMessage",
    "odometry_line",
    "on_demand",
    "read_command",
    "read_message",
    "reading_line",
    "topic_message",
]

CHANNELS = simulated_channels()

ODOMETRY = next(c for c in CHANNELS.values() if c.kind == "clock")
"""The channel whose messages are the robot's clock."""

SENSOR_TOPICS: dict[str, str] = {c.topic: c.type for c in CHANNELS.values() if not c.is_command}
"""Type per topic the robot publishes."""

COMMAND_TOPICS: dict[str, str] = {c.topic: c.type for c in CHANNELS.values() if c.is_command}
"""Type per topic the robot obeys."""

RESET_ODOMETRY = "/mobile_base/commands/reset_odometry"
"""An empty message on it lets the odometry begin anew."""

LATCHED = frozenset(c.topic for c in CHANNELS.values() if not c.is_command and (c.latched or c.kind == "state"))
"""Topics whose last value a new subscriber gets. A state is published when it changes; a real base repeats it."""

_COMMANDS: dict[str, Channel] = {c.topic: c for c in CHANNELS.values() if c.is_command}


class TopicMessage(NamedTuple):
    """A message on a topic that is none of the robot's: of a program, a ROS client or a person (rule R23)."""

    topic: str
    msg: Any

    def line(self) -> bytes:
        """The ``publish`` line of the robot link."""
        return msgspec.json.encode({"op": "publish", "topic": self.topic, "msg": self.msg}) + b"\n"


def read_message(topic: str, msg: Any) -> Command | TopicMessage:
    """
    A message that a person or a ROS client publishes: a command when the robot listens to its topic.

    Raises:
        BadMessage: the topic is one of the robot's sensors, or the message does not fit it.
    """
    if topic in COMMAND_TOPICS:
        return read_command(topic, msgspec.json.encode(msg))
    if topic in SENSOR_TOPICS:
        raise BadMessage(tr("the robot itself publishes {topic}", topic=topic))
    if not isinstance(msg, dict):
        raise BadMessage(tr("a message on {topic} is not an object", topic=topic))
    return TopicMessage(topic, msg)


def read_command(topic: str, msg: bytes | msgspec.Raw) -> Command:
    """
    A command message as a value.

    Raises:
        BadMessage: the topic is none the robot obeys, or the message does not fit it.
    """
    data = bytes(msg)
    return _read_short_command(topic, data) if len(data) <= _SHORT else _read_command(topic, data)


def _read_command(topic: str, msg: bytes) -> Command:
    channel = _COMMANDS.get(topic)
    if channel is None:
        raise BadMessage(tr("the robot does not listen to {topic}", topic=topic))
    try:
        return Command(channel.name, channel.read(msgspec.json.decode(msg)))
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError) as error:
        raise BadMessage(tr("on {topic}: {why}", topic=topic, why=error)) from error


_SHORT = 200
"""Messages up to this length are remembered, bytes: a velocity has 60. Programs often repeat a command."""

_read_short_command = lru_cache(maxsize=4096)(_read_command)


def reading_line(reading: Reading) -> bytes:
    """The ``publish`` line of a reading."""
    channel = CHANNELS[reading.channel]
    # Distances hardly ever repeat, and those of a scan are long.
    return channel.line(reading.values) if channel.on_demand else _remembered_line(reading)


@lru_cache(maxsize=4096)
def _remembered_line(reading: Reading) -> bytes:
    return CHANNELS[reading.channel].line(reading.values)


def odometry_line(odometry: Odometry) -> bytes:
    """The ``publish`` line of an odometry message."""
    return ODOMETRY.line(odometry)


def on_demand(topics: Collection[str]) -> list[str]:
    """The channels on these topics that are measured only while something listens."""
    return [c.name for c in CHANNELS.values() if c.on_demand and not c.derived and c.topic in topics]


def topic_message(latest: Mapping[str, Values], topic: str, time: float, seq: int) -> dict[str, Any]:
    """The whole message on a topic for ROS clients, from the latest values of all channels that it carries."""
    msg: dict[str, Any] = {}
    for channel in CHANNELS.values():
        if channel.topic == topic and not channel.is_command and not channel.derived and channel.name in latest:
            _merge(msg, channel.full(latest[channel.name], time, seq))
    return msg


def _merge(into: dict[str, Any], more: dict[str, Any]) -> None:
    for key, value in more.items():
        if isinstance(value, dict) and isinstance(into.get(key), dict):
            _merge(into[key], value)
        else:
            into[key] = value
