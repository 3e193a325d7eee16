"""
Core affinity of a lockstep: keeps the thread of a run and the process of its program on one core.

Of the two one computes while the other waits, so a second core does not make them faster, and waking a process on the
same core costs least. While other work keeps the core busy the pair is free to move, as the scheduler decides. The
affinity that this thread and the program were given is never exceeded, and is restored at the end.
"""

from __future__ import annotations

import os
import socket
import struct
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path
from types import TracebackType

__all__ = ["CoreAffinity"]

_CHUNK = 65536
"""Bytes read at once."""

_CREDENTIALS = struct.Struct("3i")
"""``struct ucred``: process, user and group of a sender. unix(7)."""

REVIEW_STEPS = 100
"""Steps after which ``review`` is called."""

REVIEW_INTERVAL = 0.05
"""Between two looks at how long the pair waited for its core, s: several turns of the scheduler."""

BUSY = 1 / 3
"""A core is busy when the pair waited for it for a larger share of the time. Choice of ours: alone, one of both waits
for the last microseconds of the other's turn, some tenth; beside one busy process they wait half of the time."""


class CoreAffinity:
    """
    Of one run: reads its link, and learns from the first read which process is at the other end.

    A context manager for the thread that drives the run. On a system without these calls, or with one core, it only
    reads.
    """

    def __init__(self, link: socket.socket, wanted: bool = True) -> None:
        # Reads the link.
        self.receive: Callable[[], bytes] = partial(link.recv, _CHUNK)
        self._link = link
        # Whether the pair is on one core now.
        self.is_pinned = False
        # The process of the program; 0 when it is not known or there is nothing to pin.
        self._program = 0
        # The cores that this thread and the program were given.
        self._ours: set[int] = set()
        self._theirs: set[int] = set()
        # When the waiting time was looked at last, and what it was, s.
        self._reviewed = self._waited = 0.0
        if wanted and hasattr(os, "sched_setaffinity") and len(os.sched_getaffinity(0)) > 1:
            link.setsockopt(socket.SOL_SOCKET, socket.SO_PASSCRED, 1)
            self.receive = self._receive_first

    def __enter__(self) -> CoreAffinity:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None
    ) -> None:
        # The program ends with the run.
        if self.is_pinned:
            self.is_pinned = False
            _assign(0, self._ours)

    def _receive_first(self) -> bytes:
        """Read the first bytes with the credentials of their sender, which the kernel vouches for."""
        data, ancillary, _, _ = self._link.recvmsg(_CHUNK, socket.CMSG_SPACE(_CREDENTIALS.size))
        self.receive = partial(self._link.recv, _CHUNK)
        self._link.setsockopt(socket.SOL_SOCKET, socket.SO_PASSCRED, 0)
        for level, kind, found in ancillary:
            if level == socket.SOL_SOCKET and kind == socket.SCM_CREDENTIALS:
                self._meet(_CREDENTIALS.unpack(found[: _CREDENTIALS.size])[0])
        return data

    def _meet(self, program: int) -> None:
        # A program in a thread of this process, as in tests, has nothing to be pinned to.
        if program in (0, os.getpid()):
            return
        try:
            self._ours, self._theirs = os.sched_getaffinity(0), os.sched_getaffinity(program)
        except OSError:
            return
        self._program = program
        self._reviewed, self._waited = time.perf_counter(), self._waiting_time()
        self._pin()

    def review(self) -> None:
        """Free the pair from a busy core, and pin it again where it has one for itself. Call now and then."""
        now = time.perf_counter()
        if not self._program or now - self._reviewed < REVIEW_INTERVAL:
            return
        waited = self._waiting_time()
        is_busy = waited - self._waited > BUSY * (now - self._reviewed)
        self._reviewed, self._waited = now, waited
        if is_busy:
            self._release()
        elif not self.is_pinned:
            self._pin()

    def _pin(self) -> None:
        """To the core on which this thread is, unless the program may not run there."""
        common = self._ours & self._theirs
        if not common:
            return
        here = _current_core()
        core = here if here in common else min(common)
        self.is_pinned = True
        if not (_assign(0, {core}) and _assign(self._program, {core})):
            self._release()

    def _release(self) -> None:
        if self.is_pinned:
            self.is_pinned = False
            _assign(0, self._ours)
            _assign(self._program, self._theirs)

    def _waiting_time(self) -> float:
        """How long this thread and the program were ready and waited for a core, s; 0 where that is not known."""
        return _waited("thread-self") + _waited(str(self._program))


def _assign(process: int, cores: set[int]) -> bool:
    """Whether a process, 0 for this thread, could be assigned to these cores. A failure costs only speed."""
    try:
        os.sched_setaffinity(process, cores)
    except OSError:
        # It has ended, or the cores were taken away meanwhile.
        return False
    return True


def _waited(process: str) -> float:
    # Time on a core, time of waiting for one, both ns, and turns. Documentation/scheduler/sched-stats.rst.
    try:
        return int(Path(f"/proc/{process}/schedstat").read_bytes().split()[1]) / 1e9
    except (OSError, IndexError):
        return 0.0


def _current_core() -> int:
    # The 39th field; the name of the process, in parentheses, may have spaces. proc_pid_stat(5).
    try:
        return int(Path("/proc/thread-self/stat").read_text().rpartition(")")[2].split()[36])
    except (OSError, IndexError, ValueError):
        return -1
