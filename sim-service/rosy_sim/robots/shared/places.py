"""Angles, and bits of sensors that have several places: which are over a hole, and which have changed."""

from __future__ import annotations

import math

from ...world.arena import Arena
from ...world.events import Reading

__all__ = ["append_edge", "over_hole", "wrapped"]


def wrapped(angle: float) -> float:
    """An angle brought into (-pi, pi]."""
    return math.pi - (math.pi - angle) % math.tau


def over_hole(
    arena: Arena,
    x: float,
    y: float,
    theta: float,
    points: tuple[tuple[float, float], ...],
    weights: tuple[int, ...],
) -> int:
    """The weights of those points of a robot at x, y (m) and theta (rad) that have no floor under them."""
    c, s = math.cos(theta), math.sin(theta)
    bits = 0
    for (px, py), bit in zip(points, weights, strict=True):
        if arena.is_hole(x + c * px - s * py, y + s * px + c * py):
            bits |= bit
    return bits


def append_edge(events: list[Reading], channel: str, which: int, before: int, now: int, bit: int) -> None:
    """Append the event of a place whose bit has changed."""
    if (before ^ now) & bit:
        events.append(Reading(channel, (which, 1 if now & bit else 0)))
