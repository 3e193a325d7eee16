"""
Choice of `./rosy test quick [BASE]`: the tests that depend on what changed since BASE, and those of safety in any case.

In: changed paths. Out: the suites with their commands narrowed, and sentences that name what was left out. Within a language the import graph
decides: Vitest's and Playwright's own, and for Python that of `python_imports`. What crosses languages stands in
`CROSSINGS`: a change of a folder there runs the suites behind it whole. It is never the proof that a commit is right.
"""

from __future__ import annotations

import subprocess
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from python_imports import dependents

from .scheduler import Suite

__all__ = ["Choice", "changed_since", "choose", "merge_base"]

CROSSINGS = {
    "protocol/": {"codegen", "editor", "python", "haskell"},
    "languages/": {"codegen", "editor", "python", "scripts"},
    "examples/": {"codegen", "editor", "python"},
    "docs/": {"editor", "python"},
    "rosy-hs/src/": {"codegen", "python", "haskell"},
    "rosy-hs/worker/": {"python", "haskell"},
    "rosy-hs/robots/": {"python", "haskell"},
    "rosy-hs/": {"haskell"},
    "rosy.cabal": {"haskell"},
    "codegen/src/": {"editor"},
    "scripts/": {"scripts"},
    "rosy": {"scripts"},
    "sim-service/rosy_sim/bench/": {"bench"},
    "e2e-tests/browsers/": {"browsers"},
}
"""Suites that run whole after a change below a folder: the compiler's answers, built programs and data cross languages."""

SAFE_PYTHON = (
    "sim-service/tests/system/test_attacks.py",
    "sim-service/tests/ownership",
    "sim-service/tests/classroom/test_class_kills.py",
    "sim-service/tests/test_atomic_file.py",
)
"""The sandbox, robots that must stop, and data that must not be lost."""

SAFE_STORIES = ("safety", "leaving", "my-programs")

STORIES_OF_THE_PAGE = ("first-minute", "first-hour")
"""Played after any change of the page or of the service, which are in every story."""


@dataclass(frozen=True)
class Choice:
    suites: Sequence[Suite]
    left_out: Sequence[str]
    """What was not run, a line each."""


def merge_base(root: Path) -> str:
    """Where this branch left main; the last commit where there is no main."""
    found = _git(root, "merge-base", "HEAD", "main")
    return found.strip() if found else "HEAD"


def changed_since(root: Path, base: str) -> Sequence[str]:
    """Committed, uncommitted and new files that differ from a commit. Raises ValueError where git does not know it."""
    changed = _git(root, "diff", "--name-only", "-z", base, "--")
    if changed is None:
        raise ValueError(base)
    new = _git(root, "ls-files", "--others", "--exclude-standard", "-z") or ""
    return sorted({path for path in (changed + new).split("\0") if path})


def choose(suites: Sequence[Suite], root: Path, changed: Sequence[str]) -> Choice:
    """Narrows each suite to what depends on the changed files."""
    whole = {suite for folder, names in CROSSINGS.items() if any(_is_below(path, folder) for path in changed) for suite in names}
    chosen: list[Suite] = []
    left_out: list[str] = []
    for suite in suites:
        if suite.name in whole or suite.name in {"build-hs"} or (suite.background and suite.name not in {"codegen", "scripts"}):
            chosen.append(suite)
        elif (narrowed := _narrowed(suite, root, changed)) is not None:
            chosen.append(narrowed)
            left_out.append(f"{suite.name}: all that does not depend on the change")
        else:
            left_out.append(f"{suite.name}: all of it")
    return Choice(chosen, left_out)


def _narrowed(suite: Suite, root: Path, changed: Sequence[str]) -> Suite | None:
    if suite.name in {"codegen", "editor"}:
        own = [str(root / path) for path in changed if path.startswith(f"{suite.name}/") and path.endswith((".ts", ".tsx"))]
        related = [word if word != "run" else "related" for word in suite.command]
        return replace(suite, command=[*related, "--run", "--passWithNoTests", *own]) if own else None
    if suite.name == "python":
        return replace(suite, command=[*(word for word in suite.command if word != "sim-service"), *_python_tests(root, changed)])
    if suite.name == "e2e":
        page = any(path.startswith(("editor/", "codegen/src/", "sim-service/rosy_sim/")) for path in changed)
        own = [Path(path).name for path in changed if path.startswith("e2e-tests/stories/") and path.endswith(".spec.ts")]
        names = [f"/{name}.spec" for name in (*SAFE_STORIES, *(STORIES_OF_THE_PAGE if page else ()))]
        return replace(suite, command=[*suite.command, *names, *own])
    return None


def _python_tests(root: Path, changed: Sequence[str]) -> list[str]:
    """Test files that import a changed module, directly or not, and those of safety."""
    touched = dependents(root / "sim-service", {path.removeprefix("sim-service/") for path in changed if path.startswith("sim-service/")})
    files = sorted(f"sim-service/{path}" for path in touched if Path(path).name.startswith("test_"))
    return [*SAFE_PYTHON, *(file for file in files if not file.startswith(SAFE_PYTHON))]


def _is_below(path: str, folder: str) -> bool:
    return path.startswith(folder) if folder.endswith("/") else path == folder


def _git(root: Path, *arguments: str) -> str | None:
    try:
        done = subprocess.run(["git", *arguments], cwd=root, capture_output=True, text=True, check=False)
    except OSError:
        return None
    return done.stdout if done.returncode == 0 else None
