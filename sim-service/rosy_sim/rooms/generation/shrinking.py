"""
Shrinking of a failing room: the reduction with the fewest things in which the program still fails.

In: a reduction, and a function that finds the first failing one among some rooms. Out: the room and whether it is
proved to be the smallest. First things are left out greedily, many at once before single ones, until each of those that
are left is needed. Then all rooms with fewer things are tried, smallest first, so that the first that fails is the
smallest of its family. The answer does not depend on how many rooms the function looks at together.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from .reductions import Reduction

__all__ = ["Shrunk", "shrink"]

MAX_TRIALS = 400
"""Rooms to try before the search for a smaller one is given up."""

MAX_SUBSETS = 100_000
"""Sets of things to look at before the search is given up; most of them are no rooms of the family."""

_BATCH = 16
"""Rooms that are given to the function at once. It is no number of processes, so that the answer depends on none."""

_Json = dict[str, Any]

FirstFailing = Callable[[Sequence[_Json]], int | None]
"""The index of the first of some rooms in which the program fails, or None."""


@dataclass(frozen=True, slots=True)
class Shrunk:
    """``things`` of the original room's ``of`` are left; ``trials`` rooms were tried."""

    world: _Json
    things: int
    of: int
    trials: int
    # Whether no room of the family with fewer things fails.
    is_minimal: bool


class _GaveUp(Exception):
    """Too many rooms were tried."""


class _Search:
    def __init__(self, reduction: Reduction, first_failing: FirstFailing, most: int) -> None:
        self._reduction = reduction
        self._first_failing = first_failing
        self._most = most
        self.trials = 0

    def first(self, subsets: Iterator[frozenset[int]]) -> frozenset[int] | None:
        """The first set of things whose room belongs to the family and fails."""
        found = ((kept, self._reduction.room(kept)) for kept in subsets)
        rooms = ((kept, room) for kept, room in found if room is not None)
        while batch := list(itertools.islice(rooms, _BATCH)):
            if self.trials + len(batch) > self._most:
                raise _GaveUp
            self.trials += len(batch)
            index = self._first_failing([room for _, room in batch])
            if index is not None:
                return batch[index][0]
        return None


def shrink(reduction: Reduction, first_failing: FirstFailing, most: int = MAX_TRIALS) -> Shrunk:
    """The smallest room of a reduction whose whole room fails; at most about ``most`` rooms are tried."""
    search = _Search(reduction, first_failing, most)
    kept = frozenset(range(reduction.things))
    is_minimal = True
    try:
        if search.first(iter([frozenset()])) is not None:
            kept = frozenset()
        else:
            while (less := search.first(_with_less(kept))) is not None:
                kept = less
            least = search.first(_counted(_smaller(reduction.things, len(kept))))
            kept = least if least is not None else kept
    except _GaveUp:
        is_minimal = False
    world = reduction.room(kept)
    assert world is not None
    return Shrunk(world, len(kept), reduction.things, search.trials, is_minimal)


def _with_less(kept: frozenset[int]) -> Iterator[frozenset[int]]:
    """The set without a half of it, then without quarters, down to single things; the empty set was tried before."""
    order = sorted(kept)
    size = len(order) // 2
    while size:
        for i in range(0, len(order), size):
            less = kept.difference(order[i : i + size])
            if less:
                yield less
        size //= 2


def _smaller(things: int, size: int) -> Iterator[frozenset[int]]:
    """All sets of at least one and of fewer things, smallest first."""
    for count in range(1, size):
        for chosen in itertools.combinations(range(things), count):
            yield frozenset(chosen)


def _counted(subsets: Iterator[frozenset[int]]) -> Iterator[frozenset[int]]:
    """The same, ending the search when there are more sets than may be looked at."""
    for count, kept in enumerate(subsets, 1):
        if count == MAX_SUBSETS:
            raise _GaveUp
        yield kept
