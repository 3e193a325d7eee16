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
    "Nearby",
    "RobotName",
    "RobotState",
    "Robots",
    "Safety",
    "Seen",
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
    """
    The page is visible and connected: without it the wheels stop. ``seen`` is the number of the latest ``seen`` that
    the page got, so that a message that waited on its way does not count; 0 before the first.
    """

    seen: int = 0


class Seen(msgspec.Struct, tag="seen", tag_field="op"):
    """The answer to each ``alive``: a number for the next one."""

    number: int


class Nearby(msgspec.Struct, omit_defaults=True):
    """
    A robot that was discovered: what it is, its domain of ROS 2, its battery, of which a robot reports the charge (%),
    the voltage (V) or nothing, whether it speaks Zenoh in place of DDS, and whether several robots are there that
    nothing tells apart.
    """

    title: str
    domain: int
    charge: int | None = None
    volts: float | None = None
    zenoh: bool = False
    several: bool = False


class RobotName(msgspec.Struct, omit_defaults=True):
    """A robot, the name of its owner, and whether that is this page; ``nearby`` while it is discovered."""

    name: str
    holder: str | None
    yours: bool
    nearby: Nearby | None = None


class Robots(msgspec.Struct, tag="robots", tag_field="op", omit_defaults=True):
    """The robots; none are listed while ``locked``. ``discovers`` is whether more of them may appear by themselves."""

    locked: bool
    robots: list[RobotName]
    discovers: bool = False


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
