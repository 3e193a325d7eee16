"""
Twin of a real robot: the program that a page runs on the robot, at the same time in the simulator beside it.

The twin starts when the program begins on the robot, and ends at the time of the run at which that one ended. It has a
world, a view and a run number of its own, so the simulated robot of the page and its ROS clients notice nothing of it.
"""

from __future__ import annotations

from collections.abc import Callable

import msgspec

from ...explain.why_not import RobotLimits
from ...run.page_run import PageRun
from ...run.simulated_run import SimulatedRun
from ...run.step_display import Simulation
from ...run.steps.lockstep import Lockstep
from ...run.steps.velocity_guard import SafetySettings
from ...run.worker_session import RunServices
from ...wire import page
from .outbox import Outbox
from .page_view import PageView, Room
from .run_explanations import RunExplanations

__all__ = ["PageTwin"]


class PageTwin:
    """Of one page, which has one twin at a time; ``now`` is a clock in s that only goes forward."""

    def __init__(self, services: RunServices, outbox: Outbox, now: Callable[[], float]) -> None:
        self._services = services
        self._outbox = outbox
        self._now = now
        # Answers questions about the twins' runs.
        self.explanations = RunExplanations(outbox.put)
        # Whether the firings of the next twin are recorded.
        self._observes = False
        # What starts the twin that was prepared; None when there is none.
        self._starts: Callable[[SafetySettings], None] | None = None
        self._run: SimulatedRun | None = None
        # The step at which the real run ended; None while it goes on.
        self._until: int | None = None
        # Twins that are over but not explained yet.
        self._unexplained: list[PageRun] = []

    def prepare(self, request: page.Run, twin: int, room: Room, seed: int) -> None:
        """
        A run is about to begin on the real robot.

        Args:
            request: of that run.
            twin: the number of the twin's run.
            room: where the twin drives; nothing else may.
            seed: of that world.
        """
        self.end_now()
        explanations = self.explanations
        view = PageView(self._outbox, room, self._services.frame_rate, self._now, explanations.on_branches)
        view.run = twin

        def start(safety: SafetySettings) -> None:
            explanations.start(twin, request.source, RobotLimits.of_motors(room.world.robot.limits))
            simulation = Simulation(
                room.world,
                seed,
                lambda _: None,
                lambda _: None,
                safety,
                lambda _, __: None,
                self._on_step,
                observes=self._observes,
            )
            beside = msgspec.structs.replace(request, run=twin, speed=1.0)
            self._until = None
            self._run = SimulatedRun(beside, simulation, self._services, view, self._on_over)

        self._starts = start

    def begin(self, safety: SafetySettings) -> None:
        """The program drives the real robot from now on, within these limits."""
        starts, self._starts = self._starts, None
        if starts is not None:
            starts(safety)

    def finish(self, step: int) -> None:
        """The run on the real robot ended at this step: the twin goes on to the same one, at once."""
        self._starts = None
        if self._run is None:
            return
        self._until = step
        self._run.set_speed("max")

    def switch_safety(self, safety: SafetySettings) -> None:
        """The safety rules of the real robot were switched."""
        if self._run is not None:
            self._run.switch_safety(safety)

    def observe(self, on: bool) -> None:
        """Whether the firings are recorded, from the next step on."""
        self._observes = on
        if self._run is not None:
            self._run.observe(on)

    def end_now(self) -> None:
        """End without waiting for anything; the page is told."""
        self._starts = None
        if self._run is not None:
            self._run.end_now()

    def close(self) -> None:
        """The page is gone."""
        self.end_now()
        for run in self._unexplained:
            run.cancel_explanation()

    def _on_step(self, lockstep: Lockstep) -> None:
        self.explanations.on_step(lockstep)
        if self._until is not None and lockstep.step >= self._until:
            self.end_now()

    def _on_over(self, run: PageRun) -> None:
        self._run = None
        self._unexplained = [r for r in [*self._unexplained, run] if not r.is_explained]
