"""The frame rate falls while steps begin late, and rises again."""

from __future__ import annotations

from itertools import pairwise

from hypothesis import given
from hypothesis import strategies as st

from rosy_sim.run.frame_rate import LOWEST_RATE, FrameRate
from rosy_sim.run.lateness import LATE, Lateness

HIGHEST = 60.0


class Steps:
    """Steps of runs, of which a share is late."""

    def __init__(self) -> None:
        self.lateness = Lateness()
        self.rate = FrameRate(HIGHEST, self.lateness)
        self.now = 0.0

    def pass_second(self, late_share: float) -> float:
        """The rate after a second with 1,000 steps, in which pages ask 50 times."""
        for _ in range(50):
            self.now += 0.02
            for number in range(20):
                self.lateness.add(2 * LATE if number < 20 * late_share else 0.0)
            rate = self.rate.at(self.now)
        return rate


def test_pages_get_all_frames_while_steps_begin_in_time() -> None:
    steps = Steps()
    assert [steps.pass_second(0.0) for _ in range(3)] == [HIGHEST] * 3


def test_the_rate_falls_to_the_lowest_within_six_seconds_and_no_further() -> None:
    steps = Steps()
    rates = [steps.pass_second(0.5) for _ in range(9)]
    assert rates[1] < 0.8 * HIGHEST
    assert rates[5:] == [LOWEST_RATE] * 4


def test_the_rate_recovers_within_half_a_minute_when_steps_are_in_time_again() -> None:
    steps = Steps()
    for _ in range(9):
        steps.pass_second(0.5)
    rates = [steps.pass_second(0.0) for _ in range(27)]
    assert all(before <= after for before, after in pairwise([LOWEST_RATE, *rates]))
    assert rates[-1] == HIGHEST


def test_one_late_step_in_two_hundred_changes_nothing() -> None:
    steps = Steps()
    for number in range(1000):
        steps.now += 0.02
        steps.lateness.add(2 * LATE if number % 200 == 199 else 0.0)
        assert steps.rate.at(steps.now) == HIGHEST


def test_after_an_hour_without_frames_the_overload_of_the_hour_before_is_forgotten() -> None:
    steps = Steps()
    for _ in range(9):
        steps.pass_second(0.5)
    steps.now += 3600
    assert steps.rate.at(steps.now) >= 0.7 * HIGHEST


@given(st.lists(st.tuples(st.floats(0, 5), st.floats(0, 0.1)), max_size=200))
def test_the_rate_stays_between_the_lowest_and_the_highest(steps: list[tuple[float, float]]) -> None:
    lateness = Lateness()
    rate, now = FrameRate(HIGHEST, lateness), 0.0
    for passed, late in steps:
        now += passed
        lateness.add(late)
        assert LOWEST_RATE <= rate.at(now) <= HIGHEST
