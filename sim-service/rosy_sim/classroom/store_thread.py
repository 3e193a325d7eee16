"""
Thread of the class store: keeps the disk's waits off the event loop and makes calls one after the other.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import Concatenate, ParamSpec, TypeVar

from .class_store import ClassStore

__all__ = ["StoreThread"]

Arguments = ParamSpec("Arguments")
Result = TypeVar("Result")


class StoreThread:
    """A store whose methods are called in one thread."""

    def __init__(self, store: ClassStore) -> None:
        self._store = store
        self._thread = ThreadPoolExecutor(max_workers=1, thread_name_prefix="class-store")

    async def call(
        self,
        method: Callable[Concatenate[ClassStore, Arguments], Result],
        /,
        *arguments: Arguments.args,
        **named: Arguments.kwargs,
    ) -> Result:
        """
        Call a method of the store. A caller that is cancelled does not cancel the call.

        Raises:
            StoreError: the disk is full or broken; nothing was changed.
        """
        loop = asyncio.get_running_loop()
        return await asyncio.shield(
            loop.run_in_executor(self._thread, lambda: method(self._store, *arguments, **named))
        )

    async def close(self) -> None:
        """Finish the calls that wait, and close the store."""
        await asyncio.get_running_loop().run_in_executor(self._thread, self._store.close)
        self._thread.shutdown(wait=False)
