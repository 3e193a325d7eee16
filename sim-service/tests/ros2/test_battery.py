"""Batteries of robots on ROS 2: their topics by the descriptions, and their messages."""

from __future__ import annotations

import math

import pytest

from rosy_sim.ros2.battery import Battery, battery_topic, read_battery


def test_the_topics_are_those_of_the_descriptions() -> None:
    topic = battery_topic("turtlebot3", "/lab")
    assert topic is not None
    assert (topic.name, topic.type) == ("/lab/battery_state", "sensor_msgs/BatteryState")
    topic = battery_topic("kobuki", "")
    assert topic is not None
    assert (topic.name, topic.type) == ("/sensors/core", "kobuki_ros_interfaces/SensorState")
    assert battery_topic("turtlesim", "/turtle1") is None


@pytest.mark.parametrize(
    ("percentage", "voltage", "battery"),
    [
        (0.874, 11.96, Battery(87, 12.0)),
        (0.0, 0.0, Battery(0, 0.0)),
        (1.0, math.nan, Battery(100, None)),
        (math.nan, 11.9, Battery(None, 11.9)),
        # No part of 1.
        (109.3, 12.1, Battery(None, 12.1)),
        (-1.0, math.inf, Battery(None, None)),
    ],
)
def test_what_is_no_charge_is_left_out(percentage: float, voltage: float, battery: Battery) -> None:
    topic = battery_topic("create3", "")
    assert topic is not None
    assert read_battery(topic, {"percentage": percentage, "voltage": voltage}) == battery


def test_a_kobuki_counts_tenths_of_volts() -> None:
    topic = battery_topic("kobuki", "")
    assert topic is not None
    assert read_battery(topic, {"battery": 158}) == Battery(None, 15.8)
