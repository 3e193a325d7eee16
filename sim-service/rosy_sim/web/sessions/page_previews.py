"""
Previews that a page asks for: one at a time, the newest request wins, within a budget of computing time.
"""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import Awaitable, Callable

from ...accounting.client import Client
from ...errors import RosyError
from ...previews.preview import PreviewTask
from ...previews.preview_pool import PreviewPool
from ...run.problems import worker_problem
from ...token_bucket import TokenBucket
from ...wire import page

__all__ = ["PagePreviews"]

_BUDGET_RATE, _BUDGET_BURST = 0.5, 10.0
"""Computing time of one page's previews: s in a second for long, and s at once."""


class PagePreviews:
    """Of one page; ``send`` puts a message into its outbox."""

    def __init__(
        self,
        pool: PreviewPool,
        client: Client,
        send: Callable[[page.Previewed], None],
        now: Callable[[], float],
        wait_ready: Callable[[], Awaitable[None]],
    ) -> None:
        self._pool = pool
        # A preview has a worker of its own, which cannot start where that of the service cannot.
        self._wait_ready = wait_ready
        self._client = client
        self._send = send
        self._now = now
        self._budget = TokenBucket(_BUDGET_RATE, _BUDGET_BURST, now())
        # When the budget allows the next preview, on the clock.
        self._next = 0.0
        self._work: asyncio.Task[None] | None = None

    def prepare(self) -> None:
        """A request is likely to come soon."""
        self._pool.prepare()

    def request(self, task: PreviewTask) -> None:
        """Compute this preview; an older one that is not finished is never answered."""
        self.cancel()
        self._work = asyncio.get_running_loop().create_task(self._answer(task))

    def cancel(self) -> None:
        """Cancel the preview in progress; its request is not answered."""
        if self._work is not None:
            self._work.cancel()

    async def close(self) -> None:
        """End what is under way."""
        if self._work is not None:
            self._work.cancel()
            with contextlib.suppress(asyncio.CancelledError):
                await self._work

    async def _answer(self, task: PreviewTask) -> None:
        await asyncio.sleep(max(0.0, self._next - self._now()))
        try:
            await self._wait_ready()
            self._send(await self._pool.run(task, self._client, self._spend))
        except RosyError as error:
            self._send(page.Previewed(task.id, "error", 0.0, (0.0, 0.0, 0.0), [], [], [], [worker_problem(error)]))

    def _spend(self, seconds: float) -> None:
        now = self._now()
        self._next = now + self._budget.overdraw(seconds, now)
