"""How long a preview may compute, on fast and slow machines."""

from __future__ import annotations

import subprocess
import sys
import time

import psutil
import pytest

from rosy_sim.previews.computing_budget import PATIENCE, ComputingBudget, processor_times

SECONDS = 3.0
OWN = psutil.Process()


@pytest.mark.parametrize(
    ("share", "end"), [(1.0, SECONDS), (0.5, 2 * SECONDS), (2.0, SECONDS), (0.0, PATIENCE * SECONDS)]
)
def test_a_preview_ends_by_the_processor_time_that_it_gets_or_when_it_has_waited_for_long(
    share: float, end: float
) -> None:
    clock = 0.0
    budget = ComputingBudget(SECONDS, lambda: clock, lambda: {OWN: 100.0 + share * clock})
    while not budget.is_used_up():
        clock += 0.125
    assert clock == pytest.approx(end, abs=0.25)


def test_the_processor_time_is_looked_at_a_few_times_only() -> None:
    clock, looks = 0.0, 0

    def computed() -> dict[psutil.Process, float]:
        nonlocal looks
        looks += 1
        return {OWN: 0.9 * clock}

    budget = ComputingBudget(SECONDS, lambda: clock, computed)
    while not budget.is_used_up():
        clock += 0.001
    assert looks < 10


def test_the_time_of_this_process_and_those_below_it_is_counted() -> None:
    busy = "import time\nwhile time.process_time() < 0.3: pass\nprint(flush=True)\ninput()"
    with subprocess.Popen([sys.executable, "-c", busy], stdin=subprocess.PIPE, stdout=subprocess.PIPE) as child:
        assert child.stdout is not None
        child.stdout.readline()
        own = time.process_time()
        # The system counts in hundredths of a second.
        assert sum(processor_times().values()) >= own + 0.2
        child.communicate(b"\n")


def test_each_preview_has_the_whole_budget_whatever_ended_before_it() -> None:
    clock = 0.0
    program = psutil.Process(OWN.ppid())
    times = {OWN: 50.0, program: 7.0}
    budget = ComputingBudget(SECONDS, lambda: clock, lambda: dict(times))
    # The program of the preview before has ended, and its time with it.
    del times[program]
    budget.begin()
    for clock in (3.0, 5.75):
        times[OWN] = 50.0 + clock / 2
        assert not budget.is_used_up()
    clock = 9.0
    times[OWN] = 53.5
    assert budget.is_used_up()
    budget.measure_baseline()
    budget.begin()
    clock += 3.0
    assert not budget.is_used_up()
