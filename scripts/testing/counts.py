"""
Test counts read from the output or the JSON report of a suite.

Each reader takes the suite's whole output and its exit status and returns passed, failed and skipped. A suite that ends
with an error status without naming a failure counts as one failure. A test that passed only on a retry has failed.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from .changed_files import LEFT_OUT

__all__ = ["Count", "Reader", "by_exit", "by_exit_or_left_out", "json_report", "own_script", "pytest_summary", "tasty_summary"]


@dataclass(frozen=True)
class Count:
    passed: int
    failed: int
    skipped: int = 0

    def __add__(self, other: Count) -> Count:
        return Count(self.passed + other.passed, self.failed + other.failed, self.skipped + other.skipped)

    def __str__(self) -> str:
        skipped = f", {self.skipped} skipped" if self.skipped else ""
        return f"{self.passed} passed, {self.failed} failed{skipped}"


Reader = Callable[[str, int], Count]


def by_exit(_output: str, status: int) -> Count:
    """A check that either holds or does not."""
    return Count(1, 0) if status == 0 else Count(0, 1)


def by_exit_or_left_out(output: str, status: int) -> Count:
    """A check that holds, does not, or says why it was left out."""
    return Count(0, 0, 1) if status == LEFT_OUT else by_exit(output, status)


def own_script(output: str, status: int) -> Count:
    """The last `N passed, M failed` that a script of this repository prints."""
    found = re.findall(r"(\d+) passed, (\d+) failed(?:, (\d+) skipped)?", output)
    if not found:
        return by_exit(output, status or 1)
    passed, failed, skipped = found[-1]
    return _with_status(Count(int(passed), int(failed), int(skipped or 0)), status)


def pytest_summary(output: str, status: int) -> Count:
    """pytest's last line, such as `3 failed, 117 passed, 2 skipped in 12.3s`."""
    lines = re.findall(r"^=*\s?(\d+ (?:passed|failed|skipped|deselected|xfailed|error).*?in [\d.:s ()]+)", output, re.M)
    if not lines:
        return by_exit(output, status or 1)
    number = {word.rstrip("s"): int(n) for n, word in re.findall(r"(\d+) (passed|failed|skipped|errors?|rerun)", lines[-1])}
    failed = number.get("failed", 0) + number.get("error", 0) + number.get("rerun", 0)
    return _with_status(Count(number.get("passed", 0), failed, number.get("skipped", 0)), status)


def tasty_summary(output: str, status: int) -> Count:
    """The summaries of all tasty suites that one `cabal test` ran."""
    passed = sum(int(n) for n in re.findall(r"All (\d+) tests? passed", output))
    failed = 0
    for bad, total in re.findall(r"(\d+) out of (\d+) tests? failed", output):
        failed += int(bad)
        passed += int(total) - int(bad)
    return _with_status(Count(passed, failed), status if passed else status or 1)


def json_report(path: Path) -> Reader:
    """The JSON report of Vitest or Playwright at `path`."""

    def read(output: str, status: int) -> Count:
        if not path.exists():
            return by_exit(output, status or 1)
        report = json.loads(path.read_text())
        if "numPassedTests" in report:
            skipped = report["numPendingTests"] + report.get("numTodoTests", 0)
            count = Count(report["numPassedTests"], report["numFailedTests"], skipped)
        else:
            stats = report["stats"]
            count = Count(stats["expected"], stats["unexpected"] + stats["flaky"], stats["skipped"])
        return _with_status(count, status)

    return read


def _with_status(count: Count, status: int) -> Count:
    return Count(count.passed, 1, count.skipped) if status and not count.failed else count
