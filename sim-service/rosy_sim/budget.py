"""
How much somebody may ask for: an allowance that grows with time up to a limit. Time comes in as a number.
"""

from __future__ import annotations

__all__ = ["Budget"]


class Budget:
    """A token bucket."""

    def __init__(self, rate: float, most: float, now: float) -> None:
        self._rate = rate
        self._most = most
        # What may be spent at ``_then``; negative after overdraw().
        self._left = most
        self._then = now

    def spend(self, cost: float, now: float) -> bool:
        """Spend if there is enough; says whether there was."""
        self._grow(now)
        if self._left < cost:
            return False
        self._left -= cost
        return True

    def overdraw(self, cost: float, now: float) -> float:
        """Spend in any case; returns the s to wait until the allowance is no longer negative."""
        self._grow(now)
        self._left -= cost
        return max(0.0, -self._left / self._rate)

    def _grow(self, now: float) -> None:
        self._left = min(self._most, self._left + (now - self._then) * self._rate)
        self._then = now
