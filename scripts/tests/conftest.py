"""
Makes the scripts importable as `./rosy test` runs them: from the scripts folder. The tests of packages take turns: one day in seven, nightly, each
day while what they test has changed, and by hand.
"""

import os
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

PACKAGED = ("rosy", "scripts/installation/", "scripts/package.py", "scripts/tests/test_package.py", "sim-service/rosy_sim/config.py")
"""What decides what a package holds and needs."""


def is_waiting(environment: dict[str, str]) -> bool:
    """Whether it is not the day of the tests of packages."""
    seed = environment.get("ROSY_TEST_SEED")
    if seed is None or environment.get("ROSY_TEST_SHARE") == "1":
        return False
    changed = environment.get("ROSY_TEST_CHANGED", "").splitlines()
    return int(seed) % 7 != 0 and not any(name == "rosy" or name.startswith(PACKAGED[1:]) for name in changed)


collect_ignore = ["test_package.py"] if is_waiting(dict(os.environ)) else []
