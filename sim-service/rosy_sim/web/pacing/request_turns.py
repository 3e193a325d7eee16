"""
Middleware that serves requests over HTTP in the turns of their client's address, so that a client that asks without end
delays no other.
"""

from __future__ import annotations

from starlette.types import ASGIApp, Receive, Scope, Send

from .loop_scheduler import REQUEST, LoopScheduler

__all__ = ["RequestTurns"]


class RequestTurns:
    """
    The application behind the turns.

    Args:
        app: the application.
        scheduler: of the event loop.
    """

    def __init__(self, app: ASGIApp, scheduler: LoopScheduler) -> None:
        self._app = app
        self._scheduler = scheduler

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Serve a request when it is the turn of its address."""
        if scope["type"] == "http":
            client = scope.get("client")
            address = client[0] if client else ""
            await self._scheduler.begin(address)
            # Its own time: what it computes is mixed with what others do meanwhile.
            self._scheduler.end(address, REQUEST)
        await self._app(scope, receive, send)
