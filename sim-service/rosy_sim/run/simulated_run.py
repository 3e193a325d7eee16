"""
Simulated run: a program in the simulator that a page watches.

Connects the compiled program (``page_run``) to the world (``lockstep``), to the clock (``realtime_runner``), and to
what the page is shown of each step (``step_display``).
"""

from __future__ import annotations

import socket
from collections.abc import Callable

from ..wire import page
from ..wire.problem import Problem
from ..wire.topics import TopicMessage
from ..wire.worker import Started
from ..worker.prepared_runs import PreparedRun
from ..world.events import velocity
from .companions import Companions
from .page_run import PageRun, RunView
from .problems import broken_link, died, missing_parts, place_needed, too_much_output
from .realtime_runner import Ending, RealTimeRunner
from .step_display import Simulation, StepDisplay
from .steps.lockstep import Lockstep
from .steps.velocity_guard import SafetySettings
from .worker_session import RunServices

__all__ = ["SimulatedRun"]


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
        self._display = StepDisplay(simulation, view, request.paused)
        self._speed: page.Speed = request.speed
        # Whether the page was told that the run waits for a place.
        self._is_waiting = False
        # The problems of a program that runs.
        self._warnings: list[Problem] = []
        self._observes = simulation.observes
        self._replay = simulation.replay
        # Set when the program has started; None again when the run is over.
        self._runner: RealTimeRunner | None = None
        self._lockstep: Lockstep | None = None
        self._on_finished = on_over
        # The programs of the other robots in the room; None without any.
        self._companions: Companions | None = None
        super().__init__(request, services, view, self._finish, prepared)
        if simulation.companions:
            # After this program, which has its place first.
            others, seed = simulation.world.others, simulation.seed
            self._companions = Companions(simulation.companions, others, seed, services, self._safety, view)
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
        self._end_at_once([])

    def _preemption(self) -> Callable[[], None]:
        return lambda: self._end_at_once([place_needed()])

    def _end_at_once(self, problems: list[Problem]) -> None:
        if self._session.is_compiling:
            self._session.cancel()
        elif self._runner is not None:
            self._runner.abandon()
            self._session.kill()
            self._runner = None
            if self._lockstep is not None:
                self._lockstep.cancel_goals()
            self._view.show_frame(force=True)
            self._simulation.on_over()
        self._end("stopped", problems)

    def set_speed(self, speed: page.Speed) -> None:
        """Change the speed of the clock."""
        self._speed = speed
        if self._runner is not None:
            self._runner.set_speed(speed)

    def pause(self) -> None:
        """Stop the clock; the page gets the frame of the last step, which may have come too soon to be sent."""
        self._display.paused = True
        if self._runner is not None:
            self._runner.pause()
            if not self.is_replaying:
                self._session.yield_slot()
                self._view.show_frame(force=True)

    def resume(self) -> None:
        """Restart the clock, when there is a place among the runs that run at once."""
        self._display.paused = False
        if self._runner is not None:
            self._is_waiting = False
            self._session.take_slot(self._go_on)

    def _go_on(self) -> None:
        if self._runner is not None and not self._display.paused:
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
        if self._companions is not None:
            self._companions.switch_safety(settings)

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
        if self._companions is not None:
            self._companions.stop()
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
        self._display.repeat_hands(lockstep)
        services, replayed = self._services, self._replay.steps
        self._runner = RealTimeRunner(
            link,
            lockstep,
            services.limits,
            services.lateness,
            services.phases,
            self,
            self._speed,
            replayed,
            companions=self._companions,
        )
        if self._display.paused:
            self._runner.pause()
            if not self.is_replaying:
                self._session.yield_slot()

    # RunnerListener

    def on_step(self, lockstep: Lockstep) -> None:
        """A step has settled and its time has passed."""
        if lockstep.commands or lockstep.published or (lockstep.settled is not None and lockstep.settled.fired):
            self._session.touch()
        self._display.on_step(lockstep)

    def on_end(self, lockstep: Lockstep, ending: Ending, detail: str) -> None:
        """The run is over."""
        self._runner = None
        lockstep.cancel_goals()
        self._simulation.world.command(velocity(0.0, 0.0))
        self._simulation.on_safety(False, lockstep.time)
        self._view.show_frame(force=True)
        time = lockstep.time
        if lockstep.has_goals:
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
