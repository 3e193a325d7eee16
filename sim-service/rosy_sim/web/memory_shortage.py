"""
End of the service when an allocation fails: with a sentence, at once.

A callback that failed has lost what it had read, so a page or a program would wait for it without end, and libraries in
C crash at a later allocation. The end of the process is what everything else is made for: robots stop, and what was
reported as saved is on the disk.
"""

from __future__ import annotations

import asyncio
import os
from typing import Any

from starlette.types import ASGIApp, Receive, Scope, Send

from ..sentences.sentence import tr
from ..sentences.wording import in_terminal

__all__ = ["EXIT_STATUS", "MemoryShortage"]

EXIT_STATUS = 71
"""Of a service that ended because it had no memory: EX_OSERR of sysexits(3)."""


class MemoryShortage:
    """Ends the process when a callback of the event loop or a request finds no memory. Its sentence is made before."""

    def __init__(self) -> None:
        sentence = tr(
            "Rosy ended, because this computer has no memory left for it. What was saved is there, and robots stand. "
            "Close other programs, or allow fewer programs at once (--runs), and start Rosy again."
        )
        self._last_words = f"rosy: {in_terminal(sentence)}\n".encode()

    def watch(self, loop: asyncio.AbstractEventLoop) -> None:
        """From now on, callbacks and tasks of this loop."""
        loop.set_exception_handler(self._handle)

    def around(self, app: ASGIApp) -> ASGIApp:
        """The application, whose requests are watched."""

        async def serve(scope: Scope, receive: Receive, send: Send) -> None:
            try:
                await app(scope, receive, send)
            except MemoryError:
                self._end()

        return serve

    def _handle(self, loop: asyncio.AbstractEventLoop, context: dict[str, Any]) -> None:
        if isinstance(context.get("exception"), MemoryError):
            self._end()
        loop.default_exception_handler(context)

    def _end(self) -> None:
        os.write(2, self._last_words)
        # Its children end when their pipes close.
        os._exit(EXIT_STATUS)
