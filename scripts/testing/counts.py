"""
Test counts and reasons of skipped tests, read from the output or the JSON report of a suite.

Each reader takes the suite's whole output and its exit status and returns passed, failed and skipped. A suite that ends
with an error status without naming a failure counts as one failure. A test that passed only on a retry has failed.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

__all__ = ["OTHER_VERSION", "Count", "Reader", "by_exit", "json_report", "own_script", "pytest_summary", "tasty_summary"]

OTHER_VERSION = 78
"""Exit status of a check whose tool has another version than its sources follow; its last line says which. `EX_CONFIG` of sysexits.h."""


@dataclass(frozen=True)
class Count:
    passed: int
    failed: int
    skipped: int = 0
    reasons: tuple[str, ...] = ()
    """Why tests were skipped: a line for one test or for several with the same reason."""

    def __add__(self, other: Count) -> Count:
        return Count(self.passed + other.passed, self.failed + other.failed, self.skipped + other.skipped, self.reasons + other.reasons)

    def __str__(self) -> str:
        return f"{self.passed} passed, {self.failed} failed, {self.skipped} skipped"


Reader = Callable[[str, int], Count]

_COLOURS = re.compile(r"\x1b\[[0-9;]*m")


def by_exit(output: str, status: int) -> Count:
    """A check that holds, does not, or says that its tool has another version."""
    if status == OTHER_VERSION:
        return Count(0, 0, 1, tuple(output.splitlines()[-1:]))
    return Count(1, 0) if status == 0 else Count(0, 1)


def own_script(output: str, status: int) -> Count:
    """The last `N passed, M failed` that a script of this repository prints."""
    found = re.findall(r"(\d+) passed, (\d+) failed(?:, (\d+) skipped)?", output)
    if not found:
        return by_exit(output, status or 1)
    passed, failed, skipped = found[-1]
    return _with_status(Count(int(passed), int(failed), int(skipped or 0)), status)


def pytest_summary(output: str, status: int) -> Count:
    """pytest's last line, such as `3 failed, 117 passed, 2 skipped in 12.3s`. What was deselected counts as skipped."""
    output = _COLOURS.sub("", output)
    lines = re.findall(r"^=*\s?(\d+ (?:passed|failed|skipped|deselected|xfailed|error).*?in [\d.:s ()]+)", output, re.M)
    if not lines:
        return by_exit(output, status or 1)
    number = {word.rstrip("s"): int(n) for n, word in re.findall(r"(\d+) (passed|failed|skipped|deselected|errors?|rerun)", lines[-1])}
    failed = number.get("failed", 0) + number.get("error", 0) + number.get("rerun", 0)
    reasons = [f"{where} (×{count}): {why}" for count, where, why in re.findall(r"^SKIPPED \[(\d+)\] (\S+?): (.*)$", output, re.M)]
    if "deselected" in number:
        reasons.append(f"{number['deselected']} deselected by hand")
    skipped = number.get("skipped", 0) + number.get("deselected", 0)
    return _with_status(Count(number.get("passed", 0), failed, skipped, tuple(reasons)), status)


def tasty_summary(output: str, status: int) -> Count:
    """The summaries of all tasty suites that one command ran. A test that passes with the words `skipped: …` was skipped."""
    passed = sum(int(n) for n in re.findall(r"All (\d+) tests? passed", output))
    failed = 0
    for bad, total in re.findall(r"(\d+) out of (\d+) tests? failed", output):
        failed += int(bad)
        passed += int(total) - int(bad)
    skips = re.findall(r"^\s+(\S.*?):\s+OK.*\n\s+skipped: (.*)$", _COLOURS.sub("", output), re.M)
    reasons = tuple(f"{name}: {why}" for name, why in skips)
    return _with_status(Count(passed - len(skips), failed, len(skips), reasons), status if passed else status or 1)


def json_report(path: Path) -> Reader:
    """The JSON report of Vitest or Playwright at `path`."""

    def read(output: str, status: int) -> Count:
        if not path.exists():
            return by_exit(output, status or 1)
        report = json.loads(path.read_text())
        if "numPassedTests" in report:
            left = [test["fullName"] for file in report["testResults"] for test in file["assertionResults"] if test["status"] in ("pending", "skipped", "todo")]
            skipped = report["numPendingTests"] + report.get("numTodoTests", 0)
            count = Count(report["numPassedTests"], report["numFailedTests"], skipped, tuple(f"{name}: what it needs is missing here" for name in left))
        else:
            stats = report["stats"]
            count = Count(stats["expected"], stats["unexpected"] + stats["flaky"], stats["skipped"], tuple(_skipped_stories(report.get("suites", []))))
        return _with_status(count, status)

    return read


def _skipped_stories(suites: list[dict[str, Any]]) -> Iterator[str]:
    for suite in suites:
        for story in suite.get("specs", []):
            for test in story["tests"]:
                if test["status"] == "skipped":
                    whys = [note["description"] for note in test.get("annotations", []) if note["type"] == "skip" and note.get("description")]
                    yield f"{story['title']}: {' '.join(dict.fromkeys(whys)) or 'no reason given'}"
        yield from _skipped_stories(suite.get("suites", []))


def _with_status(count: Count, status: int) -> Count:
    return Count(count.passed, 1, count.skipped, count.reasons) if status and not count.failed else count
