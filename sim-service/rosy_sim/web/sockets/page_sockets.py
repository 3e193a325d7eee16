"""
Sockets of pages: one page session each. ``protocol/README.md``, section 4.

Here are connections and their limits; ``web/sessions`` has what a page may ask for.
"""

from __future__ import annotations

import asyncio
import secrets
from collections.abc import Callable

from starlette.status import WS_1013_TRY_AGAIN_LATER
from starlette.websockets import WebSocket, WebSocketDisconnect

from ...accounting.client import network_of
from ...accounting.slots import Slots
from ...run.problems import address_full, service_full
from ...wire import page
from ..pacing.loop_scheduler import LoopScheduler, PageTurns
from ..pacing.paced_frames import WRITE
from ..pacing.reading_pace import ReadingPace
from ..sessions.page_session import PageSession
from .first_completed import first_completed

__all__ = ["PageSockets"]


class PageSockets:
    """
    The sockets of all pages.

    Args:
        slots: how many there may be.
        scheduler: of the event loop.
        open_session: makes the session of a page: its random name, its turns and the address of its client.
    """

    def __init__(
        self, slots: Slots, scheduler: LoopScheduler, open_session: Callable[[str, PageTurns, str], PageSession]
    ) -> None:
        # By their random names.
        self.sessions: dict[str, PageSession] = {}
        self._slots = slots
        self._scheduler = scheduler
        self._open_session = open_session

    async def serve(self, socket: WebSocket) -> None:
        """Serve one page until it disconnects."""
        address = socket.client.host if socket.client is not None else ""
        turns = PageTurns(self._scheduler, address)
        await socket.accept()
        async with turns.turn():
            session = None
            if self._slots.take(network_of(address)):
                session = self._open_session(secrets.token_urlsafe(9), turns, address)
        if session is None:
            full = service_full(self._slots.total) if self._slots.is_full else address_full(self._slots.each)
            await socket.send_text(page.encode(page.Refusal(full.message, full.hint, full.sentences)))
            await socket.close(WS_1013_TRY_AGAIN_LATER)
            return
        self.sessions[session.id] = session
        try:
            await first_completed(
                _receive(socket, session, turns), _send(socket, session), session.outbox.overflowed.wait()
            )
        finally:
            del self.sessions[session.id]
            self._slots.free(network_of(address))
            await session.close()


async def _receive(socket: WebSocket, session: PageSession, turns: PageTurns) -> None:
    """
    Read until the page disconnects. A page whose messages are too many, or take too long to serve, is read more slowly,
    so that it delays no other.
    """
    now = asyncio.get_running_loop().time
    pace = ReadingPace(now())
    while True:
        message = await socket.receive()
        if message["type"] == "websocket.disconnect":
            return
        text = message.get("text") or message.get("bytes") or ""
        before = turns.spent
        await session.receive(text)
        if wait := pace.wait(len(text), turns.spent - before, now()):
            await asyncio.sleep(wait)


async def _send(socket: WebSocket, session: PageSession) -> None:
    """Send until the page disconnects or stops reading."""
    write = socket.scope.get("extensions", {}).get(WRITE)
    if write is not None:
        session.outbox.write_with(write)
    try:
        while True:
            await socket.send_text(page.encode(await session.outbox.get()))
    except (WebSocketDisconnect, RuntimeError):
        # The page disconnected during a send; the receiver notices as well.
        return
