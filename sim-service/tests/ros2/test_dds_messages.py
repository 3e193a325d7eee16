"""Messages between JSON and CDR, against bytes that were made by hand from the definitions and the rules of CDR."""

from __future__ import annotations

import json
import math
import struct
from typing import Any

import pytest

pytest.importorskip("cyclonedds", reason="Cyclone DDS is not installed")

from rosy_sim.robot_description import description, known_robots
from rosy_sim.ros2.transports.dds_messages import BadMessage, from_json, message_class, request_class, to_json

HEAD = b"\x00\x01\x00\x00"
"""CDR, little-endian (DDSI-RTPS 2.5, 10.2)."""


def now() -> tuple[int, int]:
    return (7, 8)


def encoded(kind: str, message: Any) -> bytes:
    return bytes(from_json(kind, message, now).serialize())


def robot_types() -> set[str]:
    """The types of all robots on ROS 2, requests of services among them."""
    found = set()
    for robot in map(description, known_robots()):
        variables = robot["profiles"].get("ros2")
        for channel in robot["channels"] if variables else []:
            kind = channel["ros"]["type"].format_map(variables | {"velocityType": "geometry_msgs/Twist"})
            found.add(f"{kind}_Request" if channel["ros"].get("service") else kind)
    return found | {"geometry_msgs/TwistStamped"}


@pytest.mark.parametrize("kind", sorted(robot_types()))
def test_every_message_of_a_robot_has_a_definition_and_comes_back(kind: str) -> None:
    made = message_class(kind)
    assert made is not None
    empty = to_json(kind, from_json(kind, {}, now))
    again = made.deserialize(encoded(kind, empty))
    assert to_json(kind, again) == empty


def test_bytes_of_a_velocity() -> None:
    twist = {"linear": {"x": 0.25}, "angular": {"z": -1}}
    assert encoded("geometry_msgs/Twist", twist) == HEAD + struct.pack("<6d", 0.25, 0, 0, 0, 0, -1)
    stamped = struct.pack("<iIi4s", 7, 8, 1, b"\0") + struct.pack("<6d", 0.25, 0, 0, 0, 0, -1)
    assert encoded("geometry_msgs/TwistStamped", {"twist": twist}) == HEAD + stamped


def test_a_header_with_a_time_keeps_it() -> None:
    kind = "geometry_msgs/TwistStamped"
    message = {"header": {"stamp": {"sec": 1, "nanosec": 2}}}
    assert to_json(kind, from_json(kind, message, now))["header"]["stamp"] == {"sec": 1, "nanosec": 2}


def test_numbers_that_json_lacks_stay_as_rosbridge_writes_them() -> None:
    scan = from_json("sensor_msgs/LaserScan", {"ranges": [math.inf, math.nan, 1]}, now)
    assert json.dumps(to_json("sensor_msgs/LaserScan", scan)["ranges"]) == "[Infinity, NaN, 1.0]"


def test_bytes_are_base_64_and_read_as_lists_too() -> None:
    for data in ([1, 2, 3], "AQID"):
        message = from_json("std_msgs/UInt8MultiArray", {"data": data}, now)
        assert to_json("std_msgs/UInt8MultiArray", message)["data"] == "AQID"


def test_a_message_without_fields_has_the_one_that_ros_2_gives_it() -> None:
    assert encoded("std_msgs/Empty", {}) == HEAD + b"\0"
    assert request_class("std_srvs/Nothing_Request", "std_srvs::srv::dds_::Nothing_Request_") is None


@pytest.mark.parametrize(
    ("kind", "message", "why"),
    [
        ("geometry_msgs/Twist", [], "geometry_msgs/Twist is not an object"),
        ("geometry_msgs/Twist", {"speed": 1}, "geometry_msgs/Twist does not have a field speed"),
        ("geometry_msgs/Twist", {"linear": {"x": "1"}}, "geometry_msgs/Twist.linear.x is not a number"),
        ("geometry_msgs/Twist", {"linear": {"x": True}}, "geometry_msgs/Twist.linear.x is not a number"),
        ("std_msgs/UInt8", {"data": 256}, "std_msgs/UInt8.data is not a uint8"),
        ("std_msgs/UInt8", {"data": 1.0}, "std_msgs/UInt8.data is not a uint8"),
        ("std_msgs/Int32", {"data": -(2**31) - 1}, "std_msgs/Int32.data is not a int32"),
        ("std_msgs/Bool", {"data": 1}, "std_msgs/Bool.data is not a bool"),
        ("std_msgs/String", {"data": 1}, "std_msgs/String.data is not a string"),
        ("std_msgs/UInt8MultiArray", {"data": "?"}, "std_msgs/UInt8MultiArray.data is not base 64"),
        ("sensor_msgs/LaserScan", {"ranges": 1}, "sensor_msgs/LaserScan.ranges is not a list"),
        ("irobot_create_msgs/LightringLeds", {"leds": []}, "irobot_create_msgs/LightringLeds.leds has 0 entries for 6"),
    ],
)
def test_a_message_that_does_not_fit_is_refused_with_its_place(kind: str, message: Any, why: str) -> None:
    with pytest.raises(BadMessage, match=f"^{why}$"):
        from_json(kind, message, now)
