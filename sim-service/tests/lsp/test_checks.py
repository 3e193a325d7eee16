"""Checks of documents with a worker that answers when the test says so: the newest text wins, older checks end."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable

import msgspec

from rosy_sim.errors import WorkerLost, WorkerRefused
from rosy_sim.lsp.checks import CheckedDocument, DocumentChecks
from rosy_sim.lsp.document import Document
from rosy_sim.sentences.sentence import verbatim
from rosy_sim.wire.problem import Problem, problem
from rosy_sim.wire.worker import Checked

URI = "file:///a.hs"


class _Worker:
    """Stands for the supervisor: each question waits for its answer."""

    def __init__(self) -> None:
        self.asked: asyncio.Queue[tuple[str, asyncio.Future[Checked]]] = asyncio.Queue()

    async def check(self, source: str) -> Checked:
        answer: asyncio.Future[Checked] = asyncio.get_running_loop().create_future()
        self.asked.put_nowait((source, answer))
        return await answer


def checked(text: str) -> Checked:
    return Checked(1, [problem("test", verbatim(text))], msgspec.Raw(b"[]"))


def with_checks(test: Callable[[DocumentChecks, _Worker], Awaitable[None]]) -> list[str]:
    """Run a test; returns what the editor was told."""
    told: list[str] = []

    def on_checked(found: CheckedDocument) -> None:
        told.append(found.problems[0].message)

    async def run() -> None:
        worker = _Worker()

        async def no_conflicts(_: Document) -> list[Problem]:
            return []

        # Only its check is used.
        checks = DocumentChecks(worker, no_conflicts, on_checked, lambda _, why: told.append(f"failed: {why}"))  # type: ignore[arg-type]
        await test(checks, worker)
        await checks.close()

    asyncio.run(run())
    return told


def test_a_newer_text_cancels_the_check_of_an_older_one() -> None:
    async def test(checks: DocumentChecks, worker: _Worker) -> None:
        checks.schedule(Document(URI, "old", 1), pause=0.0)
        _, old = await worker.asked.get()
        checks.schedule(Document(URI, "new", 2), pause=0.0)
        source, new = await worker.asked.get()
        assert (source, old.cancelled()) == ("new", True)
        new.set_result(checked("new"))
        current = await checks.current(URI)
        assert current is not None
        assert current.document.text == "new"

    assert with_checks(test) == ["new"]


def test_texts_that_follow_each_other_quickly_are_one_question() -> None:
    async def test(checks: DocumentChecks, worker: _Worker) -> None:
        for version in range(20):
            checks.schedule(Document(URI, f"text {version}", version))
        source, answer = await worker.asked.get()
        assert (source, worker.asked.qsize()) == ("text 19", 0)
        answer.set_result(checked("last"))
        await checks.current(URI)

    assert with_checks(test) == ["last"]


def test_a_question_that_a_worker_takes_to_its_grave_is_asked_again() -> None:
    async def test(checks: DocumentChecks, worker: _Worker) -> None:
        checks.schedule(Document(URI, "text", 1), pause=0.0)
        (await worker.asked.get())[1].set_exception(WorkerLost())
        (await worker.asked.get())[1].set_result(checked("again"))
        await checks.current(URI)

    assert with_checks(test) == ["again"]


def test_a_text_that_cannot_be_checked_is_told_and_has_no_answer() -> None:
    async def test(checks: DocumentChecks, worker: _Worker) -> None:
        checks.schedule(Document(URI, "text", 1), pause=0.0)
        (await worker.asked.get())[1].set_exception(WorkerRefused("too long"))
        assert await checks.current(URI) is None

    assert with_checks(test) == ["failed: The compiler part of Rosy did not accept the request: too long"]


def test_documents_are_checked_beside_each_other_and_forgotten_when_they_are_closed() -> None:
    async def test(checks: DocumentChecks, worker: _Worker) -> None:
        checks.schedule(Document(URI, "one", 1), pause=0.0)
        checks.schedule(Document("file:///b.hs", "two", 1), pause=0.0)
        questions = dict([await worker.asked.get(), await worker.asked.get()])
        checks.forget(URI)
        questions["two"].set_result(checked("two"))
        await checks.current("file:///b.hs")
        assert (questions["one"].cancelled(), await checks.current(URI)) == (True, None)

    assert with_checks(test) == ["two"]
