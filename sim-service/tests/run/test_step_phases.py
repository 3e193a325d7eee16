"""Phases of runs at real time: even, and soon."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from rosy_sim.run.step_phases import PHASES, StepPhases
from rosy_sim.world.time_step import STEP


@given(st.lists(st.tuples(st.floats(0, 1e6), st.booleans()), max_size=100))
def test_phases_are_even_and_begin_within_a_step(asked: list[tuple[float, bool]]) -> None:
    phases, taken = StepPhases(), [0] * PHASES
    for now, stays in asked:
        phase, due = phases.enter(now)
        assert now <= due < now + STEP
        assert taken[phase] == min(taken)
        taken[phase] += 1
        if not stays:
            phases.leave(phase)
            taken[phase] -= 1


def test_a_run_that_is_alone_begins_at_once() -> None:
    _, due = StepPhases().enter(12.0301)
    assert due - 12.0301 <= STEP / PHASES


def test_runs_that_begin_together_do_not_step_together() -> None:
    phases = StepPhases()
    assert sorted(phases.enter(5.0)[0] for _ in range(PHASES)) == list(range(PHASES))
