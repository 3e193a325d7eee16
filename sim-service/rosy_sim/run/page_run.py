"""
Run that a page watches, wherever it drives: from the press of Run to the last message for the page.

It is compiled in a ``WorkerSession`` and reports to a ``RunView``. ``simulated_run`` adds what is particular to the
simulator, ``ownership.robot_run`` what is particular to a real robot.
"""

from __future__ import annotations

import asyncio
import socket
from abc import ABC, abstractmethod
from collections.abc import Callable
from typing import Literal, Protocol

from ..wire import page
from ..wire.firing import Branch, Firing
from ..wire.link_messages import MemoryValue
from ..wire.problem import Problem
from ..wire.robot_process import ObservedStep
from ..wire.worker import Started
from ..worker.prepared_runs import PreparedRun
from ..world.events import Command
from ..world.goals import GoalState
from .companions import CompanionView
from .steps.command_conflicts import CommandConflict
from .worker_session import RunServices, Silence, WorkerSession

__all__ = ["Ended", "OnObservedStep", "PageRun", "RunView"]

Ended = Literal["done", "error", "stuck", "stopped", "time", "refused"]


class RunView(CompanionView, Protocol):
    """Receives what a page is shown of a run. ``web.sessions.page_view`` implements it."""

    # The latest step of the run; set by the run.
    step: int
    # Whether the page asks for firings with their provenance; set by the page.
    shows_firings: bool

    def show_state(self, state: Literal["compiling", "running"], problems: list[Problem] | None = None) -> None:
        """Show where the run is."""

    def show_started(self, problems: list[Problem], branches: list[Branch]) -> None:
        """Show that the program begins to run, with its warnings and branches."""

    def show_queued(self, place: int) -> None:
        """Show the position in the run queue, 1 for the next."""

    def show_ended(self, run: int, ended: Ended, problems: list[Problem]) -> None:
        """Show that a run, which need not be the latest, has ended."""

    def add_fired(self, names: list[str]) -> None:
        """Show these functions with the next frame."""

    def add_sensed(self, time: float, texts: list[str]) -> None:
        """Show the events that the program sensed at a time, s, with the next frame."""

    def add_firings(self, time: float, firings: list[Firing]) -> None:
        """Show these firings of a step, with their provenance, with the next frame."""

    def set_memory(self, values: list[MemoryValue]) -> None:
        """Show what the program remembers with the next frame."""

    def show_output(self, time: float, texts: list[str], sounds: list[int]) -> None:
        """Show the texts and play the sounds of a step."""

    def show_conflict(self, time: float, conflict: CommandConflict) -> None:
        """Show that functions override each other's commands."""

    def show_blocked(self, time: float, has_bumped: bool) -> None:
        """Show that the robot pushes against something and does not move; ``has_bumped``: with its bumper."""

    def show_divergence(self, time: float) -> None:
        """Show when the program began to differ from the run that it repeats."""

    def show_uncompared(self, time: float) -> None:
        """Show since when it is not known whether the program differs from the run that it repeats."""

    def show_goals(self, states: list[GoalState]) -> None:
        """Show the goals if they have changed visibly."""

    def show_frame(self, force: bool = False) -> None:
        """Show the simulated robot as it is now, unless the last frame was too recent."""


class OnObservedStep(Protocol):
    """Called for each step of a robot with commands, and for each observed one."""

    def __call__(
        self,
        time: float,
        observed: ObservedStep | None,
        commands: list[Command],
        *,
        is_first: bool,
        is_overridden: bool,
    ) -> None:
        """
        Without ``observed`` the step was not observed. ``is_first``: it is the first of the run. ``is_overridden``: the
        robot was sent another velocity than the program's.
        """


class PageRun(ABC):
    """
    Compiles at once; implements ``CompilationListener``.

    Args:
        on_over: called once, when the robot is free for the next run. The page may still have to be told why this run
            ended: see ``is_explained``.
        prepared: what is compiled of the program already.
    """

    def __init__(
        self,
        request: page.Run,
        services: RunServices,
        view: RunView,
        on_over: Callable[[PageRun], None],
        prepared: PreparedRun | None = None,
    ) -> None:
        self._run = request.run
        self._services = services
        self._view = view
        self._on_over = on_over
        # The robot is free again, and the page has been told how the run ended or will be.
        self._is_over = False
        # Asks the worker why the program went silent.
        self._explanation: asyncio.Task[None] | None = None
        view.show_state("compiling")
        self._session = WorkerSession(request.source, services, self, prepared, self._preemption())

    # Requests of the page

    @abstractmethod
    def stop(self) -> None:
        """Let the program end in good order, which takes a second at most."""

    @abstractmethod
    def end_now(self) -> None:
        """End without waiting for anything; the page is told."""

    @abstractmethod
    def set_speed(self, speed: page.Speed) -> None:
        """Change the speed of the clock."""

    @abstractmethod
    def pause(self) -> None:
        """Stop the clock."""

    @abstractmethod
    def resume(self) -> None:
        """Restart the clock."""

    @abstractmethod
    def forward(self) -> None:
        """Make one step while paused."""

    def _preemption(self) -> Callable[[], None] | None:
        """What ends this run for a client that has no place; ``None`` for one that keeps its place."""
        return None

    # After the end

    def cancel_explanation(self) -> None:
        """The page is gone: do not ask the worker any more."""
        if self._explanation is not None:
            self._explanation.cancel()

    @property
    def is_explained(self) -> bool:
        """Whether the page has been told how the run ended."""
        return self._explanation is None or self._explanation.done()

    # CompilationListener

    def on_queued(self, place: int) -> None:
        """The run queue is full."""
        self._view.show_queued(place)

    def on_turn(self) -> None:
        """The wait in the queue is over."""
        self._view.show_state("compiling")

    @abstractmethod
    def on_started(self, link: socket.socket, started: Started) -> None:
        """The program runs; this run owns its link."""

    def on_failed(self, ended: Literal["refused", "error"], problems: list[Problem]) -> None:
        """The program does not compile, or the worker is lost."""
        self._end(ended, problems)

    # The end

    def _end(self, ended: Ended, problems: list[Problem]) -> None:
        """Tell the page, once."""
        if self._is_over:
            return
        self._is_over = True
        self._view.show_ended(self._run, ended, problems)
        self._on_over(self)

    def _end_silent(self, silence: Silence, time: float) -> None:
        """Tell the page as soon as the worker has reported the cause."""
        if self._is_over:
            return
        self._is_over = True
        self._explanation = asyncio.get_running_loop().create_task(self._explain(silence, time))
        self._on_over(self)

    async def _explain(self, silence: Silence, time: float) -> None:
        problem = await self._session.diagnose(silence, time)
        self._view.show_ended(self._run, "stuck" if silence == "stuck" else "error", [problem])
