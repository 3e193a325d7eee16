"""A program's side of the link and the mailbox, written from ``protocol/README.md``, section 2."""

from __future__ import annotations

import mmap
import platform
import select
import socket
import struct
import sys
from collections.abc import Callable

import pytest

from rosy_sim.worker.mailbox import Mailbox

__all__ = ["CAN_HAVE_MAILBOX", "answer_batches", "needs_mailbox"]

CAN_HAVE_MAILBOX = sys.platform == "linux" and platform.machine() == "x86_64"

needs_mailbox = pytest.mark.skipif(
    not CAN_HAVE_MAILBOX,
    reason="a mailbox needs a processor that keeps the order of writes",
)

BATCH_LENGTH, ANSWER_LENGTH, EXPECTED = 0, 64, 128
"""Where the words stand, bytes."""

BATCH, ANSWER, SIZE = 4096, 32768, 65536
"""Where a batch and an answer stand, and the size of all, bytes."""


def answer_batches(link: socket.socket, mailbox: Mailbox | None, answer: Callable[[bytes], bytes]) -> None:
    """
    Answer each batch where it came, until one is ``end`` or the link is closed; an answer that does not fit goes over
    the link.
    """
    memory = mmap.mmap(mailbox.descriptor, SIZE) if mailbox is not None else None
    expects = False
    while True:
        batch, came_in_mailbox = _next_batch(link, memory if expects else None)
        if batch in (b"", b"end"):
            return
        # Before the answer: after it the simulator may say it of the batch after the next one.
        expects = memory is not None and struct.unpack_from("<I", memory, EXPECTED)[0] != 0
        said = answer(batch)
        if memory is not None and came_in_mailbox and len(said) <= SIZE - ANSWER:
            memory[ANSWER : ANSWER + len(said)] = said
            struct.pack_into("<I", memory, ANSWER_LENGTH, len(said))
        else:
            link.sendall(said)


def _next_batch(link: socket.socket, memory: mmap.mmap | None) -> tuple[bytes, bool]:
    if memory is None:
        return link.recv(100000), False
    while True:
        size = struct.unpack_from("<I", memory, BATCH_LENGTH)[0]
        if size:
            batch = memory[BATCH : BATCH + size]
            struct.pack_into("<I", memory, BATCH_LENGTH, 0)
            return batch, True
        if select.select([link], [], [], 0)[0]:
            return link.recv(100000), False
