"""
Why a command was sent, one step back: its firing, what that read, and what caused it. One sentence per link.
"""

from __future__ import annotations

from typing import NamedTuple

from ..wire.explanation import Sentence, SentenceId
from ..wire.firing import Firing, Taken
from ..world.time_step import STEP
from .recorded_run import RecordedRun, SentCommand
from .values import inside, written
from .wording import english

__all__ = ["Link", "ending", "sending", "shown_inputs", "step_back"]


class Link(NamedTuple):
    """One sentence of an explanation, and the firing that it is about, if it is about one."""

    said: Sentence
    time: float
    firing: int | None = None

    @property
    def sentence(self) -> str:
        """In English."""
        return english(self.said)


def sending(run: RecordedRun, sent: SentCommand) -> Link:
    """That a command was sent, by which function and for which inputs."""
    firing = sent.firing
    if firing is None:
        ended_by = ending(run, sent)
        if ended_by is None:
            return Link(Sentence("stopped", time=sent.time, value=sent.value), sent.time)
        sentence = Sentence("stopped-by", time=sent.time, value=sent.value, other=ended_by.function, cause=ended_by.n)
        return Link(sentence, sent.time, ended_by.n)
    sentence = Sentence("sent", time=sent.time, function=firing.function, value=sent.value, values=shown_inputs(firing))
    return Link(sentence, sent.time, firing.n)


def ending(run: RecordedRun, stop: SentCommand) -> Firing | None:
    """
    The firing whose ``Done`` led to a command that no function sent (rule R10).

    Known when it belongs to the task that sent the command before. A task that was stopped from outside has none.
    """
    before = [one for one in run.commands() if one.type == stop.type and one.firing is not None]
    tasks = [one.firing.task for one in before if one.firing is not None and one.time <= stop.time + 1e-9]
    if not tasks:
        return None
    return next(
        (
            firing
            for time, firing in run.firings()
            if abs(time - stop.time) < STEP / 2
            and firing.task == tasks[-1]
            and any(given.to == "done" for given in firing.gave)
        ),
        None,
    )


def shown_inputs(firing: Firing) -> list[str]:
    """The inputs of a firing that can be shown."""
    return [taken.value for taken in firing.took if taken.value not in ("_", "()")]


def step_back(run: RecordedRun, firing: Firing) -> tuple[list[Link], list[Firing]]:
    """What one firing read and what caused it, as sentences and as firings to follow."""
    links: list[Link] = []
    causes: list[Firing] = []
    time = run.time_of(firing)
    for taken in firing.took:
        if taken.origin in ("memory", "param"):
            writer = run.firing(taken.firing)
            if writer is None:
                links.append(_unwritten(taken, time))
            else:
                link, first = remembering(run, taken.type, writer)
                links.append(link)
                causes.append(first)
        elif taken.origin == "event" and taken.value not in ("()", firing.cause.value, _event(run, firing)):
            links += _waited(run, taken, time)
    before = run.firing(firing.cause.firing)
    links.append(Link(_cause(run, firing, before), time, firing.n))
    return links, causes + ([before] if before is not None else [])


def remembering(run: RecordedRun, kind: str, writer: Firing) -> tuple[Link, Firing]:
    """Since when a memory of a type has had the value that a firing wrote, and the firing to follow."""
    value = written(writer, kind) or ""
    first = run.beginning_of_value(kind, writer)
    if first is None:
        return Link(Sentence("from-start", type=kind, value=value), 0.0), writer
    since = run.time_of(first)
    sentence = Sentence("remembered", type=kind, value=value, since=since, other=first.function, cause=first.n)
    return Link(sentence, since, first.n), first


def _unwritten(taken: Taken, time: float) -> Link:
    known: SentenceId = "first-value" if taken.firing is None else "old-value"
    return Link(Sentence(known, type=taken.type, value=inside(taken.value)), time)


def _event(run: RecordedRun, firing: Firing) -> str:
    """The user event that caused a firing, as Haskell shows it."""
    sender = run.firing(firing.cause.firing)
    if firing.cause.by != "event" or sender is None:
        return ""
    return next((given.value for given in sender.gave if given.event == firing.cause.event), "")


def _waited(run: RecordedRun, taken: Taken, time: float) -> list[Link]:
    """An event that had come before and waited for the other inputs."""
    times = [when for when, text in run.events() if text == taken.value and when <= time]
    return [Link(Sentence("had-come", value=taken.value, since=times[-1]), times[-1])] if times else []


_PLAIN_CAUSES: dict[str, SentenceId] = {
    "tick": "ran-tick",
    "start": "ran-start",
    "instant": "ran-wait",
    "end": "ran-end",
}


def _cause(run: RecordedRun, firing: Firing, before: Firing | None) -> Sentence:
    """Why a function ran; ``before`` is the firing that led to it."""
    name, time = firing.function, run.time_of(firing)
    cause = firing.cause
    if cause.by == "message":
        return Sentence("ran-message", function=name, time=time, value=cause.value)
    if cause.by in _PLAIN_CAUSES:
        return Sentence(_PLAIN_CAUSES[cause.by], function=name, time=time)
    if before is None:
        return Sentence("ran-unknown", function=name, time=time)
    value = _event(run, firing)
    kind: SentenceId = "ran-event"
    if cause.by == "task":
        kind, value = _transition(before)
    return Sentence(
        kind,
        function=name,
        time=time,
        other=before.function,
        cause=before.n,
        since=run.time_of(before),
        value=value,
    )


def _transition(before: Firing) -> tuple[SentenceId, str]:
    """How a firing led to a change of tasks, and what it gave as feedback."""
    sinks = {given.to: given for given in before.gave}
    if "done" in sinks:
        return "ran-done", ""
    if "call" in sinks:
        return "ran-call", ""
    if "feedback" in sinks:
        return "ran-feedback", sinks["feedback"].value
    return "ran-task", ""
