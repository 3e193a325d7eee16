"""
Companions of a run: the other robots in its room, each with a program of its own.

Their programs are compiled with that of the run, and make the same steps: a step is over when all programs have
settled, so a run with companions is as repeatable as one without. They end with the run. One that does not run, or
that ends before, is reported once, and its robot stands from then on. ``realtime_runner`` says when steps begin.
"""

from __future__ import annotations

import asyncio
import socket
from collections.abc import Callable, Sequence
from typing import Literal, Protocol

from ..wire import page
from ..wire.problem import Problem
from ..wire.worker import Started
from ..world.events import velocity
from ..world.world import World
from .loop_link import Failure, LoopLink
from .problems import broken_link, died, missing_parts, no_place_beside, place_needed, too_much_output
from .steps.lockstep import Lockstep
from .steps.velocity_guard import SafetySettings
from .worker_session import RunServices, WorkerSession

__all__ = ["Companion", "CompanionView", "Companions"]


class CompanionView(Protocol):
    """Receives what a page is shown of companions; their numbers are from 1 on."""

    def show_companion_said(self, robot: int, time: float, texts: list[str], sounds: list[int]) -> None:
        """Show the texts and play the sounds of a step, s."""

    def show_companion_ended(self, robot: int, time: float, problem: Problem | None) -> None:
        """Show that a companion's program has ended before the run, at a time, s; why, if not by itself."""


class Companion:
    """
    Program of one further robot. Implements ``CompilationListener`` and ``LinkListener``.

    Args:
        number: of the robot, from 1 on.
        on_settled: called when the program is no longer waited for: it is ready, has settled, or is over.
    """

    def __init__(
        self,
        number: int,
        source: str,
        world: World,
        seed: int,
        services: RunServices,
        safety: SafetySettings,
        view: CompanionView,
        on_settled: Callable[[], None],
    ) -> None:
        self.number = number
        self.world = world
        self._services = services
        self._view = view
        self._on_settled = on_settled
        self._loop = asyncio.get_running_loop()
        self.lockstep = Lockstep(world, seed, safety=safety)
        # Set when the program runs; None again when it is over.
        self._link: LoopLink | None = None
        self.is_over = False
        # Seconds of wall-clock time left for the answer that is awaited; None while none is.
        self._patience: float | None = None
        # Asks the worker why the program went silent.
        self._explanation: asyncio.Task[None] | None = None
        self._session = WorkerSession(source, services, self, on_preempt=lambda: self._end(place_needed()))

    @property
    def is_settled(self) -> bool:
        """Whether nothing is awaited of the program."""
        return self.is_over or (self._link is not None and self.lockstep.state in ("ready", "settled"))

    # CompilationListener

    def on_queued(self, place: int) -> None:
        """There is no place for one more program. A run waits for its own place only, or two runs could for ever."""
        del place
        self._end(no_place_beside())

    def on_turn(self) -> None:
        """The wait in the queue is over."""

    def on_started(self, link: socket.socket, started: Started) -> None:
        """The program runs, if its robot has what it uses."""
        self._link = LoopLink(link, self.lockstep, self)
        missing = missing_parts(self.world, started.uses)
        if missing:
            self._end(missing[0])
            return
        self._patience = self._services.limits.ready
        self._link.send(self.lockstep.begin())

    def on_failed(self, ended: Literal["refused", "error"], problems: list[Problem]) -> None:
        """The program does not compile, or the worker is lost."""
        del ended
        self._end(next((found for found in problems if found.severity == "error"), None) or died(None, 0.0))

    # Steps

    def sense(self) -> None:
        """A step begins."""
        if self.is_over:
            return
        assert self._link is not None
        batch = self.lockstep.sense()
        if batch:
            self._patience = self._services.limits.settle
            self._link.send(batch)

    def settle(self, is_shown: bool) -> None:
        """All programs have settled: the commands count from now on. ``is_shown``: what it said is new to the page."""
        lockstep = self.lockstep
        if self.is_over:
            return
        lockstep.guard()
        if lockstep.commands:
            self._session.touch()
            if is_shown:
                self._view.show_companion_said(self.number, lockstep.time, lockstep.said(), lockstep.sounds())

    def advance(self) -> None:
        """The time of the step has passed."""
        if not self.is_over:
            self.lockstep.advance()

    def check_deadline(self, seconds: float) -> None:
        """So much wall-clock time has passed."""
        if self._patience is not None:
            self._patience -= seconds
            if self._patience < 0:
                self._end_silent("stuck")

    # LinkListener

    def on_answer(self) -> None:
        """The program is ready, has settled, or has ended."""
        if self.lockstep.state == "ended":
            self._end_by_itself()
        else:
            self._patience = None
            self._on_settled()

    def on_failure(self, failure: Failure, detail: str) -> None:
        """Nothing comes of the program any more."""
        time = self.lockstep.time
        if failure == "loud":
            self._end(too_much_output(detail, time))
        elif failure == "broken":
            self._end(broken_link(detail, time))
        else:
            self._end_silent(failure)

    # The end

    def stop(self) -> None:
        """The run is over, and the program with it. Nothing is reported."""
        if self._explanation is not None:
            self._explanation.cancel()
        if not self.is_over:
            self._finish()
        self._kill()

    def _kill(self) -> None:
        if self._session.is_compiling:
            self._session.cancel()
        else:
            self._session.kill()

    def _finish(self) -> None:
        """The robot stands; what becomes of its program is left to the caller."""
        self.is_over = True
        self._patience = None
        link, self._link = self._link, None
        if link is not None:
            link.close()
        self.lockstep.cancel_goals()
        self.world.command(velocity(0.0, 0.0))

    def _end_by_itself(self) -> None:
        last = self.lockstep.ended
        problem = None
        if last is not None and last.how == "error":
            problem = last.problem or died(None, self.lockstep.time)
        self._view.show_companion_said(self.number, self.lockstep.time, self.lockstep.said(), self.lockstep.sounds())
        self._end(problem)

    def _end(self, problem: Problem | None) -> None:
        if not self.is_over:
            self._finish()
            self._kill()
            self._view.show_companion_ended(self.number, self.lockstep.time, problem)
            self._on_settled()

    def _end_silent(self, silence: Literal["stuck", "died"]) -> None:
        if not self.is_over:
            self._explanation = self._loop.create_task(self._explain(silence))
            self._finish()
            self._on_settled()

    async def _explain(self, silence: Literal["stuck", "died"]) -> None:
        time = self.lockstep.time
        problem = await self._session.diagnose(silence, time)
        self._view.show_companion_ended(self.number, time, problem)


class Companions:
    """
    All companions of one run.

    Args:
        programs: of the robots.
        worlds: theirs, in the same order.
        seed: of the run; the next numbers are those of its companions.
    """

    def __init__(
        self,
        programs: Sequence[page.Companion],
        worlds: Sequence[World],
        seed: int,
        services: RunServices,
        safety: SafetySettings,
        view: CompanionView,
    ) -> None:
        # Called when nothing is awaited any more of any of them.
        self.on_settled: Callable[[], None] = lambda: None
        self._all = [
            Companion(number, program.source, world, seed + number, services, safety, view, self._review)
            for number, (program, world) in enumerate(zip(programs, worlds, strict=True), 1)
        ]

    @property
    def are_settled(self) -> bool:
        """Whether nothing is awaited of any program."""
        return all(companion.is_settled for companion in self._all)

    def _review(self) -> None:
        if self.are_settled:
            self.on_settled()

    def sense(self) -> None:
        """A step begins."""
        for companion in self._all:
            companion.sense()

    def settle(self, is_shown: bool) -> None:
        """All programs have settled, that of the run as well; its time passes next."""
        for companion in self._all:
            companion.settle(is_shown)

    def advance(self) -> None:
        """The time of the step has passed."""
        for companion in self._all:
            companion.advance()

    def check_deadline(self, seconds: float) -> None:
        """So much wall-clock time has passed since the last check."""
        for companion in self._all:
            companion.check_deadline(seconds)

    def switch_safety(self, settings: SafetySettings) -> None:
        """Change the safety rules of all robots."""
        for companion in self._all:
            companion.lockstep.switch_safety(settings)

    def stop(self) -> None:
        """The run is over."""
        self.on_settled = lambda: None
        for companion in self._all:
            companion.stop()
