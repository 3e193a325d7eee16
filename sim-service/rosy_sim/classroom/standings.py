"""
Standings of a competition: the pupils whose hand-ins for a task were checked, by the rooms in which their programs did
well, and those that are equal by the mean time in these rooms.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import msgspec

from ..wire.page.room_tests import TestedRoom
from .messages.check_messages import CheckResult
from .messages.projector_messages import Standing

__all__ = ["Results", "mean_time", "standings"]

Results = Mapping[int, bytes]
"""The results of a task by pupil, as JSON; empty for a hand-in that was not checked."""


def mean_time(rooms: Sequence[TestedRoom]) -> float | None:
    """
    The mean time in the passed rooms until all was reached that can be reached, s, in tenths; ``None`` without such a
    room. A room in which there is only something to avoid takes as long as its run.
    """
    times = [_time(room) for room in rooms if room.passed]
    return round(sum(times) / len(times), 1) if times else None


def _time(room: TestedRoom) -> float:
    # What is to be avoided is decided when the run is over.
    reached = [found.time for found in room.findings if found.time is not None and found.time < room.time]
    return max(reached, default=room.time)


def standings(results: Results, nicknames: Mapping[int, str]) -> list[Standing]:
    """The table, the first place first; pupils who are equal have the same place, and the next place is left out."""
    found = [
        (msgspec.json.decode(result, type=CheckResult), nicknames[pupil])
        for pupil, result in results.items()
        if result and pupil in nicknames
    ]
    found.sort(key=lambda one: (*_rank(one[0]), one[1].casefold()))
    table: list[Standing] = []
    for number, (result, nickname) in enumerate(found, 1):
        is_equal = number > 1 and _rank(result) == _rank(found[number - 2][0])
        place = table[-1].place if is_equal else number
        table.append(Standing(place, nickname, result.passed, result.rooms, result.time))
    return table


def _rank(result: CheckResult) -> tuple[float, float]:
    """The share of the rooms, because a hand-in may have been checked in another number of rooms; then the time."""
    return -result.passed / max(1, result.rooms), float("inf") if result.time is None else result.time
