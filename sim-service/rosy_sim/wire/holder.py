"""
What ``rosy-robot`` tells of a robot it holds, and what it is asked. ``protocol/README.md``, section 7.
"""

from __future__ import annotations

from typing import Literal

import msgspec

from .problem import Problem
from .shown import Sight, Tone, Words

__all__ = [
    "EndedLine",
    "FrameLine",
    "HoldingLine",
    "Line",
    "LinkLine",
    "SaidLine",
    "SoundLine",
    "StoppedLine",
    "ask",
    "read_line",
]


class HoldingLine(msgspec.Struct, tag="holding", tag_field="op"):
    """The first line: how the robot is driven. m/s, rad/s."""

    safety: bool
    max_speed: float
    max_turn: float


class LinkLine(msgspec.Struct, tag="link", tag_field="op"):
    """How the way to the robot is."""

    link: Literal["connecting", "connected", "lost"]
    why: str


class FrameLine(Sight, tag="frame", tag_field="op"):
    """The robot by its odometry, from where the run began."""

    backing: bool


class SaidLine(Words, tag="said", tag_field="op"):
    """A line for the console."""


class SoundLine(Tone, tag="sound", tag_field="op"):
    """A sound to play."""


class EndedLine(msgspec.Struct, tag="ended", tag_field="op"):
    """A program has ended; one line for each that was run, in their order."""

    time: float
    how: Literal["done", "error", "broken", "stopped", "stuck", "died", "lost"]
    problem: Problem | None = None


class StoppedLine(msgspec.Struct, tag="stopped", tag_field="op"):
    """Whether the emergency stop holds the wheels."""

    stopped: bool


Line = HoldingLine | LinkLine | FrameLine | SaidLine | SoundLine | EndedLine | StoppedLine

_decoder = msgspec.json.Decoder(Line)


def read_line(line: bytes) -> Line:
    """
    A line as a value.

    Raises:
        msgspec.DecodeError: rosy-robot is of another version than we.
    """
    read: Line = _decoder.decode(line)
    return read


def ask(op: Literal["run", "stop", "estop", "free", "alive"]) -> bytes:
    """A request as a line."""
    return msgspec.json.encode({"op": op}) + b"\n"
