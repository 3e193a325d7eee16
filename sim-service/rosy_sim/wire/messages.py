"""
The ROS messages the robot speaks, field by field, for ``/rosapi/message_details``.

From the .msg files of kobuki_msgs, nav_msgs, geometry_msgs and std_msgs (ROS 1, noetic).
"""

from __future__ import annotations

__all__ = ["FIELDS", "typedefs"]

_EXAMPLES = {"string": "", "bool": "False", "float64": "0.0", "time": "{}"}

FIELDS: dict[str, list[tuple[str, str, int]]] = {
    "kobuki_msgs/ButtonEvent": [("uint8", "button", -1), ("uint8", "state", -1)],
    "kobuki_msgs/BumperEvent": [("uint8", "bumper", -1), ("uint8", "state", -1)],
    "kobuki_msgs/CliffEvent": [("uint8", "sensor", -1), ("uint8", "state", -1), ("uint16", "bottom", -1)],
    "kobuki_msgs/WheelDropEvent": [("uint8", "wheel", -1), ("uint8", "state", -1)],
    "kobuki_msgs/RobotStateEvent": [("uint8", "state", -1)],
    "kobuki_msgs/Led": [("uint8", "value", -1)],
    "kobuki_msgs/Sound": [("uint8", "value", -1)],
    "std_msgs/String": [("string", "data", -1)],
    "std_msgs/Header": [("uint32", "seq", -1), ("time", "stamp", -1), ("string", "frame_id", -1)],
    "geometry_msgs/Vector3": [("float64", "x", -1), ("float64", "y", -1), ("float64", "z", -1)],
    "geometry_msgs/Point": [("float64", "x", -1), ("float64", "y", -1), ("float64", "z", -1)],
    "geometry_msgs/Quaternion": [("float64", name, -1) for name in "xyzw"],
    "geometry_msgs/Twist": [("geometry_msgs/Vector3", "linear", -1), ("geometry_msgs/Vector3", "angular", -1)],
    "geometry_msgs/Pose": [("geometry_msgs/Point", "position", -1), ("geometry_msgs/Quaternion", "orientation", -1)],
    "geometry_msgs/PoseWithCovariance": [("geometry_msgs/Pose", "pose", -1), ("float64", "covariance", 36)],
    "geometry_msgs/TwistWithCovariance": [("geometry_msgs/Twist", "twist", -1), ("float64", "covariance", 36)],
    "nav_msgs/Odometry": [
        ("std_msgs/Header", "header", -1),
        ("string", "child_frame_id", -1),
        ("geometry_msgs/PoseWithCovariance", "pose", -1),
        ("geometry_msgs/TwistWithCovariance", "twist", -1),
    ],
}
"""Per type: type, name and array length (-1 for a single value) of each field, in wire order."""


def typedefs(kind: str) -> list[dict[str, object]]:
    """A type and all it is made of, as rosapi describes them; empty for a type the robot does not speak."""
    found: list[dict[str, object]] = []
    waiting = [kind]
    seen: set[str] = set()
    while waiting:
        name = waiting.pop(0)
        fields = FIELDS.get(name)
        if fields is None or name in seen:
            continue
        seen.add(name)
        waiting += [field for field, _, _ in fields]
        found.append(
            {
                "type": name,
                "fieldnames": [field for _, field, _ in fields],
                "fieldtypes": [field for field, _, _ in fields],
                "fieldarraylen": [length for _, _, length in fields],
                "examples": [_example(field, length) for field, _, length in fields],
                "constnames": [],
                "constvalues": [],
            }
        )
    return found


def _example(field: str, length: int) -> str:
    if length >= 0:
        return "[]"
    return "{}" if "/" in field else _EXAMPLES.get(field, "0")
