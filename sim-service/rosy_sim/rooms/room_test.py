"""
Test of one program in many rooms: the outcomes, worst first, and the smallest failing room.

A pure function of the program and the ``RoomTest``, whatever the machine and the number of processes.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from ..errors import BadInput
from ..run.steps.velocity_guard import OFF, SafetySettings
from ..sentences.sentence import Sentence, tr
from ..wire.problem import Problem
from ..world.properties import Property
from .generation.families import Family
from .generation.reductions import reduction_of
from .generation.shrinking import Shrunk, shrink
from .trial import Outcome
from .trial_pool import ProgramLost, Trials
from .trial_process import Answer, Task, Trial

__all__ = ["MAX_ROOMS", "Report", "RoomTest", "Smallest", "check_goals", "shrunk_report", "try_rooms", "worst_first"]

MAX_ROOMS = 10_000
"""Most rooms of a test."""

_Json = dict[str, Any]


@dataclass(frozen=True, slots=True)
class RoomTest:
    """What a program is tested for; ``seconds`` are simulated, in each room."""

    family: Family
    rooms: int
    seed: int
    seconds: float
    properties: tuple[Property, ...]
    safety: SafetySettings = OFF

    def task(self, source: str) -> Task:
        """What a trial process must know to test a program."""
        return Task(
            source,
            ", ".join(map(str, self.properties)),
            self.seconds,
            self.family.name,
            self.family.base,
            self.seed,
            self.safety,
        )


def check_goals(family: Family, properties: Sequence[Property]) -> None:
    """
    A room with goals of its own gets no place to reach, so it cannot be tested for one that it lacks.

    Raises:
        BadInput: the room of the family has goals, but no place to reach.
    """
    goals = family.base.get("goals") if family.base is not None else None
    wants_place = any(wanted.kind == "reaches-goal" for wanted in properties)
    if goals and wants_place and not any(goal["kind"] == "reach" for goal in goals):
        raise BadInput(tr("This room has no place to reach; test for its own goals (room-goals)."))


@dataclass(frozen=True, slots=True)
class Smallest:
    """The smallest failing room that was found, and how the program fails there."""

    shrunk: Shrunk
    outcome: Outcome


@dataclass(frozen=True, slots=True)
class Report:
    """
    ``outcomes`` are by room number, with their worlds. With ``refused`` the program does not compile; with ``lost`` it
    ended the worker twice, and has no outcomes.
    """

    outcomes: list[Outcome] = field(default_factory=list)
    worlds: list[_Json] = field(default_factory=list)
    refused: list[Problem] = field(default_factory=list)
    lost: Sentence | None = None
    smallest: Smallest | None = None

    @property
    def passed(self) -> int:
        """In how many rooms the program went well and all properties hold."""
        return sum(outcome.has_passed for outcome in self.outcomes)


def try_rooms(test: RoomTest, trials: Trials, on_outcome: Callable[[Outcome], None]) -> Report:
    """
    Try a program in all rooms of a test.

    ``on_outcome`` is called for each room, in the order in which they are ready. The report of a program that is lost
    (``ProgramLost``) says so.
    """

    def on_answer(answer: Answer) -> None:
        if answer.outcome is not None:
            on_outcome(answer.outcome)

    try:
        # The first room alone: a program that does not compile compiles in none.
        answers = trials.run([Trial(1)])
        first = answers[0].outcome
        assert first is not None
        if first.ended == "refused":
            return Report(refused=first.problems)
        on_outcome(first)
        answers += trials.run([Trial(number) for number in range(2, test.rooms + 1)], on_answer)
    except ProgramLost as error:
        return Report(lost=error.why)
    outcomes = [answer.outcome for answer in answers if answer.outcome is not None]
    worlds = [answer.world for answer in answers if answer.world is not None]
    return Report(outcomes, worlds)


def shrunk_report(test: RoomTest, trials: Trials, report: Report, on_shrink: Callable[[int], None]) -> Report:
    """
    The report with the smallest room in which the program fails, if it fails in one.

    ``on_shrink`` is called with the number of rooms that were tried while shrinking.
    """
    failing = [(o, w) for o, w in zip(report.outcomes, report.worlds, strict=True) if not o.has_passed]
    if not failing:
        return report
    # The earliest failure is the quickest to watch; among equals, the fewest things are the quickest to shrink.
    name = test.family.name
    outcome, world = min(failing, key=lambda one: (one[0].time, reduction_of(name, one[1]).things, one[0].room))
    try:
        return replace(report, smallest=_shrink(name, outcome, world, trials, on_shrink))
    except ProgramLost as error:
        return Report(lost=error.why)


def _shrink(family: str, outcome: Outcome, world: _Json, trials: Trials, on_shrink: Callable[[int], None]) -> Smallest:
    tried = 0
    last = outcome

    def first_failing(rooms: Sequence[_Json]) -> int | None:
        nonlocal tried, last
        # As many together as there are processes: more would be tried in vain behind the first that fails.
        for first in range(0, len(rooms), trials.processes):
            some = rooms[first : first + trials.processes]
            answers = trials.run([Trial(outcome.room, room, outcome.seed) for room in some])
            tried += len(some)
            on_shrink(tried)
            for i, answer in enumerate(answers):
                if answer.outcome is not None and answer.outcome.fails_like(outcome):
                    last = answer.outcome
                    return first + i
        return None

    return Smallest(shrink(reduction_of(family, world), first_failing), last)


def worst_first(outcomes: Sequence[Outcome]) -> list[Outcome]:
    """Crashes, then the most failed properties, those farthest from holding, the earliest; then by number."""
    return sorted(
        outcomes,
        key=lambda outcome: (
            outcome.has_passed,
            not outcome.has_crashed,
            -len(outcome.failed),
            -round(sum(finding.shortfall for finding in outcome.findings), 3),
            outcome.time,
            outcome.room,
        ),
    )
