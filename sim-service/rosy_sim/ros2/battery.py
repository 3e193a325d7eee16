"""
Batteries of robots on ROS 2: on which topic a robot reports its battery, and what a message there says. Pure.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from ..robot_description import description

__all__ = ["Battery", "BatteryTopic", "battery_topic", "read_battery"]

_STATE = "sensor_msgs/BatteryState"


@dataclass(frozen=True, slots=True)
class Battery:
    """``charge`` is a whole percentage, of robots that report it; ``volts`` is rounded to 0.1 V."""

    charge: int | None = None
    volts: float | None = None


@dataclass(frozen=True, slots=True)
class BatteryTopic:
    """A topic with its type, the field that has the voltage, and what multiplies it to give V."""

    name: str
    type: str
    field: str
    scale: float


def battery_topic(kind: str, namespace: str) -> BatteryTopic | None:
    """That of a robot, by its description; ``None`` for a robot that reports none."""
    robot = description(kind)
    variables = {**robot["profiles"]["ros2"], "prefix": namespace}
    for channel in robot["channels"]:
        if channel["name"] == "Battery":
            ros = channel["ros"]
            [field] = ros["fields"]
            path, scale = (field, 1.0) if isinstance(field, str) else (field["path"], field.get("scale", 1.0))
            return BatteryTopic(ros["topic"].format_map(variables), ros["type"].format_map(variables), path, scale)
    return None


def read_battery(topic: BatteryTopic, message: dict[str, Any]) -> Battery:
    """What a message says."""
    volts = message[topic.field] * topic.scale
    # A part of 1, or NaN (sensor_msgs, msg/BatteryState.msg); what some robots send in its place is no part.
    part = message["percentage"] if topic.type == _STATE else math.nan
    return Battery(
        round(100 * part) if 0 <= part <= 1 else None,
        round(volts, 1) if math.isfinite(volts) else None,
    )
