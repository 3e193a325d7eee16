"""
HTTP protocol whose requests must arrive in time: a client that opens connections and sends nothing, or sends a request
slowly, byte by byte, holds them for some seconds only. One that sends many requests without waiting for answers, which
no browser does, is not served. WebSockets are not concerned once they are open.
"""

from __future__ import annotations

import asyncio
from typing import ClassVar

from uvicorn.protocols.http.httptools_impl import HttpToolsProtocol

from .sliced_timer import SlicedTimer

__all__ = ["RequestDeadline"]


_PIECE = 4096
"""Bytes that are read at once: at most 230 requests, which take some ms."""

_PIPELINED = 16
"""Requests of a connection that may wait for the answers to others."""


class RequestDeadline(HttpToolsProtocol):
    """The protocol of one connection; ``uvicorn.Config(http=RequestDeadline)``."""

    seconds: ClassVar[float] = 10.0
    """From the connection, or from the first byte after an answer, to the end of a request's head."""

    _timer: SlicedTimer | None = None

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        """Begin to wait for the first request."""
        super().connection_made(transport)
        self._set_timer()

    def data_received(self, data: bytes) -> None:
        """Wait on while the request is incomplete, from when it began."""
        for start in range(0, len(data), _PIECE):
            super().data_received(data[start : start + _PIECE])
            if len(self.pipeline) > _PIPELINED:
                self.transport.abort()
                return
            if self.transport.is_closing() or self.transport.get_protocol() is not self:
                # It has ended, or is a WebSocket, whose client waits for an answer before it sends more.
                break
        self._set_timer()

    def connection_lost(self, exc: Exception | None) -> None:
        """Wait no more."""
        super().connection_lost(exc)
        self._cancel()

    def _set_timer(self) -> None:
        if not self._is_waiting:
            self._cancel()
        elif self._timer is None:
            self._timer = SlicedTimer(self.loop, self.seconds, self._expire)

    def _cancel(self) -> None:
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None

    @property
    def _is_waiting(self) -> bool:
        """Whether no request is being answered, and the connection is not that of a WebSocket."""
        is_answering = self.cycle is not None and not self.cycle.response_complete
        return not is_answering and self.transport.get_protocol() is self

    def _expire(self) -> None:
        self._timer = None
        if self._is_waiting:
            self.transport.abort()
