"""
Extent and seed of long tests: ``./rosy test`` runs a share that changes daily, ``./rosy test nightly`` all of it.

``ROSY_TEST_SEED=17 ./rosy test python`` repeats the choice of a run.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TypeVar

__all__ = ["SEED", "TODAY", "WHOLE", "Day", "rotated"]

Row = TypeVar("Row")

WHOLE = float(os.environ.get("ROSY_TEST_SHARE", "0.1")) >= 1
"""Whether all cases are run."""

SEED = int(os.environ.get("ROSY_TEST_SEED", "1"))
"""Changes daily; printed by ``./rosy test``."""


def rotated(rows: Sequence[Row], parts: int, *, seed: int = SEED, whole: bool = WHOLE) -> list[Row]:
    """All rows, or every ``parts``-th: the next ones with the next seed, so that each row has its turn."""
    return [row for number, row in enumerate(rows) if whole or (number + seed) % parts == 0]


TESTS = "sim-service/tests"

DAYS = 13
"""
Days in which each test that takes turns is run once. Prime: each row of a table with fewer parts meets the day of its
test.
"""


@dataclass(frozen=True)
class Day:
    """Part of a run that decides which of the tests that take turns are run."""

    seed: int
    whole: bool
    changed: frozenset[str] = frozenset()
    """Names of files, from the root of the repository, that differ from what has passed."""

    def share(self, tests: Iterable[tuple[str, str]]) -> set[str]:
        """
        Those of the tests (name, file) that are run: one in thirteen by their order, those of changed files, and those
        of the folders and files that are named like a changed package or module. Those in ``system`` are about the
        language and its programs, those in ``ownership`` and ``recordings`` also about the robot process.
        """
        ordered = sorted(tests)
        sources = [name for name in self.changed if name.startswith("sim-service/rosy_sim/")]
        packages = {name.split("/")[2].removesuffix(".py") for name in sources}
        if any(name.startswith(("docs/", "examples/", "rosy-hs/src/")) for name in self.changed):
            packages.add("system")
        if any(name.startswith("rosy-hs/robots/") for name in self.changed):
            packages |= {"ownership", "recordings"}
        return {
            name
            for number, (name, file) in enumerate(ordered)
            if self.whole
            or (number + self.seed) % DAYS == 0
            or file in self.changed
            or any(file.startswith((f"{TESTS}/{package}/", f"{TESTS}/test_{package}.py")) for package in packages)
        }


TODAY = Day(
    SEED,
    # Without a daily seed tests are started by hand: all that are named are run.
    WHOLE or "ROSY_TEST_SEED" not in os.environ,
    frozenset(os.environ.get("ROSY_TEST_CHANGED", "").splitlines()),
)
