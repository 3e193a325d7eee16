"""
All suites of the repository: static checks, unit tests and browser stories, in the order in which they should start.

Suites with browsers, robots and limits of time share the cores. What only computes runs in the background all the while, one suite at a time. `cores` is
what a suite keeps busy, not what it may use.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from .counts import by_exit, json_report, own_script, pytest_summary, tasty_summary
from .scheduler import Suite

__all__ = ["suites"]

PYTHON = sys.executable
SHELL_SCRIPTS = [
    "rosy",
    "scripts/lib/setup.sh",
    "scripts/lib/steps.sh",
    "scripts/lib/preflight.sh",
    "scripts/lib/installed.sh",
    "scripts/fix",
    "scripts/lock",
    ".ci/run",
]

# Limits (s), many times what a test and a suite take: they end what waits for ever, and name it. Nightly runs have none.
TEST_LIMIT = 900
SUITE_LIMIT = 4800

# The Haskell benchmarks, which no other suite compiles; each is a program of its own.
TYPES_OF_BENCHMARKS = """for program in Main Bytecode; do
  ghc -v0 -fno-code -dynamic -package-db "dist-newstyle/packagedb/ghc-$(ghc --numeric-version)" -irosy-hs/bench "rosy-hs/bench/$program.hs" || exit
done"""


def suites(reports: Path, nightly: bool = False) -> Sequence[Suite]:
    """All suites; nightly ones have no limits of time."""

    def vitest(name: str, background: bool = False) -> Suite:
        report = reports / f"{name}.json"
        reporters = ["--reporter=default", "--reporter=json", f"--outputFile.json={report}"]
        # With CI a snapshot that is not committed fails; without, Vitest writes it and passes.
        command = ["env", "CI=1", "npx", "vitest", "run", *reporters, "--root", name]
        return Suite(name, command, json_report(report), report=report, background=background)

    def check(name: str, *command: str) -> Suite:
        return Suite(name, command, by_exit, prints=False, background=True)

    def style(name: str, *words: str) -> Suite:
        return check(name, PYTHON, "scripts/haskell_style.py", *words)

    stories = reports / "e2e.json"
    short = reports / "browsers.json"
    # pytest then ends the process with the stacks of all its threads, and pytest-xdist names the test and goes on with the others.
    hangs = [] if nightly else ["-o", f"faulthandler_timeout={TEST_LIMIT}", "-o", "faulthandler_exit_on_timeout=true"]
    built = frozenset({"build-hs"})
    listed = [
        # First and not in the background: after `start` it also links the worker and the robot program again, which other suites run.
        replace(check("build-hs", PYTHON, "scripts/testing/haskell.py", "build"), background=False),
        # Stories and Python tests wait for simulated robots and for limits of time during about half of their time, so they have more
        # processes than cores. No other suite runs beside both: stories take more than one core, and a drag needs processor time.
        Suite("e2e", ["npx", "playwright", "test", "-c", "e2e-tests"], json_report(stories), report=stories, after=built),
        Suite(
            "python",
            [PYTHON, "-m", "pytest", "sim-service", "-rfEs", "--durations=60", "-n", "4", "--dist", "worksteal", *hangs],
            pytest_summary,
            cores=0.5,
            after=built,
        ),
        # Builds what is not built, so that the suite can also be run alone.
        Suite("haskell", [PYTHON, "scripts/testing/haskell.py"], tasty_summary, cores=0.5, after=built),
        # A finger that rests opens a menu, so a drag by touch needs a machine that is not fully busy.
        Suite(
            "browsers",
            ["npx", "playwright", "test", "-c", "e2e-tests/browsers"],
            json_report(short),
            report=short,
            after=frozenset({"e2e"}),
        ),
        # Only so that those before it start first.
        replace(vitest("editor"), after=built),
        # Beside what is left of the stories, in place of the Python tests: it waits for about half of its time, and none of its times is judged.
        Suite("bench", [PYTHON, "scripts/bench.py", "--small"], own_script, cores=0.5, after=frozenset({"haskell", "python"})),
        replace(vitest("codegen", background=True), after=built),
        # Not before the suite above, which takes longer.
        Suite("scripts", [PYTHON, "-m", "pytest", "-q", "-rfEs", "scripts/tests"], pytest_summary, prints=False, background=True, after=built),
        check("types-py", PYTHON, "-m", "mypy", "--config-file", "sim-service/pyproject.toml", "sim-service/rosy_sim", "sim-service/tests"),
        # All that may use the names of a browser is one program: as four, the compiler read the sources of codegen and of the page four times.
        check("types-ts", "npx", "tsc", "-b", "codegen", "tsconfig.check.json"),
        # The build may still change the library.
        replace(check("types-bench", "bash", "-c", TYPES_OF_BENCHMARKS), after=built),
        # The versions of Debian 12.
        style("lint-hs", "hlint", "3.3"),
        style("format-hs", "ormolu", "0.3", "--mode", "check"),
        check("format-ts", "npx", "biome", "check", "."),
        check("format-py", PYTHON, "-m", "ruff", "format", "--check", "sim-service", "scripts"),
        check("lint-py", PYTHON, "-m", "ruff", "check", "sim-service", "scripts"),
        check("shell", "shellcheck", "-x", *SHELL_SCRIPTS),
        Suite("borders", [PYTHON, "scripts/borders.py"], own_script, prints=False, background=True),
    ]
    return [replace(suite, limit=math.inf if nightly else SUITE_LIMIT) for suite in listed]
