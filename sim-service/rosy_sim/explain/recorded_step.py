"""
Recorded step: what a program did in one step of an observed run.

The firings of most steps are never asked about: a step that a page records keeps them as the program sent them, and
reads them when a question gets to it.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass
from typing import NamedTuple

from ..wire.firing import Firing, count_firings, read_firings
from ..world.events import VELOCITY_CHANNEL, Command

__all__ = ["EncodedContent", "RecordedStep", "ShownCommand", "StepContent", "commands_of_step"]


class ShownCommand(NamedTuple):
    """A command of a step, as Haskell shows it, and its channel; empty for a topic of the program's own."""

    channel: str
    value: str


class StepContent:
    """Firings, events and commands of a step; events and values of commands as in a trace."""

    __slots__ = ("commands", "count", "events", "firings")

    def __init__(self, firings: list[Firing], events: list[str], commands: list[ShownCommand]) -> None:
        self.firings = firings
        self.events = events
        self.commands = commands
        # For how many firings it counts in the limit of a run.
        self.count = len(firings)

    @property
    def is_empty(self) -> bool:
        """Whether nothing happened."""
        return not (self.firings or self.events or self.commands)

    @property
    def first_number(self) -> int:
        """The number of its first firing."""
        return self.firings[0].n if self.firings else -1


class EncodedContent:
    """The same of ``settled``: its firings as they were sent, the events that were sensed, and the commands."""

    __slots__ = ("_commands", "_encoded", "_firings", "_sensed", "_sent", "count", "is_empty")

    def __init__(self, encoded: bytes, sensed: list[str], sent: list[Command]) -> None:
        self.count = count_firings(encoded)
        self.is_empty = not (self.count or sensed or sent)
        self._encoded = encoded
        self._sensed = sensed
        self._sent = sent
        # None until something asks.
        self._firings: list[Firing] | None = None
        self._commands: list[ShownCommand] | None = None

    @property
    def firings(self) -> list[Firing]:
        """The firings; none when what was sent is no list of firings."""
        if self._firings is None:
            self._firings = read_firings(self._encoded)
            self._encoded = b""
        return self._firings

    @property
    def events(self) -> list[str]:
        """What was sensed, then what the program sent itself."""
        return self._sensed + [given.value for firing in self.firings for given in firing.gave if given.to == "event"]

    @property
    def commands(self) -> list[ShownCommand]:
        """All commands in their order."""
        if self._commands is None:
            self._commands = commands_of_step(self.firings, self._sent)
        return self._commands

    @property
    def first_number(self) -> int:
        """The number of its first firing."""
        return self.firings[0].n if self.firings else -1


@dataclass(slots=True)
class RecordedStep:
    """A step with its time, s."""

    time: float
    content: StepContent | EncodedContent
    # Since when the safety rules drove instead of the program, s; None when the program drove.
    overridden_since: float | None = None
    # A hand had put the robot in another place since the step before.
    is_placed: bool = False


def commands_of_step(firings: list[Firing], commands: list[Command]) -> list[ShownCommand]:
    """
    The commands of a step as Haskell shows them, in the form of a trace, without one. Those of a firing have its types.

    All come from firings but velocities of 0 for tasks that were stopped (rule R10), and lines that ``main`` prints.
    """
    from_firings = [
        ShownCommand(one.type, one.value) for firing in firings for one in firing.gave if one.to == "command"
    ]
    velocities = sum(one.channel == VELOCITY_CHANNEL for one in from_firings)
    if velocities == sum(command.channel == VELOCITY_CHANNEL for command in commands):
        return from_firings
    given = deque(from_firings)
    ordered: list[ShownCommand] = []
    for command in commands:
        if command.channel != VELOCITY_CHANNEL:
            continue
        while given and given[0].channel != VELOCITY_CHANNEL:
            ordered.append(given.popleft())
        if given and _velocity(given[0].value) == command.values:
            ordered.append(given.popleft())
        elif command.values == (0.0, 0.0):
            ordered.append(ShownCommand(VELOCITY_CHANNEL, "Velocity 0.0 0.0"))
    return ordered + list(given)


def _velocity(value: str) -> tuple[float, ...]:
    words = value.replace("(", "").replace(")", "").split(" ")[1:]
    return tuple(float(word) for word in words)
