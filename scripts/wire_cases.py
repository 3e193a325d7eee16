"""
Cases of the messages of the service, for the decoders of the page: ``protocol/goldens/messages.jsonl``.

In: the structs that `wire_typescript` reads. Out: a line for each case. One with ``value`` is a message as the service encodes it, and
what the page reads of it; one without is no message to the service's types, and the page refuses it. The values are random with a fixed
seed. With ``--check`` nothing is written, and the exit code says whether the file is up to date.
"""

from __future__ import annotations

import json
import random
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import msgspec
from msgspec import inspect as mi

from wire_typescript import ROOT, answers, camel, default_of, held, members_of

FILE = Path("protocol/goldens/messages.jsonl")

TEXTS = ["", " ", "main = simulate (Velocity 0.1 0)", "Zoë 🤖", "<b>", "__proto__"]
NUMBERS = [0.5, -3.25, 1e-09, 1e308, 20.5]
WRONG = [None, True, 1.5, "wrong", [], {}, ["wrong"], {"wrong": 1}]

Json = object


def text(dice: random.Random, info: mi.StrType) -> str:
    found = dice.choice(TEXTS)
    return (found if info.pattern is None else "program-1")[: info.max_length] or "x" * (info.min_length or 0)


def number(dice: random.Random, info: mi.IntType | mi.FloatType) -> float:
    """Within the limits; whole numbers have those of both languages."""
    low, high = info.ge if info.ge is not None else -1, info.le if info.le is not None else 2**53
    if isinstance(info, mi.IntType):
        return dice.choice([int(low), int(high), 0, 1, 2])
    return dice.choice([value for value in NUMBERS if low <= value and (info.le is None or value <= high)])


def value(dice: random.Random, info: mi.Type, depth: int = 0) -> Json:
    """A random value of a type, as JSON."""
    info = held(info)
    sizes = [0, 1, 2] if depth < 6 else [0]
    match info:
        case mi.StructType():
            fields = {field.encode_name: value(dice, field.type, depth + 1) for field in info.fields if field.required or dice.random() < 0.6}
            if info.array_like:
                return [value(dice, field.type, depth + 1) for field in info.fields]
            return fields if info.tag is None else {str(info.tag_field): info.tag, **fields}
        case mi.StrType():
            return text(dice, info)
        case mi.IntType() | mi.FloatType():
            return number(dice, info)
        case mi.BoolType():
            return dice.random() < 0.5
        case mi.NoneType():
            return None
        case mi.AnyType() | mi.RawType():
            return {"any": [1, None]}
        case mi.LiteralType():
            return dice.choice(info.values)
        case mi.ListType():
            return [value(dice, info.item_type, depth + 1) for _ in range(max(info.min_length or 0, dice.choice(sizes)))]
        case mi.TupleType():
            return [value(dice, item, depth + 1) for item in info.item_types]
        case mi.DictType():
            return {text(dice, mi.StrType()): value(dice, info.value_type, depth + 1) for _ in range(dice.choice(sizes))}
        case mi.UnionType():
            nothing = [mi.NoneType()] * info.includes_none
            return value(dice, dice.choice([*members_of(info), *nothing] if depth < 6 else [*nothing, *members_of(info)][:1]), depth)
    raise TypeError(f"no value for {info}")


def read(info: mi.Type, said: Json) -> Json:
    """What the page reads of a message: fields in camel case, what was left out filled in, rows as objects."""
    info = held(info)
    match info:
        case mi.StructType():
            names = [field.encode_name for field in info.fields]
            given = dict(zip(names, said, strict=True)) if isinstance(said, list) else dict(said)  # type: ignore[call-overload]
            tag = {} if info.tag is None else {str(info.tag_field): info.tag}
            return tag | {
                camel(field.encode_name): read(field.type, given[field.encode_name]) if field.encode_name in given else default_of(field)
                for field in info.fields
            }
        case mi.ListType() if isinstance(said, list):
            return [read(info.item_type, each) for each in said]
        case mi.DictType() if isinstance(said, dict):
            return {name: read(info.value_type, each) for name, each in said.items()}
        case mi.UnionType() if isinstance(said, dict | list):
            wanted = mi.ListType if isinstance(said, list) else mi.StructType | mi.DictType
            return next((read(each, said) for each in members_of(info) if isinstance(held(each), wanted)), said)
    return said


def damaged(dice: random.Random, message: Json) -> Json:
    """The message with one of its values, on any level, replaced or left out."""
    copy = json.loads(json.dumps(message))
    places = list(_places(copy, dice))
    dice.choice(places)()
    return copy


def _places(within: Json, dice: random.Random) -> Iterator[Callable[[], None]]:
    entries = within.items() if isinstance(within, dict) else enumerate(within) if isinstance(within, list) else []
    for key, inner in list(entries):
        if key != "op":
            yield lambda key=key: within.__setitem__(key, dice.choice(WRONG))  # type: ignore[attr-defined,misc]
            if isinstance(within, dict):
                yield lambda key=key: within.__delitem__(key)  # type: ignore[attr-defined,misc]
        yield from _places(inner, dice)


def cases() -> Iterator[dict[str, Json]]:
    for name, union in answers():
        decoder = msgspec.json.Decoder(union)
        for struct in mi.type_info(union).types:  # type: ignore[attr-defined]
            # Each message has its own seed, so that a change of one leaves the others as they are.
            dice = random.Random(f"{name} {struct.tag}")
            for _ in range(3):
                message = msgspec.json.decode(msgspec.json.encode(decoder.decode(msgspec.json.encode(value(dice, struct)))))
                yield {"type": name, "message": message, "value": read(struct, message)}
                for wrong in (damaged(dice, message) for _ in range(3) if struct.fields):
                    try:
                        decoder.decode(json.dumps(wrong))
                    except msgspec.ValidationError:
                        yield {"type": name, "message": wrong}


def file_text() -> str:
    unique = dict.fromkeys(json.dumps(case, ensure_ascii=False, separators=(",", ":")) for case in cases())
    return "".join(f"{line}\n" for line in unique)


def main() -> int:
    text = file_text()
    if "--check" not in sys.argv:
        (ROOT / FILE).write_text(text)
    elif not (ROOT / FILE).exists() or (ROOT / FILE).read_text() != text:
        print(f"{FILE} is not up to date: run .rosy/venv/bin/python scripts/wire_cases.py")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
