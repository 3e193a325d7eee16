"""
Channels of a robot: table-driven conversion between values and ROS messages, from ``protocol/robots/<name>.json``.

The values of a channel are the leaves of its Haskell type in order: numbers, the codes of choices, 0 and 1 for truths,
and texts. One topic may carry several channels. The same descriptions generate the Haskell types and tables
(scripts/robots.py).
"""

from __future__ import annotations

import base64
import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cache
from typing import Any

import msgspec

from ..robot_description import simulated
from ..sentences.sentence import SentenceError, tr

__all__ = ["BadMessage", "Channel", "Values", "simulated_channels"]

_encode = msgspec.json.Encoder().encode

Json = dict[str, Any]
Values = tuple[float | int | str, ...]


class BadMessage(SentenceError):
    """A message does not fit its topic; the text says how."""


@dataclass(frozen=True, slots=True)
class Leaf:
    """One value of a channel: its kind, and the codes that a choice may have."""

    name: str
    kind: str
    codes: frozenset[int] = frozenset()


@dataclass(frozen=True, slots=True)
class Place:
    """Where a leaf is in a message."""

    path: tuple[str, ...]
    leaf: Leaf
    scale: float = 1.0
    yaw: bool = False
    flags: bool = False
    # All values from here on are the distances of a laser scan.
    ranges: bool = False


@dataclass(slots=True)
class Channel:
    """One kind of sensor message or command of the simulated robot."""

    name: str
    kind: str
    topic: str
    type: str
    latched: bool
    places: tuple[Place, ...]
    # Fields that are the same in every message, by path; a list is chosen by the code of the last value.
    constants: Mapping[tuple[str, ...], Any] = field(default_factory=dict)
    # The frame of the message's header, if it has a header.
    header: str | None = None
    # Whether a frame for the page shows the last command.
    holds: bool = False
    # Whether it is measured only while something listens.
    on_demand: bool = False
    # Whether robots compute it from a message that another channel of its topic has.
    derived: bool = False
    # Fields that are arrays of bytes: base 64 in the messages of rosbridge servers.
    byte_arrays: tuple[str, ...] = ()
    # The line with a place for each number; None when its message holds something else.
    _template: bytes | None = field(init=False, repr=False, compare=False)

    # Which of its values is an angle that its message has as a quaternion; None when none is.
    _yaw: int | None = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        yaws = [i for i, place in enumerate(self.places) if place.yaw]
        self._yaw = yaws[0] if yaws else None
        self._template = self._line_template()

    @property
    def is_command(self) -> bool:
        """Whether programs send it."""
        return self.kind == "command"

    @property
    def is_indexed(self) -> bool:
        """Whether the first value says which of several sensors has changed."""
        return self.kind == "event" and len(self.places) == 2 and bool(self.places[0].leaf.codes)

    def message(self, values: Values) -> Json:
        """The fields of a message that carry these values, and no others."""
        msg: Json = {}
        for place, value in self._placed(values):
            if place.ranges:
                _put(msg, place.path, list(values[len(self.places) - 1 :]))
            elif place.yaw:
                half = float(value) / 2
                _put(msg, (*place.path, "z"), math.sin(half))
                _put(msg, (*place.path, "w"), math.cos(half))
            elif place.leaf.kind == "Bool":
                _put(msg, place.path, bool(value))
            elif place.scale != 1.0:
                _put(msg, place.path, round(float(value) / place.scale))
            else:
                _put(msg, place.path, value)
        return msg

    def _placed(self, values: Values) -> Iterator[tuple[Place, float | int | str]]:
        """Each place with its value; the distances of a scan, if they are the last place, with the first of them."""
        has_ranges = bool(self.places) and self.places[-1].ranges
        return zip(self.places, (*values, 0.0)[: len(self.places)] if has_ranges else values, strict=True)

    def full(self, values: Values, time: float, seq: int) -> Json:
        """The message with its constants and its header, for ROS clients."""
        msg = self.message(values)
        for path, constant in self.constants.items():
            chosen = constant["choice"][int(values[-1])] if isinstance(constant, dict) else constant
            _put(msg, path, chosen)
        if self.places and self.places[-1].ranges:
            # As the driver of the scanner: 0 for a beam that meets nothing.
            farthest = float(msg["range_max"])
            msg["ranges"] = [0.0 if distance >= farthest else distance for distance in msg["ranges"]]
        for key in self.byte_arrays:
            msg[key] = base64.b64encode(bytes(msg[key])).decode()
        if self.header is not None:
            secs = int(time)
            msg["header"] = {
                "seq": seq,
                "stamp": {"secs": secs, "nsecs": round((time - secs) * 1e9)},
                "frame_id": self.header,
            }
        return msg

    def line(self, values: Values) -> bytes:
        """The ``publish`` line of the robot link."""
        if self._template is not None and len(values) == len(self.places):
            # The encoder writes each number as it does in a message.
            numbers = values if self._yaw is None else self._with_quaternion(values, self._yaw)
            return self._template % tuple(_encode(numbers)[1:-1].split(b","))
        return _encode({"op": "publish", "topic": self.topic, "msg": self.message(values)}) + b"\n"

    @staticmethod
    def _with_quaternion(values: Values, yaw: int) -> Values:
        """The numbers of a message whose value at ``yaw`` is an angle, in the order of its places."""
        half = float(values[yaw]) / 2
        return (*values[:yaw], math.sin(half), math.cos(half), *values[yaw + 1 :])

    def _line_template(self) -> bytes | None:
        if not self.places or any(
            p.ranges or (not p.yaw and (p.leaf.kind != "Double" or p.scale != 1.0)) for p in self.places
        ):
            return None
        if sum(p.yaw for p in self.places) > 1:
            return None
        # Values whose numbers all differ, and occur nowhere else in the line.
        values = tuple(1.0 + (i + 1) / 1024 for i in range(len(self.places)))
        line = msgspec.json.encode({"op": "publish", "topic": self.topic, "msg": self.message(values)}) + b"\n"
        at = 0
        pieces = []
        for number in values if self._yaw is None else self._with_quaternion(values, self._yaw):
            text = msgspec.json.encode(number)
            end = line.find(text, at)
            if end < 0 or line.count(text) != 1:
                return None
            pieces.append(line[at:end].replace(b"%", b"%%"))
            at = end + len(text)
        return b"%b".join([*pieces, line[at:].replace(b"%", b"%%")])

    def is_in(self, msg: Any, places: int | None = None) -> bool:
        """Whether a message has the fields of the channel, or of its first places; one topic may carry several."""
        return all(_has(msg, place.path) for place in self.places[:places])

    def read(self, msg: Any) -> Values:
        """
        The values in a message; a field that is missing is zero, as in ROS.

        Raises:
            BadMessage: the message does not fit.
        """
        if not isinstance(msg, dict):
            raise BadMessage(tr("a message on {topic} is not an object", topic=self.topic))
        values: list[float | int | str] = []
        for place in self.places:
            found = _get(msg, place.path)
            values += (
                [self._value(place, one) for one in found]
                if place.ranges and isinstance(found, list)
                else [self._value(place, found)]
            )
        return tuple(values)

    def _value(self, place: Place, found: Any) -> float | int | str:
        where = f"{'.'.join(place.path)} on {self.topic}"
        kind = place.leaf.kind
        if place.yaw:
            found = found if isinstance(found, dict) else {}
            return 2 * math.atan2(_as_float(found.get("z", 0.0)), _as_float(found.get("w", 1.0)))
        if found is _MISSING:
            return "" if kind == "String" else 0.0 if kind == "Double" else 0
        if kind == "String":
            if not isinstance(found, str):
                raise BadMessage(tr("{where} is not a text", where=where))
            return found
        if kind == "Bool":
            if not isinstance(found, bool):
                raise BadMessage(tr("{where} is not a truth", where=where))
            return int(found)
        if isinstance(found, bool) or not isinstance(found, int | float):
            raise BadMessage(tr("{where} is not a number", where=where))
        if kind in ("Double", "[Double]"):
            # Dividing by ten, unlike multiplying by 0.1, gives the number that people write.
            number = _as_float(found)
            number = number / (1 / place.scale) if place.scale < 1 else number * place.scale
            if not math.isfinite(number):
                raise BadMessage(tr("{where} is not a finite number", where=where))
            return number
        # As the real server: a float where the type says integer spoils the message.
        if isinstance(found, float):
            raise BadMessage(tr("{where} is not an integer", where=where))
        if place.leaf.codes and found not in place.leaf.codes:
            raise BadMessage(tr("{where} is out of range", where=where))
        return found


def _as_float(value: Any) -> float:
    """A number; infinite if no float can hold it, 0 if it is none."""
    try:
        return float(value) if isinstance(value, int | float) else 0.0
    except OverflowError:
        return math.inf


def _put(msg: Json, path: tuple[str, ...], value: Any) -> None:
    """Numbers in a path are places of a list."""
    at: Any = msg
    for i, step in enumerate(path):
        last = i == len(path) - 1
        empty: Any = None if last else [] if path[i + 1].isdigit() else {}
        if isinstance(at, list):
            while len(at) <= int(step):
                at.append(0 if last else empty)
            if last:
                at[int(step)] = value
            at = at[int(step)]
        else:
            if last:
                at[step] = value
            at = at.setdefault(step, empty)


_MISSING: Any = object()
"""What is at a path that a message does not have."""


def _byte(text: str, index: int) -> Any:
    """A byte of an array in base 64."""
    try:
        return base64.b64decode(text, validate=True)[index]
    except (ValueError, IndexError):
        return _MISSING


def _get(msg: Any, path: tuple[str, ...]) -> Any:
    at: Any = msg
    for step in path:
        if isinstance(at, dict):
            at = at.get(step, _MISSING)
        elif isinstance(at, list) and step.isdigit() and int(step) < len(at):
            at = at[int(step)]
        elif isinstance(at, str) and step.isdigit():
            return _byte(at, int(step))
        else:
            return at if at is not _MISSING and not isinstance(at, list) else _MISSING
    return at


def _has(msg: Any, path: tuple[str, ...]) -> bool:
    at: Any = msg
    for step in path:
        if isinstance(at, dict) and step in at:
            at = at[step]
        elif isinstance(at, list | str) and step.isdigit() and int(step) < len(at):
            at = at[int(step)]
        else:
            return False
    return True


def _leaves(types: Mapping[str, Json], name: str, label: str = "") -> list[Leaf]:
    entry = types.get(name)
    if entry is None:
        return [Leaf(label, name)]
    if "alias" in entry:
        return _leaves(types, entry["alias"], label)
    if "values" in entry:
        return [Leaf(label, name, frozenset(entry["values"].values()))]
    return [leaf for part in entry["fields"] for leaf in _leaves(types, part["type"], part.get("name", label))]


def _place(leaf: Leaf, place: str | Json) -> Place:
    if isinstance(place, str):
        return Place(tuple(place.split(".")), leaf)
    if "ahead" in place:
        # A field of its own on the robot link.
        return Place(("ahead",), leaf)
    if "ranges" in place:
        return Place(tuple(place["ranges"].split(".")), leaf, ranges=True)
    if "yaw" in place:
        return Place(tuple(place["yaw"].split(".")), leaf, yaw=True)
    return Place(tuple(place["path"].split(".")), leaf, place.get("scale", 1.0), flags="flags" in place)


def _channel(types: Mapping[str, Json], variables: Mapping[str, str], entry: Json) -> Channel:
    ros = entry["ros"]
    leaves = _leaves(types, entry["name"])
    return Channel(
        entry["name"],
        entry["kind"],
        _expanded(ros["topic"], variables),
        _expanded(ros["type"], variables),
        ros.get("latched", False),
        tuple(_place(leaf, place) for leaf, place in zip(leaves, ros["fields"], strict=True)),
        {tuple(path.split(".")): value for path, value in ros.get("also", {}).items()},
        ros.get("header"),
        "holds" in entry,
        entry.get("onDemand", False),
        any(isinstance(place, dict) and "ahead" in place for place in ros["fields"]),
        tuple(ros.get("bytes", ())),
    )


def _expanded(text: str, variables: Mapping[str, str]) -> str:
    for name, value in variables.items():
        text = text.replace("{" + name + "}", value)
    return _expanded(text, variables) if any("{" + name + "}" in text for name in variables) else text


@cache
def simulated_channels() -> Mapping[str, Channel]:
    """The channels of the simulated robot, by name."""
    robot = simulated()
    types = {entry["name"]: entry for entry in robot["types"]}
    variables = next(iter(robot["profiles"].values()))
    return {entry["name"]: _channel(types, variables, entry) for entry in robot["channels"]}
