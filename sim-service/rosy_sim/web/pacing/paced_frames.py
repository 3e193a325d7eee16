"""
WebSocket protocol that reads frames in small pieces, at a pace for each client address.

A client may send 40,000 empty frames in one packet of 256 kB, and uvicorn's protocol reads and answers all of them at a
stretch: 0.2 s and more, in which no other page is served, again and again. Here a piece of 4 kB is read at a time, all
connections together read for some milliseconds in an iteration of the event loop, and those of an address have a share
of it. What messages mean and cost is
not known here (``loop_scheduler.py``, ``reading_pace.py``).

An application may write a text without a task and the layers of ASGI: the scope has the function ``WRITE`` for it.
"""

from __future__ import annotations

import asyncio
import contextlib
import time
from collections.abc import Callable
from typing import Any, cast

from uvicorn.protocols.websockets.websockets_sansio_impl import WebSocketsSansIOProtocol
from websockets.frames import Frame
from websockets.http11 import Request
from websockets.protocol import State

from ...token_bucket import Share, TokenBucket

__all__ = ["WRITE", "FrameBudgets", "PacedFrames", "paced_frames"]

WRITE = "rosy.write"
"""Extension of the scope: ``(text: bytes) -> bool`` writes a text now; false when it has to be sent as ASGI has it."""

_PIECE = 4096
"""Bytes that are read at once: at most 700 frames, which take 3 ms."""

_RATE, _BURST = 0.1, 0.05
"""Share of the loop for the frames of one address, and s at once. A message of a page takes some 10 µs."""

_FLOODS = 0.2
"""Share of the loop for the frames of all addresses that have used up their own."""

_ITERATION = 0.002
"""Computing time of all connections in one iteration of the loop, s, after which the others wait for the next one."""

_FRAGMENTS = 10_000
"""Frames of one message. Browsers send one; empty ones would fill the memory without end."""

_FINAL_TEXT = 0x81
"""The first byte of a frame that is a whole text."""

_SHORTEST = 0.001
"""Wait for the share of an address, s."""

_UNREADABLE = 0.1
"""Until the next look at a client that does not read its answers, s."""

_NO_TEXT, _TOO_BIG = 1007, 1009
"""Close codes. RFC 6455, section 7.4.1."""


def _text_header(size: int) -> bytes:
    """
    What stands before a text of so many bytes. RFC 6455, section 5.2. With the frames of ``websockets`` it took two
    fifths of the time in which a text is written.
    """
    if size < 126:
        return bytes((_FINAL_TEXT, size))
    if size < 1 << 16:
        return bytes((_FINAL_TEXT, 126)) + size.to_bytes(2, "big")
    return bytes((_FINAL_TEXT, 127)) + size.to_bytes(8, "big")


def _is_utf8(data: bytes) -> bool:
    try:
        data.decode()
    except UnicodeDecodeError:
        return False
    return True


class FrameBudgets:
    """
    Computing time for reading frames, by client address.

    Args:
        computed: the processor time of this thread, s.
    """

    def __init__(self, computed: Callable[[], float] = time.thread_time) -> None:
        self.computed = computed
        self._buckets: dict[str, Share] = {}
        # When the bucket of an address is full again, on the loop's clock.
        self._full: dict[str, float] = {}
        self._floods = TokenBucket(_FLOODS, _BURST, 0.0)
        # Computing time in this iteration of the loop, s.
        self._spent = 0.0

    @property
    def is_iteration_over(self) -> bool:
        """Whether all frames wait for the next iteration of the loop."""
        return self._spent >= _ITERATION

    def add(self, spent: float, loop: asyncio.AbstractEventLoop) -> None:
        """Count computing time in this iteration of the loop, s."""
        if spent > 0 and self._spent == 0:
            loop.call_soon(self._begin_iteration)
        self._spent += spent

    def _begin_iteration(self) -> None:
        self._spent = 0.0

    def charge(self, address: str, spent: float, now: float) -> float:
        """Take computing time of an address; returns the s after which it may go on."""
        bucket = self._buckets.get(address)
        if bucket is None:
            # Those that are full again are as good as unknown.
            for other in [other for other, full in self._full.items() if full <= now]:
                del self._buckets[other], self._full[other]
            bucket = self._buckets[address] = Share(TokenBucket(_RATE, _BURST, now), self._floods)
        wait = bucket.overdraw(spent, now)
        self._full[address] = now + wait + _BURST / _RATE
        return wait


class PacedFrames(WebSocketsSansIOProtocol):
    """The protocol of one connection."""

    def __init__(self, budgets: FrameBudgets, **settings: Any) -> None:
        super().__init__(**settings)
        self._budgets = budgets
        # What has arrived and is not read yet, from a position on.
        self._unread = b""
        self._position = 0
        # Reads on.
        self._timer: asyncio.Handle | None = None

    def data_received(self, data: bytes) -> None:
        """Read a part at once, and the rest in later iterations of the loop."""
        self._unread = self._unread[self._position :] + data
        self._position = 0
        if self._timer is None:
            self._read_on()
        else:
            self._pause()

    async def receive(self) -> Any:
        """The next message, as the application takes it; then there is room for the next ones."""
        message = await super().receive()
        if self._is_behind:
            self._pause()
            if self._timer is None:
                self._read_on()
        return message

    def connection_lost(self, exc: Exception | None) -> None:
        """Read what the share of the address allows; the rest is lost with the connection."""
        if self._timer is not None:
            self._timer.cancel()
        # The transport can neither be paused nor answer any more.
        self.read_paused = True
        with contextlib.suppress(RuntimeError):
            while self._is_behind and self._read_piece() == 0:
                pass
        self._unread, self._position = b"", 0
        super().connection_lost(exc)

    def handle_connect(self, event: Request) -> None:
        """As in uvicorn, with an extension."""
        super().handle_connect(event)
        if self.handshake_complete:
            # Refused.
            return
        cast("dict[str, Any]", self.scope["extensions"])[WRITE] = self.write_text

    def write_text(self, text: bytes) -> bool:
        """Write a text at once, unless the client does not read or the connection is not open."""
        if not self.handshake_complete or self.initial_response is not None or self.close_sent:
            return False
        if self.disconnected or not self.writable.is_set() or self.transport.is_closing():
            return False
        if self.conn.state is not State.OPEN or self.conn.extensions:
            # The client closes the connection, or compresses.
            return False
        self.transport.write(b"".join((*self.conn.data_to_send(), _text_header(len(text)), text)))
        return True

    def handle_cont(self, event: Frame) -> None:
        """As in uvicorn, but not without end."""
        super().handle_cont(event)
        if len(self.frames) > _FRAGMENTS:
            self.conn.fail(_TOO_BIG)
            self.handle_parser_exception()

    def send_receive_event_to_app(self) -> None:
        """As in uvicorn, which logs a traceback for a text that is not UTF-8."""
        if self.curr_msg_data_type == "text" and not _is_utf8(b"".join(self.frames)):
            self.frames = []
            self.conn.fail(_NO_TEXT)
            self.handle_parser_exception()
        else:
            super().send_receive_event_to_app()

    @property
    def _is_behind(self) -> bool:
        return self._position < len(self._unread)

    def _read_on(self) -> None:
        """Read pieces while there is time, and set the timer for the rest."""
        self._timer = None
        wait = self._charge(0.0)
        # A message that the application has not taken yet ends the reading, as in uvicorn.
        while self._is_behind and not self.read_paused and not self.transport.is_closing():
            if not self.writable.is_set():
                wait = max(wait, _UNREADABLE)
            elif wait == 0 and not self._budgets.is_iteration_over:
                wait = self._read_piece()
            if wait or self._budgets.is_iteration_over:
                # A shorter wait than the clock can tell would come back at once.
                self._timer = self.loop.call_later(max(wait, _SHORTEST) if wait else 0, self._read_on)
                break
        if self._is_behind:
            self._pause()
        elif not self.read_paused and not self.transport.is_closing() and not self.transport.is_reading():
            self.transport.resume_reading()

    def _read_piece(self) -> float:
        """Read a piece; returns the s to wait before the next."""
        piece = self._unread[self._position : self._position + _PIECE]
        self._position += len(piece)
        before = self._budgets.computed()
        super().data_received(piece)
        spent = self._budgets.computed() - before
        self._budgets.add(spent, self.loop)
        return self._charge(spent)

    def _charge(self, spent: float) -> float:
        return self._budgets.charge(self.client[0] if self.client is not None else "", spent, self.loop.time())

    def _pause(self) -> None:
        if not self.transport.is_closing() and self.transport.is_reading():
            self.transport.pause_reading()


def paced_frames() -> type[asyncio.Protocol]:
    """``uvicorn.Config(ws=paced_frames())``: all connections of a server share the budgets."""
    budgets = FrameBudgets()

    class Paced(PacedFrames):
        def __init__(self, **settings: Any) -> None:
            super().__init__(budgets, **settings)

    return Paced
