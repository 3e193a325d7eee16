"""
Messages of ``rosy-robot hold``: its lines about a robot, and the requests it takes. ``protocol/README.md``, section 7.
"""

from __future__ import annotations

from typing import Any, Literal

import msgspec

from .firing import Firing
from .link_messages import MemoryValue
from .problem import Problem, Sentence
from .telemetry import PlayedSound, Shown, Speech, Telemetry

__all__ = [
    "CommandsLine",
    "DriveSettingsLine",
    "EndedLine",
    "FrameLine",
    "Line",
    "LinkLine",
    "ObservedStep",
    "SaidLine",
    "SentCommand",
    "SoundLine",
    "StoppedLine",
    "decode_line",
    "encode_alive",
    "encode_record",
    "encode_request",
    "encode_switch",
    "read_observed",
]


class DriveSettingsLine(msgspec.Struct, tag="holding", tag_field="op"):
    """How the robot is driven: the first line, and after each `safety`. m/s, rad/s."""

    safety: bool
    max_speed: float
    max_turn: float


class LinkLine(msgspec.Struct, tag="link", tag_field="op", omit_defaults=True):
    """The state of the connection to the robot."""

    link: Literal["connecting", "connected", "lost"]
    why: str
    # The same for other languages.
    sentence: Sentence | None = None


class FrameLine(Telemetry, tag="frame", tag_field="op"):
    """The robot by its odometry, from where the run began."""

    backing: bool


class SaidLine(Speech, tag="said", tag_field="op"):
    """A line for the console."""


class SoundLine(PlayedSound, tag="sound", tag_field="op"):
    """A sound to play."""


class SentCommand(msgspec.Struct):
    """A command of the program. A message on a topic of the program's own has no channel."""

    channel: str | None
    values: Shown


class CommandsLine(msgspec.Struct, tag="commands", tag_field="op"):
    """
    The commands of a step, and the functions that fired in it. ``sent`` is that of ``settled``.

    Of an observed step also whether the safety rules owned the wheels, and what the program told: ``read_observed``.
    """

    time: float
    fired: list[str]
    sent: list[int]
    commands: list[SentCommand]
    backing: bool | msgspec.UnsetType = msgspec.UNSET
    observed: Any = msgspec.UNSET


class ObservedStep(msgspec.Struct):
    """What a program tells of an observed step, as in ``settled``."""

    firings: list[Firing] = []
    sensed: list[str] = []
    memory: list[MemoryValue] | None = None


def read_observed(line: CommandsLine) -> ObservedStep | None:
    """
    What the program told of the step; None when it was not observed.

    Raises:
        msgspec.ValidationError: the program broke the protocol.
    """
    if line.observed is msgspec.UNSET:
        return None
    return msgspec.convert(line.observed, ObservedStep)


class EndedLine(msgspec.Struct, tag="ended", tag_field="op"):
    """A program has ended; one line for each that was run, in their order."""

    time: float
    how: Literal["done", "error", "broken", "stopped", "stuck", "died", "lost"]
    problem: Problem | None = None


class StoppedLine(msgspec.Struct, tag="stopped", tag_field="op"):
    """Whether the emergency stop holds the wheels."""

    stopped: bool


Line = DriveSettingsLine | LinkLine | FrameLine | SaidLine | SoundLine | CommandsLine | EndedLine | StoppedLine

_decoder = msgspec.json.Decoder(Line)


def decode_line(line: bytes) -> Line:
    """
    A line as a value.

    Raises:
        msgspec.DecodeError: rosy-robot is of another version.
    """
    read: Line = _decoder.decode(line)
    return read


def encode_alive(time: float) -> bytes:
    """The line that says that the page was visible at ``time``, s of ``CLOCK_BOOTTIME``."""
    return msgspec.json.encode({"op": "alive", "time": time}) + b"\n"


def encode_request(op: Literal["run", "stop", "estop", "free"]) -> bytes:
    """A request as a line."""
    return msgspec.json.encode({"op": op}) + b"\n"


def encode_record(file: str) -> bytes:
    """The line that names the file for the log of the next run."""
    return msgspec.json.encode({"op": "record", "file": file}) + b"\n"


def encode_switch(op: Literal["safety", "observe"], on: bool) -> bytes:
    """The line that switches the safety rules, or the record of firings."""
    return msgspec.json.encode({"op": op, "on": on}) + b"\n"
