"""
Token bucket: limits a rate of messages or bytes while allowing bursts. Time is an argument.
"""

from __future__ import annotations

__all__ = ["TokenBucket"]


class TokenBucket:
    """``rate`` tokens a second, at most ``most`` at once."""

    def __init__(self, rate: float, most: float, now: float) -> None:
        # May be changed; the new rate also counts for the time since the last call.
        self.rate = rate
        self._most = most
        # Tokens at ``_then``; negative after overdraw().
        self._left = most
        self._then = now

    def spend(self, cost: float, now: float) -> bool:
        """Take tokens if there are enough; returns whether there were."""
        self._refill(now)
        if self._left < cost:
            return False
        self._left -= cost
        return True

    def overdraw(self, cost: float, now: float) -> float:
        """Take tokens in any case; returns the s to wait until the bucket is no longer negative."""
        self._refill(now)
        self._left -= cost
        return max(0.0, -self._left / self.rate)

    def _refill(self, now: float) -> None:
        self._left = min(self._most, self._left + (now - self._then) * self.rate)
        self._then = now
