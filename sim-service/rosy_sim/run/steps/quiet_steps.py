"""
Quiet steps of a run: those in which the program has said that nothing can fire, and what it has missed in them.

In: ``quiet`` of the program's answers, the readings of each step. Out: whether a step can be left out, and the states
that changed in the steps left out. An event ends the quiet.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from ...wire.topics import CHANNELS, ODOMETRY
from ...world.events import Reading
from ...world.world import Odometry

__all__ = ["MemoryRequest", "QuietSteps"]

MemoryRequest = Literal["none", "soon", "now"]
"""Whether the program is asked what it remembers: not, with a step that is not quiet anyway, or at once."""

_SOON = 5
"""Steps for which a request for the memory may wait: until the next tick."""

_EVENTS = frozenset(channel.name for channel in CHANNELS.values() if channel.kind == "event")


class QuietSteps:
    """Of one run."""

    __slots__ = ("_memory_is_known", "_missed", "_until", "odometry")

    def __init__(self) -> None:
        # The first step that is not quiet.
        self._until = 0
        # The latest changes of states in the steps that were left out, by channel.
        self._missed: dict[str, Reading] = {}
        # The odometry of the last step that was left out; None when there is none.
        self.odometry: Odometry | None = None
        # Whether the program was asked for its memory since it last did something.
        self._memory_is_known = False

    def begin(self, step: int, count: int) -> None:
        """The program has settled a step and calls the next ones quiet."""
        self._until = step + 1 + count

    def covers(self, step: int, memory: MemoryRequest) -> bool:
        """Whether the program need not be asked in a step, as far as is known before it is sensed."""
        if step >= self._until:
            return False
        return memory == "none" or self._memory_is_known or (memory == "soon" and self._until - step <= _SOON)

    def skip(self, readings: Sequence[Reading]) -> bool:
        """Leave out a step with these readings, unless one of them is an event; its ``odometry`` is to be set then."""
        for reading in readings:
            if reading.channel in _EVENTS:
                return False
        for reading in readings:
            self._missed[reading.channel] = reading
        return True

    def end(self, asks_memory: bool) -> None:
        """The program is asked again."""
        self._until = 0
        self._memory_is_known = asks_memory

    def take_missed(self) -> list[Reading] | None:
        """What the program has to know of the steps left out since it was asked last; None when there are none."""
        if self.odometry is None:
            return None
        missed = [*self._missed.values(), Reading(ODOMETRY.name, self.odometry)]
        self._missed = {}
        self.odometry = None
        return missed
