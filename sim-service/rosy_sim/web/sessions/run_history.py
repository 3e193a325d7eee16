"""
Bounded history of a page's runs: what is kept of each run after the next one has begun, by the number of the run.
"""

from __future__ import annotations

from collections import OrderedDict
from typing import Generic, TypeVar

__all__ = ["MAX_RUNS", "RunHistory"]

MAX_RUNS = 20
"""Runs that are kept; as many as the page shows in its tree of runs."""

_T = TypeVar("_T")


class RunHistory(Generic[_T]):
    """
    The latest runs.

    Args:
        most: the weights of the kept runs together; the oldest runs are dropped.
    """

    def __init__(self, most: int) -> None:
        self._most = most
        self._runs: OrderedDict[int, tuple[_T, int]] = OrderedDict()
        self._weight = 0

    def add(self, run: int, value: _T, weight: int) -> None:
        """Keep a run that is over; an earlier one with the same number is replaced."""
        self._remove(run)
        self._runs[run] = (value, weight)
        self._weight += weight
        while self._runs and (self._weight > self._most or len(self._runs) > MAX_RUNS):
            self._remove(next(iter(self._runs)))

    def get(self, run: int) -> _T | None:
        """What is kept of a run; None when it was dropped or there was none."""
        found = self._runs.get(run)
        return found[0] if found is not None else None

    def clear(self) -> None:
        """Drop all runs."""
        self._runs.clear()
        self._weight = 0

    def _remove(self, run: int) -> None:
        _, weight = self._runs.pop(run, (None, 0))
        self._weight -= weight
