"""Messages of a page about a run: its start and clock, hands, and what the page is shown of it."""

from __future__ import annotations

from typing import Annotated, Literal

import msgspec

from ..firing import Branch
from ..link_messages import MemoryValue
from ..problem import Problem
from ..telemetry import PlayedSound, Speech, Telemetry
from ..user_input import UserInput
from .explanations import FiringShown

__all__ = [
    "MAX_COMPANIONS",
    "MAX_SPEED",
    "MIN_SPEED",
    "Blocked",
    "Companion",
    "CompanionEnded",
    "CompanionSaid",
    "ConflictShown",
    "Diverged",
    "Forward",
    "Frame",
    "Goal",
    "GoalsShown",
    "Input",
    "Pause",
    "Reset",
    "Resume",
    "Run",
    "RunState",
    "Said",
    "SetSpeed",
    "SoundPlayed",
    "Speed",
    "Stop",
    "Uncompared",
]

Speed = float | Literal["max"]

MIN_SPEED, MAX_SPEED = 0.05, 64.0
"""Slowest and fastest clock a page may ask for, times real time."""


MAX_COMPANIONS = 3
"""Robots in the room besides that of the run. Each has a place among the programs that run at once."""


class Companion(msgspec.Struct):
    """One more robot in the room of a run: its program, and where it starts, m and rad."""

    source: str
    x: float
    y: float
    theta: float


class Run(msgspec.Struct, tag="run", tag_field="op"):
    """
    Compile and drive.

    ``after``: repeat so many steps of the run ``of``, without one the last run, with its seed and hands, and go on
    from there. ``paused``: in the simulator, start with the clock stopped, before the first step. ``twin``: on a real
    robot, the number of a run of the same program in the simulator beside it. ``companions``: in the simulator, more
    robots in the room; with ``after`` those of the earlier run are there, and these are not read.
    """

    run: int
    source: str
    seed: int | None = None
    speed: Speed = 1.0
    after: int | None = None
    of: int | None = None
    twin: int | None = None
    paused: bool = False
    companions: Annotated[list[Companion], msgspec.Meta(max_length=MAX_COMPANIONS, extra={"constant": True})] = []


class Stop(msgspec.Struct, tag="stop", tag_field="op"):
    """End the run."""


class Reset(msgspec.Struct, tag="reset", tag_field="op"):
    """End the run and put everything back."""


class SetSpeed(msgspec.Struct, tag="speed", tag_field="op"):
    """Change the clock."""

    speed: Speed


class Pause(msgspec.Struct, tag="pause", tag_field="op"):
    """Stop the clock."""


class Resume(msgspec.Struct, tag="resume", tag_field="op"):
    """Restart the clock."""


class Forward(msgspec.Struct, tag="forward", tag_field="op"):
    """Make one step while paused."""


class Input(UserInput, tag="input", tag_field="op", kw_only=True):
    """Actions of the user on the robot."""


class RunState(msgspec.Struct, tag="state", tag_field="op", omit_defaults=True):
    """Where a run is. ``problems`` is always sent."""

    run: int
    state: Literal["queued", "compiling", "running", "ended"]
    problems: list[Problem]
    ended: Literal["done", "error", "stuck", "stopped", "time", "refused"] | None = None
    # In the queue, while the state is `queued`: 1 is the next.
    place: int | None = None
    # Between which the functions of a program that begins to run choose.
    branches: list[Branch] = []


class Frame(Telemetry, tag="frame", tag_field="op", omit_defaults=True, kw_only=True):
    """Ground truth for drawing. ``times``, s, of each of ``sensed``, when there is one; ``boxes`` only when movable
    things have moved since the last frame with them, ``others`` when other robots have; ``ghost`` only when odometry
    is not the truth; ``memory`` only when it has changed; ``firings`` only while the page observes the run."""

    run: int
    step: int
    times: list[float] | None = None
    boxes: list[tuple[float, float, float]] | None = None
    others: list[tuple[float, float, float]] | None = None
    ghost: tuple[float, float, float] | None = None
    memory: list[MemoryValue] | None = None
    firings: list[FiringShown] | None = None


class Said(Speech, tag="said", tag_field="op", kw_only=True):
    """A line for the console."""

    run: int


class CompanionSaid(Speech, tag="companion-said", tag_field="op", kw_only=True):
    """A line for the console, of another robot of the run: 1 for the first of its companions."""

    run: int
    robot: int


class CompanionEnded(msgspec.Struct, tag="companion-ended", tag_field="op"):
    """The program of another robot of the run has ended, at a time, s. ``problem``: why, if not by itself."""

    run: int
    robot: int
    time: float
    problem: Problem | None


class SoundPlayed(PlayedSound, tag="sound", tag_field="op", kw_only=True):
    """A sound to play."""

    run: int


class ConflictShown(msgspec.Struct, tag="conflict", tag_field="op"):
    """``winner`` keeps replacing the commands of ``loser`` on a channel."""

    run: int
    time: float
    command: str
    winner: str
    loser: str


class Blocked(msgspec.Struct, tag="blocked", tag_field="op"):
    """The robot has pushed against something for 2 s without moving. ``bumped``: its bumper is pressed."""

    run: int
    time: float
    bumped: bool


class Goal(msgspec.Struct):
    """How far a goal of the world is: ``progress`` from 0 to 1, ``time`` when it was done or missed."""

    kind: str
    title: str
    state: Literal["open", "done", "missed"]
    progress: float
    time: float | None


class GoalsShown(msgspec.Struct, tag="goals", tag_field="op"):
    """All goals of the world, in its order, when one of them has changed."""

    run: int
    goals: list[Goal]


class Diverged(msgspec.Struct, tag="diverged", tag_field="op"):
    """At this time (s) a program that repeats the last run gave other commands for the first time."""

    run: int
    time: float


class Uncompared(msgspec.Struct, tag="uncompared", tag_field="op"):
    """From this time (s) on, it is not known whether a program that repeats the last run gave other commands."""

    run: int
    time: float
