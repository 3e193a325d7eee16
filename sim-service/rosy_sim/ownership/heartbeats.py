"""
Heartbeats of a page that owns a robot: each names the latest answer that the page had seen, so its age is known here.

A page that hangs, or a network that stalls, sends its old heartbeats when it goes on; by their numbers they count for
nothing. The clock runs while this computer sleeps.
"""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable

from ..boot_clock import boot_seconds

__all__ = ["Heartbeats"]

_KEPT = 50
"""Answers whose times are kept: five seconds of ten heartbeats each."""


class Heartbeats:
    """The answers to one page's heartbeats."""

    def __init__(self, now: Callable[[], float] = boot_seconds) -> None:
        self._now = now
        self._number = 0
        self._times: OrderedDict[int, float] = OrderedDict()

    def next(self) -> int:
        """The number of the next answer, which is sent now."""
        self._number += 1
        self._times[self._number] = self._now()
        if len(self._times) > _KEPT:
            self._times.popitem(last=False)
        return self._number

    def time_of(self, seen: int) -> float | None:
        """When the answer of this number was sent, s of ``boot_seconds``; None when it is unknown or long ago."""
        return self._times.get(seen)
