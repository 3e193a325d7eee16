"""
Limit on wrong codes, keys and words: for each page, for each client address, and for all together. Time is an argument.
"""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Sequence
from dataclasses import dataclass

from .token_bucket import TokenBucket

__all__ = ["Attempts", "Rate"]

_MAX_KEYS = 1000
"""Pages or addresses remembered; those that tried longest ago are forgotten first."""


@dataclass(frozen=True, slots=True)
class Rate:
    """Wrong attempts a second, and at once."""

    rate: float
    burst: float


class Attempts:
    """
    Only wrong attempts cost, so that a class behind one address can join at once. One that exceeds a limit does not
    count for the limits after it, so that a page or an address that guesses does not use up those of the others.

    Args:
        each: limits by a key of each kind, the narrowest kind first.
        total: limit for all together.
        now: s on a clock that only goes forward.
    """

    def __init__(self, each: Sequence[Rate], total: Rate, now: float) -> None:
        self._each: list[tuple[Rate, OrderedDict[str, TokenBucket]]] = [(rate, OrderedDict()) for rate in each]
        self._all = TokenBucket(total.rate, total.burst, now)

    def begin(self, keys: Sequence[str], now: float) -> bool:
        """Charge an attempt before its outcome is known; returns whether it may be made. One key of each kind."""
        buckets = [self._bucket(kind, key, now) for kind, key in zip(self._each, keys, strict=True)]
        return all(bucket.spend(1, now) for bucket in buckets) and self._all.spend(1, now)

    @staticmethod
    def _bucket(kind: tuple[Rate, OrderedDict[str, TokenBucket]], key: str, now: float) -> TokenBucket:
        rate, buckets = kind
        if key not in buckets:
            buckets[key] = TokenBucket(rate.rate, rate.burst, now)
            if len(buckets) > _MAX_KEYS:
                buckets.popitem(last=False)
        buckets.move_to_end(key)
        return buckets[key]

    def succeeded(self, keys: Sequence[str], now: float) -> None:
        """Give the charge back."""
        for (_, buckets), key in zip(self._each, keys, strict=True):
            if key in buckets:
                buckets[key].overdraw(-1, now)
        self._all.overdraw(-1, now)
