"""
Test runner: every check and test of the repository, several suites at once, and one line that counts them.

In: suite names (none: all); `quick [BASE]` for what depends on the changes since BASE (default: the merge base with main) and what is about safety;
`nightly` for more random cases from a new seed; `names` for the names of all tests. Out: the output of each suite in one block when it
ends, a table, the failed and the skipped tests with their reasons, and `N passed, M failed, K skipped` as the last line. Exit 0 if nothing failed.
The same commit runs the same tests on each day and machine.
"""

from __future__ import annotations

import os
import subprocess
import sys
import time
from collections.abc import Sequence
from pathlib import Path

from testing.counts import Count
from testing.failures import failed_tests
from testing.names import listed_tests
from testing.quick import changed_since, choose, merge_base
from testing.scheduler import Result, run_all
from testing.suites import suites

ROOT = Path(__file__).resolve().parent.parent
STATE = ROOT / ".rosy"


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


def environment(nightly: bool) -> dict[str, str]:
    """Environment of the suites. Random tests have seed 1 by themselves; nightly ones draw more cases from the seed that stands here."""
    more = {"ROSY_TEST_NIGHTLY": "1", "ROSY_TEST_SEED": str(int(time.time()) % 2**31)} if nightly else {}
    return {
        **more,
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


def skips(results: Sequence[Result]) -> list[str]:
    """Each skipped test with its reason; a suite that gives none says how many."""
    lines: list[str] = []
    for result in results:
        if result.count.skipped:
            reasons = result.count.reasons or (f"{result.count.skipped} tests, without a reason",)
            lines += [f"  {result.suite.name}: {reason}" for reason in reasons]
    return ["\n  Skipped:", *lines] if lines else []


def main() -> int:
    words = sys.argv[1:]
    mode = words.pop(0) if words[:1] in (["quick"], ["nightly"], ["names"]) else ""
    known = suites(STATE / "reports", mode == "nightly")
    names = [suite.name for suite in known]
    left_out: Sequence[str] = ()
    if mode == "names":
        try:
            print("\n".join(listed_tests(ROOT, known)))
        except subprocess.CalledProcessError as error:
            print(f"{error.output or ''}{error.stderr or ''}\nrosy test: the tests cannot be listed, since `{' '.join(error.cmd)}` failed.", file=sys.stderr)
            return 1
        return 0
    if mode == "quick":
        base = words[0] if words else merge_base(ROOT)
        try:
            changed = changed_since(ROOT, base)
        except ValueError:
            print(f"rosy test: git knows no commit '{base}'. `git log` lists them.", file=sys.stderr)
            return 1
        known, left_out = (choice := choose(known, ROOT, changed)).suites, choice.left_out
        words = []
    unknown = sorted(set(words) - set(names))
    if unknown:
        print(f"rosy test: no suite is called {', '.join(unknown)}. There are: {', '.join(names)}.", file=sys.stderr)
        return 1
    logs = STATE / "log"
    logs.mkdir(parents=True, exist_ok=True)
    env = environment(mode == "nightly")
    screen = Screen()
    results: list[Result] = []

    def ended(result: Result) -> None:
        results.append(result)
        screen.ended(result)

    began = time.monotonic()
    cores = int(env.get("ROSY_TEST_CORES", len(os.sched_getaffinity(0))))
    try:
        run_all([s for s in known if not words or s.name in words], cores, ROOT, logs, env, screen.progress, ended)
    except KeyboardInterrupt:
        return 130
    results.sort(key=lambda r: names.index(r.suite.name))
    print()
    for result in results:
        print(row(result))
    for line in [*failures(results), *skips(results)]:
        print(line)
    minutes, computing = (time.monotonic() - began) / 60, sum(result.computing for result in results) / 60
    print(f"\n  {minutes:.1f} minutes on {cores} cores, {computing:.1f} minutes of computing")
    if mode == "nightly":
        print(f"  Seed of the random tests: ROSY_TEST_SEED={env['ROSY_TEST_SEED']}")
    if left_out:
        print("\n  Not complete. Left out, for `./rosy test` runs it:", *(f"    {line}" for line in left_out), sep="\n")
    total = sum((result.count for result in results), Count(0, 0))
    print(f"\n{total}")
    return 1 if total.failed else 0


if __name__ == "__main__":
    sys.exit(main())
