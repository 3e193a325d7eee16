"""Heartbeats of a page: only what it has seen lately counts, however its messages were delayed."""

from __future__ import annotations

import itertools

from rosy_sim.ownership.heartbeats import Heartbeats


def test_a_heartbeat_counts_from_when_its_answer_was_sent() -> None:
    clock = itertools.count(100)
    heartbeats = Heartbeats(lambda: float(next(clock)))
    assert [heartbeats.time_of(0), heartbeats.next(), heartbeats.time_of(1)] == [None, 1, 100.0]
    assert [heartbeats.next(), heartbeats.time_of(2), heartbeats.time_of(1)] == [2, 101.0, 100.0]


def test_heartbeats_that_waited_say_the_time_from_which_they_are() -> None:
    now = 10.0
    heartbeats = Heartbeats(lambda: now)
    seen = heartbeats.next()
    # Eighty messages of a page that was silent for eight seconds arrive at once; all name what it saw before.
    now = 18.0
    times = []
    for _ in range(80):
        times.append(heartbeats.time_of(seen))
        heartbeats.next()
    assert set(times) <= {10.0, None}
    # Five seconds of them are kept and no more.
    assert (heartbeats.time_of(seen), heartbeats.time_of(seen + 80)) == (None, 18.0)


def test_numbers_that_were_never_sent_do_not_count() -> None:
    heartbeats = Heartbeats(lambda: 1.0)
    heartbeats.next()
    assert [heartbeats.time_of(n) for n in (-1, 0, 2, 10**30)] == [None] * 4
