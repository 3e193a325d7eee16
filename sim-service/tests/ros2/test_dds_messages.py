"""Messages between JSON and CDR, against bytes that were made by hand from the definitions and the rules of CDR."""

from __future__ import annotations

import json
import math
import struct
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("cyclonedds", reason="Cyclone DDS is not installed")

from rosy_sim.robot_description import description, known_robots
from rosy_sim.ros2.transports.dds_messages import BadMessage, decode, from_json, message_class, to_json, with_header
from rosy_sim.ros2.transports.definitions import ros2_fields

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
    assert message_class("std_srvs/Nothing_Request") is None


def actions_of_robots() -> set[str]:
    """The types of the actions of all robots on ROS 2."""
    profiles = [description(robot)["profiles"].get("ros2", {}) for robot in known_robots()]
    return {text.format_map(p) for p in profiles for name, text in p.items() if name.endswith("_type")}


@pytest.mark.parametrize("kind", sorted(actions_of_robots()))
def test_every_action_of_a_robot_has_its_services_and_topics(kind: str) -> None:
    for part in ("SendGoal_Request", "SendGoal_Response", "GetResult_Request", "GetResult_Response", "FeedbackMessage"):
        assert message_class(f"{kind}_{part}") is not None


def test_bytes_of_a_goal_and_of_the_header_of_cyclone_s_services() -> None:
    goal = {"goal_id": {"uuid": list(range(16))}, "goal": {"distance": 0.5, "max_translation_speed": 0.25}}
    body = bytes(range(16)) + struct.pack("<2f", 0.5, 0.25)
    kind = "irobot_create_msgs/DriveDistance_SendGoal_Request"
    assert encoded(kind, goal) == HEAD + body
    made = with_header(kind)
    assert made is not None
    headed = made(rosy_client=7, rosy_number=2, **vars(from_json(kind, goal, now)))
    assert bytes(headed.serialize(use_version_2=False)) == HEAD + struct.pack("<Qq", 7, 2) + body


def test_the_result_of_an_older_year_is_that_without_an_error() -> None:
    """Nav2's on Humble, a status and an empty message, whose bytes are not filled up over Zenoh."""
    kind = "nav2_msgs/NavigateToPose_GetResult_Response"
    assert to_json(kind, decode(kind, HEAD + b"\4\0")) == {"status": 4, "result": {"error_code": 0}}


def test_definitions_of_one_s_own_are_read_as_ros_2_writes_them(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name, text in {
        "own_a/srv/Add.srv": "# two numbers\nint64 a\nint64 b 3  # at first\n---\nint64 sum\n",
        "own_a/action/Go.action": "uint8 FAST=1\nstring<=10 where\n---\n---\nPlace[<=3] places\n",
        "own_a/Place.msg": "float32[2] at\n",
        "own_a/Strange.msg": "what?\n",
    }.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    monkeypatch.setenv("ROSY_MSG_PATH", f"/nowhere:{tmp_path}")
    assert ros2_fields("own_a/Add_Request") == (("int64", "a", -1), ("int64", "b", -1))
    assert ros2_fields("own_a/Add_Response") == (("int64", "sum", -1),)
    assert ros2_fields("own_a/Go_Goal") == (("string", "where", -1),)
    assert ros2_fields("own_a/Go_Feedback") == (("own_a/Place", "places", 0),)
    assert ros2_fields("own_a/Place") == (("float32", "at", 2),)
    assert [ros2_fields(f"own_a/{name}") for name in ("Strange", "Add_Goal", "../Place")] == [None] * 3


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
