"""
Patterns of events and commands in lesson files: ``Bumper _ Pressed``, ``Led1 !Black``, ``Velocity <0 _``.

The words are those of Haskell, from the robot's description; a recorded value is the number of the ROS message.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from typing import Any

from ..robot_description import simulated
from ..sentences.sentence import SentenceError, tr

__all__ = ["BadPattern", "ChannelPattern", "channel_pattern"]

Value = float | int | str
_Test = Callable[[Value], bool]

_CLOSE = 1e-6
"""Numbers nearer than this are equal."""


class BadPattern(SentenceError):
    """A pattern does not fit the robot; the text is a sentence."""


class ChannelPattern:
    """A channel, and a test for each of its values."""

    __slots__ = ("_tests", "channel")

    def __init__(self, channel: str, tests: list[_Test]) -> None:
        self.channel = channel
        self._tests = tests

    def matches(self, channel: str, values: tuple[Value, ...]) -> bool:
        """Whether a recorded event or command is of this kind."""
        return channel == self.channel and all(test(value) for test, value in zip(self._tests, values, strict=False))


@cache
def channel_pattern(text: str, of: str) -> ChannelPattern:
    """
    Read a pattern of an ``event`` or a ``command``.

    Raises:
        BadPattern: no such channel, or a value that it cannot have.
    """
    name, *words = text.split()
    channels = {entry["name"]: entry for entry in simulated()["channels"] if entry["kind"] == of}
    if name not in channels:
        raise BadPattern(
            tr("there is no {of} {name}; there are {channels}.", of=of, name=name, channels=list(channels))
        )
    leaves = _leaves(name)
    if len(words) > len(leaves):
        raise BadPattern(
            tr("{name} has {count} values, and here are {found}.", name=name, count=len(leaves), found=len(words))
        )
    return ChannelPattern(name, [_test(word, leaf) for word, leaf in zip(words, leaves, strict=False)])


def _leaves(name: str) -> list[Mapping[str, int] | None]:
    """For each value of a type the codes of its names; ``None`` for a number or a text."""
    types: dict[str, dict[str, Any]] = {entry["name"]: entry for entry in simulated()["types"]}
    entry = types.get(name)
    if entry is None:
        return [None]
    if "alias" in entry:
        return _leaves(entry["alias"])
    if "values" in entry:
        return [entry["values"]]
    return [leaf for part in entry["fields"] for leaf in _leaves(part["type"])]


def _test(word: str, codes: Mapping[str, int] | None) -> _Test:
    if word == "_":
        return lambda _: True
    if word[0] == "!" and len(word) > 1:
        refused = _test(word[1:], codes)
        return lambda value: not refused(value)
    if codes is not None:
        if word not in codes:
            raise BadPattern(tr("{word} is none of {codes}.", word=word, codes=list(codes)))
        code = codes[word]
        return lambda value: value == code
    try:
        if word[0] in "<>":
            bound = float(word[1:])
            if word[0] == "<":
                return lambda value: float(value) < bound - _CLOSE
            return lambda value: float(value) > bound + _CLOSE
        wanted = float(word)
    except ValueError as error:
        raise BadPattern(tr("{word} is neither a number nor _; compare with <0 or >0.", word=word)) from error
    return lambda value: abs(float(value) - wanted) <= _CLOSE
