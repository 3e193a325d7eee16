"""
The robot's topics: their names and types, sensor events as rosbridge ``publish`` lines, and command
messages as values.

Field names and numbers: kobuki_msgs (msg/*.msg), nav_msgs/Odometry, geometry_msgs/Twist; the table is
in ``protocol/README.md``, section 2.
"""

from __future__ import annotations

import math
from typing import Annotated, Any, Literal

import msgspec

from ..world.events import Command, Event, EventKind, Led, Say, Sound, Velocity
from ..world.world import Odometry

__all__ = [
    "COMMAND_TOPICS",
    "ODOM",
    "SENSOR_TOPICS",
    "BadMessage",
    "event_line",
    "event_message",
    "odometry_line",
    "read_command",
    "show_command",
    "show_event",
]

BASE = "/mobile_base"
ODOM = "/odom"

EVENT_TOPICS: dict[EventKind, tuple[str, str, str]] = {
    "robot_state": (f"{BASE}/events/robot_state", "kobuki_msgs/RobotStateEvent", ""),
    "button": (f"{BASE}/events/button", "kobuki_msgs/ButtonEvent", "button"),
    "bumper": (f"{BASE}/events/bumper", "kobuki_msgs/BumperEvent", "bumper"),
    "cliff": (f"{BASE}/events/cliff", "kobuki_msgs/CliffEvent", "sensor"),
    "wheel_drop": (f"{BASE}/events/wheel_drop", "kobuki_msgs/WheelDropEvent", "wheel"),
}
"""Topic, type and the name of the field that says which sensor, per kind of event."""

SENSOR_TOPICS: dict[str, str] = {
    **{topic: kind for topic, kind, _ in EVENT_TOPICS.values()},
    ODOM: "nav_msgs/Odometry",
}
"""Type per topic the robot publishes."""

COMMAND_TOPICS: dict[str, str] = {
    f"{BASE}/commands/velocity": "geometry_msgs/Twist",
    f"{BASE}/commands/led1": "kobuki_msgs/Led",
    f"{BASE}/commands/led2": "kobuki_msgs/Led",
    f"{BASE}/commands/sound": "kobuki_msgs/Sound",
    "/rosy/say": "std_msgs/String",
}
"""Type per topic the robot obeys."""

_BOTTOM = (2000, 200)
"""``CliffEvent.bottom`` over floor and over a hole, ADC counts of 4096. Our choice: the sensor's answer
at 3 cm and beyond its range (kobuki_documentation, doc/specifications.rst gives no curve)."""


class BadMessage(Exception):
    """A message does not fit its topic; the text says how."""


class _Linear(msgspec.Struct, frozen=True):
    x: float = 0.0


class _Angular(msgspec.Struct, frozen=True):
    z: float = 0.0


_STILL = _Linear()
_STRAIGHT = _Angular()


class _Twist(msgspec.Struct):
    linear: _Linear = _STILL
    angular: _Angular = _STRAIGHT


class _Led(msgspec.Struct):
    value: Annotated[int, msgspec.Meta(ge=0, le=3)] = 0


class _Sound(msgspec.Struct):
    value: Annotated[int, msgspec.Meta(ge=0, le=6)] = 0


class _String(msgspec.Struct):
    data: str = ""


_twist = msgspec.json.Decoder(_Twist)
_led = msgspec.json.Decoder(_Led)
_sound = msgspec.json.Decoder(_Sound)
_string = msgspec.json.Decoder(_String)


def read_command(topic: str, msg: bytes | msgspec.Raw) -> Command:
    """
    A command message as a value.

    Raises:
        BadMessage: the topic is none the robot obeys, or the message does not fit it.
    """
    try:
        match topic:
            case "/mobile_base/commands/velocity":
                twist = _twist.decode(msg)
                linear, angular = twist.linear.x, twist.angular.z
                if not (math.isfinite(linear) and math.isfinite(angular)):
                    raise BadMessage(f"a speed on {topic} is not a finite number")
                return Velocity(linear, angular)
            case "/mobile_base/commands/led1":
                return Led(1, _led.decode(msg).value)
            case "/mobile_base/commands/led2":
                return Led(2, _led.decode(msg).value)
            case "/mobile_base/commands/sound":
                return Sound(_sound.decode(msg).value)
            case "/rosy/say":
                return Say(_string.decode(msg).data)
            case _:
                raise BadMessage(f"the robot does not listen to {topic}")
    except (msgspec.DecodeError, UnicodeDecodeError) as error:
        raise BadMessage(f"on {topic}: {error}") from error


def event_message(event: Event) -> tuple[str, dict[str, int]]:
    """Topic and message of an event."""
    topic, _, field = EVENT_TOPICS[event.kind]
    if not field:
        return topic, {"state": event.state}
    msg = {field: event.which, "state": event.state}
    if event.kind == "cliff":
        msg["bottom"] = _BOTTOM[event.state]
    return topic, msg


def _event_lines() -> dict[Event, bytes]:
    lines: dict[Event, bytes] = {}
    counts: dict[EventKind, int] = {"robot_state": 1, "button": 3, "bumper": 3, "cliff": 3, "wheel_drop": 2}
    for kind, count in counts.items():
        for which in range(count):
            for state in (0, 1):
                event = Event(kind, which, state)
                topic, msg = event_message(event)
                lines[event] = msgspec.json.encode({"op": "publish", "topic": topic, "msg": msg}) + b"\n"
    return lines


_EVENT_LINES = _event_lines()


def event_line(event: Event) -> bytes:
    """The ``publish`` line of an event."""
    return _EVENT_LINES[event]


def odometry_line(odometry: Odometry) -> bytes:
    """The ``publish`` line of an odometry message on the pipe: only the fields the table names."""
    x, y, theta, v, w = odometry
    half = theta / 2
    return (
        '{"op":"publish","topic":"/odom","msg":{"pose":{"pose":{"position":'
        f'{{"x":{x!r},"y":{y!r}}},"orientation":{{"z":{math.sin(half)!r},"w":{math.cos(half)!r}}}}}}},'
        f'"twist":{{"twist":{{"linear":{{"x":{v!r}}},"angular":{{"z":{w!r}}}}}}}}}}}\n'
    ).encode()


_SIDES = ("Left", "Center", "Right")
_COLOURS = ("Black", "Green", "Orange", "Red")
_SOUNDS = ("On", "Off", "Recharge", "Button", "Error", "CleaningStart", "CleaningEnd")


def show_event(event: Event) -> str:
    """An event as Haskell shows it."""
    kind, which, state = event
    match kind:
        case "robot_state":
            return "Online" if state else "Offline"
        case "button":
            return f"Button Button{which} {'Pressed' if state else 'Released'}"
        case "bumper":
            return f"Bumper {_SIDES[which]}Bumper {'Pressed' if state else 'Released'}"
        case "cliff":
            return f"Cliff {_SIDES[which]}Cliff {'Hole' if state else 'Floor'}"
        case "wheel_drop":
            return f"Wheel {('Left', 'Right')[which]}Wheel {'Air' if state else 'Ground'}"


def show_command(command: Command) -> str:
    """A command as Haskell shows it."""
    match command:
        case Velocity(linear, angular):
            return f"Velocity {_show_argument(linear)} {_show_argument(angular)}"
        case Led(led, colour):
            return f"Led{led} {_COLOURS[colour]}"
        case Sound(sound):
            return f"{_SOUNDS[sound]}Sound"
        case Say(text):
            return f"Say {_show_string(text)}"


def _show_argument(number: float) -> str:
    """A Double in argument position: Haskell 2010 report, section 11.4 (negative ones in parentheses)."""
    text = _show_double(number)
    return f"({text})" if text.startswith("-") else text


def _show_double(number: float) -> str:
    """Haskell's show: plain from 0.1 up to 10^7, else with an exponent (Numeric.showFloat)."""
    if number == 0 or 0.1 <= abs(number) < 1e7:
        text = repr(number)
        return text if "e" not in text else f"{number:.1f}"
    mantissa, _, exponent = f"{number!r}".partition("e")
    if not exponent:
        sign = "-" if mantissa.startswith("-") else ""
        whole, _, fraction = mantissa.lstrip("-").partition(".")
        digits = (whole + fraction).lstrip("0")
        power = len(whole) - 1 if whole != "0" else -(len(fraction) - len(fraction.lstrip("0")) + 1)
        digits = digits.rstrip("0") or "0"
        return f"{sign}{digits[0]}.{digits[1:] or '0'}e{power}"
    return f"{mantissa if '.' in mantissa else mantissa + '.0'}e{int(exponent)}"


_ESCAPES = {
    '"': '\\"',
    "\\": "\\\\",
    "\n": "\\n",
    "\t": "\\t",
    "\r": "\\r",
    "\a": "\\a",
    "\b": "\\b",
    "\f": "\\f",
    "\v": "\\v",
    "\x7f": "\\DEL",
}


def _show_string(text: str) -> str:
    """Haskell's show for String: other than printable ASCII as decimal escapes, ``\\&`` before a digit."""
    shown = ""
    numeric = False
    for char in text:
        if numeric and char.isascii() and char.isdigit():
            shown += "\\&"
        numeric = False
        if char in _ESCAPES:
            shown += _ESCAPES[char]
        elif " " <= char <= "~":
            shown += char
        else:
            shown += f"\\{ord(char)}"
            numeric = True
    return f'"{shown}"'


def full_odometry(odometry: Odometry, time: float, seq: int) -> dict[str, Any]:
    """The whole nav_msgs/Odometry for rosbridge clients; covariances as in kobuki_node, src/library/odometry.cpp."""
    x, y, theta, v, w = odometry
    covariance = [0.0] * 36
    for i, value in ((0, 0.1), (7, 0.1), (14, 1e10), (21, 1e10), (28, 1e10), (35, 0.05)):
        covariance[i] = value
    zero: Literal[0] = 0
    secs = int(time)
    return {
        "header": {
            "seq": seq,
            "stamp": {"secs": secs, "nsecs": round((time - secs) * 1e9)},
            "frame_id": "odom",
        },
        "child_frame_id": "base_footprint",
        "pose": {
            "pose": {
                "position": {"x": x, "y": y, "z": 0.0},
                "orientation": {"x": 0.0, "y": 0.0, "z": math.sin(theta / 2), "w": math.cos(theta / 2)},
            },
            "covariance": covariance,
        },
        "twist": {
            "twist": {
                "linear": {"x": v, "y": 0.0, "z": 0.0},
                "angular": {"x": 0.0, "y": 0.0, "z": w},
            },
            "covariance": [float(zero)] * 36,
        },
    }
