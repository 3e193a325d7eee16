"""
Recorded run: firings with their provenance (language rule R12), events and commands of a program, with their times.

Bounded: of a run that fires more often than ``MAX_FIRINGS`` times the latest firings are kept.
"""

from __future__ import annotations

from bisect import bisect_right
from collections import deque
from typing import NamedTuple

from ..wire.firing import Firing
from .recorded_step import EncodedContent, RecordedStep, ShownCommand, StepContent
from .values import inside, written

__all__ = ["MAX_FIRINGS", "RecordedRun", "SentCommand"]

MAX_FIRINGS = 200_000
"""Firings that are kept: more than an hour of a program that fires 50 times a second. A choice of ours."""


class SentCommand(NamedTuple):
    """
    A command, as Haskell shows it, its type, and the firing that sent it; None when no function did (rule R10).

    The program reports the type with the firing, without its parameters. A command without a firing has that of its
    channel.
    """

    time: float
    type: str
    value: str
    firing: Firing | None


class RecordedRun:
    """
    What a program did, step by step.

    Args:
        until: later steps are not recorded, s. None for all.
        most: firings that are kept, the latest ones.
    """

    def __init__(self, until: float | None = None, most: int = MAX_FIRINGS) -> None:
        self._until = until
        self._most = most
        self._steps: deque[RecordedStep] = deque()
        # Those of them in which something fired.
        self._fired: deque[RecordedStep] = deque()
        # How many firings are kept.
        self.count = 0
        # Since when the safety rules drive, as of the last step.
        self._overridden_since: float | None = None
        # When the last step was recorded, s; None before the first.
        self.end: float | None = None
        # Earlier steps were dropped or not observed, s.
        self.known_since = 0.0

    def add_step(
        self,
        time: float,
        firings: list[Firing],
        events: list[str],
        commands: list[ShownCommand],
        *,
        is_overridden: bool = False,
        is_placed: bool = False,
    ) -> None:
        """Append a step; ``events`` and the values of ``commands`` as in a trace."""
        content = StepContent(firings, events, commands)
        self.add(time, content, is_overridden=is_overridden, is_placed=is_placed)

    def add(
        self,
        time: float,
        content: StepContent | EncodedContent,
        *,
        is_overridden: bool = False,
        is_placed: bool = False,
    ) -> None:
        """Append a step."""
        if self._until is not None and time > self._until + 1e-9:
            return
        self.end = time
        was_overridden = self._overridden_since is not None
        self._overridden_since = (self._overridden_since if was_overridden else time) if is_overridden else None
        if content.is_empty and not (is_overridden or was_overridden or is_placed):
            return
        step = RecordedStep(time, content, self._overridden_since, is_placed)
        self._steps.append(step)
        if content.count:
            self._fired.append(step)
            self.count += content.count
        while self.count > self._most:
            dropped = self._steps.popleft().content.count
            if dropped:
                self._fired.popleft()
                self.count -= dropped
            self.known_since = self._steps[0].time if self._steps else time

    def firing(self, number: int | None) -> Firing | None:
        """The firing with this number, if it is recorded."""
        return self._find(number)[1] if number is not None else None

    def time_of(self, firing: Firing) -> float:
        """When it fired, s since the start of the program."""
        return self._find(firing.n)[0]

    def _find(self, number: int) -> tuple[float, Firing | None]:
        """
        A firing and its time. They are numbered in their order, so that few steps need to be read to find one.
        """
        index = bisect_right(self._fired, number, key=lambda step: step.content.first_number) - 1
        if index < 0:
            return 0.0, None
        step = self._fired[index]
        return step.time, next((firing for firing in step.content.firings if firing.n == number), None)

    def firings(self) -> list[tuple[float, Firing]]:
        """All firings in order, with their times."""
        return [(step.time, firing) for step in self._steps for firing in step.content.firings]

    def latest_firings(self) -> list[tuple[float, Firing]]:
        """The latest firing of each function, with its time, in order."""
        latest = {firing.function: (time, firing) for time, firing in self.firings()}
        return sorted(latest.values(), key=lambda found: found[1].n)

    def events(self) -> list[tuple[float, str]]:
        """All events that the program sensed or sent itself, with their times."""
        return [(step.time, text) for step in self._steps for text in step.content.events]

    def latest_command(self, kind: str, until: float) -> SentCommand | None:
        """The last command of a type (``Velocity``) at or before a time, s. Parameters of the type are not compared."""
        for step in reversed(self._steps):
            if step.time > until + 1e-9:
                continue
            for sent in reversed(_commands(step)):
                if sent.type == kind.partition(" ")[0]:
                    return sent
        return None

    def latest_write(self, kind: str, until: float) -> Firing | None:
        """The last firing at or before a time, s, that wrote a memory of a type (``Memory Int``)."""
        for step in reversed(self._steps):
            if step.time > until + 1e-9:
                continue
            for firing in reversed(step.content.firings):
                if any(given.to in ("memory", "param") and given.type == kind for given in firing.gave):
                    return firing
        return None

    def beginning_of_value(self, kind: str, writer: Firing) -> Firing | None:
        """
        The firing since which a memory of a type (``Memory Bool``) has had the value that another one wrote: the first
        of those that wrote the same one after the other. None when that was its first value already.
        """
        value = written(writer, kind)
        first = writer
        for step in reversed(self._fired):
            for firing in reversed(step.content.firings):
                if firing.n >= writer.n:
                    continue
                earlier = written(firing, kind)
                if earlier not in (None, value):
                    return first
                if earlier is not None:
                    first = firing
                for taken in firing.took:
                    if taken.type == kind and taken.firing is None and firing.task == writer.task:
                        return None if inside(taken.value) == value else first
        return first

    def latest_firing(self, function: str, until: float) -> Firing | None:
        """The last firing of a function at or before a time, s."""
        for step in reversed(self._steps):
            if step.time <= until + 1e-9:
                for firing in reversed(step.content.firings):
                    if firing.function == function:
                        return firing
        return None

    def latest_event_named(self, constructor: str, until: float) -> str | None:
        """The last event with a constructor (``Bumper``) at or before a time, s, as Haskell shows it."""
        for step in reversed(self._steps):
            if step.time <= until + 1e-9:
                for text in reversed(step.content.events):
                    if text.partition(" ")[0] == constructor:
                        return text
        return None

    def latest_event(self, text: str, until: float) -> tuple[float, Firing | None, list[Firing]] | None:
        """
        When an event came last, at or before a time, s; the firing that sent it, None for one of the robot; and the
        firings of that step that it caused.
        """
        for step in reversed(self._steps):
            if step.time <= until + 1e-9 and text in step.content.events:
                firings = step.content.firings
                sent = [(f, g.event) for f in firings for g in f.gave if g.to == "event" and g.value == text]
                if not sent:
                    return step.time, None, [firing for firing in firings if firing.cause.value == text]
                sender, number = sent[-1]
                takers = [f for f in firings if f.cause.by == "event" and f.cause.event == number]
                return step.time, sender, takers
        return None

    def overridden_since(self, time: float) -> float | None:
        """When the safety rules began to drive that did so at a time, s; None when the program drove."""
        return next((step.overridden_since for step in reversed(self._steps) if step.time <= time + 1e-9), None)

    def latest_placement(self, until: float) -> float | None:
        """When a hand put the robot in another place last, at or before a time, s."""
        return next((step.time for step in reversed(self._steps) if step.is_placed and step.time <= until + 1e-9), None)

    def commands(self) -> list[SentCommand]:
        """All commands in order, each with the firing that sent it."""
        return [sent for step in self._steps for sent in _commands(step)]


def _commands(step: RecordedStep) -> list[SentCommand]:
    """
    The commands of a step, matched with the outputs of its firings.

    Both are in firing order. A command between them that no firing gave was sent for a task that was stopped.
    """
    outputs = deque(
        (firing, given) for firing in step.content.firings for given in firing.gave if given.to == "command"
    )
    sent: list[SentCommand] = []
    for channel, value in step.content.commands:
        # A long text is cut in the record of a firing and whole in the trace.
        if outputs and value.startswith(outputs[0][1].value):
            firing, given = outputs.popleft()
            sent.append(SentCommand(step.time, given.type, value, firing))
        else:
            sent.append(SentCommand(step.time, channel, value, None))
    return sent
