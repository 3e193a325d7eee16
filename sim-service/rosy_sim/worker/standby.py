"""
Standby worker: a second worker, warm, that takes over at once when the current one dies.

It is monitored as well: a standby that dies or is wedged is replaced before it is needed.
"""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import Callable

from .connection import Connection

__all__ = ["LAST_PAUSE", "StandbyWorker"]

_PROBE_INTERVAL = 1.0
"""Between two probes of a warm standby, s."""

_FIRST_PAUSE, LAST_PAUSE = 0.02, 1.0
"""Between a death and the next start, s; doubles while it keeps dying before it is warm."""


class StandbyWorker:
    """At most one worker, made by ``connect``, which returns None when none can be started."""

    def __init__(self, connect: Callable[[], Connection | None]) -> None:
        self._connect = connect
        self._waiting: Connection | None = None
        # Set while there is one, warm or not.
        self._present = asyncio.Event()
        self._supervision: asyncio.Task[None] | None = None
        self._closed = False

    @property
    def pid(self) -> int | None:
        """Its process, warm or not."""
        return self._waiting.pid if self._waiting is not None else None

    def prepare(self) -> None:
        """Keep one from now on."""
        if self._supervision is None and not self._closed:
            self._supervision = asyncio.create_task(self._supervise())

    def take(self) -> Connection | None:
        """The standby, which the caller owns from now on; there is no other until the next prepare()."""
        taken, self._waiting = self._waiting, None
        self._present.clear()
        if self._supervision is not None and taken is not None:
            self._supervision.cancel()
            self._supervision = None
        return taken

    async def wait_ready(self) -> None:
        """Until it could take over at once, for tests and tables."""
        while True:
            await self._present.wait()
            connection = self._waiting
            if connection is not None and await connection.wait_ready():
                return

    async def close(self) -> None:
        """End it and start no more."""
        self._closed = True
        if self._supervision is not None:
            self._supervision.cancel()
            with contextlib.suppress(asyncio.CancelledError):
                await self._supervision

    async def _supervise(self) -> None:
        pause = _FIRST_PAUSE
        while True:
            connection = self._connect()
            if connection is not None:
                self._waiting = connection
                self._present.set()
                try:
                    await connection.wait_until_lost(_PROBE_INTERVAL)
                finally:
                    if self._waiting is connection:
                        self._waiting = None
                        self._present.clear()
                        await connection.end()
                pause = _FIRST_PAUSE if connection.ready.is_set() else pause
            await asyncio.sleep(pause)
            pause = min(LAST_PAUSE, pause * 2)
