"""Outcome of a program in a room as pages and boards get it: with the room, and a path for a small picture."""

from __future__ import annotations

from ..wire.page.room_tests import FindingShown, TestedRoom
from .trial import Finding, Outcome

__all__ = ["tested_room"]

_MAX_POINTS = 80
"""Of a path in a small picture."""


def tested_room(outcome: Outcome, world: object) -> TestedRoom:
    """The outcome with the room in which it was."""
    path = outcome.path
    step = max(1, -(-len(path) // _MAX_POINTS))
    return TestedRoom(
        outcome.room,
        outcome.seed,
        outcome.has_passed,
        outcome.ended,
        outcome.time,
        [_shown(finding) for finding in outcome.findings],
        outcome.problems,
        world,
        [*path[:-1:step], *path[-1:]],
    )


def _shown(finding: Finding) -> FindingShown:
    return FindingShown(finding.property, finding.state, finding.time, finding.amount)
