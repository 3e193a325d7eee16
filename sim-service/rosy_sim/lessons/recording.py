"""
Recording of a run for the checks of a lesson: what the robot did in each step, what it sensed and what it was told.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple

from ..run.steps.lockstep import Lockstep
from ..world.arena import Arena
from ..world.goals import GoalState
from ..world.properties import PropertyTracker

__all__ = ["Happening", "Recording", "Sample"]

MAX_HAPPENINGS = 100_000
"""Of a recording: what a program sends at most in the longest step of a lesson that is sensible."""


class Sample(NamedTuple):
    """The robot after a step: s, m, m, rad, m/s, rad/s, and the bits of the bumper and of the wheels in the air."""

    time: float
    x: float
    y: float
    theta: float
    v: float
    w: float
    bumpers: int
    wheels: int


class Happening(NamedTuple):
    """An event or a command of a step, with the values of its channel; ``time`` in s."""

    time: float
    channel: str
    values: tuple[float | int | str, ...]


@dataclass(slots=True)
class Recording:
    """What happened from the start of a run until now."""

    arena: Arena
    samples: list[Sample] = field(default_factory=list)
    events: list[Happening] = field(default_factory=list)
    commands: list[Happening] = field(default_factory=list)
    goals: list[GoalState] = field(default_factory=list)
    # What is known of the properties that checks name; changed by add() and end().
    properties: PropertyTracker | None = None
    # When the program ended by itself, s; None while it goes on or when it was stopped.
    done: float | None = None

    @property
    def time(self) -> float:
        """Seconds recorded."""
        return self.samples[-1].time if self.samples else 0.0

    def end(self) -> None:
        """Nothing more happens: what never happened holds."""
        if self.properties is not None:
            self.properties.finish(self.time)

    def add(self, lockstep: Lockstep) -> None:
        """Record the step that has settled and passed."""
        world = lockstep.world
        bits = world.sensors
        time = lockstep.time
        self.samples.append(Sample(time, world.x, world.y, world.theta, world.v, world.w, bits.bumpers, bits.wheels))
        if len(self.events) < MAX_HAPPENINGS:
            self.events += [Happening(time, channel, values) for channel, values in lockstep.events]
        if len(self.commands) < MAX_HAPPENINGS:
            self.commands += [Happening(time, channel, values) for channel, values in lockstep.commands]
        self.goals = list(lockstep.goals.states)
        if self.properties is not None:
            self.properties.observe(lockstep.observation())
        if lockstep.ended is not None and lockstep.ended.how == "done":
            self.done = time
