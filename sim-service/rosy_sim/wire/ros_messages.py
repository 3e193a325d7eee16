"""
The ROS messages the robot speaks, field by field, for ``/rosapi/message_details``: from their definitions in
``rosy-hs/ros/msg`` (ROS 1, noetic).
"""

from __future__ import annotations

import re
from functools import cache

from ..robot_description import ROBOTS
from .channels import simulated_channels

__all__ = ["typedefs"]

_DEFINITIONS = ROBOTS.parent.parent / "rosy-hs" / "ros" / "msg"

_EXAMPLES = {"string": "", "bool": "False", "float64": "0.0", "time": "{}"}

_FIELD = re.compile(r"([\w/]+)(?:\[(\d*)\])?\s+(\w+)\s*(?:#.*)?")

Field = tuple[str, str, int]
"""Type, name and array length: -1 for a single value, 0 for any length."""


@cache
def _fields(kind: str) -> tuple[Field, ...] | None:
    """The fields of a message in wire order; ``None`` for a type that is none."""
    package, _, name = kind.partition("/")
    path = _DEFINITIONS / package / f"{name}.msg"
    if not re.fullmatch(r"\w+/\w+", kind) or not path.is_file():
        return None
    found = filter(None, map(_FIELD.fullmatch, map(str.strip, path.read_text().splitlines())))
    return tuple((_full(m[1], package), m[3], -1 if m[2] is None else int(m[2] or 0)) for m in found)


def _full(kind: str, package: str) -> str:
    """A type with its package; those of ROS itself have none."""
    if kind == "Header":
        return "std_msgs/Header"
    return kind if "/" in kind or kind[0].islower() else f"{package}/{kind}"


def typedefs(kind: str) -> list[dict[str, object]]:
    """A type and all it is made of, as rosapi describes them; empty for a type the robot does not speak."""
    if kind not in _spoken():
        return []
    found: list[dict[str, object]] = []
    waiting = [kind]
    seen: set[str] = set()
    while waiting:
        name = waiting.pop(0)
        fields = _fields(name)
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


@cache
def _spoken() -> frozenset[str]:
    """The types of the robot's topics, and the types that those are made of."""
    found: set[str] = set()
    waiting = {channel.type for channel in simulated_channels().values()}
    while waiting:
        found |= waiting
        waiting = {field for name in waiting for field, _, _ in _fields(name) or ()} - found
    return frozenset(found)


def _example(field: str, length: int) -> str:
    if length >= 0:
        return "[]"
    return "{}" if "/" in field else _EXAMPLES.get(field, "0")
