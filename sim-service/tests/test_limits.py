"""Limits of programs that get less of the processor than others."""

from __future__ import annotations

from rosy_sim.config import Limits


def test_stretched_limits_are_longer_for_programs_and_the_same_for_sizes_and_counts() -> None:
    limits = Limits(settle=2.0, ready=10.0, stop=1.0, gone=1.0, compile=30.0, worker_ready=120.0)
    assert limits.stretched(5.0) == Limits(
        settle=10.0, ready=50.0, stop=5.0, gone=5.0, compile=150.0, worker_ready=600.0
    )
