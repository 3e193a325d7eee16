"""
Goals of a world: their description, its reader, and the progress of a run.

``GoalTracker.observe`` is called once per step; nothing here changes the world. A goal is
``open`` until it is ``done`` or ``missed``; to avoid something is done when the run ends without it.
"""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass
from typing import Literal, NamedTuple, Protocol

from ..sentences.sentence import tr
from .field_readers import ArenaError, items, number, object_fields, point, points, positive

__all__ = [
    "Avoid",
    "Draw",
    "Goal",
    "GoalState",
    "GoalTracker",
    "Lap",
    "Observation",
    "Reach",
    "State",
    "Touch",
    "Visit",
    "read_goals",
]

State = Literal["open", "done", "missed"]
_Point = tuple[float, float]

_SAMPLE = 0.05
"""Distance between the points of a shape that must be passed, m."""

_MAX_SAMPLES = 1000
"""Points of a long shape, which then lie farther apart."""

MAX_GOALS = 10
"""Of a world."""


class Observation(NamedTuple):
    """
    State of the robot at a time (s since the run began): position (m), bumper, cliff and wheel bits, and whether an
    obstacle kept its wheels from turning as fast as the motors wanted.
    """

    time: float
    x: float
    y: float
    bumpers: int
    cliffs: int
    wheels: int
    is_blocked: bool = False


class GoalState(NamedTuple):
    """How far a goal is: ``progress`` from 0 to 1, ``time`` (s) when it was done or missed."""

    kind: str
    title: str
    state: State
    progress: float
    time: float | None


@dataclass(frozen=True, slots=True)
class Reach:
    """Be within ``r`` of a place."""

    x: float
    y: float
    r: float
    title: str
    within: float | None = None
    kind: str = "reach"


@dataclass(frozen=True, slots=True)
class Touch:
    """Press a bumper within ``r`` of a place."""

    x: float
    y: float
    r: float
    title: str
    within: float | None = None
    kind: str = "touch"


@dataclass(frozen=True, slots=True)
class Avoid:
    """Never bump, never see a hole, or never be within ``r`` of a place."""

    what: Literal["bumps", "holes", "place"]
    title: str
    x: float = 0.0
    y: float = 0.0
    r: float = 0.0
    within: float | None = None
    kind: str = "avoid"


@dataclass(frozen=True, slots=True)
class Visit:
    """Be within ``r`` of each of some places, in any order."""

    points: tuple[_Point, ...]
    r: float
    title: str
    within: float | None = None
    kind: str = "visit"


@dataclass(frozen=True, slots=True)
class Lap:
    """Cross a line ``laps`` times after the first time, always the same way; the clock starts at the first."""

    start: _Point
    end: _Point
    laps: int
    title: str
    within: float | None = None
    kind: str = "lap"


@dataclass(frozen=True, slots=True)
class Draw:
    """Follow a line through some points, never farther from it than ``tolerance`` once it is begun."""

    points: tuple[_Point, ...]
    tolerance: float
    title: str
    within: float | None = None
    kind: str = "draw"


Goal = Reach | Touch | Avoid | Visit | Lap | Draw

_TITLES = {
    "reach": tr("Come to the place"),
    "touch": tr("Touch the thing"),
    "avoid": tr("Stay away"),
    "visit": tr("Visit all the places"),
    "lap": tr("Drive a lap"),
    "draw": tr("Draw the shape"),
}


def read_goals(fields: dict[str, object]) -> tuple[Goal, ...]:
    """
    The ``goals`` of a world.

    Raises:
        ArenaError: the first thing that is wrong, with its path.
    """
    found = items(fields, "goals")
    if len(found) > MAX_GOALS:
        raise ArenaError("goals", tr("a world can have at most {most} goals.", most=MAX_GOALS))
    return tuple(_goal(object_fields(value, path), path) for value, path in found)


def _goal(fields: dict[str, object], path: str) -> Goal:
    kind = fields.get("kind")
    if not isinstance(kind, str) or kind not in _TITLES:
        raise ArenaError(f"{path}.kind", tr("expected one of {titles}.", titles=list(_TITLES)))
    title = fields.get("title", str(_TITLES[kind]))
    if not isinstance(title, str):
        raise ArenaError(f"{path}.title", tr("the title must be text."))
    within = positive(fields, "within", path, 1e6) if "within" in fields else None
    match kind:
        case "reach" | "touch":
            x, y = number(fields.get("x"), f"{path}.x"), number(fields.get("y"), f"{path}.y")
            made = Reach if kind == "reach" else Touch
            return made(x, y, positive(fields, "r", path), title, within)
        case "avoid":
            return _avoid(fields, path, title)
        case "visit":
            return Visit(points(fields, path, 1), positive(fields, "r", path), title, within)
        case "lap":
            line = object_fields(fields.get("line"), f"{path}.line")
            laps = number(fields.get("laps", 1), f"{path}.laps")
            if not (1 <= laps <= 1000 and laps == int(laps)):
                raise ArenaError(f"{path}.laps", tr("expected a whole number from 1 to 1000."))
            start, end = (point(line.get(key), f"{path}.line.{key}") for key in ("from", "to"))
            return Lap(start, end, int(laps), title, within)
        case _:
            return Draw(points(fields, path, 2), positive(fields, "tolerance", path), title, within)


def _avoid(fields: dict[str, object], path: str, title: str) -> Avoid:
    what = fields.get("what", "place")
    if what == "place":
        x, y = number(fields.get("x"), f"{path}.x"), number(fields.get("y"), f"{path}.y")
        return Avoid("place", title, x, y, positive(fields, "r", path))
    if what == "bumps" or what == "holes":
        return Avoid(what, title)
    raise ArenaError(f"{path}.what", tr("expected bumps, holes or place."))


class _Tracker(Protocol):
    """Takes one observation after another; returns the progress, and whether the goal is lost."""

    def update(self, now: Observation) -> tuple[float, bool]: ...


class _ReachTracker:
    def __init__(self, goal: Reach | Touch) -> None:
        self._goal = goal
        self._farthest = 0.0

    def update(self, now: Observation) -> tuple[float, bool]:
        goal = self._goal
        gap = max(0.0, math.dist((now.x, now.y), (goal.x, goal.y)) - goal.r)
        self._farthest = max(self._farthest, gap)
        if gap == 0 and (isinstance(goal, Reach) or now.bumpers):
            return 1.0, False
        return (0.99 * (1 - gap / self._farthest) if self._farthest else 0.0), False


class _AvoidTracker:
    def __init__(self, goal: Avoid) -> None:
        self._goal = goal

    def update(self, now: Observation) -> tuple[float, bool]:
        goal = self._goal
        if goal.what == "bumps":
            return 0.0, now.bumpers != 0
        if goal.what == "holes":
            return 0.0, now.wheels != 0
        return 0.0, math.dist((now.x, now.y), (goal.x, goal.y)) <= goal.r


class _VisitTracker:
    def __init__(self, points: tuple[_Point, ...], radius: float) -> None:
        self._left = list(points)
        self._total = len(points)
        self._radius = radius

    def update(self, now: Observation) -> tuple[float, bool]:
        self._left = [p for p in self._left if math.dist((now.x, now.y), p) > self._radius]
        return 1 - len(self._left) / self._total, False


class _LapTracker:
    def __init__(self, goal: Lap) -> None:
        self._goal = goal
        self._last: _Point | None = None
        # Crossings so far, those the first way minus those back; and which way the first was.
        self._crossed = 0
        self._way = 0
        self._began = 0.0

    def update(self, now: Observation) -> tuple[float, bool]:
        here = (now.x, now.y)
        if self._last is not None:
            canonical_address = _crossing(self._last, here, self._goal.start, self._goal.end)
            if canonical_address and not self._way:
                self._way = canonical_address
            if canonical_address and not self._crossed:
                self._began = now.time
            self._crossed += canonical_address * self._way
        self._last = here
        limit = self._goal.within
        late = limit is not None and self._crossed > 0 and now.time - self._began > limit
        return max(0, self._crossed - 1) / self._goal.laps, late


class _DrawTracker:
    def __init__(self, goal: Draw) -> None:
        self._goal = goal
        self._samples = _sampled(goal.points)
        self._left = set(range(len(self._samples)))
        self._begun = False

    def update(self, now: Observation) -> tuple[float, bool]:
        here = (now.x, now.y)
        near = {i for i in range(len(self._samples)) if math.dist(here, self._samples[i]) <= self._goal.tolerance}
        self._begun = self._begun or bool(near)
        self._left -= near
        return 1 - len(self._left) / len(self._samples), self._begun and not near


def _tracker(goal: Goal) -> _Tracker:
    match goal:
        case Reach() | Touch():
            return _ReachTracker(goal)
        case Avoid():
            return _AvoidTracker(goal)
        case Visit():
            return _VisitTracker(goal.points, goal.r)
        case Lap():
            return _LapTracker(goal)
        case Draw():
            return _DrawTracker(goal)


class GoalTracker:
    """All goals of a run."""

    def __init__(self, goals: tuple[Goal, ...]) -> None:
        self._goals = goals
        self._trackers = [_tracker(goal) for goal in goals]
        # How far each is; changed by observe() and finish().
        self.states = [GoalState(goal.kind, goal.title, "open", 0.0, None) for goal in goals]

    def __bool__(self) -> bool:
        return bool(self._goals)

    @property
    def reached(self) -> bool:
        """Whether all are done."""
        return all(state.state == "done" for state in self.states)

    def observe(self, now: Observation) -> None:
        """Update all open goals."""
        for i, (goal, tracker) in enumerate(zip(self._goals, self._trackers, strict=True)):
            state = self.states[i]
            if state.state != "open":
                continue
            progress, lost = tracker.update(now)
            timed = goal.within is not None and not isinstance(goal, Lap)
            late = timed and goal.within is not None and now.time > goal.within
            if progress >= 1 and not lost and not late:
                self.states[i] = state._replace(state="done", progress=1.0, time=now.time)
            elif lost or late:
                self.states[i] = state._replace(state="missed", progress=progress, time=now.time)
            else:
                self.states[i] = state._replace(progress=max(state.progress, progress))

    def finish(self, time: float) -> None:
        """The run is over: what was avoided until now is done, everything else that is open is missed."""
        for i, (goal, state) in enumerate(zip(self._goals, self.states, strict=True)):
            if state.state == "open":
                kept = isinstance(goal, Avoid)
                self.states[i] = state._replace(
                    state="done" if kept else "missed", progress=1.0 if kept else state.progress, time=time
                )


def _crossing(a: _Point, b: _Point, p: _Point, q: _Point) -> int:
    """Whether going from a to b crosses the line p-q: 1 from its right to its left, -1 back, 0 not."""
    before, after = _side(p, q, a), _side(p, q, b)
    if (before < 0) == (after < 0) or (_side(a, b, p) < 0) == (_side(a, b, q) < 0):
        return 0
    return 1 if after >= 0 else -1


def _side(p: _Point, q: _Point, a: _Point) -> float:
    """Positive when a is to the left of going from p to q."""
    return (q[0] - p[0]) * (a[1] - p[1]) - (q[1] - p[1]) * (a[0] - p[0])


def _sampled(points: tuple[_Point, ...]) -> list[_Point]:
    found = [points[0]]
    length = sum(math.dist(a, b) for a, b in itertools.pairwise(points))
    spacing = max(_SAMPLE, length / _MAX_SAMPLES)
    for (x0, y0), (x1, y1) in itertools.pairwise(points):
        pieces = max(1, math.ceil(math.dist((x0, y0), (x1, y1)) / spacing))
        found += [(x0 + (x1 - x0) * i / pieces, y0 + (y1 - y0) * i / pieces) for i in range(1, pieces + 1)]
    return found
