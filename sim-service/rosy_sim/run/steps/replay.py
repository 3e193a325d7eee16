"""
Replay: the part of an earlier run that a run begins with, and the commands of that run to compare with.

A run that goes on from a moment of another one repeats its seed and hands up to that step as fast as it can, and then
continues live. An unchanged program repeats the run exactly; a changed one is compared with it command by command.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from ...wire.topics import TopicMessage
from ...world.events import Command
from .hands import HandAction
from .lockstep import Lockstep

__all__ = ["NO_REPLAY", "CommandLog", "Replay"]

_MAX_STEPS = 200_000
"""Steps with commands that are kept of a run: more than an hour. Later ones are not compared, and the page is told."""


@dataclass(slots=True)
class CommandLog:
    """The commands and messages of a program, by the step in which it gave them."""

    # Steps that have been completed.
    steps: int = 0
    _given: dict[int, tuple[Command | TopicMessage, ...]] = field(default_factory=dict)

    def add(self, lockstep: Lockstep) -> None:
        """Record the step that has just been integrated."""
        self.steps = lockstep.step
        if (lockstep.commands or lockstep.published) and len(self._given) < _MAX_STEPS:
            self._given[lockstep.step - 1] = _given(lockstep)

    @property
    def kept_steps(self) -> int:
        """The steps before this one can be compared."""
        return self.steps if len(self._given) < _MAX_STEPS else next(reversed(self._given)) + 1

    def differs(self, lockstep: Lockstep) -> bool:
        """Whether the step that has just been integrated had other commands than here, as far as these are kept."""
        step = lockstep.step - 1
        return step < self.kept_steps and self._given.get(step, ()) != _given(lockstep)


def _given(lockstep: Lockstep) -> tuple[Command | TopicMessage, ...]:
    return (*lockstep.commands, *lockstep.published)


@dataclass(frozen=True, slots=True)
class Replay:
    """
    What a run repeats before it is live.

    Args:
        steps: how many.
        hands: what happened before these steps, and before the first live one; in order.
        commands: those of the earlier run.
    """

    steps: int = 0
    hands: tuple[tuple[int, HandAction], ...] = ()
    commands: CommandLog = field(default_factory=CommandLog)

    def hands_before(self, step: int) -> list[HandAction]:
        """The actions between the step before and this one."""
        return [action for at, action in self.hands if at == step]


NO_REPLAY = Replay()
"""For a run that begins at its start. Its log of commands is not added to."""
