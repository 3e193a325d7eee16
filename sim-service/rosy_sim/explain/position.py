"""
Way of the robot to the place where it was at a time: the commands that it followed, in stretches.

A stretch is the time in which commands of one function asked for motion of one kind: ahead or back, to the left or to
the right. Commands that another one replaced in the same step moved nothing. A place where a hand put the robot has no
earlier way.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import groupby
from typing import NamedTuple

from ..wire.explanation import Sentence
from ..wire.firing import Firing
from ..world.events import VELOCITY_CHANNEL
from .recorded_run import RecordedRun, SentCommand
from .values import velocity_values
from .why import Link

__all__ = ["MAX_STRETCHES", "Way", "stretches"]

MAX_STRETCHES = 3
"""Stretches in an answer: as many sentences as a learner reads at once. A choice of ours."""


class Way(NamedTuple):
    """Sentences, the latest first; the last command that moved the robot; firings, in the order of time."""

    links: list[Link]
    last: SentCommand | None
    firings: list[Firing]


@dataclass(frozen=True, slots=True)
class _Stretch:
    sent: list[SentCommand]
    # When the next one began, s.
    end: float

    @property
    def stands(self) -> bool:
        return _kind(self.sent[0]) == (0, 0)


def stretches(run: RecordedRun, time: float) -> Way:
    """The way to the place at a time, s."""
    placed = run.latest_placement(time)
    begin = placed if placed is not None else run.known_since
    all_of_it = list(_all(run, begin, time))
    # The robot stood before its first command.
    while all_of_it and all_of_it[0].stands and placed is None and run.known_since == 0:
        del all_of_it[0]
    shown = all_of_it[-MAX_STRETCHES:]
    links = [_link(one, max(begin, one.sent[0].time)) for one in reversed(shown)]
    if shown and len(shown) < len(all_of_it):
        since = shown[0].sent[0].time
        links.append(Link(Sentence("followed-others", since=since), since))
    elif placed is not None:
        links.append(Link(Sentence("placed", time=placed), placed))
    elif links and run.known_since > 0:
        links.append(Link(Sentence("not-known-before", since=run.known_since), run.known_since))
    firings = [one.sent[-1].firing for one in shown]
    return Way(links, shown[-1].sent[-1] if shown else None, [firing for firing in firings if firing is not None])


def _all(run: RecordedRun, begin: float, until: float) -> Iterator[_Stretch]:
    """The stretches between two times; the command in force at the first of them counts."""
    sent = [one for one in run.commands() if one.type == VELOCITY_CHANNEL and one.time <= until + 1e-9]
    # Of one step the last command moves the robot.
    in_force = [list(of_step)[-1] for _, of_step in groupby(sent, key=lambda one: one.time)]
    before = [one for one in in_force if one.time < begin - 1e-9]
    later = [one for one in in_force if one.time >= begin - 1e-9]
    groups = [list(group) for _, group in groupby([*before[-1:], *later], key=_key)]
    ends = [group[0].time for group in groups[1:]] + [until]
    for group, end in zip(groups, ends, strict=False):
        if end > max(begin, group[0].time) + 1e-9:
            yield _Stretch(group, end)


def _key(sent: SentCommand) -> tuple[object, ...]:
    kind = _kind(sent)
    # It stands, whichever function says so.
    return kind if kind == (0, 0) or sent.firing is None else (*kind, sent.firing.function)


def _kind(sent: SentCommand) -> tuple[int, ...]:
    """The signs of speed and turn rate."""
    values = velocity_values(sent.value) or (0.0, 0.0)
    return tuple((value > 0) - (value < 0) for value in values)


def _strength(sent: SentCommand) -> float:
    return sum(abs(value) for value in velocity_values(sent.value) or ())


def _link(stretch: _Stretch, since: float) -> Link:
    firing = stretch.sent[-1].firing
    if stretch.stands or firing is None:
        return Link(Sentence("stood", since=since, until=stretch.end), since, firing.n if firing is not None else None)
    sentence = Sentence(
        "followed",
        since=since,
        until=stretch.end,
        other=firing.function,
        cause=firing.n,
        value=stretch.sent[-1].value,
    )
    slowest, fastest = min(stretch.sent, key=_strength).value, max(stretch.sent, key=_strength).value
    if slowest != fastest:
        sentence = Sentence(
            "followed-changes",
            since=since,
            until=stretch.end,
            other=firing.function,
            cause=firing.n,
            values=[slowest, fastest],
        )
    return Link(sentence, since, firing.n)
