"""
Messages of ROS 2, and between them and rosbridge's JSON.

Types are made from definitions and are encoded (CDR) by Cyclone DDS, also those that Zenoh carries. A field that a
message does not have is zero, an empty text or an empty list; a header without a time has that of now, because
controllers ignore velocities that are old (ros2_controllers, diff_drive_controller). Arrays of bytes are base 64 in
JSON, and are read as lists too.
"""

from __future__ import annotations

import base64
import binascii
from collections.abc import Callable
from functools import cache
from typing import Any

from cyclonedds.idl import make_idl_struct
from cyclonedds.idl.types import (
    array,
    float32,
    float64,
    int8,
    int16,
    int32,
    int64,
    sequence,
    uint8,
    uint16,
    uint32,
    uint64,
)

from .dds_names import dds_message_type
from .definitions import ros2_fields

__all__ = ["BadMessage", "decode", "encode", "from_json", "message_class", "to_json", "unreadable", "with_header"]

_PRIMITIVES: dict[str, Any] = {
    "bool": bool, "string": str, "byte": uint8, "char": uint8, "int8": int8, "uint8": uint8, "int16": int16,
    "uint16": uint16, "int32": int32, "uint32": uint32, "int64": int64, "uint64": uint64, "float32": float32,
    "float64": float64,
}  # fmt: skip

_BOUNDS = {
    **{f"int{bits}": (-(2 ** (bits - 1)), 2 ** (bits - 1) - 1) for bits in (8, 16, 32, 64)},
    **{f"uint{bits}": (0, 2**bits - 1) for bits in (8, 16, 32, 64)},
    "byte": (0, 255),
    "char": (0, 255),
}

_BYTES = frozenset({"uint8", "char"})

_HEADER = "std_msgs/Header"

Now = Callable[[], tuple[int, int]]
"""The time of day: s since 1970 and ns."""


class BadMessage(Exception):
    """A message does not fit its type; says where and why, in the words of rosbridge's users, who write programs."""


@cache
def message_class(kind: str) -> Any | None:
    """The class of a message type, or of a part of a service or action; ``None`` without its definition."""
    return _class(kind, {})


@cache
def with_header(kind: str) -> Any | None:
    """
    The class of a service's request or response behind the header that Cyclone DDS's services have (rmw_cyclonedds,
    serdata.hpp): who calls, and the number of the call.
    """
    return _class(kind, {"rosy_client": uint64, "rosy_number": int64})


def _class(kind: str, header: dict[str, Any]) -> Any | None:
    fields = ros2_fields(kind)
    if fields is None:
        return None
    types = {name: _annotation(field, length) for field, name, length in fields}
    if any(kind is None for kind in types.values()):
        return None
    # A structure of IDL has a member, so ROS 2 gives it one.
    return make_idl_struct(
        kind.replace("/", "_"),
        dds_message_type(kind).replace("::", "."),
        header | (types or {"structure_needs_at_least_one_member": uint8}),
    )


def _annotation(field: str, length: int) -> Any | None:
    inner = _PRIMITIVES[field] if field in _PRIMITIVES else message_class(field) if "/" in field else None
    if inner is None or length < 0:
        return inner
    return array[inner, length] if length else sequence[inner]


def encode(message: Any) -> bytes:
    """A message as CDR behind its header of four bytes (RTPS 2.5, 10.2), as ROS 2 sends it over DDS and Zenoh."""
    return bytes(message.serialize(use_version_2=False))


def decode(kind: str, payload: bytes) -> Any:
    """
    The message of a type.

    Raises:
        BadMessage: there is another one, or none.
    """
    try:
        # A definition of another year may have fewer fields: what is missing in the last word is zero, as in DDS.
        whole = payload + b"\0" * (-len(payload) % 4)
        return message_class(kind).deserialize(whole)  # type: ignore[union-attr]
    except Exception as why:
        raise unreadable(kind) from why


def unreadable(kind: str) -> BadMessage:
    """What arrives in place of a type's message has other bytes."""
    return BadMessage(f"what arrives is no {kind}")


def to_json(kind: str, message: Any) -> dict[str, Any]:
    """A message of a type as rosbridge has it; numbers that JSON lacks stay."""
    return {name: _json_field(field, length, getattr(message, name)) for field, name, length in ros2_fields(kind) or ()}


def _json_field(field: str, length: int, value: Any) -> Any:
    if length >= 0 and field in _BYTES:
        return base64.b64encode(bytes(value)).decode()
    if "/" in field:
        return [to_json(field, entry) for entry in value] if length >= 0 else to_json(field, value)
    return list(value) if length >= 0 else value


def from_json(kind: str, value: Any, now: Now) -> Any:
    """
    The message of a type.

    Raises:
        BadMessage: it does not fit.
    """
    return _message(kind, value, now, message_class(kind), kind)


def _message(kind: str, value: Any, now: Now, made: Any, path: str) -> Any:
    if not isinstance(value, dict):
        raise BadMessage(f"{path} is not an object")
    fields = ros2_fields(kind) or ()
    unknown = value.keys() - {name for _, name, _ in fields}
    if unknown:
        raise BadMessage(f"{path} does not have a field {min(unknown)}")
    parts = {name: _field(field, length, value.get(name), now, f"{path}.{name}") for field, name, length in fields}
    if kind == _HEADER and "stamp" not in value:
        parts["stamp"].sec, parts["stamp"].nanosec = now()
    return made(**(parts or {"structure_needs_at_least_one_member": 0}))


def _field(field: str, length: int, value: Any, now: Now, path: str) -> Any:
    if length < 0:
        return _single(field, value, now, path)
    if value is None:
        return [_single(field, None, now, path) for _ in range(length)]
    if isinstance(value, str) and field in _BYTES:
        try:
            value = list(base64.b64decode(value, validate=True))
        except binascii.Error:
            raise BadMessage(f"{path} is not base 64") from None
    if not isinstance(value, list):
        raise BadMessage(f"{path} is not a list")
    if length and len(value) != length:
        raise BadMessage(f"{path} has {len(value)} entries for {length}")
    return [_single(field, entry, now, path) for entry in value]


def _single(field: str, value: Any, now: Now, path: str) -> Any:
    if "/" in field:
        return _message(field, {} if value is None else value, now, message_class(field), path)
    if field == "string":
        if not isinstance(value, str | None):
            raise BadMessage(f"{path} is not a string")
        return value or ""
    if field == "bool":
        if not isinstance(value, bool | None):
            raise BadMessage(f"{path} is not a bool")
        return bool(value)
    if value is None:
        return 0
    if field in _BOUNDS:
        least, most = _BOUNDS[field]
        if isinstance(value, bool) or not isinstance(value, int) or not least <= value <= most:
            raise BadMessage(f"{path} is not a {field}")
        return value
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise BadMessage(f"{path} is not a number")
    return float(value)
