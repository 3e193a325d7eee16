"""
Fuzzer of messages and files in JSON: valid values are generated from their msgspec types or taken from seeds, and then
damaged.

Damage is structural (a value is replaced, dropped, repeated, renamed, nested) or in the bytes (cut, flipped, repeated,
not UTF-8). Everything follows from the seed of the random generator, so that a case can be repeated.
"""

from __future__ import annotations

import copy
import json
import random
import string
from collections.abc import Sequence
from typing import Any

import msgspec
import msgspec.inspect as inspect

__all__ = ["Fuzzer", "damaged_bytes", "generated"]

_TEXTS = (
    "",
    " ",
    "\x00",
    "\x1b]0;x\x07",
    "\ud800",
    "\u202eevil",
    "a\u2028b",
    "../../etc/passwd",
    "<script>alert(1)</script>",
    "%s%n{0}{name}",
    "/mobile_base/commands/velocity",
    "/odom",
    "std_msgs/String",
    "ü" * 300,
    "main = simulate (Velocity 0.1 0)",
    "null",
    "-1",
)

_NUMBERS: tuple[Any, ...] = (
    0,
    -1,
    1,
    2,
    3,
    255,
    65536,
    2**31,
    2**53 + 1,
    2**63,
    2**64,
    -(2**63) - 1,
    10**400,
    0.1,
    -0.0,
    5e-324,
    1e308,
    -1e308,
)

_HOSTILE: tuple[Any, ...] = (None, True, False, [], {}, [[]], {"": ""}, [0] * 1000, *_NUMBERS, *_TEXTS)


def generated(kind: Any, rng: random.Random, depth: int = 0) -> Any:
    """A JSON value of a msgspec type; numbers and texts are often at the edges of what is allowed."""
    found = kind if isinstance(kind, inspect.Type) else inspect.type_info(kind)
    match found:
        case inspect.StructType():
            value: dict[str, Any] = {} if found.tag_field is None else {found.tag_field: found.tag}
            for field in found.fields:
                if field.required or (depth < 4 and rng.random() < 0.5):
                    value[field.encode_name] = generated(field.type, rng, depth + 1)
            return list(value.values()) if found.array_like else value
        case inspect.UnionType():
            return generated(rng.choice(found.types), rng, depth)
        case inspect.ListType() | inspect.VarTupleType() | inspect.SetType():
            return [
                generated(found.item_type, rng, depth + 1)
                for _ in range(rng.choice((0, 1, 2, 5) if depth < 4 else (0, 1)))
            ]
        case inspect.TupleType():
            return [generated(item, rng, depth + 1) for item in found.item_types]
        case inspect.DictType():
            return {_text(rng): generated(found.value_type, rng, depth + 1) for _ in range(rng.randrange(3))}
        case inspect.LiteralType():
            return rng.choice(found.values)
        case inspect.EnumType():
            return rng.choice([member.value for member in found.cls])
        case inspect.BoolType():
            return rng.random() < 0.5
        case inspect.IntType():
            return rng.choice((0, 1, 2, 7, -1, 100, 2**31, 2**53))
        case inspect.FloatType():
            return rng.choice((0, 0.5, 1, -3.25, 1e9, 1e-9, 1e308))
        case inspect.StrType():
            return _text(rng)
        case inspect.NoneType():
            return None
        case _:
            return _hostile(rng)


def _hostile(rng: random.Random) -> Any:
    return copy.deepcopy(rng.choice(_HOSTILE))


def _text(rng: random.Random) -> str:
    return (
        rng.choice(_TEXTS)
        if rng.random() < 0.4
        else "".join(rng.choices(string.ascii_letters + "/_ ", k=rng.randrange(12)))
    )


def _places(value: Any, found: list[tuple[Any, Any]], room: int = 400) -> None:
    """Containers with a key of each, at most ``room``."""
    children = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, child in children:
        if len(found) >= room:
            return
        found.append((value, key))
        _places(child, found, room)


def _damage(value: Any, rng: random.Random, others: Sequence[Any]) -> Any:
    """The value with one structural fault. It is changed in place where that is possible."""
    found: list[tuple[Any, Any]] = []
    _places(value, found)
    if not found:
        return _hostile(rng)
    holder, key = rng.choice(found)
    way = rng.randrange(7)
    if way <= 1:
        holder[key] = _hostile(rng)
    elif way == 2:
        del holder[key]
    elif way == 3:
        other: list[tuple[Any, Any]] = []
        _places(rng.choice(others), other)
        if other:
            giver, place = rng.choice(other)
            holder[key] = copy.deepcopy(giver[place])
    elif way == 4:
        if isinstance(holder, dict):
            holder[rng.choice((key + "s", "", "op", "__proto__", _text(rng)))] = (
                holder[key] if rng.random() < 0.5 else holder.pop(key)
            )
        else:
            holder[key:key] = [holder[key]] * rng.choice((1, 2, 1000))
    elif way == 5:
        for _ in range(rng.choice((1, 2, 10))):
            holder[key] = [holder[key]] if rng.random() < 0.5 else {"a": holder[key]}
    else:
        holder[key] = str(holder[key]) if rng.random() < 0.5 else [holder[key]]
    return value


def damaged_bytes(data: bytes, rng: random.Random) -> bytes:
    """The bytes with one fault."""
    place = rng.randrange(len(data) + 1)
    end = min(len(data), place + rng.choice((1, 2, 8, 64)))
    match rng.randrange(8):
        case 0:
            return data[:place]
        case 1:
            return data[:place] + bytes([rng.randrange(256)]) + data[place + 1 :]
        case 2:
            return data[:place] + data[end:]
        case 3:
            return data[:place] + data[place:end] * rng.choice((2, 3, 300)) + data[end:]
        case 4:
            return (
                data[:place]
                + rng.choice(
                    (
                        b"\xff",
                        b"\xed\xa0\x80",
                        b"\x00",
                        b"\xef\xbb\xbf",
                        b"NaN",
                        b"Infinity",
                        b"1e999",
                        b'"',
                        b"\\",
                        b"\\ud800",
                    )
                )
                + data[place:]
            )
        case 5:
            # Deeper than any recursion.
            return data[:place] + rng.choice((b"[", b'{"a":')) * rng.choice((60, 5_000, 200_000)) + data[place:]
        case 6:
            return data + data
        case _:
            return data.replace(b'"', b"'", 1) if rng.random() < 0.5 else data.replace(b":", b",", 1)


class Fuzzer:
    """Cases around valid values: of the type ``kind``, and ``seeds``."""

    def __init__(self, rng: random.Random, kind: Any = None, seeds: Sequence[Any] = ()) -> None:
        self._rng = rng
        self._kind = None if kind is None else inspect.type_info(kind)
        self._seeds = seeds

    def value(self) -> Any:
        """A valid value, or one with one to three structural faults."""
        rng = self._rng
        fresh = self._kind is not None and (not self._seeds or rng.random() < 0.6)
        value = generated(self._kind, rng) if fresh else copy.deepcopy(rng.choice(self._seeds))
        others = self._seeds or (value,)
        for _ in range(rng.choice((0, 1, 1, 1, 2, 3))):
            value = _damage(value, rng, others)
        return value

    def case(self) -> bytes:
        """The bytes of such a value, one in five with faults in the bytes as well."""
        data = encoded(self.value())
        if self._rng.random() < 0.2:
            for _ in range(self._rng.choice((1, 1, 2))):
                data = damaged_bytes(data, self._rng)
        return data


def encoded(value: Any) -> bytes:
    """JSON that may hold what a strict encoder refuses: large whole numbers, half surrogates."""
    try:
        return msgspec.json.encode(value)
    except (msgspec.MsgspecError, UnicodeEncodeError, OverflowError):
        return json.dumps(value).encode()
