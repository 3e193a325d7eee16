"""
Haskell's idioms: Rosy's answer beside GHC's, and why they differ where they do.

``UPDATE_GOLDENS=1`` writes the table ``idioms.md``; a difference without a reason in ``idioms.py`` fails.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest

from rosy_sim.config import discover
from rosy_sim.worker.blocking_worker import BlockingWorker

from .idioms import IDIOMS, Idiom
from .real_runs import ran, worker_started

TABLE = Path(__file__).with_name("idioms.md")
_LONGEST = 90

pytestmark = [
    pytest.mark.real,
    pytest.mark.skipif(not discover().worker, reason="the worker is not built"),
    pytest.mark.skipif(shutil.which("ghc") is None, reason="there is no GHC"),
]


@pytest.fixture(scope="module")
def worker() -> Iterator[BlockingWorker]:
    yield from worker_started()


@pytest.fixture(scope="module")
def answers_of_ghc(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """What GHC's interpreter prints for each idiom, by name; one process for all of them."""
    folder = tmp_path_factory.mktemp("idioms")
    commands = [":set -w"]
    for number, idiom in enumerate(IDIOMS):
        (folder / f"I{number}.hs").write_text(f"{idiom.typed.lstrip()}\nmain :: IO ()\nmain = putStrLn answer\n")
        commands += [f":load I{number}.hs", "main", ":load", f'putStrLn "<<end {number}>>"']
    done = subprocess.run(
        ["ghc", "--interactive", "-v0", "-ignore-dot-ghci", "-fno-warn-tabs", "-package-env", "-"],
        input="\n".join(commands) + "\n",
        cwd=folder,
        capture_output=True,
        text=True,
        check=True,
        env={**os.environ, "LANG": "C.UTF-8"},
        timeout=300,
    )
    printed = re.split(r"<<end \d+>>\n", done.stdout)
    return {idiom.name: text.strip() or "refused" for idiom, text in zip(IDIOMS, printed, strict=False)}


def answer_of_rosy(worker: BlockingWorker, idiom: Idiom) -> str:
    """What the program says, or what is said about it."""
    source = f"{idiom.typed.lstrip()}\nmain = simulate (say answer)\n"
    told = worker.check(source).problems
    errors = [problem for problem in told if problem.severity == "error"]
    if errors:
        return f"refused: {errors[0].message} {errors[0].hint}"
    run = ran(worker, source, seconds=1.0)
    failed = [f"fails: {problem.message}" for problem in run.outcome.problems]
    return "; ".join([*run.said, *failed, *(f"warns: {problem.message}" for problem in told)]).strip()


def row(idiom: Idiom, rosy: str, ghc: str) -> str:
    cells = [idiom.name, shown(ghc), "the same" if rosy == ghc else shown(rosy), idiom.difference]
    return "| " + " | ".join(cells) + " |"


def shown(text: str) -> str:
    one_line = " ".join(text.split()).replace("|", "\\|")
    return one_line if len(one_line) <= _LONGEST else one_line[: _LONGEST - 2] + " …"


@pytest.mark.long
def test_every_difference_has_a_reason(worker: BlockingWorker, answers_of_ghc: dict[str, str]) -> None:
    answers = [(idiom, answer_of_rosy(worker, idiom), answers_of_ghc[idiom.name]) for idiom in IDIOMS]
    table = "\n".join(
        [
            "# Idioms of Haskell, and what Rosy answers",
            "",
            "Each program of `idioms.py` defines `answer`. GHC prints it in its interpreter; Rosy says it in a task.",
            "Written by `test_idioms.py`.",
            "",
            "| idiom | GHC | Rosy | why |",
            "|---|---|---|---|",
            *(row(*answer) for answer in answers),
            "",
        ]
    )
    if os.environ.get("UPDATE_GOLDENS"):
        TABLE.write_text(table)
    assert [(i.name, rosy, ghc) for i, rosy, ghc in answers if (rosy != ghc) != bool(i.difference)] == []
    assert table == TABLE.read_text()


def test_there_are_forty_idioms() -> None:
    assert len({idiom.name for idiom in IDIOMS}) == len(IDIOMS) >= 40
