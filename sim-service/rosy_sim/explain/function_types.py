"""
Types that a program writes, from a check's ``graph``: those of the functions that it simulates, and the synonyms under
which it writes its memories.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

import msgspec

from ..wire.explanation import Sentence
from .why_not import FunctionType

__all__ = ["function_types", "with_synonyms", "written_memories"]


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


def written_memories(graph: msgspec.Raw | bytes) -> dict[str, str]:
    """
    How a program writes the types of its memories where it uses a synonym: ``Memory Bool`` is ``Memory Hit``. A type
    that it writes under two synonyms is one memory and keeps its own name. The keys are as a run tells the types.
    """
    written: dict[str, set[str]] = {}
    for shape in _shapes(msgspec.json.decode(graph, type=_Graph).parts):
        spelled, name = str(shape.get("is", shape["type"])), str(shape["type"])
        if spelled.startswith(("Memory ", "Param ")) and name != spelled:
            written.setdefault(_as_run_tells(spelled), set()).add(name)
    return {spelled: name for spelled, (name, *others) in written.items() if not others}


def with_synonyms(sentence: Sentence, memories: dict[str, str]) -> Sentence:
    """A sentence with memories as the program writes their types. See ``written_memories``."""
    types = [memories.get(kind, kind) for kind in sentence.types]
    return msgspec.structs.replace(sentence, type=memories.get(sentence.type, sentence.type), types=types)


def _as_run_tells(spelled: str) -> str:
    """The compiler writes ``String``, a run ``[Char]``."""
    return re.sub(r"\bString\b", "[Char]", spelled)


def _shapes(parts: list[_Part]) -> Iterator[dict[str, Any]]:
    """All single types that functions take and give."""
    for part in parts:
        for shape in [*part.inputs, part.output]:
            yield from _types(shape)
        yield from _shapes([*part.start, *part.parts, *part.steps])


def _types(shape: Any) -> Iterator[dict[str, Any]]:
    match shape:
        case {"type": str()}:
            yield shape
        case {"maybe": inner} | {"each": inner}:
            yield from _types(inner)
        case {"all": inner} | {"either": inner}:
            for one in inner:
                yield from _types(one)


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
    return (str(one.get("is", one["type"])) for one in _types(shape))
