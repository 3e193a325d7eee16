"""
Why a function did not run, or did not send a command, or why a command had no effect.

The answers are tried in the order of the design: it does not exist here; it lacked an input; it ran and chose
otherwise; it sent, and another command replaced it; it sent, and the robot could not; nothing takes the event; the
moment is outside of the run. The first that holds is the answer; if none does, what is known and nothing else.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import NamedTuple

from ..robot_description import type_roles
from ..wire.explanation import Sentence
from ..wire.firing import Firing
from ..world.robot import MotorLimits
from .recorded_run import RecordedRun, SentCommand
from .values import velocity_values
from .why import Link, ending, shown_inputs

__all__ = [
    "FunctionType",
    "RobotLimits",
    "Window",
    "hindrance",
    "outside",
    "why_no_effect",
    "why_not_received",
    "why_not_run",
    "why_not_sent",
]

_SAMPLES = {"Seconds", "Clock", "StdGen", "Memory", "Param"}
"""Types of the language that never trigger a function (rule R3)."""

TICK = 0.1
"""Time between two firings of a function without an event, s (language rule R3)."""


class FunctionType(NamedTuple):
    """
    A function of ``simulate`` with its inputs and outputs, as in the ``graph`` of a check.

    ``task`` has the names of all functions of its task, none for a function outside of tasks; ``is_start`` is one that
    runs once, at the beginning of the task.
    """

    name: str
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    task: tuple[str, ...] = ()
    is_start: bool = False


class Window(NamedTuple):
    """From a time to a time, s since the start of the program."""

    start: float
    end: float

    def holds(self, time: float) -> bool:
        """Whether a time lies in it."""
        return self.start - 1e-9 <= time <= self.end + 1e-9


class RobotLimits(NamedTuple):
    """The fastest that a robot drives, m/s, and turns, rad/s."""

    speed: float
    turn: float

    @classmethod
    def of_motors(cls, limits: MotorLimits) -> RobotLimits:
        """Those of a simulated robot."""
        return cls(limits.speed, limits.angular_speed)


def why_not_run(run: RecordedRun, functions: Sequence[FunctionType], name: str, window: Window) -> Link:
    """Why a function did not run in a window of time."""
    ran = [(time, firing) for time, firing in run.firings() if firing.function == name]
    for time, firing in ran:
        if window.holds(time):
            return Link(Sentence("did-run", function=name, time=time, values=shown_inputs(firing)), time, firing.n)
    before = [(time, firing) for time, firing in ran if time < window.start]
    return (
        outside(run, window)
        or _missing(functions, name, window)
        or _waiting_task(run, functions, name, window)
        or _ended_task(run, name, before, window)
        or _finished_start(functions, name, before)
        or _lacking(run, functions, name, window)
        or _last_known(run, name, before, window)
    )


def why_not_sent(run: RecordedRun, functions: Sequence[FunctionType], name: str, command: str, window: Window) -> Link:
    """Why a function did not send a command of a type (``Velocity``) in a window of time, or why it did not last."""
    ran = [(time, firing) for time, firing in run.firings() if firing.function == name and window.holds(time)]
    if not ran:
        return why_not_run(run, functions, name, window)
    other = _other_type(functions, name, command, window)
    if other is not None:
        return other
    sent = [
        one
        for one in run.commands()
        if one.firing is not None and window.holds(one.time) and command in (one.value, one.type)
    ]
    for one in reversed(sent):
        if one.firing is not None and one.firing.function == name:
            sentence = Sentence("did-send", function=name, value=one.value, time=one.time)
            return _replaced(run, one) or Link(sentence, one.time, one.firing.n)
    time, firing = ran[-1]
    sentence = Sentence("gave", function=name, time=time, values=shown_inputs(firing), gave=firing.gave)
    return Link(sentence, time, firing.n)


def why_no_effect(run: RecordedRun, sent: SentCommand, limits: RobotLimits) -> Link:
    """Why a command that was sent does not show: it was replaced, or the robot could not do it."""
    return (
        _replaced(run, sent)
        or hindrance(run, sent, limits)
        or Link(Sentence("in-force", value=sent.value, time=sent.time), sent.time, _number(sent.firing))
    )


def hindrance(run: RecordedRun, sent: SentCommand, limits: RobotLimits) -> Link | None:
    """What keeps the robot from following its command; None when nothing is known to."""
    return _overridden(run, sent) or _beyond(sent, limits) or _hindered(run, sent)


def why_not_received(run: RecordedRun, functions: Sequence[FunctionType], event: str, window: Window) -> Link:
    """Why a user event of a type reached no function in a window of time."""
    firings = [(time, firing) for time, firing in run.firings() if window.holds(time)]
    sent = [(time, f) for time, f in firings if any(g.to == "event" and g.type == event for g in f.gave)]
    takers = [f.name for f in functions if any(_takes(taken, event) for taken in f.inputs)]
    if not sent:
        senders = [f.name for f in functions if any(_takes(given, event) for given in f.outputs)]
        sentence = Sentence("no-sender", type=event)
        if senders:
            sentence = Sentence("never-sent", type=event, functions=senders, since=window.start, until=window.end)
        return Link(sentence, window.end)
    last, sender = sent[-1]
    if not takers:
        return Link(Sentence("no-taker", function=sender.function, type=event, time=last), last, sender.n)
    received = [(time, f) for time, f in firings if f.function in takers and _was_sent(run, f, event)]
    if received:
        time, taker = received[-1]
        return Link(Sentence("received", function=taker.function, type=event, time=time), time, taker.n)
    ends = [over for taker in takers if (over := _end_of_task(run, taker)) is not None]
    if ends and max(ends) < sent[0][0]:
        first, since = sent[0][0], max(ends)
        return Link(Sentence("taker-ended", type=event, time=first, functions=takers, since=since), first, sent[0][1].n)
    return Link(Sentence("taker-silent", type=event, time=last, functions=takers), last, sender.n)


# The answers in their order; None when one does not hold.


def _number(firing: Firing | None) -> int | None:
    return firing.n if firing is not None else None


def outside(run: RecordedRun, window: Window) -> Link | None:
    """The window lies before or after what is recorded."""
    if run.end is None or window.end < 0:
        return Link(Sentence("run-not-begun"), window.start)
    if window.start > run.end:
        return Link(Sentence("run-over", time=run.end), run.end)
    if run.known_since > window.end:
        return Link(Sentence("not-known-before", since=run.known_since), run.known_since)
    return None


def _missing(functions: Sequence[FunctionType], name: str, window: Window) -> Link | None:
    is_there = any(f.name == name for f in functions)
    return None if is_there else Link(Sentence("not-part", function=name), window.start)


def _ended_task(run: RecordedRun, name: str, before: list[tuple[float, Firing]], window: Window) -> Link | None:
    """The function's task had ended; known only of a function that has run."""
    if not before:
        return None
    task = before[-1][1].task
    for time, firing in run.firings():
        if firing.task == task and time <= window.start and any(given.to == "done" for given in firing.gave):
            sentence = Sentence("task-ended", function=name, time=time, other=firing.function, cause=firing.n)
            return Link(sentence, time, firing.n)
    return None


def _waiting_task(run: RecordedRun, functions: Sequence[FunctionType], name: str, window: Window) -> Link | None:
    """The function's task had not begun: none of its functions had run. Not known when the start is not recorded."""
    same = [one for one in functions if one.name == name]
    if run.known_since > 0 or not same or not all(one.task for one in same):
        return None
    mates = {mate for one in same for mate in one.task}
    starts = [one for one in functions if one.is_start and one.name in mates]
    if any(_events(taken) for start in starts for taken in start.inputs):
        # It may have begun, and its start waits for an event.
        return None
    if any(firing.function in mates for time, firing in run.firings() if time <= window.end + 1e-9):
        return None
    sentence = Sentence("task-waits", function=name, until=window.end)
    return Link(sentence, window.end)


def _finished_start(functions: Sequence[FunctionType], name: str, before: list[tuple[float, Firing]]) -> Link | None:
    """The function runs once at the beginning of its task, and has done so."""
    same = [one for one in functions if one.name == name]
    if not before or not all(one.is_start for one in same):
        return None
    time, firing = before[-1]
    return Link(Sentence("runs-once", function=name, time=time), time, firing.n)


def _other_type(functions: Sequence[FunctionType], name: str, command: str, window: Window) -> Link | None:
    """The function has no command of this type among its outputs, but another function or the robot knows it."""
    given = [output for one in functions if one.name == name for output in one.outputs]
    known = {output for one in functions for output in one.outputs} | type_roles().commands
    if not given or command in given or command not in known:
        return None
    return Link(Sentence("other-type", function=name, type=command, types=list(dict.fromkeys(given))), window.end)


def _end_of_task(run: RecordedRun, name: str) -> float | None:
    tasks = {firing.task for _, firing in run.firings() if firing.function == name}
    ends = [t for t, f in run.firings() if f.task in tasks and any(given.to == "done" for given in f.gave)]
    return ends[-1] if ends else None


def _lacking(run: RecordedRun, functions: Sequence[FunctionType], name: str, window: Window) -> Link | None:
    for function in functions:
        if function.name != name:
            continue
        for taken in function.inputs:
            kinds = _events(taken)
            if not kinds:
                continue
            times = sorted(time for kind in kinds for time in _times(run, kind))
            if any(window.holds(time) for time in times):
                continue
            earlier = [time for time in times if time < window.start]
            last = earlier[-1] if earlier else None
            sentence = Sentence("lacks", function=name, types=kinds, since=window.start, until=window.end, time=last)
            return Link(sentence, window.start if last is None else last)
    return None


def _last_known(run: RecordedRun, name: str, before: list[tuple[float, Firing]], window: Window) -> Link:
    if before:
        time, firing = before[-1]
        later = next((t for t, f in run.firings() if f.function == name and t > window.end), None)
        if firing.cause.by == "tick" and later is not None and later < time + 1.5 * TICK:
            sentence = Sentence("ticks", function=name, time=time, until=later)
            return Link(sentence, time, firing.n)
        sentence = Sentence("ran-before", function=name, time=time, since=window.start, until=window.end)
        return Link(sentence, time, firing.n)
    return Link(Sentence("never-ran", function=name, since=window.start, until=window.end), window.start)


def _replaced(run: RecordedRun, sent: SentCommand) -> Link | None:
    """Another function's command took the place of this one at once or soon."""
    if sent.type in type_roles().commands - type_roles().held:
        return None
    commands = run.commands()
    later = commands[commands.index(sent) + 1 :]
    for one in later:
        if one.type != sent.type:
            continue
        if one.firing is None:
            ended_by = ending(run, one)
            sentence = Sentence("replaced-by-stop", time=sent.time, since=one.time, value=one.value)
            if ended_by is not None:
                sentence = Sentence(
                    "replaced-by-end",
                    time=sent.time,
                    since=one.time,
                    value=one.value,
                    other=ended_by.function,
                    cause=ended_by.n,
                )
            return Link(sentence, one.time, _number(sent.firing))
        if (
            sent.firing is not None
            and one.firing.function == sent.firing.function
            and one.firing.task == sent.firing.task
        ):
            return None
        sentence = Sentence(
            "replaced",
            time=sent.time,
            since=one.time,
            other=one.firing.function,
            cause=one.firing.n,
            value=one.value,
        )
        return Link(sentence, one.time, _number(sent.firing))
    return None


def _overridden(run: RecordedRun, sent: SentCommand) -> Link | None:
    """The safety rules (rule R24) drove when the command was sent."""
    since = run.overridden_since(sent.time) if sent.type == "Velocity" else None
    if since is None:
        return None
    return Link(Sentence("overridden", since=since, value=sent.value), since, _number(sent.firing))


def _beyond(sent: SentCommand, limits: RobotLimits) -> Link | None:
    asked = velocity_values(sent.value)
    if asked is None:
        return None
    linear, angular = abs(asked[0]), abs(asked[1])
    if linear > limits.speed:
        sentence = Sentence("beyond-speed", value=sent.value, asked=linear, limit=limits.speed)
    elif angular > limits.turn:
        sentence = Sentence("beyond-turn", value=sent.value, asked=angular, limit=limits.turn)
    else:
        return None
    return Link(sentence, sent.time, _number(sent.firing))


def _hindered(run: RecordedRun, sent: SentCommand) -> Link | None:
    """Something holds the robot: the last values of its bumpers and wheels when the command was sent."""
    asked = velocity_values(sent.value)
    if asked is None:
        return None
    last: dict[str, tuple[float, str]] = {}
    for time, text in run.events():
        words = text.split(" ")
        if time <= sent.time and words[0] in ("Bumper", "Wheel") and len(words) == 3:
            last[words[1]] = (time, text)
    for time, text in last.values():
        if text.endswith(" Air") and asked != (0.0, 0.0):
            return Link(Sentence("in-the-air", value=text, time=time), time, _number(sent.firing))
        if text.endswith(" Pressed") and asked[0] > 0:
            return Link(Sentence("in-the-way", value=text, time=time), time, _number(sent.firing))
    return None


# Types and values as Haskell writes them.


def _kind(value: str) -> str:
    return value.split(" ")[0]


def _events(taken: str) -> list[str]:
    """The event types of an input, any of which triggers; none when it runs without an event."""
    if taken.startswith("Either "):
        sides = _arguments(taken)
        return [kind for side in sides for kind in _events(side)]
    if taken.startswith(("Maybe ", "(", "[")):
        return []
    return [] if _kind(taken) in _SAMPLES | type_roles().states else [taken]


def _takes(taken: str, event: str) -> bool:
    return re.search(rf"(?<![\w.]){re.escape(event)}(?![\w.])", taken) is not None


def _arguments(applied: str) -> list[str]:
    """``Either (Maybe A) B`` as ``["Maybe A", "B"]``."""
    arguments: list[str] = []
    depth = 0
    for word in applied.split(" ")[1:]:
        if depth == 0:
            arguments.append(word)
        else:
            arguments[-1] += " " + word
        depth += word.count("(") - word.count(")")
    return [a[1:-1] if a.startswith("(") and a.endswith(")") else a for a in arguments]


def _times(run: RecordedRun, kind: str) -> list[float]:
    """When events of a type came."""
    start = type_roles().views.get(kind, kind)
    sensed = [time for time, text in run.events() if text == start or text.startswith(start + " ")]
    return sensed + [t for t, f in run.firings() if any(given.to == "event" and given.type == kind for given in f.gave)]


def _was_sent(run: RecordedRun, firing: Firing, event: str) -> bool:
    sender = run.firing(firing.cause.firing)
    if firing.cause.by != "event" or sender is None:
        return False
    return any(given.event == firing.cause.event and given.type == event for given in sender.gave)
