"""The bounded history of a page's runs."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from rosy_sim.web.sessions.run_history import MAX_RUNS, RunHistory


@given(st.lists(st.tuples(st.integers(0, 30), st.integers(0, 50)), max_size=60))
def test_it_keeps_the_latest_runs_within_its_bounds(added: list[tuple[int, int]]) -> None:
    history: RunHistory[int] = RunHistory(100)
    expected: dict[int, int] = {}
    for run, weight in added:
        history.add(run, weight, weight)
        expected.pop(run, None)
        expected[run] = weight
        while sum(expected.values()) > 100 or len(expected) > MAX_RUNS:
            expected.pop(next(iter(expected)))
    assert {run: history.get(run) for run in range(31) if history.get(run) is not None} == expected
    history.clear()
    assert all(history.get(run) is None for run in range(31))
