"""
Telemetry of a robot: fields shared by the lines of ``rosy-robot`` (``robot_process``) and the messages for the page
(``page``). ``protocol/README.md``, sections 4 and 7.
"""

from __future__ import annotations

import msgspec

__all__ = ["PlayedSound", "PoseShown", "Shown", "Speech", "Telemetry"]


class Speech(msgspec.Struct):
    """A text of the program."""

    time: float
    text: str


class PlayedSound(msgspec.Struct):
    """A sound of the program."""

    time: float
    sound: int


class PoseShown(msgspec.Struct):
    """Where the robot is: m, m, rad."""

    x: float
    y: float
    theta: float


Shown = list[float | int | str]
"""The values of a channel; of an event with several sensors the state of each."""


class Telemetry(msgspec.Struct):
    """
    Where the robot is, what its channels say, what fired since the last one, and what the program sensed, as Haskell
    shows it.
    """

    time: float
    pose: PoseShown
    channels: dict[str, Shown]
    fired: list[str]
    sensed: list[str]
