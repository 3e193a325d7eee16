"""
Messages of a page, both ways. ``protocol/README.md``, section 4. The modules hold them by subject; here is the codec.

Requests are read into values; answers are values whose encoding is the frame. What the worker found is passed on as the
worker's own values.
"""

from __future__ import annotations

import math

import msgspec

from ..worker import Checked, Completed
from .explanations import Because, BranchPlace, FiringShown, Observe, SentenceShown, Why, WhyNot, firing_shown
from .programs import MAX_PREVIEW, Check, ChecksShown, ChooseLessonStep, Complete, PreparePreviews, Preview, Previewed
from .recordings import Replay, ReplayBegun, RunRecorded
from .robots import (
    Alive,
    EmergencyStop,
    Free,
    Leave,
    Nearby,
    RobotName,
    Robots,
    RobotState,
    Safety,
    Seen,
    SwitchSafety,
    Take,
    Unlock,
)
from .runs import (
    MAX_SPEED,
    MIN_SPEED,
    Blocked,
    Companion,
    CompanionEnded,
    CompanionSaid,
    ConflictShown,
    Diverged,
    Forward,
    Frame,
    Goal,
    GoalsShown,
    Input,
    Pause,
    Reset,
    Resume,
    Run,
    RunState,
    Said,
    SetSpeed,
    SoundPlayed,
    Speed,
    Stop,
    Uncompared,
)
from .session import ChooseWorld, Hello, Refusal, Visibility, Visible, WorkerState, WorldShown, refusal, worker_state

__all__ = [
    "Alive",
    "Answer",
    "BadRequest",
    "Because",
    "Blocked",
    "BranchPlace",
    "Check",
    "Checked",
    "ChecksShown",
    "ChooseLessonStep",
    "ChooseWorld",
    "Companion",
    "CompanionEnded",
    "CompanionSaid",
    "Complete",
    "Completed",
    "ConflictShown",
    "Diverged",
    "EmergencyStop",
    "FiringShown",
    "Forward",
    "Frame",
    "Free",
    "Goal",
    "GoalsShown",
    "Hello",
    "Input",
    "Leave",
    "Nearby",
    "Observe",
    "Pause",
    "PreparePreviews",
    "Preview",
    "Previewed",
    "Refusal",
    "Replay",
    "ReplayBegun",
    "Request",
    "Reset",
    "Resume",
    "RobotName",
    "RobotState",
    "Robots",
    "Run",
    "RunRecorded",
    "RunState",
    "Safety",
    "Said",
    "Seen",
    "SentenceShown",
    "SetSpeed",
    "SoundPlayed",
    "Speed",
    "Stop",
    "SwitchSafety",
    "Take",
    "Uncompared",
    "Unlock",
    "Visibility",
    "Visible",
    "Why",
    "WhyNot",
    "WorkerState",
    "WorldShown",
    "encode",
    "encode_bytes",
    "firing_shown",
    "read_request",
    "refusal",
    "worker_state",
]

Request = (
    ChooseWorld
    | ChooseLessonStep
    | Check
    | Complete
    | Run
    | Replay
    | PreparePreviews
    | Preview
    | Stop
    | Reset
    | SetSpeed
    | Pause
    | Resume
    | Forward
    | Observe
    | Visibility
    | Why
    | WhyNot
    | Input
    | Unlock
    | Take
    | Leave
    | EmergencyStop
    | Free
    | SwitchSafety
    | Alive
)

_decoder = msgspec.json.Decoder(Request)


class BadRequest(Exception):
    """A message is not valid; the text says why."""


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
    if isinstance(request, Run):
        for robot in request.companions:
            if not all(math.isfinite(number) for number in (robot.x, robot.y, robot.theta)):
                raise BadRequest("the place of a robot must be finite")
    if isinstance(request, Preview) and not (math.isfinite(request.seconds) and 0 < request.seconds <= MAX_PREVIEW):
        raise BadRequest(f"the time of a preview must be more than 0 and at most {MAX_PREVIEW:g} s")
    return request


Answer = (
    Hello
    | WorkerState
    | WorldShown
    | Checked
    | Completed
    | RunState
    | Frame
    | Said
    | CompanionSaid
    | CompanionEnded
    | ConflictShown
    | Blocked
    | Because
    | SoundPlayed
    | GoalsShown
    | Previewed
    | Diverged
    | Uncompared
    | ChecksShown
    | Robots
    | RobotState
    | RunRecorded
    | ReplayBegun
    | Safety
    | Seen
    | Refusal
)

_encoder = msgspec.json.Encoder()


def encode(answer: Answer) -> str:
    """The text of a frame."""
    return _encoder.encode(answer).decode()


def encode_bytes(answer: Answer) -> bytes:
    """The text of a frame in UTF-8."""
    return _encoder.encode(answer)
