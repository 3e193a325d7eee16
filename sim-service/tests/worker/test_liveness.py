"""The liveness monitor on a slow machine: workers that wait or collect garbage, and workers that hang."""

from __future__ import annotations

import os

import psutil
import pytest

from rosy_sim.worker.liveness import PROBE_INTERVAL, LivenessMonitor

PATIENCE = 10.0
"""A worker that waits for the processor for so long is left alone, s."""


class Observed(LivenessMonitor):
    """A monitor of a process that is in ``status`` and uses ``share`` of a processor between two probes."""

    def __init__(self, status: str, share: float) -> None:
        super().__init__(os.getpid())
        self._observed = status
        self._share = share
        self._used = 0.0

    def _process_state(self) -> tuple[str, float]:
        self._used += self._share * PROBE_INTERVAL
        return self._observed, self._used


def probes_until_wedged(monitor: LivenessMonitor, most: int = 1000) -> int | None:
    """How many probes without an answer it takes; None when the worker is left alone."""
    return next((count for count in range(1, most) if monitor.probe()), None)


@pytest.mark.parametrize("status", [psutil.STATUS_RUNNING, psutil.STATUS_DISK_SLEEP])
def test_a_worker_that_gets_no_processor_is_waited_for(status: str) -> None:
    probes = probes_until_wedged(Observed(status, 0.0))
    assert probes is not None
    assert probes * PROBE_INTERVAL > PATIENCE


def test_a_worker_that_computes_for_less_than_a_second_is_not_wedged() -> None:
    monitor = Observed(psutil.STATUS_RUNNING, 1.0)
    assert not any(monitor.probe() for _ in range(round(1.0 / PROBE_INTERVAL)))


@pytest.mark.parametrize("status", [psutil.STATUS_STOPPED, psutil.STATUS_SLEEPING, psutil.STATUS_DEAD])
def test_a_worker_that_does_nothing_is_wedged_within_a_second(status: str) -> None:
    probes = probes_until_wedged(Observed(status, 0.0))
    assert probes is not None
    assert probes * PROBE_INTERVAL < 1.0


def test_an_endless_loop_is_found_by_its_processor_time() -> None:
    probes = probes_until_wedged(Observed(psutil.STATUS_RUNNING, 1.0))
    assert probes is not None
    assert probes * PROBE_INTERVAL < 2.0


def test_an_answer_begins_the_count_again() -> None:
    monitor = Observed(psutil.STATUS_SLEEPING, 0.0)
    for _ in range(20):
        assert not monitor.probe()
        monitor.record_activity()
