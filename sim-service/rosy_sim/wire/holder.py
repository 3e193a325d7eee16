"""
What ``rosy-robot`` tells of a robot it holds, and what it is asked. ``protocol/README.md``, section 7.
"""

from __future__ import annotations

from typing import Literal

import msgspec

from .problem import Problem

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


class FrameLine(msgspec.Struct, tag="frame", tag_field="op"):
    """The robot's odometry and what it senses and shows; bits as the page's frame has them."""

    time: float
    x: float
    y: float
    theta: float
    v: float
    w: float
    bumpers: int
    cliffs: int
    wheels: int
    buttons: int
    led1: int
    led2: int
    fired: list[str]
    backing: bool


class SaidLine(msgspec.Struct, tag="said", tag_field="op"):
    """The program speaks."""

    time: float
    text: str


class SoundLine(msgspec.Struct, tag="sound", tag_field="op"):
    """The program plays."""

    time: float
    sound: int


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
