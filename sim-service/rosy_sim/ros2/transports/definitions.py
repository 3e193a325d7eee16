"""
ROS 2 message and service types by their definitions: their fields in wire order.

In: the name of a type, ``geometry_msgs/Twist``. A type that ROS 1 has too is read from ``rosy-hs/ros/msg``, with the
header and times of
ROS 2 in place of those of ROS 1; the others are in the table below. A type whose definition is not there is ``None``.
"""

from __future__ import annotations

from functools import cache

from ...robot_description import description, known_robots
from ...wire.ros.ros_messages import Field, definition_fields, fields_of

__all__ = ["ros2_fields", "ros2_schema"]

_DEFINITIONS: dict[str, str] = {
    # rcl_interfaces, builtin_interfaces/msg
    "builtin_interfaces/Time": "int32 sec\nuint32 nanosec",
    "builtin_interfaces/Duration": "int32 sec\nuint32 nanosec",
    # common_interfaces: the header has no sequence number
    "std_msgs/Header": "builtin_interfaces/Time stamp\nstring frame_id",
    # geometry2
    "tf2_msgs/TFMessage": "geometry_msgs/TransformStamped[] transforms",
    "std_srvs/SetBool_Request": "bool data",
    "std_srvs/Trigger_Request": "",
    "std_srvs/Empty_Request": "",
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
    "irobot_create_msgs/EStop_Request": "bool e_stop_on",
    # turtlebot3_msgs 2.2
    "turtlebot3_msgs/SensorState": "Header header\nuint8 bumper\nfloat32 cliff\nfloat32 sonar\nfloat32 illumination\n"
    "uint8 led\nuint8 button\n"
    "bool torque\nint32 left_encoder\nint32 right_encoder\nfloat32 battery",
    "turtlebot3_msgs/Sound_Request": "uint8 value",
    # turtlesim (Humble)
    "turtlesim/Pose": "float32 x\nfloat32 y\nfloat32 theta\nfloat32 linear_velocity\nfloat32 angular_velocity",
    "turtlesim/Color": "uint8 r\nuint8 g\nuint8 b",
    "turtlesim/SetPen_Request": "uint8 r\nuint8 g\nuint8 b\nuint8 width\nuint8 off",
}
"""Fields of what ROS 1 does not have, or has otherwise."""

_TIMES = {"time": "builtin_interfaces/Time", "duration": "builtin_interfaces/Duration"}


@cache
def ros2_fields(kind: str) -> tuple[Field, ...] | None:
    """The fields of a message or of a service's request (``std_srvs/SetBool_Request``)."""
    package, _, name = kind.partition("/")
    text = _DEFINITIONS.get(kind)
    if text is not None:
        return definition_fields(text, package)
    earlier = _earlier_packages().get(package, package)
    fields = fields_of(f"{earlier}/{name}")
    if fields is None:
        return None
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
