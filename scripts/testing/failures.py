"""
Names and first messages of failed tests, read from the output or the JSON report of a suite.

They are printed after the table of all suites, because the end of a long output is what is read first and kept longest.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

__all__ = ["failed_tests"]

_COLOURS = re.compile(r"\x1b\[[0-9;]*m")
# What pytest-xdist says of a test whose process has ended; why stands where the process wrote it (faulthandler's first line).
_CRASHED = "worker 'gw"
_CAUSE = re.compile(r"^(Timeout \([\d:.]+\)|Fatal Python error: .*)", re.M)
# What Playwright and vitest show of the source below a message: lines with their numbers.
_SOURCE = re.compile(r"^\s*(?:>\s*)?\d+ \|.*$|^\s*\|\s*\^.*$", re.M)
# Characters that are kept of the beginning and of the end of a message: a story's end says what it waited for. The whole stands in the suite's output.
_BEGINNING, _END = 300, 700


def failed_tests(output: str, report: Path | None) -> list[str]:
    """One line for each failed test, with its message as far as it is known; empty if the suite names none."""
    if report is not None and report.exists():
        written = json.loads(report.read_text())
        found = list(_vitest(written)) if "testResults" in written else list(_playwright(written.get("suites", []), ()))
    else:
        plain = _COLOURS.sub("", output)
        found = re.findall(r"^(?:FAILED|ERROR) (\S.*)$", plain, re.M)
        found = [f"{line} ({cause})" if _CRASHED in line and (cause := _causes(plain)) else line for line in found]
        found += _tasty(plain)
    return [_one_line(name) for name in found]


def _causes(output: str) -> str:
    """Why processes of the tests have ended, each cause once."""
    return "; ".join(dict.fromkeys(_CAUSE.findall(output)))


def _vitest(report: dict[str, Any]) -> Iterator[str]:
    for file in report["testResults"]:
        failed = [test for test in file["assertionResults"] if test["status"] == "failed"]
        for test in failed:
            yield f"{test['fullName']}: {' '.join(test.get('failureMessages', []))}"
        if file["status"] == "failed" and not failed:
            yield f"{Path(file['name']).name}: {file.get('message', '')}"


def _playwright(suites: list[dict[str, Any]], above: tuple[str, ...]) -> Iterator[str]:
    """Stories that failed, or passed only on a retry."""
    for suite in suites:
        names = (*above, suite["title"]) if suite["title"] else above
        for story in suite.get("specs", []):
            for test in story["tests"]:
                if test["status"] in ("unexpected", "flaky"):
                    errors = [error["message"] for result in test["results"] for error in result.get("errors", []) if "message" in error]
                    yield f"{' > '.join((*names, story['title']))}: {' '.join(errors)}"
        yield from _playwright(suite.get("suites", []), names)


def _tasty(output: str) -> Iterator[str]:
    """Tests that failed, with the lines below them that are further to the right."""
    for failed in re.finditer(r"^([ \t]+)(\S.*?):[ \t]+FAIL(?: \(.*\))?$((?:\n\1[ \t]+\S.*)*)", output, re.M):
        message = failed[3].split("Use -p ")[0].strip()
        yield f"{failed[2]}: {message}" if message else failed[2]


def _one_line(text: str) -> str:
    line = " ".join(_SOURCE.sub("", _COLOURS.sub("", text)).split())
    return line if len(line) <= _BEGINNING + _END else f"{line[:_BEGINNING]} … {line[-_END:]}"
