"""Core affinity of a lockstep: which cores this thread and a program are on, and that it ends with the run."""

from __future__ import annotations

import os
import socket
from collections.abc import Iterator
from contextlib import contextmanager

import pytest

from rosy_sim.run import core_affinity, program_link
from rosy_sim.run.core_affinity import REVIEW_STEPS, CoreAffinity
from rosy_sim.run.program_link import ProgramLink
from rosy_sim.worker.mailbox import Mailbox

from ..mailboxes import answer_batches, needs_mailbox

pytestmark = pytest.mark.skipif(
    not hasattr(os, "sched_setaffinity") or len(os.sched_getaffinity(0)) < 2, reason="needs two cores"
)


@pytest.fixture(autouse=True)
def given() -> Iterator[set[int]]:
    """The cores that this process was given."""
    cores = os.sched_getaffinity(0)
    yield cores
    os.sched_setaffinity(0, cores)


@pytest.fixture(autouse=True)
def waited(monkeypatch: pytest.MonkeyPatch) -> list[float]:
    """How long the pair has waited for its core, s; the clock stands unless a test moves it."""
    times = [0.0, 0.0]
    monkeypatch.setattr(core_affinity, "_waited", lambda process: times[1] if process == "thread-self" else 0.0)
    monkeypatch.setattr("time.perf_counter", lambda: times[0])
    return times


@contextmanager
def program(mailbox: Mailbox | None = None) -> Iterator[tuple[ProgramLink, int]]:
    """Our end of the link to a process that answers whatever it gets until the link is closed, and the process."""
    ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_STREAM)
    child = os.fork()
    if child == 0:
        ours.close()
        answer_batches(theirs, mailbox, lambda _: b"answer")
        os._exit(0)
    theirs.close()
    try:
        with ours:
            link = ProgramLink(ours, mailbox)
            link.limit_waiting(10.0)
            yield link, child
    finally:
        os.waitpid(child, 0)


@contextmanager
def program_with_mailbox() -> Iterator[tuple[ProgramLink, int]]:
    """The same with a mailbox."""
    with Mailbox() as mailbox, program(mailbox) as (link, child):
        yield link, child


def answer(link: ProgramLink, core: CoreAffinity) -> bytes:
    """What the program answers to something."""
    is_first = link.program == 0
    (link.send if is_first else link.send_batch)(b"step")
    found = link.receive()
    if is_first:
        core.begin()
    return found


def test_both_are_on_one_core_during_a_run_and_this_thread_has_its_cores_back_after_it(given: set[int]) -> None:
    with program() as (link, child), CoreAffinity(link) as core:
        assert answer(link, core) == b"answer"
        mine = os.sched_getaffinity(0)
        assert mine == os.sched_getaffinity(child)
        assert len(mine) == 1
        assert mine <= given
        assert answer(link, core) == b"answer"
    assert os.sched_getaffinity(0) == given


def test_a_process_with_one_core_keeps_it_and_leaves_the_program_alone(given: set[int]) -> None:
    with program() as (link, child):
        os.sched_setaffinity(0, {min(given)})
        with CoreAffinity(link) as core:
            assert answer(link, core) == b"answer"
            assert os.sched_getaffinity(child) == given
        assert os.sched_getaffinity(0) == {min(given)}


def test_a_program_that_was_given_other_cores_keeps_them(given: set[int]) -> None:
    first, second, *_ = sorted(given)
    with program() as (link, child):
        os.sched_setaffinity(child, {second})
        with CoreAffinity(link) as core:
            assert answer(link, core) == b"answer"
            assert os.sched_getaffinity(child) == {second}
            assert os.sched_getaffinity(0) == {second}
        assert os.sched_getaffinity(0) >= {first, second}


def test_a_pair_leaves_a_busy_core_and_has_one_core_again_when_it_is_quiet(
    given: set[int], waited: list[float]
) -> None:
    with program() as (link, child), CoreAffinity(link) as core:
        answer(link, core)
        waited[:] = [1.0, 0.5]
        core.review()
        was = core.placement
        assert was == "free"
        assert os.sched_getaffinity(0) == os.sched_getaffinity(child) == given
        waited[:] = [2.0, 0.6]
        core.review()
        assert core.placement == "shared"
        assert len(os.sched_getaffinity(0) | os.sched_getaffinity(child)) == 1


def ask(link: ProgramLink, core: CoreAffinity, steps: int = REVIEW_STEPS) -> None:
    """Steps in which the program is asked, and a review."""
    for _ in range(steps):
        assert answer(link, core) == b"answer"
    core.review()


@needs_mailbox
def test_a_program_that_is_asked_in_each_step_is_put_on_another_core(given: set[int]) -> None:
    with program_with_mailbox() as (link, child), CoreAffinity(link) as core:
        ask(link, core)
        assert core.placement == "separate"
        mine, others = os.sched_getaffinity(0), os.sched_getaffinity(child)
        assert len(mine) == 1
        assert mine | others == given
        assert not mine & others
        assert answer(link, core) == b"answer"
    assert os.sched_getaffinity(0) == given


@needs_mailbox
def test_a_program_that_is_asked_now_and_then_has_another_core_only_at_first(waited: list[float]) -> None:
    with program_with_mailbox() as (link, _), CoreAffinity(link) as core:
        answer(link, core)
        placements = [core.placement]
        waited[:] = [1.0, 0.0]
        ask(link, core, REVIEW_STEPS // 10)
        assert [*placements, core.placement] == ["separate", "shared"]


@needs_mailbox
def test_a_pair_that_finds_its_two_cores_busy_shares_one_and_tries_again_after_longer_and_longer_pauses(
    waited: list[float],
) -> None:
    with program_with_mailbox() as (link, _), CoreAffinity(link) as core:
        ask(link, core)
        for time, waiting, placement in [
            (1.0, 1.0, "shared"),
            (1.01, 1.0, "shared"),
            (1.03, 1.0, "separate"),
            (1.1, 1.1, "shared"),
            (1.13, 1.1, "shared"),
            (1.15, 1.1, "separate"),
        ]:
            waited[:] = [time, waiting]
            ask(link, core)
            assert core.placement == placement


@needs_mailbox
def test_a_pair_whose_program_takes_long_shares_one_core(waited: list[float], monkeypatch: pytest.MonkeyPatch) -> None:
    with program_with_mailbox() as (link, _), CoreAffinity(link) as core:
        ask(link, core)
        # Every look into the mailbox is in vain.
        monkeypatch.setattr(program_link, "SPINS", 0)
        waited[:] = [1.0, 0.0]
        ask(link, core)
        assert core.placement == "shared"


def test_a_pair_whose_program_has_ended_is_free(given: set[int], waited: list[float]) -> None:
    with program() as (link, child):
        with CoreAffinity(link) as core:
            answer(link, core)
            link.send(b"end")
            os.waitid(os.P_PID, child, os.WEXITED | os.WNOWAIT)
            waited[:] = [1.0, 1.0]
            core.review()
            waited[:] = [2.0, 1.0]
            core.review()
        assert os.sched_getaffinity(0) == given


def test_a_program_in_a_thread_of_this_process_is_not_pinned(given: set[int]) -> None:
    ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_STREAM)
    link = ProgramLink(ours)
    with ours, theirs, CoreAffinity(link) as core:
        theirs.sendall(b"ready")
        assert link.receive() == b"ready"
        core.begin()
        assert core.placement == "free"
        assert os.sched_getaffinity(0) == given


def test_nothing_is_pinned_unless_wanted(given: set[int]) -> None:
    with program() as (link, child), CoreAffinity(link, wanted=False) as core:
        assert answer(link, core) == b"answer"
        assert os.sched_getaffinity(child) == os.sched_getaffinity(0) == given
