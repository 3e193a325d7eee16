"""
Extent and seed of long tests: ``./rosy test`` runs a share that changes daily, ``./rosy test nightly`` all of it.

``ROSY_TEST_SEED=17 ./rosy test python`` repeats the choice of a run.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import TypeVar

__all__ = ["SEED", "WHOLE", "rotated"]

Row = TypeVar("Row")

WHOLE = float(os.environ.get("ROSY_TEST_SHARE", "0.1")) >= 1
"""Whether all cases are run."""

SEED = int(os.environ.get("ROSY_TEST_SEED", "1"))
"""Changes daily; printed by ``./rosy test``."""


def rotated(rows: Sequence[Row], parts: int, *, seed: int = SEED, whole: bool = WHOLE) -> list[Row]:
    """All rows, or every ``parts``-th: the next ones with the next seed, so that each row has its turn."""
    return [row for number, row in enumerate(rows) if whole or (number + seed) % parts == 0]
