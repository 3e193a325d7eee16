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
from ..sentences.alphabetical_order import SortKey, sort_key
from ..sentences.sentence import tr, verbatim
from ..sentences.terminal_text import neutralize_line
from ..sentences.wording import in_terminal, machine_wording
from ..text_lines import text_lines
from ..worker.launcher import sandbox_warning

__all__ = ["Grade", "csv_rows", "format_table", "grade_programs", "programs_in", "short_names"]

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
    The programs among files and folders; a folder counts with all below it but hidden files, as the page's
    ``editor/src/browser/program_collection.ts``. A link to nothing is a program that cannot be read.

    Raises:
        BadInput: there are none.
    """
    found: list[Path] = []
    for path in paths:
        # `Path.is_dir` raises an error for a name that is too long.
        if os.path.isdir(path):
            inside = (p.relative_to(path) for p in path.rglob("*") if not p.is_dir())
            found += [path / name for name in sorted(filter(_is_program, inside), key=_order)]
        else:
            found.append(path)
    # A project and the Haskell printed beside it are one program.
    projects = {p.parent for p in found if p.suffix.lower() == ".rosy"}
    kept = [p for p in found if not (p.name == "Main.hs" and p.parent in projects)]
    if not kept:
        raise BadInput(tr("There are no programs in {names}.", names=list(map(str, paths))))
    return kept


def _order(path: Path) -> list[SortKey]:
    language = machine_wording().language
    # Without its ending, so that Ada comes before Ada 2.
    return [sort_key(part, language) for part in (*path.parent.parts, path.stem, path.suffix)]


def short_names(files: Sequence[Path]) -> list[str]:
    """The names of files below the folder that has all of them."""
    folder = os.path.commonpath([file.absolute().parent for file in files])
    return [os.path.relpath(file.absolute(), folder) for file in files]


def _is_program(path: Path) -> bool:
    # macOS keeps a hidden copy of properties beside each file: ._name in an archive, or below __MACOSX.
    is_hidden = any(part.startswith(".") or part == "__MACOSX" for part in path.parts)
    return path.suffix.lower() in (".rosy", ".hs", ".lhs") and not is_hidden


def grade_programs(files: Sequence[Path], options: Sequence[str]) -> list[Grade]:
    """Run each file with the same options."""
    with ThreadPoolExecutor(max_workers=os.cpu_count() or 2) as pool:
        named = zip(short_names(files), files, strict=True)
        return list(results([pool.submit(_one, name, file, options) for name, file in named]))


def _one(name: str, file: Path, options: Sequence[str]) -> Grade:
    done = subprocess.run(
        [sys.executable, "-m", "rosy_sim", "run", str(file), *options], capture_output=True, text=True, check=False
    )
    last: dict[str, object] = {}
    if lines := text_lines(done.stdout):
        last = json.loads(lines[-1])
    goals = last.get("goals", [])
    assert isinstance(goals, list)
    missed = [goal["title"] for goal in goals if goal["state"] != "done"]
    warning = "rosy: " + in_terminal(sandbox_warning(verbatim("\0"))).partition("\0")[0]
    # The row names the file already.
    problems = [line for line in text_lines(done.stderr) if not line.startswith(warning)]
    problem = problems[0].removeprefix("rosy: ") if problems else ""
    problem = problem.removeprefix(f"{file} ").removeprefix(f"{file}:").strip()
    time = last.get("time", 0.0)
    assert isinstance(time, float)
    remark = neutralize_line(problem or "; ".join(missed))
    return Grade(neutralize_line(name), done.returncode, time, (len(goals) - len(missed), len(goals)), remark)


def format_table(grades: Sequence[Grade]) -> str:
    """The table, and a last line that counts where there are several programs."""
    head = [in_terminal(title) for title in (tr("program"), tr("went"), tr("goals"), tr("time"))]
    went = [_went(g) for g in grades]
    width = max(len(head[0]), *(len(g.name) for g in grades))
    how = max(12, *map(len, went))
    of = max(5, len(head[2]))
    rows = [f"{head[0]:<{width}}  {head[1]:<{how}}  {head[2]:>{of}}  {head[3]:>8}"]
    for g, outcome in zip(grades, went, strict=True):
        goals = f"{g.goals[0]}/{g.goals[1]}" if g.goals[1] else "-"
        row = f"{g.name:<{width}}  {outcome:<{how}}  {goals:>{of}}  {g.time:>6.2f} s"
        rows.append(f"{row}  {g.remark}".rstrip())
    if len(grades) > 1:
        well = sum(g.status == 0 for g in grades)
        rows.append(in_terminal(tr("{well} of {all} went well.", well=well, all=len(grades))))
    return "\n".join(rows)


def csv_rows(grades: Sequence[Grade]) -> list[list[str]]:
    """The table for a spreadsheet, which would take 1/2 for a day."""
    titles = (tr("program"), tr("went"), tr("goals reached"), tr("goals"), tr("time"), tr("remark"))
    head = [in_terminal(title) for title in titles]
    return [head, *([g.name, _went(g), *map(str, g.goals), f"{g.time:.2f} s", g.remark] for g in grades)]


def _went(grade: Grade) -> str:
    return in_terminal(_OUTCOMES.get(grade.status, _FAILED))
