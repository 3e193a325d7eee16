"""The typed graph of a program, as a check of the compiler gives it (protocol section 3), read for lessons."""

from __future__ import annotations

import re

import msgspec

__all__ = ["GraphFunction", "ProgramGraph", "read_graph"]

_TYPE_NAME = re.compile(r"[A-Z][A-Za-z0-9_']*")


class GraphFunction(msgspec.Struct, frozen=True):
    """A function with the types of what it takes and sends, as Haskell writes them."""

    name: str
    inputs: list[str] = []
    outputs: list[str] = []

    def takes(self, types: list[str]) -> bool:
        """Whether all these types occur in its inputs."""
        return set(types) <= _names(self.inputs)

    def gives(self, types: list[str]) -> bool:
        """Whether all these types occur in its outputs."""
        return set(types) <= _names(self.outputs)


class ProgramGraph(msgspec.Struct, frozen=True):
    """All functions of a program."""

    functions: list[GraphFunction] = []

    @property
    def own(self) -> list[GraphFunction]:
        """The functions without ``main``."""
        return [function for function in self.functions if function.name != "main"]


def read_graph(data: msgspec.Raw | bytes) -> ProgramGraph:
    """A graph from the worker's answer."""
    return msgspec.json.decode(data, type=ProgramGraph)


def _names(types: list[str]) -> set[str]:
    return {name for text in types for name in _TYPE_NAME.findall(text)}
