"""
Limit of the runs that are observed at the same time.
"""

from __future__ import annotations

from dataclasses import dataclass, field

__all__ = ["MOST_OBSERVED", "ObservedRuns"]

MOST_OBSERVED = 32
"""
Runs that are observed at the same time, one per page of a class: at 50 steps per second recording takes a tenth of a
core.
"""


@dataclass(frozen=True, slots=True)
class ObservedRuns:
    """
    Limit of the runs that are observed at the same time.

    An observed step takes a seventh more computing than another one (``./rosy bench why``), and the record
    of a run up to 20 MB of memory. A run without a place is not recorded.
    """

    most: int
    runs: set[object] = field(default_factory=set)

    def admit(self, run: object) -> bool:
        """Take a place for a run; whether it has one."""
        if run not in self.runs and len(self.runs) >= self.most:
            return False
        self.runs.add(run)
        return True
