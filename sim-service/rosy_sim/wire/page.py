"""
The page's messages, both ways. ``protocol/README.md``, section 4.

Requests are read into values here; answers are values whose encoding is the frame. What the worker found is passed on
as the worker's own values.
"""

from __future__ import annotations

import math
from typing import Any, Literal

import msgspec

from .hands import HandMessage
from .link import Kept
from .problem import Problem
from .shown import Sight, Tone, Words
from .worker import Checked, Completed

__all__ = [
    "Alive",
    "BadRequest",
    "Check",
    "Checked",
    "ChooseWorld",
    "Complete",
    "Completed",
    "EmergencyStop",
    "Forward",
    "Frame",
    "Free",
    "Goal",
    "GoalsShown",
    "Hello",
    "Input",
    "Leave",
    "Pause",
    "Refusal",
    "Request",
    "Reset",
    "Resume",
    "RobotName",
    "RobotState",
    "Robots",
    "Run",
    "RunState",
    "Said",
    "SetSpeed",
    "SoundPlayed",
    "Speed",
    "Stop",
    "Take",
    "Unlock",
    "WorkerState",
    "WorldShown",
    "encode",
    "read_request",
]

PROTOCOL = 1

Speed = float | Literal["max"]

MIN_SPEED, MAX_SPEED = 0.05, 64.0
"""Slowest and fastest clock a page may ask for, times real time."""


class ChooseWorld(msgspec.Struct, tag="world", tag_field="op"):
    """A room by name or as JSON."""

    world: Any


class Check(msgspec.Struct, tag="check", tag_field="op"):
    """Type-check while typing."""

    id: int
    source: str


class Complete(msgspec.Struct, tag="complete", tag_field="op"):
    """What can stand at a place?"""

    id: int
    source: str
    line: int
    column: int


class Run(msgspec.Struct, tag="run", tag_field="op"):
    """Compile and drive."""

    run: int
    source: str
    seed: int | None = None
    speed: Speed = 1.0


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
    """Let it go."""


class Forward(msgspec.Struct, tag="forward", tag_field="op"):
    """One step while it stands."""


class Input(HandMessage, tag="input", tag_field="op", kw_only=True):
    """Hands."""


class Unlock(msgspec.Struct, tag="unlock", tag_field="op"):
    """The code that lets a page at the robots."""

    code: str


class Take(msgspec.Struct, tag="take", tag_field="op"):
    """Have a robot. ``run`` is the number that its frames carry until the next run."""

    robot: str
    who: str
    run: int = 0


class Leave(msgspec.Struct, tag="leave", tag_field="op"):
    """Let others have it."""


class EmergencyStop(msgspec.Struct, tag="estop", tag_field="op"):
    """The wheels stand, whatever happens, until `free`."""


class Free(msgspec.Struct, tag="free", tag_field="op"):
    """The robot may drive again."""


class Alive(msgspec.Struct, tag="alive", tag_field="op"):
    """Somebody looks at the robot: without it the wheels stand."""


Request = (
    ChooseWorld
    | Check
    | Complete
    | Run
    | Stop
    | Reset
    | SetSpeed
    | Pause
    | Resume
    | Forward
    | Input
    | Unlock
    | Take
    | Leave
    | EmergencyStop
    | Free
    | Alive
)

_decoder = msgspec.json.Decoder(Request)


class BadRequest(Exception):
    """A message is none the service knows; the text says why."""


def read_request(text: str | bytes) -> Request:
    """
    A page's message as a value.

    Raises:
        BadRequest: it is none.
    """
    try:
        request: Request = _decoder.decode(text)
    except (msgspec.DecodeError, RecursionError, UnicodeError) as error:
        raise BadRequest(str(error)) from error
    if isinstance(request, Run | SetSpeed) and request.speed != "max":
        if not math.isfinite(request.speed) or request.speed <= 0:
            raise BadRequest("a speed must be more than 0")
        request.speed = max(MIN_SPEED, min(MAX_SPEED, request.speed))
    return request


class Hello(msgspec.Struct, tag="hello", tag_field="op", kw_only=True):
    """The session exists."""

    protocol: int = PROTOCOL
    session: str


class WorkerState(msgspec.Struct, tag="worker", tag_field="op"):
    """How the worker is."""

    state: Literal["starting", "ready", "restarting"]


class WorldShown(msgspec.Struct, tag="world", tag_field="op"):
    """The room to draw."""

    world: Any


class RunState(msgspec.Struct, tag="state", tag_field="op", omit_defaults=True):
    """Where a run is. ``problems`` is always sent."""

    run: int
    state: Literal["queued", "compiling", "running", "ended"]
    problems: list[Problem]
    ended: Literal["done", "error", "stuck", "stopped", "time", "refused"] | None = None
    # In the queue, while the state is `queued`: 1 is the next.
    place: int | None = None


class Frame(Sight, tag="frame", tag_field="op", omit_defaults=True, kw_only=True):
    """Ground truth for drawing. ``boxes`` only when movable things have moved since the last
    frame with them; ``ghost`` only when odometry is not the truth; ``memory`` only when it has changed."""

    run: int
    step: int
    boxes: list[tuple[float, float, float]] | None = None
    ghost: tuple[float, float, float] | None = None
    memory: list[Kept] | None = None


class Said(Words, tag="said", tag_field="op", kw_only=True):
    """A line for the console."""

    run: int


class SoundPlayed(Tone, tag="sound", tag_field="op", kw_only=True):
    """A sound to play."""

    run: int


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


class RobotName(msgspec.Struct):
    """A robot, who has it, and whether that is this page."""

    name: str
    holder: str | None
    yours: bool


class Robots(msgspec.Struct, tag="robots", tag_field="op"):
    """The robots one may choose; none are told while ``locked``."""

    locked: bool
    robots: list[RobotName]


class RobotState(msgspec.Struct, tag="robot", tag_field="op"):
    """The robot that this page has. ``link`` is ``gone`` when it has it no more."""

    name: str
    link: Literal["connecting", "connected", "lost", "gone"]
    why: str
    # Whether it backs off by itself from what it runs into, and whether it does so now.
    safety: bool
    backing: bool
    # The emergency stop holds its wheels.
    stopped: bool
    # m/s, rad/s.
    max_speed: float
    max_turn: float


class Refusal(msgspec.Struct, tag="refusal", tag_field="op"):
    """The last message could not be served."""

    message: str
    hint: str = ""


Answer = (
    Hello
    | WorkerState
    | WorldShown
    | Checked
    | Completed
    | RunState
    | Frame
    | Said
    | SoundPlayed
    | GoalsShown
    | Robots
    | RobotState
    | Refusal
)

_encoder = msgspec.json.Encoder()


def encode(answer: Answer) -> str:
    """The text of a frame."""
    return _encoder.encode(answer).decode()
