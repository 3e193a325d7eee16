"""
Checks of the open documents by the worker and the text service: one at a time per document, the newest text only.

A change cancels the check of the older text, in the worker as well, and the next one begins after a pause in typing.
"""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable
from dataclasses import dataclass, field

import msgspec

from ..errors import RosyError, WorkerLost
from ..sentences.sentence import Sentence, sentence_of, tr
from ..wire.problem import Problem
from ..wire.worker import Checked
from ..worker.supervisor import WorkerSupervisor
from .document import Document
from .hover import Declaration, TypesAtPlaces

__all__ = ["CheckedDocument", "DocumentChecks"]

PAUSE = 0.15
"""Without a key press before a text is checked, s: longer than between two keys of a fast typist."""

_declarations = msgspec.json.Decoder(list[Declaration])
_types = msgspec.json.Decoder(TypesAtPlaces)


@dataclass(frozen=True, slots=True)
class CheckedDocument:
    """A text and what the worker says about it."""

    document: Document
    problems: list[Problem] = field(default_factory=list)
    declarations: list[Declaration] = field(default_factory=list)
    types: TypesAtPlaces = field(default_factory=lambda: TypesAtPlaces([], []))
    # Raw JSON of the declarations, for codegen.
    raw_declarations: msgspec.Raw = field(default_factory=lambda: msgspec.Raw(b"[]"))


class DocumentChecks:
    """
    Checks of any number of documents.

    Args:
        conflicts: warnings that the worker does not give.
        on_checked: called with each answer.
        on_failed: called with the sentence when a text cannot be checked.
    """

    def __init__(
        self,
        worker: WorkerSupervisor,
        conflicts: Callable[[Document], Awaitable[list[Problem]]],
        on_checked: Callable[[CheckedDocument], None],
        on_failed: Callable[[Document, Sentence], None],
    ) -> None:
        self._worker = worker
        self._conflicts = conflicts
        self._on_checked = on_checked
        self._on_failed = on_failed
        self._tasks: dict[str, asyncio.Task[None]] = {}
        self._latest: dict[str, CheckedDocument] = {}

    def schedule(self, document: Document, pause: float = PAUSE) -> None:
        """Check a text after a pause, in place of an older text of the same document."""
        self._cancel(document.uri)
        self._tasks[document.uri] = asyncio.get_running_loop().create_task(self._check(document, pause))

    def forget(self, uri: str) -> None:
        """The document is closed."""
        self._cancel(uri)
        self._latest.pop(uri, None)

    def latest(self, uri: str) -> CheckedDocument | None:
        """The last answer about a document, which may be about an older text."""
        return self._latest.get(uri)

    async def current(self, uri: str) -> CheckedDocument | None:
        """The answer about the present text, as soon as it is there; ``None`` when it cannot be checked."""
        while (task := self._tasks.get(uri)) is not None and not task.done():
            await asyncio.wait((task,))
        return self._latest.get(uri)

    async def close(self) -> None:
        """Cancel all checks."""
        tasks = list(self._tasks.values())
        for task in tasks:
            task.cancel()
        await asyncio.gather(*tasks, return_exceptions=True)

    def _cancel(self, uri: str) -> None:
        task = self._tasks.pop(uri, None)
        if task is not None:
            task.cancel()

    async def _check(self, document: Document, pause: float) -> None:
        await asyncio.sleep(pause)
        while True:
            try:
                answer = await self._worker.check(document.source)
            except WorkerLost:
                # The worker that takes its place is asked again.
                continue
            except (RosyError, TimeoutError) as error:
                self._latest.pop(document.uri, None)
                self._on_failed(document, sentence_of(error) if str(error) else tr("it takes too long"))
                return
            break
        checked = _decoded(document, answer, await self._conflicts(document))
        self._latest[document.uri] = checked
        self._on_checked(checked)


def _decoded(document: Document, answer: Checked, conflicts: list[Problem]) -> CheckedDocument:
    return CheckedDocument(
        document,
        [*answer.problems, *conflicts],
        _declarations.decode(answer.declarations),
        _types.decode(answer.types),
        answer.declarations,
    )
