"""
Link of a lockstep: this thread's end of the socket to a program, and their mailbox if they have one.

``busy_waits`` says whether both busy-wait in the mailbox, each on a core of its own. A change of it is announced with
the next batch and holds from the one after that.
"""

from __future__ import annotations

import select
import socket
import struct
import time
from collections.abc import Callable

from ..worker.mailbox import Mailbox

__all__ = ["ProgramLink"]

_CHUNK = 65536
"""Bytes read at once."""

_TIMEVAL = struct.Struct("@ll")
"""``struct timeval``: seconds and microseconds."""

_CREDENTIALS = struct.Struct("3i")
"""``struct ucred``: process, user and group of a sender. unix(7)."""

SPINS = 3000
"""Looks into the mailbox after which an answer is late: some 0.1 ms, several times what a program takes for a step."""

_SHORT_SLEEP = 4e-5
"""Between two looks for an answer that is late, s: the program waits for a core perhaps, which may be this one."""

_PATIENCE = 0.005
"""For how long this thread looks so often, s: several times what collecting garbage takes. Then it looks once in a
millisecond."""


class ProgramLink:
    """Of one run."""

    def __init__(self, link: socket.socket, mailbox: Mailbox | None = None) -> None:
        # Reads what the program says. Raises BlockingIOError when it says nothing in time.
        self.receive: Callable[[], bytes] = self.read
        # Whether both may busy-wait, and whether they are to.
        self.has_mailbox = mailbox is not None
        self.busy_waits = False
        # The process at the other end; 0 when it is not known.
        self.program = 0
        # Reads since the last review, and those of them for which this thread looked into the mailbox in vain.
        self.reads = self.slept = 0
        self._link = link
        self._mailbox = mailbox
        self._limit = 0.0
        # Whether the program expects the next batch in the mailbox.
        self._is_expected = False
        if mailbox is not None:
            self._poller = select.poll()
            self._poller.register(link, select.POLLIN)

    def limit_waiting(self, seconds: float) -> None:
        """Let each read and write fail with ``BlockingIOError`` after this time."""
        self._limit = seconds
        # The kernel keeps this time; for a timeout of Python's own each call would be two.
        self._link.settimeout(None)
        limit = _TIMEVAL.pack(int(seconds), int(seconds % 1 * 1e6))
        self._link.setsockopt(socket.SOL_SOCKET, socket.SO_RCVTIMEO, limit)
        self._link.setsockopt(socket.SOL_SOCKET, socket.SO_SNDTIMEO, limit)

    def ask_for_program(self) -> None:
        """Let the first read find out which process is at the other end."""
        self._link.setsockopt(socket.SOL_SOCKET, socket.SO_PASSCRED, 1)
        self.receive = self._receive_first

    def send(self, data: bytes) -> None:
        """Send the first line."""
        self._link.sendall(data)

    def send_batch(self, batch: bytes) -> None:
        """Send the batch of a step, or the last line, which is answered over the link."""
        mailbox = self._mailbox
        if mailbox is None:
            self._link.sendall(batch)
            return
        is_expected = self._is_expected
        if is_expected is not self.busy_waits:
            self._is_expected = self.busy_waits
            mailbox.expect(self.busy_waits)
        if is_expected and mailbox.put_batch(batch):
            self.receive = self._spin
        else:
            self.receive = self.read
            self._link.sendall(batch)

    def has_bytes(self, seconds: float) -> bool:
        """Whether there is something to read on the link within a time."""
        return bool(select.select([self._link], [], [], seconds)[0])

    def read(self) -> bytes:
        """Read from the socket."""
        self.reads += 1
        return self._link.recv(_CHUNK)

    def _receive_first(self) -> bytes:
        """Read the first bytes with the credentials of their sender, which the kernel vouches for."""
        data, ancillary, _, _ = self._link.recvmsg(_CHUNK, socket.CMSG_SPACE(_CREDENTIALS.size))
        self.receive = self.read
        self._link.setsockopt(socket.SOL_SOCKET, socket.SO_PASSCRED, 0)
        for level, kind, found in ancillary:
            if level == socket.SOL_SOCKET and kind == socket.SCM_CREDENTIALS:
                self.program = _CREDENTIALS.unpack(found[: _CREDENTIALS.size])[0]
        return data

    def _spin(self) -> bytes:
        """Busy-wait for an answer in the mailbox."""
        self.reads += 1
        mailbox = self._mailbox
        assert mailbox is not None
        answer = mailbox.take_answer(SPINS)
        if answer:
            return answer
        self.slept += 1
        now = time.monotonic()
        often_until, deadline = now + _PATIENCE, now + self._limit
        while now < deadline:
            looks_often = now < often_until
            if looks_often:
                time.sleep(_SHORT_SLEEP)
            has_bytes = self._poller.poll(0 if looks_often else 1)
            # A program that ends, or whose answer does not fit, says so over the link, after what it has left here.
            answer = mailbox.take_answer(1) or (self._link.recv(_CHUNK) if has_bytes else b"")
            if answer or has_bytes:
                return answer
            now = time.monotonic()
        raise BlockingIOError
