"""
The page's messages, both ways. ``protocol/README.md``, section 4.

Requests are read into values here; answers are values whose encoding is the frame. What the worker found is passed on
as the worker's own values.
"""

from __future__ import annotations

import math
from typing import Any, Literal

import msgspec

from .. import sentence
from .explanation import Sentence as ExplanationSentence
from .firing import Branch, Firing, Place
from .problem import Problem, Sentence, Sentences, sentences
from .robot_link import MemoryValue
from .telemetry import PlayedSound, Speech, Telemetry
from .user_input import UserInput
from .worker import Checked, Completed

__all__ = [
    "Alive",
    "BadRequest",
    "Because",
    "Check",
    "Checked",
    "ChecksShown",
    "ChooseLessonStep",
    "ChooseWorld",
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
    "Observe",
    "Pause",
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
    "firing_shown",
    "read_request",
    "refusal",
]

PROTOCOL = 1

Speed = float | Literal["max"]

Visible = Literal["focused", "visible", "hidden"]
"""How much of a page its user sees."""

MAX_PREVIEW = 300.0
"""Longest run that a page may have previewed, s, simulated."""

MIN_SPEED, MAX_SPEED = 0.05, 64.0
"""Slowest and fastest clock a page may ask for, times real time."""


class ChooseWorld(msgspec.Struct, tag="world", tag_field="op"):
    """A room by name or as JSON."""

    world: Any


class ChooseLessonStep(msgspec.Struct, tag="lesson", tag_field="op"):
    """The checks of a lesson's step, as JSON, for the next runs; ``None`` for none."""

    step: Any


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
    """
    Compile and drive.

    ``after``: repeat so many steps of the run ``of``, without one the last run, with its seed and hands, and go on
    from there. ``twin``: on a real robot, the number of a run of the same program in the simulator beside it.
    """

    run: int
    source: str
    seed: int | None = None
    speed: Speed = 1.0
    after: int | None = None
    of: int | None = None
    twin: int | None = None


class Preview(msgspec.Struct, tag="preview", tag_field="op"):
    """Where would this program drive? ``seconds`` are simulated."""

    id: int
    source: str
    seconds: float


class Replay(msgspec.Struct, tag="replay", tag_field="op"):
    """
    Look at a recorded run, as run number ``run``: of this page's run ``of`` on a real robot, or, without one, from the
    file that the page sent last. ``room``: the page draws its room, and the run from its start on.
    """

    run: int
    of: int | None = None
    room: bool = False


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


class Observe(msgspec.Struct, tag="observe", tag_field="op"):
    """Whether the firings are recorded with their provenance, from the next step on, and whether frames carry them."""

    on: bool
    frames: bool = False


class Visibility(msgspec.Struct, tag="visibility", tag_field="op"):
    """Whether the page has the focus, is only visible, or is hidden, as the browser says: it decides about frames."""

    state: Visible


class Why(msgspec.Struct, tag="why", tag_field="op"):
    """
    Why is something as it is at a time, s (without one the latest)? About one of: a firing by its number, the latest
    firing of a function by its name, a memory by its type, an event as Haskell shows it or by its constructor, the
    position of the robot, a command by its type (`Velocity`, which is also meant when none is given). ``run``: another
    run than the latest.
    """

    id: int
    time: float | None = None
    firing: int | None = None
    function: str = ""
    position: bool = False
    memory: str = ""
    event: str = ""
    command: str = ""
    run: int | None = None


class BranchPlace(msgspec.Struct):
    """Where a branch of the program that runs starts and ends."""

    start: Place
    end: Place


class WhyNot(msgspec.Struct, tag="whyNot", tag_field="op"):
    """
    Why did something not happen between two times, s? A function that did not run, or did not send a command of a type;
    a branch that was not taken; a command that shows no effect, or an event of the program that was not received.
    """

    id: int
    since: float
    until: float
    function: str = ""
    command: str = ""
    event: str = ""
    branch: BranchPlace | None = None
    run: int | None = None


class Input(UserInput, tag="input", tag_field="op", kw_only=True):
    """Actions of the user on the robot."""


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


Request = (
    ChooseWorld
    | ChooseLessonStep
    | Check
    | Complete
    | Run
    | Replay
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
    if isinstance(request, Preview) and not (math.isfinite(request.seconds) and 0 < request.seconds <= MAX_PREVIEW):
        raise BadRequest(f"the time of a preview must be more than 0 and at most {MAX_PREVIEW:g} s")
    return request


class Hello(msgspec.Struct, tag="hello", tag_field="op", kw_only=True, rename={"in_class": "class"}):
    """The session exists. In class mode ``class`` is true; otherwise it is absent."""

    protocol: int = PROTOCOL
    session: str
    in_class: Literal[True] | msgspec.UnsetType = msgspec.UNSET


class WorkerState(msgspec.Struct, tag="worker", tag_field="op"):
    """Status of the worker."""

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
    # Between which the functions of a program that begins to run choose.
    branches: list[Branch] = []


class FiringShown(Firing, omit_defaults=True, frozen=True, kw_only=True):
    """A firing, and when it was, s since the start of the program."""

    time: float


def firing_shown(firing: Firing, time: float) -> FiringShown:
    """A firing at a time, s."""
    f = firing
    return FiringShown(f.n, f.function, f.task, f.cause, f.took, f.gave, f.branches, time=time)


class SentenceShown(msgspec.Struct, omit_defaults=True):
    """A sentence of an explanation, the time that it is about, s, and the firing, if it is about one."""

    said: ExplanationSentence
    time: float
    firing: int | None = None


class Because(msgspec.Struct, tag="because", tag_field="op"):
    """
    The answer to `why` or `whyNot` with this ``id``: sentences, the time of what was asked about, s, and the firings
    that led to it, in the order of time.
    """

    id: int
    time: float
    sentences: list[SentenceShown]
    path: list[FiringShown]


class Frame(Telemetry, tag="frame", tag_field="op", omit_defaults=True, kw_only=True):
    """Ground truth for drawing. ``boxes`` only when movable things have moved since the last
    frame with them; ``ghost`` only when odometry is not the truth; ``memory`` only when it has changed; ``firings``
    only while the page observes the run."""

    run: int
    step: int
    boxes: list[tuple[float, float, float]] | None = None
    ghost: tuple[float, float, float] | None = None
    memory: list[MemoryValue] | None = None
    firings: list[FiringShown] | None = None


class Said(Speech, tag="said", tag_field="op", kw_only=True):
    """A line for the console."""

    run: int


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


class Previewed(msgspec.Struct, tag="previewed", tag_field="op"):
    """
    Where a program would drive, with the room, the seed and the hands of the last run. Points are time (s), x, y (m),
    the pose is x, y, theta (m, rad). ``time`` (s) is how long it ran. ``unrepeatable``: the last run had more actions
    than are recorded.
    """

    id: int
    ended: Literal["time", "done", "error", "stuck", "refused", "unrepeatable"]
    time: float
    pose: tuple[float, float, float]
    path: list[tuple[float, float, float]]
    collisions: list[tuple[float, float, float]]
    goals: list[Goal]
    problems: list[Problem]


class Diverged(msgspec.Struct, tag="diverged", tag_field="op"):
    """At this time (s) a program that repeats the last run gave other commands for the first time."""

    run: int
    time: float


class Uncompared(msgspec.Struct, tag="uncompared", tag_field="op"):
    """From this time (s) on, it is not known whether a program that repeats the last run gave other commands."""

    run: int
    time: float


class ChecksShown(msgspec.Struct, tag="checks", tag_field="op"):
    """
    The checks of the lesson's step that the page has chosen. ``run`` is ``None`` while they are about the program only;
    ``over``: the time of the step or the run is over.
    """

    run: int | None
    passed: bool
    over: bool
    checks: list[Any]


class RunRecorded(msgspec.Struct, tag="recorded", tag_field="op"):
    """A run of this page on a real robot is in this file, on the computer of the service."""

    run: int
    file: str


class ReplayBegun(msgspec.Struct, tag="replayed", tag_field="op"):
    """A recording is shown from now on as this run: its program, and what the robot was called."""

    run: int
    program: str
    robot: str


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


class Refusal(msgspec.Struct, tag="refusal", tag_field="op", omit_defaults=True):
    """The last message could not be served."""

    message: str
    hint: str
    sentences: Sentences | None = None


def refusal(message: sentence.Sentence, hint: sentence.Sentence | None = None) -> Refusal:
    """A refusal in English with its sentences for other languages."""
    return Refusal(str(message), str(hint or ""), sentences(message, hint))


Answer = (
    Hello
    | WorkerState
    | WorldShown
    | Checked
    | Completed
    | RunState
    | Frame
    | Said
    | ConflictShown
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
    | Refusal
)

_encoder = msgspec.json.Encoder()


def encode(answer: Answer) -> str:
    """The text of a frame."""
    return _encoder.encode(answer).decode()


def encode_bytes(answer: Answer) -> bytes:
    """The text of a frame in UTF-8."""
    return _encoder.encode(answer)
