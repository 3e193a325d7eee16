"""
Names of all tests, without running them: what two clones of one commit must agree on.

In: the suites. Out: sorted lines `suite: test`. pytest, Playwright, Vitest and tasty list their own tests; a check is named by its suite.
What lists the tests of Haskell is built first where it is not.
"""

from __future__ import annotations

import re
import subprocess
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path

from . import haskell
from .scheduler import Suite

__all__ = ["listed_tests"]


def listed_tests(root: Path, suites: Sequence[Suite], before: Sequence[str] = ()) -> list[str]:
    """`before` starts the tools, such as `faketime` with its words. Raises CalledProcessError where a tool cannot list its tests."""
    return sorted(f"{suite.name}: {name}" for suite in suites for name in _names(root, suite, before))


def _names(root: Path, suite: Suite, before: Sequence[str]) -> Iterator[str]:
    words = [*before, *suite.command]
    if "pytest" in words:
        yield from re.findall(
            r"^\S+::.*$", _said(root, [*words[: words.index("-n")], "--collect-only", "-q"] if "-n" in words else [*words, "--collect-only"]), re.M
        )
    elif "playwright" in words:
        yield from re.findall(r"^\s+(\S.*:\d+:\d+ › .*)$", _said(root, [*words, "--list", "--reporter=list"]), re.M)
    elif "vitest" in words:
        yield from filter(None, _said(root, [*before, "npx", "vitest", "list", "--root", suite.name]).splitlines())
    elif suite.name == "haskell":
        if status := haskell.build(sys.stderr):
            raise subprocess.CalledProcessError(status, ["cabal", "build"])
        programs = haskell.folder()
        for program in haskell.PROGRAMS:
            listed = _said(root, [*before, programs.format(kind="t", name=program), "--list-tests"], haskell.environment(programs))
            yield from (f"{program}: {name}" for name in listed.splitlines())
    else:
        yield suite.name


def _said(root: Path, command: Sequence[str], environment: dict[str, str] | None = None) -> str:
    return subprocess.run(command, cwd=root, env=environment, stdin=subprocess.DEVNULL, capture_output=True, text=True, check=True).stdout
