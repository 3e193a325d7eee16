"""
Functions that a program simulates, with the types of what they take and give, from a check's ``graph``.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import msgspec

from .why_not import FunctionType

__all__ = ["function_types"]


class _Part(msgspec.Struct):
    """A part of the network, ``protocol/README.md`` §3, *Graph*."""

    kind: str
    name: str = ""
    inputs: list[Any] = []
    output: Any = None
    start: list[_Part] = []
    parts: list[_Part] = []
    steps: list[_Part] = []


class _Graph(msgspec.Struct):
    parts: list[_Part] = []


def function_types(graph: msgspec.Raw | bytes) -> list[FunctionType]:
    """All functions at work in a program, those of its tasks as well."""
    return [function for part in msgspec.json.decode(graph, type=_Graph).parts for function in _functions(part, None)]


def _functions(part: _Part, task: _Part | None, is_start: bool = False) -> Iterator[FunctionType]:
    """``task`` is the innermost one that the part belongs to."""
    if part.kind == "function":
        inputs = tuple(_written(shape) for shape in part.inputs)
        mates = () if task is None else tuple(one.name for one in [*task.start, *task.parts] if one.kind == "function")
        yield FunctionType(part.name, inputs, tuple(_flat(part.output)), mates, is_start)
    inside = part if part.kind == "task" else task
    for inner in part.start:
        yield from _functions(inner, inside, is_start=True)
    for inner in [*part.parts, *part.steps]:
        yield from _functions(inner, inside)


def _written(shape: Any) -> str:
    """A Shape as a type: ``{"either": [A, B]}`` as ``Either A B``."""
    match shape:
        case {"type": str(written)}:
            return str(shape.get("is", written))
        case {"maybe": inner}:
            return f"Maybe {_argument(inner)}"
        case {"each": inner}:
            return f"[{_written(inner)}]"
        case {"all": inner}:
            return "(" + ", ".join(_written(one) for one in inner) + ")"
        case {"either": [first, *rest]}:
            return f"Either {_argument(first)} {_argument({'either': rest} if len(rest) > 1 else rest[0])}"
    return "()"


def _argument(shape: Any) -> str:
    text = _written(shape)
    return f"({text})" if " " in text and not text.startswith(("(", "[")) else text


def _flat(shape: Any) -> Iterator[str]:
    """The types that an output may give."""
    match shape:
        case {"type": str(written)}:
            yield str(shape.get("is", written))
        case {"maybe": inner} | {"each": inner}:
            yield from _flat(inner)
        case {"all": inner} | {"either": inner}:
            for one in inner:
                yield from _flat(one)
