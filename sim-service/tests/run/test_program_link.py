"""The link of a lockstep and its mailbox: where batches and answers go, and what a program can do to it."""

from __future__ import annotations

import os
import signal
import socket
import struct
from collections.abc import Callable, Iterator
from contextlib import contextmanager

import pytest

from rosy_sim.run import program_link
from rosy_sim.run.program_link import ProgramLink
from rosy_sim.wire.robot_link import LinkError
from rosy_sim.worker.mailbox import Mailbox

from ..mailboxes import ANSWER, ANSWER_LENGTH, BATCH, SIZE, answer_batches, needs_mailbox

pytestmark = needs_mailbox


@pytest.fixture
def mailbox() -> Iterator[Mailbox]:
    with Mailbox() as box:
        yield box


@contextmanager
def program(mailbox: Mailbox, answer: Callable[[bytes], bytes], limit: float = 10.0) -> Iterator[ProgramLink]:
    """The link to a program that answers like this."""
    ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_STREAM)
    child = os.fork()
    if child == 0:
        ours.close()
        answer_batches(theirs, mailbox, answer)
        os._exit(0)
    theirs.close()
    try:
        with ours:
            link = ProgramLink(ours, mailbox)
            link.limit_waiting(limit)
            yield link
    finally:
        # It may wait for a batch that never comes.
        os.kill(child, signal.SIGKILL)
        os.waitpid(child, 0)


def said(link: ProgramLink, batch: bytes) -> tuple[bytes, bool]:
    """The whole answer to a batch, and whether it came in the mailbox."""
    link.send_batch(batch)
    looks = link.receive == link._spin
    found = link.receive()
    while not found.endswith(b"!"):
        looks = False
        found += link.receive()
    return found, looks


def test_the_mailbox_is_used_from_the_batch_after_the_announcement_on_and_no_longer_after_it_is_given_up(
    mailbox: Mailbox,
) -> None:
    with program(mailbox, lambda batch: b"<" + batch + b">!") as link:
        answers = [said(link, b"0")]
        link.busy_waits = True
        answers += [said(link, b"1"), said(link, b"2"), said(link, b"3")]
        link.busy_waits = False
        answers += [said(link, b"4"), said(link, b"5")]
    assert answers == [
        (b"<0>!", False),
        (b"<1>!", False),
        (b"<2>!", True),
        (b"<3>!", True),
        (b"<4>!", True),
        (b"<5>!", False),
    ]


@pytest.mark.parametrize("size", [1, ANSWER - BATCH, ANSWER - BATCH + 1, 500_000])
def test_a_batch_that_does_not_fit_goes_over_the_link(mailbox: Mailbox, size: int) -> None:
    with program(mailbox, lambda batch: b"%d!" % len(batch)) as link:
        link.busy_waits = True
        said(link, b"first")
        # Over the link it may come in pieces, each of which this program answers.
        link.send_batch(b"x" * size)
        found = b""
        while sum(int(piece) for piece in found.split(b"!") if piece) < size:
            found += link.receive()
        assert said(link, b"next") == (b"4!", True)


@pytest.mark.parametrize("size", [1, SIZE - ANSWER, SIZE - ANSWER + 1, 300_000])
def test_an_answer_that_does_not_fit_goes_over_the_link(mailbox: Mailbox, size: int) -> None:
    with program(mailbox, lambda _: b"x" * (size - 1) + b"!") as link:
        link.busy_waits = True
        said(link, b"first")
        found, _ = said(link, b"second")
        assert len(found) == size


def test_an_answer_that_is_late_is_waited_for(mailbox: Mailbox, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(program_link, "SPINS", 0)
    monkeypatch.setattr(program_link, "_PATIENCE", 0.0)
    with program(mailbox, lambda batch: batch + b"!") as link:
        link.busy_waits = True
        assert [said(link, b"%d" % n)[0] for n in range(5)] == [b"%d!" % n for n in range(5)]
        assert link.slept == 4


def test_a_program_that_says_nothing_is_not_waited_for_longer_than_the_limit(mailbox: Mailbox) -> None:
    with program(mailbox, lambda batch: b"first!" if batch == b"first" else b"") as link:
        link.busy_waits = True
        said(link, b"first")
        link.limit_waiting(0.05)
        link.send_batch(b"second")
        with pytest.raises(BlockingIOError):
            link.receive()


def test_a_program_that_reads_nothing_keeps_nobody_writing_longer_than_the_limit() -> None:
    ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_STREAM)
    with ours, theirs:
        link = ProgramLink(ours)
        link.limit_waiting(0.05)
        # More than the kernel keeps for a socket that is not read.
        with pytest.raises(BlockingIOError):
            link.send_batch(bytes(50_000_000))


def test_what_a_program_leaves_before_it_ends_is_read_first(mailbox: Mailbox) -> None:
    def last(batch: bytes) -> bytes:
        if batch == b"second":
            memory[ANSWER : ANSWER + 5] = b"last!"
            struct.pack_into("<I", memory, ANSWER_LENGTH, 5)
            os._exit(0)
        return b"first!"

    memory = mailbox._memory
    with program(mailbox, last) as link:
        link.busy_waits = True
        said(link, b"first")
        link.send_batch(b"second")
        assert link.receive() == b"last!"
        link.send_batch(b"third")
        assert link.receive() == b""


def test_an_answer_out_of_turn_is_none(mailbox: Mailbox) -> None:
    def eager(batch: bytes) -> bytes:
        if batch == b"first":
            struct.pack_into("<I", mailbox._memory, ANSWER_LENGTH, 4)
        return batch + b"!"

    with program(mailbox, eager) as link:
        link.busy_waits = True
        assert said(link, b"first") == (b"first!", False)
        assert said(link, b"second") == (b"second!", True)


@pytest.mark.parametrize("size", [SIZE - ANSWER + 1, 2**31, 2**32 - 1])
def test_an_answer_longer_than_the_mailbox_breaks_the_protocol(mailbox: Mailbox, size: int) -> None:
    mailbox.put_batch(b"step")
    struct.pack_into("<I", mailbox._memory, ANSWER_LENGTH, size)
    with pytest.raises(LinkError, match=f"an answer of {size} bytes"):
        mailbox.take_answer(1)


def test_a_program_cannot_take_the_memory_away(mailbox: Mailbox) -> None:
    with pytest.raises(OSError, match="not permitted"):
        os.ftruncate(mailbox.descriptor, 0)
