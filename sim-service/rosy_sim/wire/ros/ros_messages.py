"""
ROS 1 message types by their definitions in ``rosy-hs/ros/msg`` (noetic): their fields, whether a message fits, its
bytes.

In: the name of a type, and messages as rosbridge writes them. A type whose definition is not there is ``None``. A
message fits when rosbridge_suite says so (message_conversion.py, ros1 0.11.17): fields may be absent, no field may be
unknown, a float does not fit an integer.
"""

from __future__ import annotations

import base64
import binascii
import re
import struct
from functools import cache
from typing import Any

from ...robot_description import ROBOTS
from ...text_lines import text_lines
from ..channels import simulated_channels

__all__ = [
    "Field",
    "completed",
    "definition_fields",
    "definition_text",
    "fields_of",
    "message_fault",
    "serialized",
    "typedefs",
]

_DEFINITIONS = ROBOTS.parent.parent / "rosy-hs" / "ros" / "msg"

_EXAMPLES = {"string": "", "bool": "False", "float64": "0.0", "time": "{}"}

_FIELD = re.compile(r"([\w/]+)(?:\[(\d*)\])?\s+(\w+)\s*(?:#.*)?")

_INTEGERS = {
    "int8": "b", "byte": "b", "uint8": "B", "char": "B", "int16": "h", "uint16": "H", "int32": "i", "uint32": "I",
    "int64": "q", "uint64": "Q",
}  # fmt: skip
"""Formats of ``struct``."""

_FLOATS = {"float32": "f", "float64": "d"}
_TIMES = {"time": "II", "duration": "ii"}
_BYTES = frozenset({"uint8", "char"})
"""Arrays of these are base 64 in JSON."""

Field = tuple[str, str, int]
"""Type, name and array length: -1 for a single value, 0 for any length."""


@cache
def fields_of(kind: str) -> tuple[Field, ...] | None:
    """The fields of a message in wire order; ``None`` for a type without a definition here."""
    text = _definition(kind)
    if text is None:
        return None
    return definition_fields(text, kind.partition("/")[0])


def definition_fields(text: str, package: str) -> tuple[Field, ...]:
    """The fields in a definition of a message of this package, in wire order."""
    found = filter(None, map(_FIELD.fullmatch, map(str.strip, text_lines(text))))
    return tuple((_full(m[1], package), m[3], -1 if m[2] is None else int(m[2] or 0)) for m in found)


@cache
def _definition(kind: str) -> str | None:
    package, _, name = kind.partition("/")
    path = _DEFINITIONS / package / f"{name}.msg"
    return path.read_text() if re.fullmatch(r"\w+/\w+", kind) and path.is_file() else None


def _full(kind: str, package: str) -> str:
    """A type with its package; those of ROS itself have none."""
    if kind == "Header":
        return "std_msgs/Header"
    return kind if "/" in kind or kind[0].islower() else f"{package}/{kind}"


def typedefs(kind: str) -> list[dict[str, object]]:
    """A type and all it is made of, as rosapi describes them; empty for a type the robot does not speak."""
    return [
        {
            "type": name,
            "fieldnames": [field for _, field, _ in fields],
            "fieldtypes": [field for field, _, _ in fields],
            "fieldarraylen": [length for _, _, length in fields],
            "examples": [_example(field, length) for field, _, length in fields],
            "constnames": [],
            "constvalues": [],
        }
        for name, fields in (_parts(kind) if kind in _spoken() else [])
    ]


@cache
def definition_text(kind: str) -> str:
    """A definition and those that it is made of in one text, as ``gendeps --cat`` and bag files write it."""
    texts: list[str] = []
    for name, _ in _parts(kind):
        text = (_definition(name) or "").rstrip("\n") + "\n"
        texts.append(text if not texts else f"MSG: {name}\n{text}")
    return f"\n{'=' * 80}\n".join(texts)


def _parts(kind: str) -> list[tuple[str, tuple[Field, ...]]]:
    """A type with its fields, then those that it is made of."""
    found: dict[str, tuple[Field, ...]] = {}
    waiting = [kind]
    while waiting:
        name = waiting.pop(0)
        fields = fields_of(name)
        if fields is not None and name not in found:
            found[name] = fields
            waiting += [field for field, _, _ in fields]
    return list(found.items())


@cache
def _spoken() -> frozenset[str]:
    """The types of the robot's topics, and the types that those are made of."""
    return frozenset(name for channel in simulated_channels().values() for name, _ in _parts(channel.type))


def _example(field: str, length: int) -> str:
    if length >= 0:
        return "[]"
    return "{}" if "/" in field else _EXAMPLES.get(field, "0")


# Whether a message fits


def message_fault(kind: str, msg: Any) -> str | None:
    """Why a message does not fit a type, as rosbridge_suite says it. ``None``: it fits, or there is no definition."""
    return None if fields_of(kind) is None else _fault(kind, -1, msg, kind, [])


def _fault(kind: str, length: int, value: Any, root: str, path: list[str]) -> str | None:
    if length >= 0:
        return _array_fault(kind, length, value, root, path)
    if kind in _TIMES:
        is_time = value == "now" or (
            isinstance(value, dict)
            and value.keys() <= {"secs", "nsecs"}
            and all(_is_integer(n, _TIMES[kind][0]) for n in value.values())
        )
        return None if is_time else _mismatch(kind, value, root, path)
    if "/" not in kind:
        return None if _is_primitive(kind, value) else _mismatch(kind, value, root, path)
    if not isinstance(value, dict):
        return _mismatch(kind, value, root, path)
    fields = {name: (field, n) for field, name, n in fields_of(kind) or ()}
    for name, inner in value.items():
        if name not in fields:
            return f"Message type {root} does not have a field {'.'.join([*path, str(name)])}"
        why = _fault(*fields[name], inner, root, [*path, name])
        if why is not None:
            return why
    return None


def _array_fault(kind: str, length: int, value: Any, root: str, path: list[str]) -> str | None:
    if kind in _BYTES and isinstance(value, str):
        try:
            value = list(base64.b64decode(value, validate=True))
        except (binascii.Error, ValueError):
            return _mismatch(f"{kind}[]", value, root, path)
    if not isinstance(value, list) or (length > 0 and len(value) != length):
        return _mismatch(f"{kind}[{length or ''}]", value, root, path)
    return next((why for item in value if (why := _fault(kind, -1, item, root, path)) is not None), None)


def _mismatch(kind: str, value: Any, root: str, path: list[str]) -> str:
    where = f" for the field {'.'.join(path)}" if path else ""
    return f"{root} message requires a {kind}{where}, but got a {type(value).__name__}"


def _is_primitive(kind: str, value: Any) -> bool:
    if kind in _INTEGERS:
        return _is_integer(value, _INTEGERS[kind])
    if kind in _FLOATS:
        return isinstance(value, int | float) and not isinstance(value, bool)
    return isinstance(value, bool if kind == "bool" else str)


def _is_integer(value: Any, code: str) -> bool:
    if not isinstance(value, int) or isinstance(value, bool):
        return False
    bits = 8 * struct.calcsize("<" + code)
    return -(1 << bits - 1) <= value < 1 << bits - 1 if code.islower() else 0 <= value < 1 << bits


def completed(kind: str, msg: Any) -> Any:
    """A message that fits its type with all fields; those that were absent are zero, as ROS fills them in."""
    fields = fields_of(kind)
    if fields is None:
        return msg
    return {name: _completed(field, length, msg.get(name)) for field, name, length in fields}


def _completed(kind: str, length: int, value: Any) -> Any:
    if length >= 0:
        if kind in _BYTES:
            return value if isinstance(value, str) else base64.b64encode(bytes(value or length)).decode()
        return [_completed(kind, -1, item) for item in (value if value is not None else [None] * length)]
    if kind in _TIMES:
        return {"secs": 0, "nsecs": 0, **value} if isinstance(value, dict) else {"secs": 0, "nsecs": 0}
    if "/" in kind:
        return completed(kind, value if isinstance(value, dict) else {})
    if value is not None:
        return value
    return "" if kind == "string" else False if kind == "bool" else 0.0 if kind in _FLOATS else 0


# The bytes of a message


def serialized(kind: str, msg: Any) -> bytes:
    """A message that fits its type in ROS 1's serialization format; what is absent is zero."""
    return b"".join(_value_bytes(field, n, msg.get(name)) for field, name, n in fields_of(kind) or ())


def _value_bytes(kind: str, length: int, value: Any) -> bytes:
    if length >= 0:
        if kind in _BYTES and isinstance(value, str):
            value = base64.b64decode(value)
        items = value if value is not None else [None] * length
        count = b"" if length else struct.pack("<I", len(items))
        return count + b"".join(_value_bytes(kind, -1, item) for item in items)
    if kind in _TIMES:
        time = value if isinstance(value, dict) else {}
        return struct.pack("<" + _TIMES[kind], time.get("secs", 0), time.get("nsecs", 0))
    if kind in _INTEGERS:
        return struct.pack("<" + _INTEGERS[kind], value or 0)
    if kind in _FLOATS:
        return struct.pack("<" + _FLOATS[kind], value or 0.0)
    if kind == "bool":
        return struct.pack("<?", value or False)
    if kind == "string":
        text = (value or "").encode()
        return struct.pack("<I", len(text)) + text
    return serialized(kind, value if isinstance(value, dict) else {})
