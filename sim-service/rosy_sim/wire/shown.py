"""
What a robot is seen and heard to do, as ``rosy-robot`` tells it of a real one (``holder``) and the page is told of
either (``page``). ``protocol/README.md``, sections 4 and 7.
"""

from __future__ import annotations

import msgspec

__all__ = ["Sight", "Tone", "Words"]


class Words(msgspec.Struct):
    """The program speaks."""

    time: float
    text: str


class Tone(msgspec.Struct):
    """The program plays."""

    time: float
    sound: int


class Sight(msgspec.Struct):
    """Where the robot is, what it senses and shows, and what fired since the last one; bits as in SensorState."""

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
