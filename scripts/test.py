"""
Everything CI runs, suite after suite, and one line that counts it all.

In: suite names (none: all of them). Out: each suite's own output while it runs, a table, and `N passed, M failed` as the
last line; exit 0 if nothing failed. A suite is a command plus a way to read its counts; a suite that dies without counting is one failure.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
STATE = ROOT / ".rosy"


@dataclass(frozen=True)
class Count:
    passed: int
    failed: int


Reader = Callable[[str, int], Count]


def by_exit(_output: str, code: int) -> Count:
    """A check that either holds or not."""
    return Count(1, 0) if code == 0 else Count(0, 1)


def plain(output: str, code: int) -> Count:
    """The last `N passed, M failed` of our own scripts."""
    found = re.findall(r"(\d+) passed, (\d+) failed", output)
    return Count(int(found[-1][0]), int(found[-1][1])) if found else by_exit(output, code or 1)


def pytest_count(output: str, code: int) -> Count:
    lines = re.findall(r"^=*\s?(\d+ (?:passed|failed|error).*?in [\d.:s ()]+)", output, re.M)
    if not lines:
        return by_exit(output, code or 1)
    number = {word: int(n) for n, word in re.findall(r"(\d+) (passed|failed|errors?)", lines[-1])}
    failed = number.get("failed", 0) + number.get("error", 0) + number.get("errors", 0)
    return Count(number.get("passed", 0), failed or (1 if code else 0))


def tasty(output: str, code: int) -> Count:
    passed = sum(int(n) for n in re.findall(r"All (\d+) tests? passed", output))
    failed = 0
    for bad, total in re.findall(r"(\d+) out of (\d+) tests? failed", output):
        failed += int(bad)
        passed += int(total) - int(bad)
    return Count(passed, failed or (1 if code or not passed else 0))


def json_report(path: Path) -> Reader:
    """Vitest's and Playwright's JSON reports."""

    def read(_output: str, code: int) -> Count:
        if not path.exists():
            return by_exit(_output, code or 1)
        report = json.loads(path.read_text())
        if "numPassedTests" in report:
            count = Count(report["numPassedTests"], report["numFailedTests"])
        else:
            count = Count(report["stats"]["expected"] + report["stats"]["flaky"], report["stats"]["unexpected"])
        return Count(count.passed, count.failed or (1 if code else 0))

    return read


@dataclass(frozen=True)
class Suite:
    name: str
    command: list[str]
    read: Reader
    report: Path | None = None


def reported(name: str, command: list[str]) -> Suite:
    """A suite that leaves a JSON report. Playwright's own settings say where; Vitest is told."""
    report = STATE / "reports" / f"{name}.json"
    where = [f"--outputFile.json={report}"] if "vitest" in command else []
    return Suite(name, [*command, *where], json_report(report), report)


def haskell_files() -> list[str]:
    listed = subprocess.run(
        ["git", "ls-files", "*.hs", ":!*/generated/*", ":!*/gallery/*", ":!*/pupils/*", ":!*/attacks/*", ":!examples/*", ":!codegen/corpus/*"],
        cwd=ROOT,
        capture_output=True,
        check=True,
        text=True,
    )
    return [f for f in listed.stdout.split() if (ROOT / f).exists()]


def suites() -> list[Suite]:
    python = sys.executable
    vitest = ["npx", "vitest", "run", "--reporter=default", "--reporter=json"]
    hs = haskell_files()
    return [
        Suite("shell", ["shellcheck", "rosy", "scripts/lib/setup.sh", "scripts/fix", ".ci/run"], by_exit),
        Suite("format-ts", ["npx", "biome", "check", "."], by_exit),
        Suite("types-ts", ["npx", "tsc", "-b", "codegen", "editor", "e2e-tests", "examples/teleop"], by_exit),
        Suite("format-py", [python, "-m", "ruff", "format", "--check", "sim-service", "scripts"], by_exit),
        Suite("lint-py", [python, "-m", "ruff", "check", "sim-service", "scripts"], by_exit),
        Suite("types-py", [python, "-m", "mypy", "--config-file", "sim-service/pyproject.toml", "sim-service/rosy_sim", "sim-service/tests"], by_exit),
        Suite("format-hs", ["ormolu", "--mode", "check", *hs], by_exit),
        Suite("lint-hs", ["hlint", *hs], by_exit),
        Suite("borders", [python, "scripts/borders.py"], plain),
        Suite("haskell", ["cabal", "test", "--offline", "-j2", "--test-show-details=direct", "all"], tasty),
        Suite("python", [python, "-m", "pytest", "sim-service"], pytest_count),
        reported("codegen", [*vitest, "--root", "codegen"]),
        reported("editor", [*vitest, "--root", "editor"]),
        reported("e2e", ["npx", "playwright", "test", "-c", "e2e-tests"]),
    ]  # fmt: skip


def run(suite: Suite) -> Count:
    if suite.report is not None:
        suite.report.parent.mkdir(parents=True, exist_ok=True)
        suite.report.unlink(missing_ok=True)
    log = STATE / "log" / f"test-{suite.name}.log"
    env = {**os.environ, "CI": os.environ.get("CI", ""), "PYTHONDONTWRITEBYTECODE": "1", "ROSY_REPORTS": str(STATE / "reports")}
    quiet = suite.read is by_exit
    with subprocess.Popen(suite.command, cwd=ROOT, env=env, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True) as process:
        assert process.stdout is not None
        lines: list[str] = []
        for line in process.stdout:
            lines.append(line)
            if not quiet:
                sys.stdout.write(line)
                sys.stdout.flush()
    output = "".join(lines)
    log.write_text(output)
    count = suite.read(output, process.returncode)
    if quiet and count.failed:
        sys.stdout.write(output)
    return count


def main() -> int:
    known = suites()
    wanted = sys.argv[1:] or [s.name for s in known]
    unknown = set(wanted) - {s.name for s in known}
    if unknown:
        print(f"rosy test: no suite is called {', '.join(sorted(unknown))}. There are: {', '.join(s.name for s in known)}.", file=sys.stderr)
        return 1
    table: list[tuple[str, Count, float]] = []
    for suite in known:
        if suite.name not in wanted:
            continue
        print(f"\n── {suite.name}", flush=True)
        began = time.monotonic()
        table.append((suite.name, run(suite), time.monotonic() - began))
    print()
    for name, count, seconds in table:
        print(f"  {name:<12} {count.passed:>6} passed {count.failed:>4} failed {seconds:>7.1f} s")
    passed, failed = sum(c.passed for _, c, _ in table), sum(c.failed for _, c, _ in table)
    print(f"\n{passed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
