"""
Mailbox of a lockstep: memory that this process and a program share, for the bytes of a step (``protocol/README.md``,
section 2).

While both have a core of their own, neither makes a system call: each writes the bytes of its turn there, then their
length, for which the other busy-waits. What does not fit goes over the link. Only on Linux, and on processors that
keep the order of writes: x86-64.
"""

from __future__ import annotations

import fcntl
import mmap
import os
import platform
import sys
from types import TracebackType

from ..wire.robot_link import LinkError

__all__ = ["Mailbox", "open_mailbox"]

_SIZE = 65536
"""Bytes of the memory."""

_BATCH_LENGTH, _ANSWER_LENGTH, _EXPECTED = 0, 16, 32
"""Words of the memory: the length of a batch, that of an answer, whether the next batch comes here. They are in
different cache lines, 0 while nothing is there."""

_BATCH, _ANSWER = 4096, 32768
"""Where a batch and an answer stand, bytes."""


class Mailbox:
    """Of one program. A context manager that gives the memory back."""

    def __init__(self) -> None:
        self.descriptor = os.memfd_create("rosy-mailbox", os.MFD_CLOEXEC | os.MFD_ALLOW_SEALING)
        os.ftruncate(self.descriptor, _SIZE)
        # A program that made it shorter would end this process at its next look.
        fcntl.fcntl(self.descriptor, fcntl.F_ADD_SEALS, fcntl.F_SEAL_SHRINK | fcntl.F_SEAL_GROW | fcntl.F_SEAL_SEAL)
        self._memory = mmap.mmap(self.descriptor, _SIZE)
        self._words = memoryview(self._memory).cast("I")

    def __enter__(self) -> Mailbox:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None
    ) -> None:
        self._words.release()
        self._memory.close()
        os.close(self.descriptor)

    def expect(self, expected: bool) -> None:
        """Say before a batch, wherever that goes, whether the next one will come here."""
        self._words[_EXPECTED] = expected

    def put_batch(self, batch: bytes) -> bool:
        """Whether there was room for a batch, which the program then has."""
        size = len(batch)
        if size > _ANSWER - _BATCH:
            return False
        words = self._words
        # What a program wrote out of turn is no answer.
        words[_ANSWER_LENGTH] = 0
        self._memory[_BATCH : _BATCH + size] = batch
        words[_BATCH_LENGTH] = size
        return True

    def take_answer(self, spins: int) -> bytes:
        """
        The answer to the latest batch; empty when it is not there after so many looks.

        Raises:
            LinkError: the program says that it is longer than the mailbox.
        """
        words = self._words
        for _ in range(spins):
            size = words[_ANSWER_LENGTH]
            if size:
                words[_ANSWER_LENGTH] = 0
                if size > _SIZE - _ANSWER:
                    raise LinkError(f"an answer of {size} bytes in the mailbox")
                return self._memory[_ANSWER : _ANSWER + size]
        return b""


def open_mailbox() -> Mailbox | None:
    """A mailbox, where there can be one."""
    return Mailbox() if sys.platform == "linux" and platform.machine() == "x86_64" else None
