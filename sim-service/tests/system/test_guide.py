"""
Programs of the guide: every Haskell block of its pages is checked by the real worker and driven in the simulator.

Words behind ``haskell`` say how: ``room=table`` and ``seconds=20`` (5 without it), ``fragment`` for a part of a
program, which gets an end of its own, ``refused`` for a program with a mistake, whose
explanation stands in the text of the page, ``package`` for a module of a package of its own, which GHC compiles.
A block of the language ``says`` below a program is what the program says.
"""

from __future__ import annotations

import json
import re
import subprocess
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest

from rosy_sim.classroom.exports.written_tests import read_key
from rosy_sim.config import discover
from rosy_sim.worker.blocking_worker import BlockingWorker
from rosy_sim.worlds.gallery import named_world

from .real_runs import ran, worker_started

pytestmark = [pytest.mark.real, pytest.mark.skipif(not discover().worker, reason="the worker is not built")]

ROOT = Path(__file__).resolve().parents[3]

BLOCK = re.compile(r"^```haskell([^\n]*)\n(.*?)^```$(?:\n\n^```says\n(.*?)^```$)?", re.M | re.S)
MARKUP = re.compile(r"[`*‘’]|^> ?|\n", re.M)


@dataclass(frozen=True, slots=True)
class Block:
    """A program of a page."""

    page: str
    line: int
    words: list[str]
    source: str
    said: list[str] | None

    def word(self, name: str, otherwise: str) -> str:
        """The value of a word such as `room=table`."""
        found = [word.partition("=")[2] for word in self.words if word.startswith(f"{name}=")]
        return found[0] if found else otherwise


def pages() -> list[str]:
    """The Markdown files of the guide; made pages hold programs that ``test_lessons.py`` runs."""
    contents = json.loads((ROOT / "docs" / "contents.json").read_text("utf-8"))
    return [page["file"] for chapter in contents["chapters"] for page in chapter["pages"] if "file" in page]


def blocks() -> list[Block]:
    """The programs of all pages, and of the written tests, by the number of their question."""
    found = []
    for page in pages():
        text = (ROOT / page).read_text("utf-8")
        for match in BLOCK.finditer(text):
            said = match[3].splitlines() if match[3] is not None else None
            found.append(Block(page, text.count("\n", 0, match.start()) + 1, match[1].split(), match[2], said))
    return found + [
        Block(f"test {name}", number, [], question.program, None)
        for name, questions in read_key(ROOT / "examples" / "written-tests.json").items()
        for number, question in enumerate(questions, 1)
        if question.program is not None
    ]


BLOCKS = blocks()


@pytest.fixture(scope="module")
def worker() -> Iterator[BlockingWorker]:
    yield from worker_started()


def test_no_block_is_left_out() -> None:
    """Every block that is called Haskell is one of those that are run."""
    for page in pages():
        text = (ROOT / page).read_text("utf-8")
        assert text.count("```haskell") == sum(block.page == page for block in BLOCKS), page
        assert text.count("```says") == sum(block.page == page and block.said is not None for block in BLOCKS), page


@pytest.mark.parametrize("block", BLOCKS, ids=lambda block: f"{block.page}:{block.line}")
def test_a_program_of_the_guide_does_what_its_page_says(block: Block, worker: BlockingWorker, tmp_path: Path) -> None:
    if "package" in block.words:
        compiles_in_a_package(block.source, tmp_path)
        return
    source = f"{block.source}\nmain = simulate (Velocity 0 0)\n" if "fragment" in block.words else block.source
    checked = worker.check(source)
    errors = [problem.message for problem in checked.problems if problem.severity == "error"]
    if "refused" in block.words:
        text = MARKUP.sub(" ", (ROOT / block.page).read_text("utf-8"))
        assert errors
        assert plain(errors[0]) in plain(text)
        return
    assert errors == []
    run = ran(worker, source, float(block.word("seconds", "5")), world=named_world(block.word("room", "room")))
    assert [problem.message for problem in run.outcome.problems] == []
    assert run.outcome.ended in ("time", "done")
    if block.said is not None:
        assert run.said == block.said


def plain(text: str) -> str:
    """Without markup and line breaks."""
    return " ".join(MARKUP.sub(" ", text).split())


def compiles_in_a_package(source: str, folder: Path) -> None:
    """A module that uses the packages which are built here."""
    file = folder / "Main.hs"
    file.write_text(source, "utf-8")
    [packages] = (ROOT / "dist-newstyle" / "packagedb").glob("ghc-*")
    own = [file.stem for file in packages.glob("rosy-*.conf")]
    exposed = [f"-package-id={unit}" for unit in own if not unit.endswith("-ros")]
    databases = ["-hide-all-packages", f"-package-db={packages}", "-package=base", *exposed]
    subprocess.run(["ghc", "-v0", "-fno-code", "-dynamic", *databases, file], check=True)
