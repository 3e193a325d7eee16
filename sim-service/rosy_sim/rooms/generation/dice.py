"""
Random numbers for generated rooms: the same on every machine for the same key.

Python guarantees the sequence of ``random()`` for a seed; its other functions may change, so they are not used. A text
is turned into a seed with SHA-512.
"""

from __future__ import annotations

import random
from collections.abc import Sequence
from typing import TypeVar

__all__ = ["Dice"]

_Item = TypeVar("_Item")


class Dice:
    """Draws from a stream of random numbers that belongs to ``key``."""

    def __init__(self, key: str) -> None:
        self._random = random.Random(key)

    def whole(self, low: int, high: int) -> int:
        """A whole number, both ends included."""
        return low + int(self._random.random() * (high - low + 1))

    def step(self, low: float, high: float, step: float) -> float:
        """One of ``low``, ``low + step``, … up to ``high``, rounded to millimetres."""
        return round(low + step * self.whole(0, round((high - low) / step)), 3)

    def choice(self, items: Sequence[_Item]) -> _Item:
        """One of some items."""
        return items[self.whole(0, len(items) - 1)]

    def seed(self) -> int:
        """A seed for a run."""
        return self.whole(0, 2**31 - 1)
