"""
Thread of the class store: keeps the disk's waits off the event loop and makes calls one after the other.

While the database server cannot be reached, a call is tried again for a short time, such as that of a restart; then
calls fail at once until ``keep`` has reached the server.
"""

from __future__ import annotations

import asyncio
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from typing import Concatenate, ParamSpec, TypeVar

from .class_store import ClassStore
from .database import StoreAway

__all__ = ["StoreThread"]

Arguments = ParamSpec("Arguments")
Result = TypeVar("Result")

_RESTART = 5.0
"""How long a call waits for a server that cannot be reached, s: as long as it takes to start again, and more."""

_PAUSE = 0.2
"""Between its attempts, s."""


class StoreThread:
    """A store whose methods are called in one thread."""

    def __init__(self, store: ClassStore, patience: float = _RESTART) -> None:
        self._store = store
        self._patience = patience
        self._thread = ThreadPoolExecutor(max_workers=1, thread_name_prefix="class-store")
        # Since when the server cannot be reached, and why.
        self._away: tuple[float, StoreAway] | None = None

    @property
    def is_away(self) -> bool:
        """Whether the last attempt to reach the database server was in vain."""
        return self._away is not None

    async def call(
        self,
        method: Callable[Concatenate[ClassStore, Arguments], Result],
        /,
        *arguments: Arguments.args,
        **named: Arguments.kwargs,
    ) -> Result:
        """
        Call a method of the store, which is one transaction. A caller that is cancelled does not cancel the call.

        Raises:
            StoreError: the disk is full or broken, or the server is away; nothing was changed.
        """
        return await self._in_thread(lambda: self._until_reached(lambda: method(self._store, *arguments, **named)))

    async def keep(self) -> None:
        """
        Keep the class locked for this service; after a lost connection, connect again.

        Raises:
            StoreAway: the server cannot be reached now.
            ClassTaken: another service has opened the class.
        """
        await self._in_thread(lambda: self._reach(self._store.keep))

    async def _in_thread(self, call: Callable[[], Result]) -> Result:
        loop = asyncio.get_running_loop()
        return await asyncio.shield(loop.run_in_executor(self._thread, call))

    def _until_reached(self, call: Callable[[], Result]) -> Result:
        while True:
            if self._away is not None and time.monotonic() - self._away[0] > self._patience:
                raise StoreAway(*self._away[1].args)
            with suppress(StoreAway):
                return self._reach(call)
            time.sleep(_PAUSE)

    def _reach(self, call: Callable[[], Result]) -> Result:
        try:
            result = call()
        except StoreAway as error:
            self._away = (time.monotonic() if self._away is None else self._away[0], error)
            raise
        self._away = None
        return result

    async def close(self) -> None:
        """Finish the calls that wait, and close the store."""
        await asyncio.get_running_loop().run_in_executor(self._thread, self._store.close)
        self._thread.shutdown(wait=False)
