"""
Same problems as the page's check: every mistake of the gallery, through the language server and an independent client.
"""

from __future__ import annotations

from collections.abc import AsyncIterator, Iterator
from pathlib import Path

import pytest
import pytest_asyncio
from lsprotocol import types

from rosy_sim.config import discover
from rosy_sim.wire.problem import Place, Problem
from rosy_sim.worker.blocking_worker import BlockingWorker

from ..system.real_runs import worker_started
from .editor import Client, Editor, applied, connected

GALLERY = Path(__file__).resolve().parents[3] / "rosy-hs" / "test-worker" / "gallery"
PROGRAMS = {path: path.read_text("utf-8") for path in sorted(GALLERY.glob("*/Main.hs"))}
SEVERITIES = {1: "error", 2: "warning", 3: "note"}

pytestmark = [
    pytest.mark.real,
    pytest.mark.asyncio(loop_scope="module"),
    pytest.mark.skipif(not discover().worker, reason="the worker is not built"),
]


@pytest.fixture(scope="module")
def worker() -> Iterator[BlockingWorker]:
    yield from worker_started()


@pytest_asyncio.fixture(scope="module", loop_scope="module")
async def client() -> AsyncIterator[Client]:
    async with connected() as client:
        yield client


def position(text: str, place: Place) -> types.Position:
    """A worker's place in UTF-16 units; past the end of a line it is that end."""
    lines = text.split("\n")
    if place.line > len(lines):
        return types.Position(len(lines) - 1, len(lines[-1].encode("utf-16-le")) // 2)
    before = lines[place.line - 1][: place.column - 1]
    return types.Position(place.line - 1, len(before.encode("utf-16-le")) // 2)


def edited(text: str, problem: Problem, number: int) -> str:
    """A text after a fix of the worker, by Python's own indices."""
    lines = text.split("\n")
    starts = [sum(len(line) + 1 for line in lines[:n]) for n in range(len(lines) + 1)]
    assert problem.fixes is not None

    def offset(place: Place) -> int:
        return min(starts[place.line - 1] + place.column - 1, len(text))

    for edit in sorted(problem.fixes[number].edits, key=lambda e: (e.start.line, e.start.column), reverse=True):
        text = text[: offset(edit.start)] + edit.text + text[offset(edit.end) :]
    return text


@pytest.mark.parametrize("path", PROGRAMS, ids=[path.parent.name for path in PROGRAMS])
async def test_a_mistake_has_the_problems_places_and_fixes_of_the_pages_check(
    client: Client, worker: BlockingWorker, path: Path
) -> None:
    text = PROGRAMS[path]
    expected = worker.check(text).problems
    editor = Editor(client, text)
    # Conflicts are found by codegen, and are no mistake of the gallery.
    found = [diagnostic for diagnostic in await editor.diagnostics() if diagnostic.code != "conflict"]
    assert [(d.code, SEVERITIES[d.severity or 0], d.message) for d in found] == [
        (p.kind, p.severity, f"{p.message} {p.hint}".strip()) for p in expected
    ]
    for diagnostic, problem in zip(found, expected, strict=True):
        if problem.start is not None:
            assert diagnostic.range.start == position(text, problem.start)
            assert diagnostic.range.end == position(text, problem.end or problem.start)
        offered = {action.title: applied(text, edits_of(action)) for action in await editor.actions(diagnostic.range)}
        for number, fix in enumerate(problem.fixes or []):
            assert offered[fix.title] == edited(text, problem, number)
    editor.close()


def edits_of(action: types.CodeAction) -> list[types.TextEdit]:
    """The text edits of a code action of one document."""
    assert action.edit is not None
    assert action.edit.document_changes is not None
    [change] = action.edit.document_changes
    assert isinstance(change, types.TextDocumentEdit)
    return [edit for edit in change.edits if isinstance(edit, types.TextEdit)]
