"""
Checks and completions that a page asks for while its program is edited.

A newer question replaces an older one of the same kind, in the worker as well. Pages take turns
(``worker/question_scheduler.py``).
"""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import Callable

import msgspec

from ...errors import RosyError, WorkerLost
from ...sentences.sentence import sentence_of, tr
from ...wire import page
from ...worker.question_scheduler import QuestionScheduler
from ...worker.supervisor import WorkerSupervisor
from .outbox import Outbox

__all__ = ["ProgramChecks"]


class ProgramChecks:
    """One check and one completion at a time; close() cancels both."""

    def __init__(
        self,
        worker: WorkerSupervisor,
        scheduler: QuestionScheduler,
        outbox: Outbox,
        on_checked: Callable[[str, page.Checked], None],
        address: str,
    ) -> None:
        self._worker = worker
        self._scheduler = scheduler
        self._address = address
        self._on_checked = on_checked
        self._outbox = outbox
        self._check: asyncio.Task[None] | None = None
        self._completion: asyncio.Task[None] | None = None
        scheduler.join(self, address)

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
        self._scheduler.leave(self, self._address)

    async def _answer_check(self, request: page.Check) -> None:
        try:
            # A page is not penalised for a worker that starts.
            await self._worker.wait_ready()
            async with self._scheduler.turn(self):
                checked = await self._worker.check(request.source)
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
            async with self._scheduler.turn(self):
                completed = await self._worker.complete(request.source, request.line, request.column)
            self._outbox.put(msgspec.structs.replace(completed, id=request.id))
