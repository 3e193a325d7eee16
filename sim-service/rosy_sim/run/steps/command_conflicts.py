"""
Detection of functions that override each other's commands while a program runs, without any I/O.

A command that holds until the next one (a velocity, a light) is in conflict when another function replaces it with
another value within 0.2 s, again and again. Each pair of functions is reported once for a channel. Whether the second
function takes the first one's reason into account, through a memory for example, is not visible here: the page knows
the types.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

from ...wire.channels import Values
from ...wire.topics import CHANNELS, TopicMessage
from ...world.events import Command
from ...world.time_step import STEPS_PER_SECOND

__all__ = ["Action", "CommandConflict", "CommandConflicts", "senders"]

Action = Command | TopicMessage
"""What a program sends in a step."""

REPLACED_WITHIN = round(0.2 * STEPS_PER_SECOND)
"""Steps in which a command has hardly had an effect: 0.2 s, two ticks. A choice of ours."""

REPLACEMENTS = 3
"""Replacements of one function's commands by another's that are a conflict. A choice of ours."""


@dataclass(frozen=True, slots=True)
class CommandConflict:
    """A function whose command stays in force, and the one whose command it replaces."""

    channel: str
    winner: str
    loser: str


@dataclass(slots=True)
class _InForce:
    """The latest command of a channel: its function, its values, and the step in which they were sent first."""

    sender: str
    values: Values
    step: int


class CommandConflicts:
    """Observes the commands of one run."""

    def __init__(self) -> None:
        self._in_force: dict[str, _InForce] = {}
        # The command or message of the latest step with any, if there was exactly one.
        self._only: Action | None = None
        # By channel, winner and loser: replacements within `REPLACED_WITHIN`.
        self._replaced: Counter[tuple[str, str, str]] = Counter()
        # By channel and function: commands that held longer.
        self._held: Counter[tuple[str, str]] = Counter()
        # Channels and pairs that were reported, in any order of the pair.
        self._reported: set[tuple[str, frozenset[str]]] = set()

    def observe(
        self, step: int, fired: Sequence[str], sent: Sequence[int], actions: Sequence[Action]
    ) -> list[CommandConflict]:
        """Conflicts that this step has made certain; ``fired`` and ``sent`` are those of ``settled``."""
        if len(actions) == 1 and actions[0] == self._only:
            # By far the most steps repeat one command, which is in force and changes nothing.
            return []
        found: list[CommandConflict] = []
        sent_by = senders(fired, sent, actions)
        self._only = actions[0] if len(actions) == len(sent_by) == 1 else None
        for sender, command in sent_by:
            if not isinstance(command, Command):
                continue
            channel = command.channel
            before = self._in_force.get(channel)
            if (before is not None and before.values == command.values) or not _holds(channel):
                continue
            self._in_force[channel] = _InForce(sender, command.values, step)
            if before is None or before.sender == sender:
                continue
            if step - before.step > REPLACED_WITHIN:
                self._held[channel, before.sender] += 1
                continue
            self._replaced[channel, sender, before.sender] += 1
            if self._is_certain(channel, sender, before.sender):
                self._reported.add((channel, frozenset((sender, before.sender))))
                found.append(CommandConflict(channel, sender, before.sender))
        return found

    def _is_certain(self, channel: str, winner: str, loser: str) -> bool:
        replaced = self._replaced[channel, winner, loser]
        is_reported = (channel, frozenset((winner, loser))) in self._reported
        return replaced >= REPLACEMENTS and replaced > self._held[channel, loser] and not is_reported


def _holds(channel: str) -> bool:
    return channel == "Velocity" or CHANNELS[channel].holds


def senders(fired: Sequence[str], sent: Sequence[int], actions: Sequence[Action]) -> list[tuple[str, Action]]:
    """
    Each command or message of a step with the name of the function that sent it.

    Those before the first function's are lines that ``main`` prints. Without ``sent`` one function sent all of them.
    """
    if len(fired) == 1 and not sent:
        return [(fired[0], action) for action in actions]
    counts = sent
    if len(counts) != len(fired) or sum(counts) > len(actions):
        return []
    names = [name for name, count in zip(fired, counts, strict=True) for _ in range(count)]
    return list(zip(names, actions[len(actions) - len(names) :], strict=True))
