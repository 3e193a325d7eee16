"""
Watch over one run for the checks of a lesson's step: records the steps, and judges them as the run goes on.

The owner calls ``on_step`` after each step and ``finish`` when the run is over; the graph of the program comes whenever
the compiler has answered. Without I/O.
"""

from __future__ import annotations

from typing import Annotated

import msgspec
from msgspec import Meta

from ..robots import robot_in
from ..run.steps.lockstep import Lockstep
from ..sentences.sentence import Sentence, SentenceError, tr
from ..wire.verdict import Verdict
from ..world.arena import Arena
from ..world.properties import BadProperty, PropertyTracker, read_properties
from .channel_patterns import BadPattern, channel_pattern
from .checks import At, Check, Faces, Goals, Holds
from .program_graph import ProgramGraph
from .recording import Recording
from .verdicts import judge

__all__ = ["MAX_SECONDS", "BadStep", "CheckedStep", "LessonWatch", "examine_step"]

MAX_SECONDS = 600.0
"""Longest time that a step is judged by, s."""

_INTERVAL = 50
"""Steps between two judgements, 1 s."""


class CheckedStep(msgspec.Struct, frozen=True, kw_only=True):
    """
    What of a lesson's step the judgement of a run needs: how long it is watched, s, and its checks.

    With ``stars`` each check is a star. The first is about the goals of the room: without it a run has no star, and the
    watch is over as soon as it is done.
    """

    seconds: Annotated[float, Meta(gt=0, le=MAX_SECONDS)]
    checks: Annotated[list[Check], Meta(max_length=20)] = []
    stars: bool = False


class BadStep(SentenceError):
    """A check cannot be judged; ``path`` says where, ``why`` is a sentence."""

    def __init__(self, path: str, why: Sentence) -> None:
        super().__init__(tr("at {path}: {why}", path=path, why=why))
        self.path = path
        self.why = why


def examine_step(step: CheckedStep, arena: Arena) -> None:
    """
    Whether the checks of a step can be judged in a room.

    Raises:
        BadStep: the first that cannot.
    """
    if step.stars and not (step.checks and isinstance(step.checks[0], Goals)):
        raise BadStep("checks[0]", tr("the first star must be about the goals of the room."))
    places = sum(goal.kind in ("reach", "touch") for goal in arena.goals)
    for i, check in enumerate(step.checks):
        where = f"checks[{i}]"
        if isinstance(check, At | Faces) and check.goal >= places:
            raise BadStep(
                f"{where}.goal", tr("the room has {places} goals with a place, counted from 0.", places=places)
            )
        if isinstance(check, Holds):
            try:
                if len(read_properties(check.property)) > 1:
                    raise BadStep(f"{where}.property", tr("a check is about one property."))
            except BadProperty as error:
                raise BadStep(f"{where}.property", error.sentence) from error
        for name in ("event", "command"):
            pattern = getattr(check, name, None)
            if pattern is not None:
                try:
                    channel_pattern(pattern, name)
                except BadPattern as error:
                    raise BadStep(f"{where}.{name}", error.sentence) from error


class LessonWatch:
    """Of one run."""

    def __init__(self, step: CheckedStep, arena: Arena) -> None:
        self._step = step
        held = [found for check in step.checks if isinstance(check, Holds) for found in read_properties(check.property)]
        properties = PropertyTracker(held, arena, robot_in(arena).body) if held else None
        self._recording = Recording(arena, properties=properties)
        self._graph: ProgramGraph | None = None
        # Whether nothing more is recorded: the step's time is over, or the run is.
        self.is_over = False
        self._judged = 0
        # What is known so far; changed by on_step(), set_graph() and finish().
        self.verdicts: list[Verdict] = judge(step.checks, self._recording, None, False)

    @property
    def is_passed(self) -> bool:
        """Whether the program was driven and all checks are done, or driven for the whole time if there are none."""
        recording = self._recording
        if not self._step.checks:
            return self.is_over and self._lasted
        return bool(recording.samples) and all(verdict.state == "done" for verdict in self.verdicts)

    @property
    def _lasted(self) -> bool:
        recording = self._recording
        return recording.time >= self._step.seconds - 1e-9 or recording.done is not None or self._has_first_star

    @property
    def _has_first_star(self) -> bool:
        """Whether the goal of a challenge is reached."""
        if not self._step.stars:
            return False
        (goal,) = judge(self._step.checks[:1], self._recording, None, False)
        return goal.state == "done"

    def set_graph(self, graph: ProgramGraph) -> bool:
        """The compiler has answered. Returns whether a verdict has changed."""
        self._graph = graph
        return self._judge()

    def on_step(self, lockstep: Lockstep) -> bool:
        """Record a step. Returns whether a verdict has changed."""
        if self.is_over:
            return False
        self._recording.add(lockstep)
        self._judged += 1
        if self._recording.time >= self._step.seconds - 1e-9 or self._has_first_star:
            return self.finish()
        return self._judged % _INTERVAL == 0 and self._judge()

    def finish(self) -> bool:
        """The run is over, or the time of the step. Returns whether something has changed."""
        if self.is_over:
            return False
        self.is_over = True
        self._judge()
        return True

    def _judge(self) -> bool:
        before = self.verdicts
        final = self.is_over and self._lasted
        if final:
            self._recording.end()
        self.verdicts = judge(self._step.checks, self._recording, self._graph, final)
        return self.verdicts != before
