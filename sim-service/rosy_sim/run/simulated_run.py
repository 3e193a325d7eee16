"""
Simulated run: a program in the simulator that a page watches.

Connects the compiled program (``page_run``) to the world (``lockstep``) and to the clock (``realtime_runner``), and
turns what happens in each step into messages for the page.
"""

from __future__ import annotations

import socket
from collections.abc import Callable
from dataclasses import dataclass

from ..wire import page
from ..wire.firing import read_firings
from ..wire.problem import Problem
from ..wire.topics import TopicMessage
from ..wire.worker import Started
from ..worker.prepared_runs import PreparedRun
from ..world.events import Reading, velocity
from ..world.time_step import STEPS_PER_SECOND
from ..world.world import World
from .page_run import PageRun, RunView
from .problems import broken_link, died, missing_parts, too_much_output
from .realtime_runner import Ending, RealTimeRunner
from .steps.hands import apply_hand
from .steps.lockstep import Lockstep
from .steps.replay import NO_REPLAY, Replay
from .steps.velocity_guard import SafetySettings
from .worker_session import RunServices

__all__ = ["SimulatedRun", "Simulation"]

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


class SimulatedRun(PageRun):
    """Ends by itself, by stop(), or at once by end_now(). Implements ``RunnerListener``."""

    def __init__(
        self,
        request: page.Run,
        simulation: Simulation,
        services: RunServices,
        view: RunView,
        on_over: Callable[[PageRun], None],
        prepared: PreparedRun | None = None,
    ) -> None:
        self._simulation = simulation
        self._safety = simulation.safety
        self._speed: page.Speed = request.speed
        self._paused = request.paused
        # Whether the page was told that the run waits for a place.
        self._is_waiting = False
        # The problems of a program that runs.
        self._warnings: list[Problem] = []
        self._observes = simulation.observes
        self._replay = simulation.replay
        # Whether the replay has had other commands than the earlier run.
        self._has_diverged = False
        # Set when the program has started; None again when the run is over.
        self._runner: RealTimeRunner | None = None
        self._lockstep: Lockstep | None = None
        self._on_finished = on_over
        super().__init__(request, services, view, self._finish, prepared)
        if self._replay.steps == 0:
            view.show_frame(force=True)

    # Requests of the page

    def stop(self) -> None:
        """Let the program end in good order, which takes a second at most."""
        if self._session.is_compiling:
            self.end_now()
        elif self._runner is not None:
            self._runner.stop()

    def end_now(self) -> None:
        """End without waiting for anything; the page is told."""
        if self._session.is_compiling:
            self._session.cancel()
        elif self._runner is not None:
            self._runner.abandon()
            self._session.kill()
            self._runner = None
            self._view.show_frame(force=True)
            self._simulation.on_over()
        self._end("stopped", [])

    def set_speed(self, speed: page.Speed) -> None:
        """Change the speed of the clock."""
        self._speed = speed
        if self._runner is not None:
            self._runner.set_speed(speed)

    def pause(self) -> None:
        """Stop the clock; the page gets the frame of the last step, which may have come too soon to be sent."""
        self._paused = True
        if self._runner is not None:
            self._runner.pause()
            if not self.is_replaying:
                self._session.yield_slot()
                self._view.show_frame(force=True)

    def resume(self) -> None:
        """Restart the clock, when there is a place among the runs that run at once."""
        self._paused = False
        if self._runner is not None:
            self._is_waiting = False
            self._session.take_slot(self._go_on)

    def _go_on(self) -> None:
        if self._runner is not None and not self._paused:
            if self._is_waiting:
                self._is_waiting = False
                self._view.show_state("running", self._warnings)
            self._runner.resume()

    def on_queued(self, place: int) -> None:
        """The run queue is full, at the start or after a pause."""
        self._is_waiting = True
        super().on_queued(place)

    def forward(self) -> None:
        """Make one step while paused."""
        if self._runner is not None:
            self._runner.forward()

    @property
    def step(self) -> int:
        """The step that is next, or in progress; 0 while the program compiles."""
        return self._lockstep.step if self._lockstep is not None else 0

    @property
    def is_in_step(self) -> bool:
        """Whether a step has been sensed and is not integrated yet, or an earlier run is replayed. Hands wait."""
        return self.is_replaying or (
            self._runner is not None and self._lockstep is not None and self._lockstep.state == "thinking"
        )

    @property
    def is_replaying(self) -> bool:
        """Whether the steps of an earlier run are repeated."""
        return self.step < self._replay.steps

    def post(self, message: TopicMessage) -> None:
        """A message on a topic, for a program that takes it."""
        if self._lockstep is not None:
            self._lockstep.post(message)

    def switch_safety(self, settings: SafetySettings) -> None:
        """Change the safety rules."""
        self._safety = settings
        if self._lockstep is not None:
            self._lockstep.switch_safety(settings)

    def observe(self, on: bool) -> None:
        """Whether the firings are told with their provenance, from the next step on."""
        self._observes = on
        if self._lockstep is not None:
            self._observe(self._lockstep)

    def _observe(self, lockstep: Lockstep) -> None:
        observed = self._services.observed
        lockstep.observes = self._observes and observed.admit(self)
        if not lockstep.observes:
            observed.runs.discard(self)

    def _finish(self, run: PageRun) -> None:
        self._services.observed.runs.discard(self)
        self._on_finished(run)

    # CompilationListener

    def on_started(self, link: socket.socket, started: Started) -> None:
        """The program runs, if the robot has what it uses."""
        missing = missing_parts(self._simulation.world, started.uses)
        if missing:
            link.close()
            self._session.kill()
            self._end("error", missing)
            return
        self._warnings = started.problems
        self._view.show_started(started.problems, started.branches)
        lockstep = self._lockstep = Lockstep(self._simulation.world, self._simulation.seed, safety=self._safety)
        self._observe(lockstep)
        self._repeat_hands(lockstep)
        services, replayed = self._services, self._replay.steps
        self._runner = RealTimeRunner(link, lockstep, services.limits, services.lateness, self, self._speed, replayed)
        if self._paused:
            self._runner.pause()
            if not self.is_replaying:
                self._session.yield_slot()

    # RunnerListener

    def on_step(self, lockstep: Lockstep) -> None:
        """A step has settled and its time has passed."""
        self._view.step = lockstep.step
        if lockstep.settled is not None and lockstep.step <= self._replay.steps:
            self._show_replayed(lockstep)
        else:
            self._show_live(lockstep)
        self._simulation.on_step(lockstep)

    def _repeat_hands(self, lockstep: Lockstep) -> None:
        for action in self._replay.hands_before(lockstep.step):
            apply_hand(lockstep, action)

    def _show_replayed(self, lockstep: Lockstep) -> None:
        """The page has seen this step already, unless the program has changed and does something else."""
        view, replay = self._view, self._replay
        self._repeat_hands(lockstep)
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
        if is_last and lockstep.goals:
            view.show_goals(lockstep.goals.states)

    def _add_firings(self, lockstep: Lockstep) -> None:
        """Show what fired in this step with the next frame."""
        done = lockstep.settled or lockstep.ended
        if done is not None:
            self._view.add_fired(done.fired)
            self._view.add_sensed(done.sensed)
            if self._view.shows_firings:
                step = lockstep.settled.step if lockstep.settled is not None else lockstep.step
                self._view.add_firings(step / STEPS_PER_SECOND, read_firings(done.firings))

    def _show_live(self, lockstep: Lockstep) -> None:
        view = self._view
        self._simulation.on_events(lockstep.events)
        for message in lockstep.published:
            self._simulation.on_message(message)
        view.show_output(lockstep.time, lockstep.said(), lockstep.sounds())
        self._simulation.on_safety(lockstep.is_overridden, lockstep.time)
        for conflict in lockstep.conflicts:
            view.show_conflict(lockstep.time, conflict)
        self._add_firings(lockstep)
        if lockstep.settled is not None and lockstep.settled.memory is not None:
            view.set_memory(lockstep.settled.memory)
        view.show_frame(force=self._paused)
        if lockstep.goals:
            view.show_goals(lockstep.goals.states)

    def on_end(self, lockstep: Lockstep, ending: Ending, detail: str) -> None:
        """The run is over."""
        self._runner = None
        self._simulation.world.command(velocity(0.0, 0.0))
        self._simulation.on_safety(False, lockstep.time)
        self._view.show_frame(force=True)
        time = lockstep.time
        if lockstep.goals:
            lockstep.goals.finish(time)
            self._view.show_goals(lockstep.goals.states)
        self._simulation.on_over()
        if ending == "stuck" or ending == "died":
            self._end_silent(ending, time)
            return
        self._session.kill()
        if ending == "error":
            last = lockstep.ended
            problem = last.problem if last is not None and last.problem is not None else died(None, time)
            self._end("error", [problem])
        elif ending == "broken":
            self._end("error", [broken_link(detail, time)])
        elif ending == "loud":
            self._end("error", [too_much_output(detail, time)])
        else:
            self._end(ending, [])
