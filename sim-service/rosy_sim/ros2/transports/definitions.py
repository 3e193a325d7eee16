"""
ROS 2 types by their definitions: the fields of messages, and of the parts of services and actions, in wire order.

In: the name of a type, ``geometry_msgs/Twist``. A type that ROS 1 has too is read from ``rosy-hs/ros/msg``, with the
header and times of ROS 2 in place of those of ROS 1; others are in the table below, and in the folders of
``ROSY_MSG_PATH`` (``own_definitions.py``). A type whose definition is not there is ``None``.
"""

from __future__ import annotations

import re
from functools import cache

from ...robot_description import description, known_robots
from ...wire.ros.ros_messages import Field, definition_fields, fields_of
from .own_definitions import own_definition

__all__ = ["ros2_fields", "ros2_schema"]

_DEFINITIONS: dict[str, str] = {
    # rcl_interfaces, builtin_interfaces/msg
    "builtin_interfaces/Time": "int32 sec\nuint32 nanosec",
    "builtin_interfaces/Duration": "int32 sec\nuint32 nanosec",
    # common_interfaces: the header has no sequence number
    "std_msgs/Header": "builtin_interfaces/Time stamp\nstring frame_id",
    # geometry2
    "tf2_msgs/TFMessage": "geometry_msgs/TransformStamped[] transforms",
    # irobot_create_msgs 2.1 (Humble)
    "irobot_create_msgs/HazardDetection": "Header header\nuint8 type",
    "irobot_create_msgs/HazardDetectionVector": "Header header\nHazardDetection[] detections",
    "irobot_create_msgs/Button": "Header header\nbool is_pressed\nbuiltin_interfaces/Time last_start_pressed_time\n"
    "builtin_interfaces/Duration last_pressed_duration",
    "irobot_create_msgs/InterfaceButtons": "Header header\nButton button_1\nButton button_power\nButton button_2",
    "irobot_create_msgs/DockStatus": "Header header\nbool dock_visible\nbool is_docked",
    "irobot_create_msgs/LedColor": "uint8 red\nuint8 green\nuint8 blue",
    "irobot_create_msgs/LightringLeds": "Header header\nLedColor[6] leds\nbool override_system",
    "irobot_create_msgs/AudioNote": "uint16 frequency\nbuiltin_interfaces/Duration max_runtime",
    "irobot_create_msgs/AudioNoteVector": "Header header\nAudioNote[] notes\nbool append",
    # turtlebot3_msgs 2.2
    "turtlebot3_msgs/SensorState": "Header header\nuint8 bumper\nfloat32 cliff\nfloat32 sonar\nfloat32 illumination\n"
    "uint8 led\nuint8 button\n"
    "bool torque\nint32 left_encoder\nint32 right_encoder\nfloat32 battery",
    # turtlesim (Humble)
    "turtlesim/Pose": "float32 x\nfloat32 y\nfloat32 theta\nfloat32 linear_velocity\nfloat32 angular_velocity",
    "turtlesim/Color": "uint8 r\nuint8 g\nuint8 b",
    # unique_identifier_msgs; action_msgs (rcl_interfaces)
    "unique_identifier_msgs/UUID": "uint8[16] uuid",
    "action_msgs/GoalInfo": "unique_identifier_msgs/UUID goal_id\nbuiltin_interfaces/Time stamp",
    "action_msgs/GoalStatus": "GoalInfo goal_info\nint8 status",
    "action_msgs/GoalStatusArray": "GoalStatus[] status_list",
}
"""Fields of what ROS 1 does not have, or has otherwise."""

_SERVICES: dict[str, str] = {
    "std_srvs/SetBool": "bool data\n---\nbool success\nstring message",
    "std_srvs/Trigger": "---\nbool success\nstring message",
    "std_srvs/Empty": "---\n",
    "action_msgs/CancelGoal": "GoalInfo goal_info\n---\nint8 return_code\nGoalInfo[] goals_canceling",
    "irobot_create_msgs/EStop": "bool e_stop_on\n---\nbool success\nstring message",
    "turtlebot3_msgs/Sound": "uint8 value\n---\nbool success\nstring message",
    "turtlesim/SetPen": "uint8 r\nuint8 g\nuint8 b\nuint8 width\nuint8 off\n---\n",
}
"""Request and response."""

_ACTIONS: dict[str, str] = {
    # irobot_create_msgs 2.1 (Humble)
    "irobot_create_msgs/Dock": "---\nbool is_docked\n---\nbool sees_dock",
    "irobot_create_msgs/Undock": "---\nbool is_docked\n---\n",
    "irobot_create_msgs/DriveDistance": "float32 distance\nfloat32 max_translation_speed\n---\n"
    "geometry_msgs/PoseStamped pose\n---\nfloat32 remaining_travel_distance",
    "irobot_create_msgs/RotateAngle": "float32 angle\nfloat32 max_rotation_speed\n---\n"
    "geometry_msgs/PoseStamped pose\n---\nfloat32 remaining_angle_travel",
    # nav2_msgs (Jazzy). Humble has an empty result, whose bytes are those of no error.
    "nav2_msgs/NavigateToPose": "geometry_msgs/PoseStamped pose\nstring behavior_tree\n---\nuint16 error_code\n---\n"
    "geometry_msgs/PoseStamped current_pose\nbuiltin_interfaces/Duration navigation_time\n"
    "builtin_interfaces/Duration estimated_time_remaining\nint16 number_of_recoveries\nfloat32 distance_remaining",
}
"""Goal, result and feedback."""

_PARTS_OF_SERVICES = ("Request", "Response")
_PARTS_OF_ACTIONS = ("Goal", "Result", "Feedback")

_GOAL_ID = "unique_identifier_msgs/UUID goal_id\n"

_MADE_OF_ACTIONS = {
    "SendGoal_Request": _GOAL_ID + "{action}_Goal goal",
    "SendGoal_Response": "bool accepted\nbuiltin_interfaces/Time stamp",
    "GetResult_Request": _GOAL_ID,
    "GetResult_Response": "int8 status\n{action}_Result result",
    "FeedbackMessage": _GOAL_ID + "{action}_Feedback feedback",
}
"""What an action's services and topics carry (rosidl_parser, definition.py: class Action)."""

_TIMES = {"time": "builtin_interfaces/Time", "duration": "builtin_interfaces/Duration"}


@cache
def ros2_fields(kind: str) -> tuple[Field, ...] | None:
    """The fields of a message, or of a part of a service or action: ``std_srvs/SetBool_Request``."""
    package, _, name = kind.partition("/")
    text = _DEFINITIONS.get(kind)
    if text is None:
        text = _part(kind)
    if text is not None:
        return definition_fields(text, package)
    earlier = _earlier_packages().get(package, package)
    fields = fields_of(f"{earlier}/{name}")
    if fields is None:
        own = own_definition(kind, "msg")
        return None if own is None else definition_fields(own, package)
    return tuple((_ros2_kind(field, earlier, package), at, length) for field, at, length in fields)


def ros2_schema(kind: str) -> str:
    """The definition of a message with those of its parts, as recordings and Foxglove have it (MCAP, ``ros2msg``)."""
    parts = [kind]
    texts = []
    for part in parts:
        fields = ros2_fields(part) or ()
        texts.append("\n".join(f"{_with_length(field, length)} {name}" for field, name, length in fields))
        inner = dict.fromkeys(field for field, _, _ in fields if "/" in field)
        parts += [field for field in inner if field not in parts]
    first, *others = zip(parts, texts, strict=True)
    return "\n".join([first[1], *(f"{'=' * 80}\nMSG: {part}\n{text}" for part, text in others)])


def _part(kind: str) -> str | None:
    """The definition of a part of a service or an action."""
    package, _, name = kind.partition("/")
    name, _, part = name.partition("_")
    whole = f"{package}/{name}"
    if part in _MADE_OF_ACTIONS:
        return _MADE_OF_ACTIONS[part].format(action=whole)
    for folder, known, parts in (("srv", _SERVICES, _PARTS_OF_SERVICES), ("action", _ACTIONS, _PARTS_OF_ACTIONS)):
        text = (known.get(whole) or own_definition(whole, folder)) if part in parts else None
        if text is not None:
            texts = re.split(r"^---\s*$", text, flags=re.MULTILINE)
            return texts[parts.index(part)] if len(texts) == len(parts) else None
    return None


def _with_length(field: str, length: int) -> str:
    return field if length < 0 else f"{field}[{length or ''}]"


@cache
def _earlier_packages() -> dict[str, str]:
    """Packages of robots on ROS 2 whose messages are those of a package of ROS 1, by the robots' descriptions."""
    profiles = [description(robot)["profiles"] for robot in known_robots()]
    return {p["ros2"]["messages"]: p["ros1"]["messages"] for p in profiles if p.keys() >= {"ros1", "ros2"}}


def _ros2_kind(field: str, earlier: str, package: str) -> str:
    if field.startswith(f"{earlier}/"):
        return f"{package}/{field.partition('/')[2]}"
    return _TIMES.get(field, field)
