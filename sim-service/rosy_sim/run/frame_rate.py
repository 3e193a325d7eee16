"""
Frame rate of all pages: when steps begin late, pages get fewer frames, so that simulated time keeps up with real time.

A frame costs the service about as much as two steps. A page interpolates between two frames: few of them look less
smooth, but nothing happens later. The rate is multiplied by 0.7 while more than 2.5 % of the steps are late, and rises
by a constant otherwise (additive increase and multiplicative decrease, as TCP finds the rate of a network).
"""

from __future__ import annotations

import math

from .lateness import Lateness

__all__ = ["LOWEST_RATE", "FrameRate"]

LOWEST_RATE = 12.0
"""Frames a second that a page gets on any machine."""

_INTERVAL = 1.0
"""Between two reviews of the rate, s."""

_LATE_SHARE, _FEWEST_LATE = 0.025, 3
"""The share of late steps above which the rate falls, and the fewest of them. A single pause of the machine or of the
garbage collector delays a fiftieth of the steps of an interval, and is no overload."""

_FALL, _RISE = 0.7, 2.0
"""Factor when it falls; frames a second by which it rises in a second."""


class FrameRate:
    """
    Of one service.

    Args:
        highest: frames a second when no step is late.
        lateness: of the steps of all runs.
    """

    def __init__(self, highest: float, lateness: Lateness) -> None:
        self._highest = highest
        self._lateness = lateness
        self._rate = highest
        # When the rate was reviewed last, and how many steps there had been, and late ones.
        self._reviewed = -math.inf
        self._steps, self._late = lateness.steps, lateness.late

    def at(self, now: float) -> float:
        """Frames a second at a time in s that does not go back."""
        if now - self._reviewed >= _INTERVAL:
            self._review(now)
        return self._rate

    def _review(self, now: float) -> None:
        steps, late = self._lateness.steps - self._steps, self._lateness.late - self._late
        elapsed = now - self._reviewed
        self._reviewed = now
        self._steps, self._late = self._lateness.steps, self._lateness.late
        # Before that interval no page wanted frames.
        self._rise(elapsed - _INTERVAL)
        if late >= _FEWEST_LATE and late > _LATE_SHARE * steps:
            self._rate = max(min(LOWEST_RATE, self._highest), self._rate * _FALL)
        else:
            self._rise(_INTERVAL)

    def _rise(self, seconds: float) -> None:
        self._rate = min(self._highest, self._rate + _RISE * seconds)
