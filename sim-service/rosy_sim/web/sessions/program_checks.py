"""
Checks and completions that a page asks for while its program is edited.

A newer question replaces an older one of the same kind, in the worker as well. Clients take turns
(``accounting/fair_queue.py``); one whose place is needed for another client is asked again.
"""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import Callable, Coroutine
from typing import Any, TypeVar

import msgspec

from ...accounting.client import Client
from ...accounting.fair_queue import FairQueue
from ...errors import RosyError, WorkerLost
from ...sentences.sentence import sentence_of, tr
from ...wire import page
from ...worker.supervisor import WorkerSupervisor
from .outbox import Outbox

__all__ = ["ProgramChecks"]

_Answer = TypeVar("_Answer")


class ProgramChecks:
    """One check and one completion at a time; close() cancels both."""

    def __init__(
        self,
        worker: WorkerSupervisor,
        questions: FairQueue,
        client: Client,
        outbox: Outbox,
        on_checked: Callable[[str, page.Checked], None],
    ) -> None:
        self._worker = worker
        self._questions = questions
        self._client = client
        self._on_checked = on_checked
        self._outbox = outbox
        self._check: asyncio.Task[None] | None = None
        self._completion: asyncio.Task[None] | None = None

    def check(self, request: page.Check) -> None:
        """Answer with problems, declarations and types."""
        if self._check is not None:
            self._check.cancel()
        self._check = asyncio.get_running_loop().create_task(self._answer_check(request))

    def complete(self, request: page.Complete) -> None:
        """Answer with what can stand at a place."""
        if self._completion is not None:
            self._completion.cancel()
        self._completion = asyncio.get_running_loop().create_task(self._answer_completion(request))

    async def close(self) -> None:
        """Cancel what is under way."""
        for task in (self._check, self._completion):
            if task is not None:
                task.cancel()
                with contextlib.suppress(asyncio.CancelledError):
                    await task

    async def _answer_check(self, request: page.Check) -> None:
        try:
            # A page is not penalised for a worker that starts.
            await self._worker.wait_ready()
            checked = await self._ask(lambda: self._worker.check(request.source))
        except WorkerLost:
            # The page is told that the worker restarts, and asks again.
            return
        except (RosyError, TimeoutError) as error:
            self._outbox.put(page.refusal(tr("This program could not be checked."), sentence_of(error)))
            return
        # The worker and the page number their questions independently.
        self._outbox.put(msgspec.structs.replace(checked, id=request.id))
        self._on_checked(request.source, checked)

    async def _answer_completion(self, request: page.Complete) -> None:
        # Without an answer the page offers nothing.
        with contextlib.suppress(RosyError, TimeoutError):
            # A page is not penalised for a worker that starts.
            await self._worker.wait_ready()
            completed = await self._ask(lambda: self._worker.complete(request.source, request.line, request.column))
            self._outbox.put(msgspec.structs.replace(completed, id=request.id))

    async def _ask(self, question: Callable[[], Coroutine[Any, Any, _Answer]]) -> _Answer:
        """Ask in a place of the client; begin again when the place was needed."""
        while True:
            needed = asyncio.Event()
            async with self._questions.place(self._client, needed.set):
                asking, preemption = asyncio.create_task(question()), asyncio.create_task(needed.wait())
                try:
                    await asyncio.wait((asking, preemption), return_when=asyncio.FIRST_COMPLETED)
                    if asking.done():
                        return asking.result()
                finally:
                    preemption.cancel()
                    asking.cancel()
                    # The worker is told of the cancellation.
                    await asyncio.wait((asking,))
