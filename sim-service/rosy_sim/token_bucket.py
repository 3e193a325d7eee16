"""
Token bucket: limits a rate of messages or bytes while allowing bursts. Time is an argument.
"""

from __future__ import annotations

__all__ = ["Share", "TokenBucket"]


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

    def is_full(self, now: float) -> bool:
        """Whether nothing was taken lately."""
        self._refill(now)
        return self._left >= self._most

    def _refill(self, now: float) -> None:
        self._left = min(self._most, self._left + (now - self._then) * self.rate)
        self._then = now


class Share:
    """
    Token bucket of one client beside others. From its first overdraft until it is full again, what is taken counts for
    a bucket that all such clients have together, too: however many they are, they leave a part to the others.
    """

    def __init__(self, own: TokenBucket, together: TokenBucket) -> None:
        self._own = own
        self._together = together
        self._is_overdrawn = False

    def overdraw(self, cost: float, now: float) -> float:
        """Take tokens in any case; returns the s to wait until neither bucket is negative."""
        if self._is_overdrawn and self._own.is_full(now) and self._together.overdraw(0.0, now) == 0:
            self._is_overdrawn = False
        wait = self._own.overdraw(cost, now)
        self._is_overdrawn = self._is_overdrawn or wait > 0
        return max(wait, self._together.overdraw(cost, now)) if self._is_overdrawn else wait
