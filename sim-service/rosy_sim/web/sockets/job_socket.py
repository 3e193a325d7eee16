"""A socket that carries one background job of a page: the job ends with its last message, or when the page leaves."""

from __future__ import annotations

import asyncio
from collections.abc import Coroutine
from typing import Any

from starlette.websockets import WebSocket

__all__ = ["serve_job"]


async def serve_job(
    socket: WebSocket, closed: asyncio.Event, job: Coroutine[Any, Any, None], sending: Coroutine[Any, Any, None]
) -> None:
    """
    Work and send until the last message is sent, the socket is closed, or ``closed`` is set because the page has left.
    """
    work = asyncio.create_task(job)
    sender = asyncio.create_task(sending)
    left = [asyncio.create_task(_wait_for_end(socket)), asyncio.create_task(closed.wait())]
    try:
        await asyncio.wait([sender, *left], return_when=asyncio.FIRST_COMPLETED)
    finally:
        for task in (work, sender, *left):
            task.cancel()
        await asyncio.gather(work, sender, *left, return_exceptions=True)


async def _wait_for_end(socket: WebSocket) -> None:
    """A page says nothing after its request; it closes the socket to cancel."""
    while (await socket.receive())["type"] != "websocket.disconnect":
        continue
