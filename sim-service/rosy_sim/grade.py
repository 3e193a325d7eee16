"""
Many programs, one table: ``./rosy run FOLDER`` or several files, as many at once as there are cores.

A run here is the same command that one file gets, in a process of its own, so one program cannot disturb another.
For teachers: with a world that has goals, the table says who reached them.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from .errors import BadInput

__all__ = ["Grade", "grade", "programs_in", "table"]

_WORDS = {0: "well", 1: "not compiled", 2: "failed", 3: "goal missed"}


@dataclass(frozen=True, slots=True)
class Grade:
    """How one program did; ``remark`` is its first problem or its open goal."""

    name: str
    status: int
    time: float
    goals: tuple[int, int]
    remark: str


def programs_in(paths: Sequence[Path]) -> list[Path]:
    """
    The programs among files and folders; a folder counts with all below it.

    Raises:
        BadInput: there are none.
    """
    found: list[Path] = []
    for path in paths:
        if path.is_dir():
            found += sorted(p for p in path.rglob("*") if p.suffix in (".rosy", ".hs") and p.is_file())
        else:
            found.append(path)
    # A project and the Haskell printed beside it are one program.
    projects = {p.parent for p in found if p.suffix == ".rosy"}
    kept = [p for p in found if not (p.name == "Main.hs" and p.parent in projects)]
    if not kept:
        raise BadInput(f"There are no programs in {', '.join(map(str, paths))}.")
    return kept


def grade(files: Sequence[Path], options: Sequence[str]) -> list[Grade]:
    """Run each file with the same options."""
    with ThreadPoolExecutor(max_workers=os.cpu_count() or 2) as pool:
        return list(pool.map(lambda file: _one(file, options), files))


def _one(file: Path, options: Sequence[str]) -> Grade:
    done = subprocess.run(
        [sys.executable, "-m", "rosy_sim", "run", str(file), *options], capture_output=True, text=True, check=False
    )
    last: dict[str, object] = {}
    if lines := done.stdout.splitlines():
        last = json.loads(lines[-1])
    goals = last.get("goals", [])
    assert isinstance(goals, list)
    missed = [goal["title"] for goal in goals if goal["state"] != "done"]
    # The row names the file already.
    problem = done.stderr.splitlines()[0].removeprefix("rosy: ") if done.stderr else ""
    problem = problem.removeprefix(f"{file} ").removeprefix(f"{file}:").strip()
    time = last.get("time", 0.0)
    assert isinstance(time, float)
    return Grade(str(file), done.returncode, time, (len(goals) - len(missed), len(goals)), problem or "; ".join(missed))


def table(grades: Sequence[Grade]) -> str:
    """The table, and a last line that counts."""
    width = max(len(grade.name) for grade in grades)
    rows = [f"{'program':<{width}}  {'went':<12}  {'goals':>5}  {'time':>8}"]
    for g in grades:
        goals = f"{g.goals[0]}/{g.goals[1]}" if g.goals[1] else "-"
        row = f"{g.name:<{width}}  {_WORDS.get(g.status, 'failed'):<12}  {goals:>5}  {g.time:>6.2f} s"
        rows.append(f"{row}  {g.remark}".rstrip())
    well = sum(g.status == 0 for g in grades)
    return "\n".join([*rows, f"{well} of {len(grades)} went well."])
