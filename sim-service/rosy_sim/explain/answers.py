"""
Answers to the questions of a page about a recorded run: sentences, and the firings that led to what was asked about.

One answer goes one step back; the cause in a sentence is what the next question is about.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from typing import NamedTuple

from ..wire.explanation import Sentence
from ..wire.firing import Branch, Firing
from ..world.events import VELOCITY_CHANNEL
from .branches import taken_branches
from .position import stretches
from .recorded_run import RecordedRun, SentCommand
from .untaken_branch import why_not_taken
from .why import Link, remembering, sending, shown_inputs, step_back
from .why_not import (
    FunctionType,
    RobotLimits,
    Window,
    hindrance,
    why_no_effect,
    why_not_received,
    why_not_run,
    why_not_sent,
)

__all__ = [
    "MAX_PATH",
    "Answer",
    "why_command",
    "why_event",
    "why_firing",
    "why_memory",
    "why_not",
    "why_not_branch",
    "why_position",
]

MAX_PATH = 60
"""Firings of a path: as many as a page can highlight and a learner can look through. A choice of ours."""

MAX_SENDERS = 3
"""Functions that an answer is about: as many sentences as a learner reads at once. A choice of ours."""


class Answer(NamedTuple):
    """``time`` (s) is that of what was asked about; ``path`` is in the order of time."""

    links: list[Link]
    time: float
    path: Sequence[Firing] = ()


def why_command(run: RecordedRun, kind: str, time: float, limits: RobotLimits) -> Answer:
    """Why the command of a type (``Velocity``) that is in force at a time, s, was sent."""
    sent = run.latest_command(kind, time)
    if sent is None:
        return Answer([_nothing(run, kind, time)], time)
    links = [sending(run, sent)]
    firing = run.firing(links[0].firing)
    if firing is None:
        return Answer(links, sent.time)
    hindered = hindrance(run, sent, limits) if sent.firing is not None else None
    links += taken_branches(run, firing)
    links += [hindered] if hindered is not None else []
    return _with_causes(run, firing, links, sent.time)


def why_firing(run: RecordedRun, number: int) -> Answer:
    """Why a function ran, and what it gave."""
    firing = run.firing(number)
    if firing is None:
        return Answer([Link(Sentence("not-known-before", since=run.known_since), run.known_since)], run.known_since)
    time = run.time_of(firing)
    sentence = Sentence("gave", function=firing.function, time=time, values=shown_inputs(firing), gave=firing.gave)
    return _with_causes(run, firing, [Link(sentence, time, number), *taken_branches(run, firing)], time)


def why_memory(run: RecordedRun, kind: str, time: float) -> Answer:
    """Why a memory of a type (``Memory Int``) has its value at a time, s."""
    writer = run.latest_write(kind, time)
    if writer is None:
        return Answer([Link(_unwritten(run, kind), time)], time)
    link, first = remembering(run, kind, writer)
    return _with_causes(run, first, [link], link.time)


def why_event(run: RecordedRun, text: str, time: float) -> Answer:
    """When an event came last, as Haskell shows it or by its constructor, and which functions ran for it."""
    if " " not in text:
        text = run.latest_event_named(text, time) or text
    found = run.latest_event(text, time)
    if found is None:
        none = Link(Sentence("none-came", type=text, until=time), time)
        return Answer([_unknown(run, time) if run.known_since > 0 else none], time)
    since, sender, takers = found
    links = [Link(Sentence("sensed", time=since, value=text), since)]
    if sender is not None:
        sentence = Sentence("sent", time=since, function=sender.function, value=text, values=shown_inputs(sender))
        links = [Link(sentence, since, sender.n)]
    if not takers:
        links.append(Link(Sentence("nothing-ran"), since))
    for firing in takers:
        sentence = Sentence("gave", function=firing.function, time=since, values=[], gave=firing.gave, cause=firing.n)
        links.append(Link(sentence, since, firing.n))
    return Answer(links, since, takers if sender is None else [sender, *takers])


def why_position(run: RecordedRun, time: float, limits: RobotLimits) -> Answer:
    """Why the robot was where it was at a time, s: the commands that it followed on the way, the latest first."""
    time = min(time, run.end or 0.0)
    way = stretches(run, time)
    if not way.links:
        return Answer([_unknown(run, time) if run.known_since > 0 else _unmoved(time)], time)
    hindered = hindrance(run, way.last, limits) if way.last is not None else None
    links = [*way.links[:1], *([hindered] if hindered is not None else []), *way.links[1:]]
    return Answer(links, time, way.firings)


def _unmoved(time: float) -> Link:
    return Link(Sentence("not-moved", type=VELOCITY_CHANNEL, time=time), time)


def why_not(
    run: RecordedRun,
    functions: Sequence[FunctionType],
    window: Window,
    limits: RobotLimits,
    function: str = "",
    command: str = "",
    event: str = "",
) -> Answer:
    """Why a function did not run or send a command, why a command shows no effect, or an event was not received."""
    if function and command:
        links = [why_not_sent(run, functions, function, command, window)]
    elif function:
        links = [why_not_run(run, functions, function, window)]
    elif event:
        links = [why_not_received(run, functions, event, window)]
    else:
        links = _without_effect(run, functions, command, window, limits)
    firing = run.firing(links[0].firing)
    if firing is not None and links[0].said.id == "gave":
        # It ran and chose otherwise.
        links[1:1] = taken_branches(run, firing)
    return Answer(links, links[0].time, [] if firing is None else _path(run, firing))


def why_not_branch(
    run: RecordedRun, functions: Sequence[FunctionType], branches: Sequence[Branch], asked: Branch, window: Window
) -> Answer:
    """Why an equation, a guard or an alternative was not taken."""
    links = why_not_taken(run, functions, branches, asked, window)
    firing = run.firing(links[0].firing)
    return Answer(links, links[0].time, [] if firing is None else _path(run, firing))


def _without_effect(
    run: RecordedRun, functions: Sequence[FunctionType], command: str, window: Window, limits: RobotLimits
) -> list[Link]:
    """Why a command of a type shows no effect: the functions that could sent none, or something is in its way."""
    sent: SentCommand | None = run.latest_command(command, window.end)
    if sent is not None and window.holds(sent.time):
        return [why_no_effect(run, sent, limits)]
    senders = dict.fromkeys(f.name for f in functions if command in f.outputs)
    if not senders:
        return [Link(Sentence("no-sender", type=command), window.end)]
    return [why_not_sent(run, functions, name, command, window) for name in senders][:MAX_SENDERS]


def _with_causes(run: RecordedRun, firing: Firing, links: list[Link], time: float) -> Answer:
    found, _ = step_back(run, firing)
    return Answer(links + [link for link in found if link not in links], time, _path(run, firing))


def _path(run: RecordedRun, firing: Firing) -> list[Firing]:
    """A firing and all that led to it, as far as it is recorded; of one function its first two, as in ``why``."""
    found: dict[int, Firing] = {}
    followed: dict[str, int] = {}
    todo = deque([firing])
    while todo and len(found) < MAX_PATH:
        one = todo.popleft()
        if one.n in found or followed.get(one.function, 0) == 2:
            continue
        found[one.n] = one
        followed[one.function] = followed.get(one.function, 0) + 1
        todo.extend(step_back(run, one)[1])
    return [found[number] for number in sorted(found)]


def _nothing(run: RecordedRun, kind: str, time: float) -> Link:
    return _unknown(run, time) if run.known_since > 0 else Link(Sentence("nothing-sent-yet", type=kind), time)


def _unwritten(run: RecordedRun, kind: str) -> Sentence:
    if run.known_since > 0:
        return Sentence("not-known-before", since=run.known_since)
    return Sentence("not-written", type=kind)


def _unknown(run: RecordedRun, time: float) -> Link:
    return Link(Sentence("not-known-before", since=run.known_since), time)
