"""Limit of the runs that are observed at the same time."""

from __future__ import annotations

from rosy_sim.run.observed_runs import ObservedRuns


def test_a_run_without_a_place_is_not_recorded_until_another_one_ends() -> None:
    observed = ObservedRuns(2)
    assert observed.admit("first")
    assert observed.admit("second")
    assert observed.admit("second"), "a run that has a place keeps it"
    assert not observed.admit("third")
    observed.runs.discard("first")
    assert observed.admit("third")
