"""
Phases of runs at real time: when, within the 20 ms of a step, the steps of each run begin.

Runs that begin together, or that have lost time together on a busy machine, would make their steps all at once from
then on, and the last of them late in every step. So the phases are spread evenly: a run gets the one with the fewest
runs.
"""

from __future__ import annotations

import math

from ..world.time_step import STEP

__all__ = ["PHASES", "StepPhases"]

PHASES = 20
"""Their number: a millisecond each, the resolution of uvloop's timers."""

_WIDTH = STEP / PHASES
"""s."""


class StepPhases:
    """Of all runs of a service."""

    def __init__(self) -> None:
        self._runs = [0] * PHASES

    def enter(self, now: float) -> tuple[int, float]:
        """
        A phase for a run whose next step may begin now, and when that step begins, on the same clock, s: less than a
        step later. The phase is to be left.
        """
        first = math.ceil(now / _WIDTH)
        fewest = min(range(first, first + PHASES), key=lambda tick: self._runs[tick % PHASES])
        phase = fewest % PHASES
        self._runs[phase] += 1
        return phase, max(now, fewest * _WIDTH)

    def leave(self, phase: int) -> None:
        """A run with this phase ends, pauses or changes its speed."""
        self._runs[phase] -= 1
