"""
Test runner: every check and test of the repository, several suites at once, and one line that counts them.

In: suite names (none: all), and `nightly` for all random tests at full length. Out: the output of each suite in one block
when it ends, a table, the failed tests, and `N passed, M failed` as the last line, followed by `, K skipped` when tests were skipped. Exit 0
if nothing failed. The seed of the random tests is printed; ROSY_TEST_SEED repeats a run. Tests that take turns by day also run while their file
differs from the last commit that passed all suites here, or from the commit in ROSY_TEST_BASE.
"""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Sequence
from pathlib import Path

from testing.changes import changed_since, record_commit, recorded_commit
from testing.counts import Count
from testing.failures import failed_tests
from testing.scheduler import Result, run_all
from testing.suites import suites
from tracked_files import haskell_sources

ROOT = Path(__file__).resolve().parent.parent
STATE = ROOT / ".rosy"
PASSED = STATE / "checked" / "commit"
"""The commit of the last run of all suites that passed."""
TAKING_TURNS = (
    "docs/",
    "rosy",
    "scripts/",
    "e2e-tests/",
    "examples/",
    "sim-service/",
    "codegen/src/",
    "codegen/test/",
    "editor/src/",
    "editor/test/",
)
"""Folders of the tests that take turns by day; Haskell sources do as well (`testing/changed_files.py`). The list of all that has
changed can be longer than an environment variable may be."""


class Screen:
    """Blocks of output, with a progress line below them while suites run."""

    def __init__(self) -> None:
        self._live = sys.stdout.isatty()
        self._began = time.monotonic()
        self._last: tuple[str, ...] = ()

    def progress(self, names: Sequence[str]) -> None:
        """On a terminal the line is rewritten in place; elsewhere it is printed when it changes."""
        if not self._live and tuple(names) == self._last:
            return
        if names:
            seconds = int(time.monotonic() - self._began)
            line = f"… {seconds // 60}:{seconds % 60:02} running: {', '.join(names)}"
            sys.stdout.write(f"\r\033[K{line}" if self._live else f"{line}\n")
            sys.stdout.flush()
        self._last = tuple(names)

    def ended(self, result: Result) -> None:
        if self._live:
            sys.stdout.write("\r\033[K")
        print(f"── {result.suite.name}: {result.count} ({result.seconds:.0f} s, {result.computing:.0f} s of computing)")
        if result.count.failed or result.suite.prints or not result.count.passed:
            sys.stdout.write(result.output.rstrip("\n") + "\n\n" if result.output.strip() else "")
        sys.stdout.flush()


def environment(arguments: Sequence[str]) -> dict[str, str]:
    """Environment of the suites. Random tests read ROSY_TEST_SEED and ROSY_TEST_SHARE (0.1: a tenth of the cases), tests that take turns ROSY_TEST_CHANGED."""
    nightly = "nightly" in arguments
    # The seed changes daily, so that a failure repeats until it is fixed and is the same on every machine; nightly runs draw a new one each time.
    seed = int(time.time()) if nightly else int(time.time()) // 86400
    haskell = set(haskell_sources(ROOT))
    base = os.environ.get("ROSY_TEST_BASE") or recorded_commit(PASSED)
    return {
        "ROSY_TEST_SEED": str(seed % 2**31),
        "ROSY_TEST_SHARE": "1" if nightly else "0.1",
        "ROSY_TEST_CHANGED": "\n".join(path for path in changed_since(ROOT, base) if path.startswith(TAKING_TURNS) or path in haskell),
        **os.environ,
        # Empty is off. Hundreds of tests start `rosy_sim`: with its compiled modules in `__pycache__` that takes half of the time.
        "PYTHONDONTWRITEBYTECODE": "",
        "ROSY_REPORTS": str(STATE / "reports"),
    }


def row(result: Result) -> str:
    """A line of the table: counts, wall-clock time, and processor time, which a busy machine changes least."""
    count = result.count
    skipped = f"{count.skipped:>5} skipped" if count.skipped else ""
    times = f"{result.seconds:>7.1f} s {result.computing:>7.1f} s of computing"
    return f"  {result.suite.name:<12} {count.passed:>6} passed {count.failed:>4} failed {times} {skipped}".rstrip()


def failures(results: Sequence[Result]) -> list[str]:
    """The names of all failed tests, for the end of the output; a suite that names none is named itself."""
    lines: list[str] = []
    for result in results:
        if result.count.failed:
            named = failed_tests(result.output, result.suite.report) or ["see its output above"]
            lines += [f"  {result.suite.name}: {name}" for name in named]
    return ["\n  Failed:", *lines] if lines else []


def main() -> int:
    known = suites(ROOT, STATE / "reports", "nightly" in sys.argv[1:])
    names = [suite.name for suite in known]
    wanted = [name for name in sys.argv[1:] if name != "nightly"] or names
    unknown = sorted(set(wanted) - set(names))
    if unknown:
        print(f"rosy test: no suite is called {', '.join(unknown)}. There are: {', '.join(names)}.", file=sys.stderr)
        return 1
    logs = STATE / "log"
    logs.mkdir(parents=True, exist_ok=True)
    env = environment(sys.argv[1:])
    screen = Screen()
    results: list[Result] = []

    def ended(result: Result) -> None:
        results.append(result)
        screen.ended(result)

    began = time.monotonic()
    cores = int(env.get("ROSY_TEST_CORES", len(os.sched_getaffinity(0))))
    try:
        run_all([s for s in known if s.name in wanted], cores, ROOT, logs, env, screen.progress, ended)
    except KeyboardInterrupt:
        return 130
    print()
    for result in sorted(results, key=lambda r: names.index(r.suite.name)):
        print(row(result))
    for line in failures(results):
        print(line)
    minutes, computing = (time.monotonic() - began) / 60, sum(result.computing for result in results) / 60
    print(f"\n  {minutes:.1f} minutes on {cores} cores, {computing:.1f} minutes of computing")
    print(f"  Seed of the random tests: ROSY_TEST_SEED={env['ROSY_TEST_SEED']}")
    total = sum((result.count for result in results), Count(0, 0))
    if not total.failed and len(results) == len(known):
        record_commit(ROOT, PASSED)
    print(f"\n{total}")
    return 1 if total.failed else 0


if __name__ == "__main__":
    sys.exit(main())
