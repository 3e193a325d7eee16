"""Messages of a page about real robots: who owns one, its link, and its safety."""

from __future__ import annotations

from typing import Literal

import msgspec

from ..problem import Sentence

__all__ = [
    "Alive",
    "EmergencyStop",
    "Free",
    "Leave",
    "RobotName",
    "RobotState",
    "Robots",
    "Safety",
    "SwitchSafety",
    "Take",
    "Unlock",
]


class Unlock(msgspec.Struct, tag="unlock", tag_field="op"):
    """The code that unlocks the robots."""

    code: str


class Take(msgspec.Struct, tag="take", tag_field="op"):
    """Own a robot. ``run`` is the number that its frames carry until the next run."""

    robot: str
    who: str
    run: int = 0


class Leave(msgspec.Struct, tag="leave", tag_field="op"):
    """Release the robot."""


class EmergencyStop(msgspec.Struct, tag="estop", tag_field="op"):
    """Stop the wheels until `free`."""


class Free(msgspec.Struct, tag="free", tag_field="op"):
    """The robot may drive again."""


class SwitchSafety(msgspec.Struct, tag="safety", tag_field="op"):
    """Switch the safety rules of the robot, simulated or real."""

    on: bool


class Alive(msgspec.Struct, tag="alive", tag_field="op"):
    """The page is visible and connected: without it the wheels stop."""


class RobotName(msgspec.Struct):
    """A robot, the name of its owner, and whether that is this page."""

    name: str
    holder: str | None
    yours: bool


class Robots(msgspec.Struct, tag="robots", tag_field="op"):
    """The robots; none are listed while ``locked``."""

    locked: bool
    robots: list[RobotName]


class RobotState(msgspec.Struct, tag="robot", tag_field="op", omit_defaults=True):
    """
    The robot that this page owns. ``link`` is ``gone`` when the ownership has ended; ``sentence`` is what ``why`` says,
    for other languages.
    """

    name: str
    link: Literal["connecting", "connected", "lost", "gone"]
    why: str
    # The emergency stop holds its wheels.
    stopped: bool
    # m/s, rad/s.
    max_speed: float
    max_turn: float
    sentence: Sentence | None = None


class Safety(msgspec.Struct, tag="safety", tag_field="op", omit_defaults=True):
    """
    Whether the safety rules of the robot, simulated or real, are on. ``run`` and ``since`` (s) say when they began to
    override the program; absent while they do not.
    """

    on: bool
    run: int | None = None
    since: float | None = None
