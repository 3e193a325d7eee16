"""
Encodings of the messages that a rosbridge server sends: PNG, CBOR, CBOR with ROS 1's bytes, and fragments
(rosbridge v2.0 Protocol Specification, section 3.1).

Pure. In: a message. Out: the text or the bytes of its frames.
"""

from __future__ import annotations

import base64
import math
import struct
import zlib
from typing import Any

import msgspec

from .ros_messages import fields_of, serialized

__all__ = ["ENCODINGS", "encode_publish", "fragments", "json_text", "png_text"]

ENCODINGS = ("none", "png", "cbor", "cbor-raw")
"""Of a subscription; of several the last one here wins, as in rosbridge_suite (subscribe.py: update_params)."""

_TAGS = {
    "uint16": (69, "H"), "uint32": (70, "I"), "uint64": (71, "Q"), "byte": (72, "b"), "int8": (72, "b"),
    "int16": (77, "h"), "int32": (78, "i"), "int64": (79, "q"), "float32": (85, "f"), "float64": (86, "d"),
}  # fmt: skip
"""Typed arrays, little-endian: tag (draft-ietf-cbor-array-tags-00, table 1) and format of ``struct``."""

_json = msgspec.json.Encoder()


def json_text(message: Any) -> str:
    """A message as JSON."""
    return _json.encode(message).decode()


def encode_publish(topic: str, kind: str | None, msg: Any, encoding: str, time: float) -> str | bytes:
    """
    The frame of a message on a topic at a time in s. Without a definition of the type there are no typed arrays, and
    CBOR takes the place of bytes.
    """
    frame = {"op": "publish", "topic": topic, "msg": msg}
    if encoding == "png":
        return json_text({"op": "png", "data": png_text(json_text(frame))})
    if encoding == "cbor" or (encoding == "cbor-raw" and (kind is None or fields_of(kind) is None)):
        return _cbor({**frame, "msg": _typed(kind, msg)})
    if encoding == "cbor-raw":
        assert kind is not None
        secs = int(time)
        raw = {"secs": secs, "nsecs": int((time - secs) * 1e9), "bytes": serialized(kind, msg)}
        return _cbor({**frame, "msg": raw})
    return json_text(frame)


def fragments(text: str, size: int, ident: str) -> list[str]:
    """The text itself when it has at most so many characters, or messages with parts of it (3.1.1)."""
    if len(text) <= size:
        return [text]
    parts = [text[i : i + size] for i in range(0, len(text), size)]
    return [
        json_text({"op": "fragment", "id": ident, "data": part, "num": n, "total": len(parts)})
        for n, part in enumerate(parts)
    ]


def png_text(text: str) -> str:
    """A text as a square RGB image filled up with line feeds (pngcompression.py: encode), in base 64."""
    data = text.encode()
    width = max(1, math.isqrt(len(data) // 3))
    height = max(1, math.ceil(len(data) / 3 / width))
    data = data.ljust(width * height * 3, b"\n")
    # Each row begins with its filter: none.
    rows = b"".join(b"\0" + data[y * width * 3 : (y + 1) * width * 3] for y in range(height))
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    image = b"\x89PNG\r\n\x1a\n" + _chunk(b"IHDR", header) + _chunk(b"IDAT", zlib.compress(rows)) + _chunk(b"IEND", b"")
    return base64.b64encode(image).decode()


def _chunk(kind: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


class _Tagged:
    """Bytes under a tag of CBOR."""

    def __init__(self, tag: int, data: bytes) -> None:
        self.tag = tag
        self.data = data


def _typed(kind: str | None, msg: Any) -> Any:
    """A message with typed arrays and bytes in place of lists of numbers and base 64."""
    fields = None if kind is None else fields_of(kind)
    if fields is None or not isinstance(msg, dict):
        return msg
    types = {name: (field, length) for field, name, length in fields}
    return {name: _typed_value(*types[name], value) if name in types else value for name, value in msg.items()}


def _typed_value(kind: str, length: int, value: Any) -> Any:
    if length < 0:
        return float(value) if kind in ("float32", "float64") and isinstance(value, int) else _typed(kind, value)
    if kind in ("uint8", "char"):
        return base64.b64decode(value) if isinstance(value, str) else bytes(value)
    if kind in _TAGS:
        tag, code = _TAGS[kind]
        return _Tagged(tag, struct.pack(f"<{len(value)}{code}", *value))
    return [_typed(kind, item) for item in value]


def _cbor(value: Any) -> bytes:
    """A value in CBOR (RFC 7049)."""
    match value:
        case None:
            return b"\xf6"
        case bool():
            return b"\xf5" if value else b"\xf4"
        case int():
            return _cbor_head(0, value) if value >= 0 else _cbor_head(1, -1 - value)
        case float():
            return b"\xfb" + struct.pack(">d", value)
        case bytes():
            return _cbor_head(2, len(value)) + value
        case str():
            data = value.encode()
            return _cbor_head(3, len(data)) + data
        case list() | tuple():
            return _cbor_head(4, len(value)) + b"".join(map(_cbor, value))
        case dict():
            return _cbor_head(5, len(value)) + b"".join(_cbor(k) + _cbor(v) for k, v in value.items())
        case _Tagged():
            return _cbor_head(6, value.tag) + _cbor(value.data)
        case _:
            raise TypeError(f"{type(value).__name__} is no value of a message")


def _cbor_head(major: int, number: int) -> bytes:
    """The first byte and the number behind it: a value, a length or a tag."""
    if number < 24:
        return bytes([major << 5 | number])
    for code, size, form in ((24, 1, ">B"), (25, 2, ">H"), (26, 4, ">I"), (27, 8, ">Q")):
        if number < 1 << 8 * size:
            return bytes([major << 5 | code]) + struct.pack(form, number)
    raise TypeError("a number of more than 64 bits is no value of a message")
