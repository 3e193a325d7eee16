"""
The worker in waiting: warmed up beside the one in use, so that its place is taken at once.

It is looked after as well. One that dies or is wedged while it waits is replaced, and not found out when it is needed.
"""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import Callable

from .connection import Connection

__all__ = ["LAST_PAUSE", "Spare"]

_LOOK = 1.0
"""Between two looks at a warm worker that waits, s: nobody needs it at the moment."""

_FIRST_PAUSE, LAST_PAUSE = 0.02, 1.0
"""Between a death and the next start, s; doubles while it keeps dying before it is warm."""


class Spare:
    """At most one worker, made by ``connect``, which says None when none can be started."""

    def __init__(self, connect: Callable[[], Connection | None]) -> None:
        self._connect = connect
        self._waiting: Connection | None = None
        self._keeper: asyncio.Task[None] | None = None
        self._closed = False

    @property
    def pid(self) -> int | None:
        """The process that waits, warm or not."""
        return self._waiting.pid if self._waiting is not None else None

    def prepare(self) -> None:
        """See to it from now on that there is one."""
        if self._keeper is None and not self._closed:
            self._keeper = asyncio.create_task(self._keep())

    def take(self) -> Connection | None:
        """The one that waits, which is the caller's now; there is no other until the next prepare()."""
        taken, self._waiting = self._waiting, None
        if self._keeper is not None and taken is not None:
            self._keeper.cancel()
            self._keeper = None
        return taken

    async def warm(self) -> None:
        """Until it could take over at once, for tests and tables."""
        while self._waiting is None or not self._waiting.ready.is_set():  # noqa: ASYNC110 (it may be another by then)
            await asyncio.sleep(0.01)

    async def close(self) -> None:
        """End it; none is started any more."""
        self._closed = True
        if self._keeper is not None:
            self._keeper.cancel()
            with contextlib.suppress(asyncio.CancelledError):
                await self._keeper

    async def _keep(self) -> None:
        pause = _FIRST_PAUSE
        while True:
            connection = self._connect()
            if connection is not None:
                self._waiting = connection
                try:
                    await connection.lives(_LOOK)
                finally:
                    if self._waiting is connection:
                        self._waiting = None
                        await connection.end()
                pause = _FIRST_PAUSE if connection.ready.is_set() else pause
            await asyncio.sleep(pause)
            pause = min(LAST_PAUSE, pause * 2)
