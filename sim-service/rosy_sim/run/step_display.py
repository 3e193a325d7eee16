"""
Step display: what a page is shown of each step of a simulated run, and what else is told of it.

In each step of each page: compiled (``compiled_modules``), which is why it is a class of its own.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from ..wire.firing import read_firings
from ..wire.page import Companion
from ..wire.topics import TopicMessage
from ..world.events import Reading
from ..world.time_step import STEPS_PER_SECOND
from ..world.world import World
from .page_run import RunView
from .steps.hands import apply_hand
from .steps.lockstep import Lockstep
from .steps.replay import NO_REPLAY, Replay
from .steps.velocity_guard import SafetySettings

__all__ = ["Simulation", "StepDisplay"]

_DIVERGED_STEPS = 5
"""Steps between two frames of a replay that differs from the earlier run: 10 frames per simulated second."""


@dataclass(frozen=True, slots=True)
class Simulation:
    """What a program is run in."""

    world: World
    seed: int
    # Called in each step with what the robot has sensed.
    on_events: Callable[[list[Reading]], None]
    # Called for each message that the program publishes on a topic of its own.
    on_message: Callable[[TopicMessage], None]
    safety: SafetySettings
    # Called in each step: whether the safety rules override the program, and the time in s.
    on_safety: Callable[[bool, float], None]
    # Called after each step, and once when the run is over.
    on_step: Callable[[Lockstep], None] = lambda _: None
    on_over: Callable[[], None] = lambda: None
    # Whether the page asks for a record of the firings.
    observes: bool = False
    # What is repeated of an earlier run before this one is live.
    replay: Replay = NO_REPLAY
    # The programs of the other robots in the world.
    companions: tuple[Companion, ...] = ()


class StepDisplay:
    """Of one run."""

    def __init__(self, simulation: Simulation, view: RunView, paused: bool) -> None:
        self._simulation = simulation
        self._view = view
        self._replay = simulation.replay
        # Whether the clock is stopped: then each step is shown.
        self.paused = paused
        # Whether the replay has had other commands than the earlier run.
        self._has_diverged = False

    def on_step(self, lockstep: Lockstep) -> None:
        """A step has settled and its time has passed."""
        self._view.step = lockstep.step
        if lockstep.settled is not None and lockstep.step <= self._replay.steps:
            self._show_replayed(lockstep)
        else:
            self._show_live(lockstep)
        self._simulation.on_step(lockstep)

    def repeat_hands(self, lockstep: Lockstep) -> None:
        """Apply what hands did before the next step of the run that is repeated."""
        for action in self._replay.hands_before(lockstep.step):
            apply_hand(lockstep, action)

    def _show_replayed(self, lockstep: Lockstep) -> None:
        """The page has seen this step already, unless the program has changed and does something else."""
        view, replay = self._view, self._replay
        self.repeat_hands(lockstep)
        if not self._has_diverged and replay.commands.differs(lockstep):
            self._has_diverged = True
            view.show_divergence((lockstep.step - 1) / STEPS_PER_SECOND)
        if lockstep.settled is not None and lockstep.settled.memory is not None:
            view.set_memory(lockstep.settled.memory)
        if self._has_diverged:
            self._add_firings(lockstep)
        is_last = lockstep.step == replay.steps
        if is_last and not self._has_diverged and replay.commands.kept_steps < replay.steps:
            view.show_uncompared(replay.commands.kept_steps / STEPS_PER_SECOND)
        if is_last or (self._has_diverged and lockstep.step % _DIVERGED_STEPS == 0):
            view.show_frame(force=True)
        if is_last and lockstep.has_goals:
            view.show_goals(lockstep.goals.states)

    def _add_firings(self, lockstep: Lockstep) -> None:
        """Show what fired in this step with the next frame."""
        done = lockstep.settled or lockstep.ended
        if done is not None:
            self._view.add_fired(done.fired)
            time = _program_time(lockstep)
            self._view.add_sensed(time, done.sensed)
            if self._view.shows_firings:
                self._view.add_firings(time, read_firings(done.firings))

    def _show_live(self, lockstep: Lockstep) -> None:
        view = self._view
        self._simulation.on_events(lockstep.events)
        for message in lockstep.published:
            self._simulation.on_message(message)
        if lockstep.commands:
            view.show_output(_program_time(lockstep), lockstep.said(), lockstep.sounds())
        self._simulation.on_safety(lockstep.is_overridden, lockstep.time)
        for conflict in lockstep.conflicts:
            view.show_conflict(lockstep.time, conflict)
        if lockstep.is_blocked:
            view.show_blocked(lockstep.time, lockstep.has_bumped)
        self._add_firings(lockstep)
        if lockstep.settled is not None and lockstep.settled.memory is not None:
            view.set_memory(lockstep.settled.memory)
        view.show_frame(force=self.paused)
        if lockstep.has_goals:
            view.show_goals(lockstep.goals.states)


def _program_time(lockstep: Lockstep) -> float:
    """When the program did what it did in the step that has just been made, s: the world is one step further."""
    step = lockstep.settled.step if lockstep.settled is not None else lockstep.step
    return step / STEPS_PER_SECOND
