"""
Link of a lockstep on the event loop: reads what a program sends into the lockstep, and sends it batches; never waits.

``program_link`` is the one of a thread that waits.
"""

from __future__ import annotations

import asyncio
import socket
from typing import Literal, Protocol

from ..token_bucket import TokenBucket
from ..wire.robot_link import LimitExceeded, LinkError
from .steps.lockstep import Lockstep

__all__ = ["LinkListener", "LoopLink"]

Failure = Literal["stuck", "died", "broken", "loud"]

_MAX_OUTPUT_RATE = 20e6
"""Bytes that a program may send in a second for long: forty times what the fastest of the examples sends."""


class LinkListener(Protocol):
    """Receives what happens, on the event loop; must not block."""

    def on_answer(self) -> None:
        """The program has answered: its lockstep is in another state."""

    def on_failure(self, failure: Failure, detail: str) -> None:
        """The link is of no use any more; ``detail`` is for ``broken`` and ``loud``. It may be called again."""


class _Nobody:
    """Listener of a closed link."""

    def on_answer(self) -> None:
        """Nobody waits for it."""

    def on_failure(self, failure: Failure, detail: str) -> None:
        """Nobody uses the link."""


class LoopLink:
    """Owns the simulator's end of the link until it is closed."""

    def __init__(self, link: socket.socket, lockstep: Lockstep, listener: LinkListener) -> None:
        self._loop = asyncio.get_running_loop()
        self._link = link
        self._lockstep = lockstep
        self._listener: LinkListener = listener
        self._allowance = TokenBucket(_MAX_OUTPUT_RATE, 2 * _MAX_OUTPUT_RATE, self._loop.time())
        link.setblocking(False)
        self._loop.add_reader(link, self._read)

    def send(self, data: bytes) -> None:
        """Send all of it at once."""
        try:
            sent = self._link.send(data)
        except (BlockingIOError, InterruptedError):
            sent = 0
        except OSError:
            # The reader sees the end of the stream and what came before it.
            return
        if sent < len(data):
            # At most one batch is in flight: a full pipe means that the program reads nothing.
            self._loop.call_soon(self._listener.on_failure, "stuck", "")

    def close(self) -> None:
        """Nothing is read any more."""
        self._loop.remove_reader(self._link)
        self._link.close()
        # Otherwise the listener, with its world, would wait for a full garbage collection.
        self._listener = _Nobody()

    def _read(self) -> None:
        try:
            data = self._link.recv(65536)
        except (BlockingIOError, InterruptedError):
            return
        except OSError:
            data = b""
        if not data:
            self._listener.on_failure("died", "")
            return
        if not self._allowance.spend(len(data), self._loop.time()):
            self._listener.on_failure("loud", f"more than {_MAX_OUTPUT_RATE:.0f} bytes a second")
            return
        before = self._lockstep.state
        try:
            state = self._lockstep.feed(data)
        except LimitExceeded as too_much:
            self._listener.on_failure("loud", str(too_much))
        except LinkError as error:
            self._listener.on_failure("broken", str(error))
        else:
            if state != before:
                self._listener.on_answer()
