"""
Properties of a run, chosen from words: reaches the goal, never falls, never pushes longer than 1 s, and others.

In: the arena, the robot's body, and one ``Observation`` per step, while the run goes on or from a recording. Out: one
``Verdict`` per property. Nothing here runs a program, and nothing depends on its text.

A property's words are those of ``./rosy run --hold``; the same words are sent by a page and stand in a lesson's check.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Literal, NamedTuple, Protocol

from ..sentences.sentence import SentenceError, tr
from .arena import Arena
from .floor_grid import FloorGrid
from .goals import Goal, GoalTracker, Observation, Reach
from .robot import Body

__all__ = [
    "BadProperty",
    "Kind",
    "Property",
    "PropertyTracker",
    "Verdict",
    "judge",
    "read_properties",
]

Kind = Literal["reaches-goal", "never-falls", "never-pushes", "returns-to-start", "covers", "room-goals"]

DEFAULT_PUSH = 1.0
"""Longest push of ``never-pushes`` without a number, s."""

DEFAULT_SHARE = 50.0
"""Share of the floor of ``covers`` without a number, %."""

LEFT_START = 1.0
"""A robot that was farther than this from its start, m, has left it and can return."""

AT_START = 0.3
"""A robot nearer than this to its start, m, has returned."""

_UNITS: dict[str, tuple[str, ...]] = {"never-pushes": ("s", "second", "seconds"), "covers": ("%", "percent")}

_KINDS: tuple[Kind, ...] = ("reaches-goal", "never-falls", "never-pushes", "returns-to-start", "covers", "room-goals")


class BadProperty(SentenceError):
    """Words that are no property; the text says what is wrong and what there is."""


@dataclass(frozen=True, slots=True)
class Property:
    """``amount`` is in s for ``never-pushes``, in % for ``covers``, and without meaning for the others."""

    kind: Kind
    amount: float = 0.0

    def __str__(self) -> str:
        unit = _UNITS.get(self.kind)
        return f"{self.kind} {self.amount:g} {unit[0]}" if unit is not None else self.kind


class Verdict(NamedTuple):
    """
    What a run says about a property so far.

    ``time`` (s) is when it was decided. ``shortfall`` is 0 for a property that holds and up to 1 for one that is far
    from it. ``amount`` is what was measured: the share of the way to the goals (0 to 1), the longest push (s), how near
    the robot came to its start again (m; 0 when it never left), or the covered share of the floor (%).
    """

    property: Property
    state: Literal["open", "held", "failed"]
    time: float | None = None
    amount: float = 0.0
    shortfall: float = 0.0


def read_properties(text: str) -> tuple[Property, ...]:
    """
    The properties of words such as ``never-falls never-pushes 1 s covers 50 %``.

    Raises:
        BadProperty: a word is no property, or its number is missing or impossible.
    """
    words = text.replace("%", " % ").replace(",", " ").split()
    found: list[Property] = []
    while words:
        kind = _kind(words.pop(0))
        units = _UNITS.get(kind, ())
        number = _number(words[0]) if words else None
        if number is not None:
            if not units:
                raise BadProperty(tr("The property {kind} takes no number.", kind=kind))
            words.pop(0)
            if words and words[0] in units:
                words.pop(0)
        made = _property(kind, number)
        if any(made.kind == other.kind for other in found):
            raise BadProperty(tr("The property {kind} is there twice.", kind=kind))
        found.append(made)
    if not found:
        raise BadProperty(tr("There is no property; there are {kinds}.", kinds=list(_KINDS)))
    return tuple(found)


def _kind(word: str) -> Kind:
    for kind in _KINDS:
        if word == kind:
            return kind
    raise BadProperty(tr("There is no property called {word}; there are {kinds}.", word=repr(word), kinds=list(_KINDS)))


def _number(word: str) -> float | None:
    try:
        value = float(word)
    except ValueError:
        # "1s" is a number with its unit.
        digits = word.rstrip("s")
        return _number(digits) if digits != word else None
    return value if math.isfinite(value) else None


def _property(kind: Kind, number: float | None) -> Property:
    if kind == "never-pushes":
        seconds = DEFAULT_PUSH if number is None else number
        if not 0 <= seconds <= 3600:
            raise BadProperty(tr("The seconds of never-pushes must be between 0 and 3600."))
        return Property(kind, seconds)
    if kind == "covers":
        share = DEFAULT_SHARE if number is None else number
        if not 0 < share <= 100:
            raise BadProperty(tr("The share of covers must be more than 0 % and at most 100 %."))
        return Property(kind, share)
    return Property(kind)


def judge(
    properties: Sequence[Property], arena: Arena, body: Body, run: Iterable[Observation], time: float
) -> list[Verdict]:
    """The verdicts about a recorded run that ended at ``time`` (s)."""
    tracker = PropertyTracker(properties, arena, body)
    for now in run:
        tracker.observe(now)
    tracker.finish(time)
    return tracker.verdicts


class PropertyTracker:
    """All properties of a run; ``verdicts`` changes with ``observe`` and ``finish``."""

    def __init__(self, properties: Sequence[Property], arena: Arena, body: Body) -> None:
        self._trackers = [_tracker(wanted, arena, body) for wanted in properties]
        self.verdicts = [Verdict(wanted, "open") for wanted in properties]

    @property
    def is_decided(self) -> bool:
        """Whether no further step can change a verdict."""
        return all(verdict.state != "open" for verdict in self.verdicts)

    def observe(self, now: Observation) -> None:
        """Update the open verdicts with the state after a step."""
        for i, tracker in enumerate(self._trackers):
            verdict = self.verdicts[i]
            if verdict.state == "open":
                holds = tracker.update(now)
                if holds is not None:
                    self.verdicts[i] = _decided(verdict.property, tracker, holds, now.time)

    def finish(self, time: float) -> None:
        """The run is over: what never happened holds, and what did not happen in time fails."""
        for i, tracker in enumerate(self._trackers):
            verdict = self.verdicts[i]
            if verdict.state == "open":
                holds = tracker.holds_at_end()
                self.verdicts[i] = _decided(verdict.property, tracker, holds, time)


class _Tracker(Protocol):
    """One property; ``update`` returns whether it holds once that is decided."""

    # What a verdict says about it.
    amount: float
    shortfall: float

    def update(self, now: Observation) -> bool | None: ...

    def holds_at_end(self) -> bool: ...


def _decided(wanted: Property, tracker: _Tracker, holds: bool, time: float) -> Verdict:
    state: Literal["held", "failed"] = "held" if holds else "failed"
    return Verdict(wanted, state, time, tracker.amount, 0.0 if holds else tracker.shortfall)


def _tracker(wanted: Property, arena: Arena, body: Body) -> _Tracker:
    match wanted.kind:
        case "reaches-goal":
            return _Goals(tuple(goal for goal in arena.goals if isinstance(goal, Reach)))
        case "room-goals":
            return _Goals(arena.goals)
        case "never-falls":
            return _NeverFalls()
        case "never-pushes":
            return _NeverPushes(wanted.amount)
        case "returns-to-start":
            return _ReturnsToStart(arena.start.x, arena.start.y)
        case "covers":
            return _Covers(arena, body, wanted.amount)


class _Goals:
    """All of some goals. A room without any leaves nothing to do, so it holds at once."""

    def __init__(self, goals: tuple[Goal, ...]) -> None:
        self._tracker = GoalTracker(goals)
        self.amount = 0.0
        self.shortfall = 1.0

    def update(self, now: Observation) -> bool | None:
        self._tracker.observe(now)
        states = self._tracker.states
        self._measure()
        if any(state.state == "missed" for state in states):
            return False
        # To avoid something is done when the run ends without it, so such a goal stays open until then.
        return True if self._tracker.reached else None

    def holds_at_end(self) -> bool:
        self._tracker.finish(0.0)
        self._measure()
        return self._tracker.reached

    def _measure(self) -> None:
        states = self._tracker.states
        self.amount = sum(state.progress for state in states) / len(states) if states else 1.0
        self.shortfall = 1 - self.amount


class _NeverFalls:
    """No wheel hangs over a hole."""

    amount = 0.0
    shortfall = 1.0

    def update(self, now: Observation) -> bool | None:
        return False if now.wheels else None

    def holds_at_end(self) -> bool:
        return True


class _NeverPushes:
    """The wheels never drive against an obstacle for longer than some time."""

    def __init__(self, seconds: float) -> None:
        self._limit = seconds
        self._since: float | None = None
        self._before = 0.0
        self.amount = 0.0
        self.shortfall = 1.0

    def update(self, now: Observation) -> bool | None:
        if not now.is_blocked:
            self._since = None
        else:
            # The wheels were blocked for the whole of the step that ends now.
            self._since = self._before if self._since is None else self._since
            self.amount = max(self.amount, now.time - self._since)
        self._before = now.time
        return False if self.amount > self._limit + 1e-9 else None

    def holds_at_end(self) -> bool:
        return True


class _ReturnsToStart:
    """The robot leaves its start and comes back."""

    def __init__(self, x: float, y: float) -> None:
        self._start = (x, y)
        self._left = False
        self.amount = math.inf
        self.shortfall = 1.0

    def update(self, now: Observation) -> bool | None:
        distance = math.dist(self._start, (now.x, now.y))
        self._left = self._left or distance > LEFT_START
        if not self._left:
            return None
        self.amount = min(self.amount, distance)
        self.shortfall = min(1.0, self.amount / 10)
        return True if distance < AT_START else None

    def holds_at_end(self) -> bool:
        if math.isinf(self.amount):
            self.amount = 0.0
        return False


class _Covers:
    """The body passes over a share of the floor that it can reach."""

    def __init__(self, arena: Arena, body: Body, share: float) -> None:
        self._grid = FloorGrid(arena, body.radius)
        reachable = self._grid.distances(arena.start.x, arena.start.y)
        self._left = self._grid.covered_from(iter(reachable))
        self._total = max(1, len(self._left))
        self._share = share
        self._last: tuple[int, int] | None = None
        self.amount = 0.0
        self.shortfall = 1.0

    def update(self, now: Observation) -> bool | None:
        cell = self._grid.cell_at(now.x, now.y)
        if cell != self._last:
            self._last = cell
            self._left -= self._grid.covered_from(iter([cell]))
            self.amount = 100 * (1 - len(self._left) / self._total)
            self.shortfall = 1 - self.amount / 100
        return True if self.amount >= self._share - 1e-9 else None

    def holds_at_end(self) -> bool:
        return False
