"""
Files that have changed since all suites last passed, so that a test which takes turns is run when its own file has changed.

In: the working tree, and the commit recorded in `.rosy/checked/commit` or given by ROSY_TEST_BASE. Out: paths from the root of the repository. A
clone that has no record compares with its own last commit: what others have committed, they have tested.
"""

from __future__ import annotations

import subprocess
from collections.abc import Mapping, Sequence
from pathlib import Path

__all__ = ["changed_since", "packages_are_waiting", "record_commit", "recorded_commit"]

PACKAGE_SOURCES = ("scripts/installation/", "scripts/package.py", "scripts/tests/test_package.py", "sim-service/rosy_sim/config.py")
"""What decides, with the command itself, what a package holds and needs."""


def packages_are_waiting(environment: Mapping[str, str]) -> bool:
    """Whether the tests of packages are left out: they run one day in seven, nightly, by hand, and while what they test has changed."""
    seed = environment.get("ROSY_TEST_SEED")
    if seed is None or environment.get("ROSY_TEST_SHARE") == "1" or int(seed) % 7 == 0:
        return False
    changed = environment.get("ROSY_TEST_CHANGED", "").splitlines()
    return not any(name == "rosy" or name.startswith(PACKAGE_SOURCES) for name in changed)


def changed_since(root: Path, base: str | None) -> Sequence[str]:
    """Committed, uncommitted and new files; none where there is no git. A base that does not exist counts as none."""
    known = base is not None and _git(root, "cat-file", "-e", f"{base}^{{commit}}") is not None
    changed = _git(root, "diff", "--name-only", "-z", str(base) if known else "HEAD", "--")
    new = _git(root, "ls-files", "--others", "--exclude-standard", "-z")
    return sorted({path for output in (changed, new) if output is not None for path in output.split("\0") if path})


def recorded_commit(record: Path) -> str | None:
    """The commit of the last run of all suites that passed."""
    try:
        return record.read_text().strip() or None
    except OSError:
        return None


def record_commit(root: Path, record: Path) -> None:
    """Records the present commit. With uncommitted changes as well: those are compared with it on the next run."""
    head = _git(root, "rev-parse", "HEAD")
    if head is not None:
        record.parent.mkdir(parents=True, exist_ok=True)
        record.write_text(head)


def _git(root: Path, *arguments: str) -> str | None:
    try:
        done = subprocess.run(["git", *arguments], cwd=root, capture_output=True, text=True, check=False)
    except OSError:
        return None
    return done.stdout if done.returncode == 0 else None
