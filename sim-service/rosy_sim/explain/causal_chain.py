"""
Chain of causes of a command, for a terminal: its firing, what that read and what caused it, back to messages, ticks or
the start, and what kept the robot from doing it.

One sentence per link, newest first. A function is followed twice at most, so that one that reads what it wrote itself
ends the chain there.
"""

from __future__ import annotations

from collections import Counter, deque

from ..wire.explanation import Sentence
from ..world.time_step import STEP
from .branches import taken_branches
from .recorded_run import RecordedRun, SentCommand
from .why import Link, sending, step_back
from .why_not import RobotLimits, hindrance

__all__ = ["MAX_LINKS", "commands_at", "explain", "why"]

MAX_LINKS = 12
"""Sentences of one explanation. A choice of ours: a learner reads no more at once."""


def explain(run: RecordedRun, limits: RobotLimits, time: float | None = None) -> list[Link]:
    """Why the last command was sent, or what was sent at a time, s."""
    if time is not None and (run.end is None or time > run.end + STEP):
        return [Link(Sentence("run-over", time=run.end or 0.0), time)]
    if time is not None and time < 0:
        return [Link(Sentence("run-not-begun"), time)]
    sent = commands_at(run, time)
    if sent:
        links: list[Link] = []
        for one in sent:
            links += [link for link in why(run, one, limits) if link not in links]
        return links
    if time is None:
        return [Link(Sentence("nothing-sent-yet"), run.end or 0.0)]
    before = [one for one in run.commands() if one.time < time]
    nothing = Link(Sentence("nothing-sent", time=time), time)
    return [nothing, *why(run, before[-1], limits)] if before else [nothing]


def commands_at(run: RecordedRun, time: float | None = None) -> list[SentCommand]:
    """The commands of the step at a time, s; without one the last command."""
    commands = run.commands()
    return commands[-1:] if time is None else [one for one in commands if abs(one.time - time) < STEP / 2]


def why(run: RecordedRun, sent: SentCommand, limits: RobotLimits) -> list[Link]:
    """The chain of causes of a command, at most ``MAX_LINKS`` sentences."""
    links = [sending(run, sent)]
    first = run.firing(links[0].firing)
    if first is None:
        return links
    links += taken_branches(run, first)
    hindered = hindrance(run, sent, limits) if sent.firing is not None else None
    links += [hindered] if hindered is not None else []
    todo = deque([first])
    followed = Counter([first.function])
    while todo and len(links) < MAX_LINKS:
        found, causes = step_back(run, todo.popleft())
        links += [link for link in found if link not in links]
        for cause in causes:
            if followed[cause.function] < 2:
                followed[cause.function] += 1
                todo.append(cause)
    return links[:MAX_LINKS]
