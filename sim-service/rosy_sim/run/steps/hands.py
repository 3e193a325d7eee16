"""
Hands of a run: what a person or a ROS client did to the robot, with the step before which it happened.

Program, room, seed and hands determine a run, so a run with its hands can be repeated. Everything is applied between
two steps: ``Lockstep`` may not be in the middle of one.
"""

from __future__ import annotations

import contextlib
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import msgspec

from ...wire.page import Companion
from ...wire.topics import TopicMessage
from ...world.events import Command, GiveGoal, Lift, Move, Press, TakeBackGoal, Teleport
from ...world.world import ActionRefused
from .lockstep import Lockstep
from .velocity_guard import OFF, SafetySettings

__all__ = ["Hand", "HandAction", "RecordedHands", "TimedHands", "apply_hand", "read_hands", "write_hands"]

HandAction = Press | Lift | Teleport | Move | GiveGoal | TakeBackGoal | Command | TopicMessage | SafetySettings
"""An action on the robot, a message on a topic, or other settings of the safety rules."""

TimedHands = Sequence[tuple[int, HandAction]]
"""Actions, each with the step before which it happened."""

_KINDS: dict[str, type[HandAction]] = {
    kind.__name__: kind
    for kind in (Press, Lift, Teleport, Move, GiveGoal, TakeBackGoal, Command, TopicMessage, SafetySettings)
}

_MAX_ACTIONS = 20_000
"""Actions recorded of a run; one with more cannot be repeated. Three minutes of dragging at a page's message rate."""


class Hand(msgspec.Struct, array_like=True):
    """An action as JSON."""

    step: int
    kind: str
    fields: Any


@dataclass(slots=True)
class RecordedHands:
    """
    Seed and hands of a run, from its start on.

    ``safety`` are the settings that it began with.
    """

    seed: int = 0
    safety: SafetySettings = OFF
    actions: list[tuple[int, HandAction]] = field(default_factory=list)
    # The other robots in the room.
    companions: tuple[Companion, ...] = ()
    # Whether all actions are recorded, so that the run can be repeated.
    is_complete: bool = True

    def add(self, step: int, action: HandAction) -> None:
        """Record an action that has been applied before a step."""
        if len(self.actions) < _MAX_ACTIONS:
            self.actions.append((step, action))
        else:
            self.is_complete = False

    def choose_safety(self, settings: SafetySettings) -> None:
        """Change the settings of the whole run, as a run from now on would have them."""
        self.safety = settings
        self.actions = [hand for hand in self.actions if not isinstance(hand[1], SafetySettings)]


def apply_hand(lockstep: Lockstep, action: HandAction) -> None:
    """Apply an action between two steps. One that is not possible changes nothing."""
    if isinstance(action, TopicMessage):
        lockstep.post(action)
    elif isinstance(action, Command):
        lockstep.world.command(action)
    elif isinstance(action, SafetySettings):
        lockstep.switch_safety(action)
    else:
        with contextlib.suppress(ActionRefused):
            lockstep.world.apply(action)


def write_hands(hands: TimedHands) -> list[Hand]:
    """Hands as JSON values."""
    return [Hand(step, type(action).__name__, msgspec.to_builtins(action)) for step, action in hands]


def read_hands(hands: Sequence[Hand]) -> list[tuple[int, HandAction]]:
    """
    The reverse of ``write_hands``.

    Raises:
        msgspec.ValidationError: a value is no action.
    """
    found: list[tuple[int, HandAction]] = []
    for hand in hands:
        kind = _KINDS.get(hand.kind)
        if kind is None:
            raise msgspec.ValidationError(f"no action is called {hand.kind}")
        found.append((hand.step, msgspec.convert(hand.fields, kind)))
    return found
