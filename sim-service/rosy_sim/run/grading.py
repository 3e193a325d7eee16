"""
Grading of many programs as a table: ``./rosy run FOLDER`` or several files, as many at once as there are cores.

Each program runs as by the command for one file, in a process of its own, so that no program affects another. With a
world that has goals, the table shows which were reached.
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

from ..errors import BadInput
from ..interruptible import results
from ..sentences.sentence import tr, verbatim
from ..sentences.terminal_text import neutralize_line
from ..sentences.wording import in_terminal
from ..worker.launcher import sandbox_warning

__all__ = ["Grade", "format_table", "grade_programs", "programs_in"]

_OUTCOMES = {0: tr("well"), 1: tr("not compiled"), 3: tr("goal missed")}
_FAILED = tr("failed")


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
        raise BadInput(tr("There are no programs in {names}.", names=list(map(str, paths))))
    return kept


def grade_programs(files: Sequence[Path], options: Sequence[str]) -> list[Grade]:
    """Run each file with the same options."""
    with ThreadPoolExecutor(max_workers=os.cpu_count() or 2) as pool:
        return list(results([pool.submit(_one, file, options) for file in files]))


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
    warning = "rosy: " + in_terminal(sandbox_warning(verbatim("\0"))).partition("\0")[0]
    # The row names the file already.
    problems = [line for line in done.stderr.splitlines() if not line.startswith(warning)]
    problem = problems[0].removeprefix("rosy: ") if problems else ""
    problem = problem.removeprefix(f"{file} ").removeprefix(f"{file}:").strip()
    time = last.get("time", 0.0)
    assert isinstance(time, float)
    remark = neutralize_line(problem or "; ".join(missed))
    return Grade(neutralize_line(str(file)), done.returncode, time, (len(goals) - len(missed), len(goals)), remark)


def format_table(grades: Sequence[Grade]) -> str:
    """The table, and a last line that counts."""
    width = max(len(grade_programs.name) for grade_programs in grades)
    outcomes = [in_terminal(_OUTCOMES.get(g.status, _FAILED)) for g in grades]
    head = [in_terminal(title) for title in (tr("program"), tr("went"), tr("goals"), tr("time"))]
    width = max(width, len(head[0]))
    how = max(12, *map(len, outcomes))
    of = max(5, len(head[2]))
    rows = [f"{head[0]:<{width}}  {head[1]:<{how}}  {head[2]:>{of}}  {head[3]:>8}"]
    for g, outcome in zip(grades, outcomes, strict=True):
        goals = f"{g.goals[0]}/{g.goals[1]}" if g.goals[1] else "-"
        row = f"{g.name:<{width}}  {outcome:<{how}}  {goals:>{of}}  {g.time:>6.2f} s"
        rows.append(f"{row}  {g.remark}".rstrip())
    well = sum(g.status == 0 for g in grades)
    last = in_terminal(tr("{well} of {all} went well.", well=well, all=len(grades)))
    return "\n".join([*rows, last])
