"""
Origins of the pages that may use the service: its own, and those of the other services of its cluster.

A browser reports the origin of a page; other clients report none and may always connect.
"""

from __future__ import annotations

from collections.abc import Awaitable, Callable, Collection
from urllib.parse import urlsplit

from starlette.middleware import Middleware
from starlette.middleware.cors import CORSMiddleware
from starlette.requests import HTTPConnection
from starlette.routing import WebSocketRoute
from starlette.status import WS_1008_POLICY_VIOLATION
from starlette.websockets import WebSocket

__all__ = ["PageOrigins"]


class PageOrigins:
    """``others`` are the hosts, with ports, of the other services."""

    def __init__(self, others: Collection[str]) -> None:
        self._others = others

    def admit(self, connection: HTTPConnection) -> bool:
        """Whether a request is not from a page of another origin."""
        origin = connection.headers.get("origin")
        if origin is None:
            return True
        try:
            host = urlsplit(origin).netloc
        except ValueError:
            # It is no origin, as `http://[`.
            return False
        return host == connection.headers.get("host") or host in self._others

    def socket(self, path: str, serve: Callable[[WebSocket], Awaitable[None]]) -> WebSocketRoute:
        """The route of a socket that pages of another origin cannot open."""

        async def serve_admitted(socket: WebSocket) -> None:
            if self.admit(socket):
                await serve(socket)
            else:
                await socket.close(WS_1008_POLICY_VIOLATION)

        return WebSocketRoute(path, serve_admitted)

    def middleware(self) -> list[Middleware]:
        """
        Lets the boards of the other services ask for files, with the teacher's key, and their pages send a recording.
        Fetch Standard, "CORS protocol".
        """
        allowed = [f"{scheme}://{other}" for other in self._others for scheme in ("http", "https")]
        headers = ["X-Rosy-Key"]
        if not allowed:
            return []
        return [Middleware(CORSMiddleware, allow_origins=allowed, allow_headers=headers, allow_methods=["GET", "POST"])]
