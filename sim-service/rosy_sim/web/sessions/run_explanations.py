"""
Explanations of the runs of a page: records a run while the page observes it, and answers why and why not.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field

import msgspec

from ...explain.answers import (
    Answer,
    why_command,
    why_event,
    why_firing,
    why_memory,
    why_not,
    why_not_branch,
    why_position,
)
from ...explain.function_types import function_types, with_synonyms, written_memories
from ...explain.recorded_run import RecordedRun
from ...explain.recorded_step import EncodedContent, StepContent, commands_of_step
from ...explain.untaken_branch import branch_at
from ...explain.why import Link
from ...explain.why_not import FunctionType, RobotLimits, Window
from ...run.steps.lockstep import Lockstep
from ...wire import page
from ...wire.explanation import Sentence
from ...wire.firing import Branch, Firing
from ...wire.robot_process import ObservedStep
from ...wire.worker import Checked
from ...world.events import VELOCITY_CHANNEL, Command
from ...world.time_step import STEPS_PER_SECOND
from .run_history import RunHistory

__all__ = ["MOST_FIRINGS", "RunExplanations"]

MOST_FIRINGS = 20_000
"""Firings that are kept of a run: six minutes of a program that fires 50 times a second, 20 MB. A choice of ours."""

_NO_LIMITS = RobotLimits(math.inf, math.inf)
"""Before the first run."""


@dataclass(slots=True)
class _Explained:
    """What is known of a run."""

    run: int = 0
    source: str = ""
    record: RecordedRun | None = None
    # The graph of the program; None until the compiler has told it.
    graph: msgspec.Raw | None = None
    # Whether a step of the run has passed.
    has_begun: bool = False
    limits: RobotLimits = _NO_LIMITS
    # Between which the functions of the program choose; none until it has begun.
    branches: list[Branch] = field(default_factory=list)


class RunExplanations:
    """Of one page. ``send`` puts a message into the page's outbox."""

    def __init__(self, send: Callable[[page.Because], None]) -> None:
        self._send = send
        self._latest = _Explained()
        # The runs before; their firings together are bounded like those of one run.
        self._earlier: RunHistory[_Explained] = RunHistory(MOST_FIRINGS)
        # The latest program that was checked without mistakes, with its graph.
        self._checked: tuple[str, msgspec.Raw] | None = None
        # How often hands had put the robot in another place, as of the last recorded step.
        self._placements = 0

    def on_checked(self, source: str, checked: Checked) -> None:
        """The compiler has answered about a program."""
        if any(problem.severity == "error" for problem in checked.problems):
            return
        self._checked = (source, checked.graph)
        if source == self._latest.source:
            self._latest.graph = checked.graph

    def start(self, run: int, source: str, limits: RobotLimits) -> None:
        """A run begins, on a robot with these limits."""
        before = self._latest
        if before.record is not None:
            self._earlier.add(before.run, before, before.record.count)
        graph = self._checked[1] if self._checked is not None and self._checked[0] == source else None
        self._latest = _Explained(run, source, graph=graph, limits=limits)

    def on_branches(self, branches: list[Branch]) -> None:
        """The program of the latest run begins to run."""
        self._latest.branches = branches

    def on_step(self, lockstep: Lockstep) -> None:
        """A step of a simulated run has passed."""
        self._latest.has_begun = True
        done = lockstep.settled or lockstep.ended
        if not lockstep.observes:
            self._latest.record = None
        elif done is not None:
            step = lockstep.settled.step if lockstep.settled is not None else lockstep.step
            placements = lockstep.world.placements
            if self._latest.record is None:
                self._placements = placements
            self._record(
                step / STEPS_PER_SECOND,
                # A copy: commands that arrive after the step are appended to the same list.
                EncodedContent(bytes(done.firings), done.sensed, list(lockstep.commands)),
                is_overridden=lockstep.is_overridden,
                is_placed=placements != self._placements,
            )
            self._placements = placements

    def on_robot_step(
        self,
        time: float,
        observed: ObservedStep | None,
        commands: list[Command],
        *,
        is_first: bool,
        is_overridden: bool,
    ) -> None:
        """
        A step of a run on a real robot has passed; without ``observed`` it was not observed. The first one passes a
        little after the time of the run began.
        """
        self._latest.has_begun = True
        if observed is None:
            self._latest.record = None
        else:
            firings, sensed = observed.firings, observed.sensed
            sent = [given.value for firing in firings for given in firing.gave if given.to == "event"]
            content = StepContent(firings, sensed + sent, commands_of_step(firings, commands))
            self._record(time, content, is_overridden=is_overridden, is_first=is_first)

    def on_robot_unobserved(self) -> None:
        """A run on a real robot begins or goes on without being observed; its steps without commands are not told."""
        self._latest.has_begun = True
        self._latest.record = None

    def _record(
        self,
        time: float,
        content: StepContent | EncodedContent,
        *,
        is_overridden: bool,
        is_placed: bool = False,
        is_first: bool = False,
    ) -> None:
        """Record an observed step."""
        if self._latest.record is None:
            self._latest.record = RecordedRun(most=MOST_FIRINGS)
            # Numbers of firings begin anew when an observation begins: nothing of before is kept.
            self._latest.record.known_since = 0.0 if is_first else time
        self._latest.record.add(time, content, is_overridden=is_overridden, is_placed=is_placed)

    def latest_firings(self, run: int) -> list[tuple[float, Firing]]:
        """The latest firing of each function, with its time, in order; none of a run that is not the latest one."""
        record = self._latest.record
        return record.latest_firings() if record is not None and run == self._latest.run else []

    def knows(self, run: int | None) -> bool:
        """Whether something is known of a run with this number."""
        return run is not None and (run == self._latest.run or self._earlier.get(run) is not None)

    def answer(self, request: page.Why | page.WhyNot) -> None:
        """Answer a question of the page."""
        about = self._about(request.run)
        run = about.record
        if run is None:
            answer = Answer([Link(Sentence("not-recorded" if about.has_begun else "run-not-begun"), 0.0)], 0.0)
        elif isinstance(request, page.WhyNot):
            window = Window(request.since, request.until)
            functions, asked = _functions(about), _branch(request, about)
            if asked is not None:
                answer = why_not_branch(run, functions, about.branches, asked, window)
            else:
                answer = why_not(run, functions, window, about.limits, request.function, request.command, request.event)
        else:
            answer = _why(run, request, about)
        path = [page.firing_shown(firing, run.time_of(firing)) for firing in answer.path] if run is not None else []
        memories = written_memories(about.graph) if about.graph is not None else {}
        sentences = [
            page.SentenceShown(with_synonyms(link.said, memories), link.time, link.firing) for link in answer.links
        ]
        self._send(page.Because(request.id, answer.time, sentences, path))

    def _about(self, run: int | None) -> _Explained:
        """The run that is asked about; one that is no longer kept is as one that was not recorded."""
        if run is None or run == self._latest.run:
            return self._latest
        return self._earlier.get(run) or _Explained(run, has_begun=True)


def _functions(about: _Explained) -> list[FunctionType]:
    return function_types(about.graph) if about.graph is not None else []


def _branch(request: page.WhyNot, about: _Explained) -> Branch | None:
    place = request.branch
    return branch_at(about.branches, place.start, place.end) if place is not None else None


def _why(run: RecordedRun, request: page.Why, about: _Explained) -> Answer:
    limits = about.limits
    time = request.time if request.time is not None else run.end or 0.0
    if request.firing is not None:
        return why_firing(run, request.firing)
    if request.function:
        latest = run.latest_firing(request.function, time)
        if latest is not None:
            return why_firing(run, latest.n)
        return why_not(run, _functions(about), Window(0.0, time), limits, request.function)
    if request.position:
        return why_position(run, time, limits)
    if request.memory:
        return why_memory(run, request.memory, time)
    if request.event:
        return why_event(run, request.event, time)
    return why_command(run, request.command or VELOCITY_CHANNEL, time, limits)
