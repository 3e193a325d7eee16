"""When deleted things are removed for good, also by a clock that jumps."""

from __future__ import annotations

import pytest

from rosy_sim.classroom.store.retention import DELETED_KEPT, NOTICE, kept_until, next_step

DAY, HOUR = 86_400.0, 3_600.0
AT = 1_000 * DAY
"""When something was deleted."""


def starts(*clock: float) -> list[str]:
    """The steps at starts of Rosy when its clock shows these times, until it is removed."""
    announced: float | None = None
    steps: list[str] = []
    for now in clock:
        step = next_step(AT, announced, AT + now)
        steps.append(step)
        if step == "remove":
            break
        announced = AT + now if step == "announce" else None if step == "withdraw" else announced
    return steps


def test_it_is_announced_after_its_time_and_removed_a_day_later() -> None:
    late = DELETED_KEPT + 1
    assert starts(0, DELETED_KEPT, late, late + HOUR, late + NOTICE) == ["keep", "keep", "announce", "keep", "remove"]
    # After the holidays as well.
    assert starts(90 * DAY, 91 * DAY) == ["announce", "remove"]


@pytest.mark.parametrize("jump", [sign * size for sign in (1, -1) for size in (HOUR, 12 * HOUR, 31 * DAY, 3_650 * DAY)])
def test_a_clock_that_jumps_and_is_put_right_within_a_day_removes_nothing(jump: float) -> None:
    """However often Rosy is started meanwhile, on the day of the deletion or on a later one within its time."""
    for day in (0, 1, 15, 29):
        right = day * DAY
        wrong = [right + jump + hours * HOUR for hours in (0, 1, 5, 23)]
        steps = starts(right, *wrong, right + DAY / 2, DELETED_KEPT)
        assert "remove" not in steps
        # No announcement of the wrong clock is left.
        assert steps[-1] == "keep"


@pytest.mark.parametrize("announced", [None, AT + DELETED_KEPT + 5, AT + 90 * DAY])
def test_until_the_day_that_is_shown_nothing_is_removed_and_then_something_happens(announced: float | None) -> None:
    last = kept_until(AT, announced)
    assert next_step(AT, announced, last - 1) == "keep"
    assert next_step(AT, announced, last + 1) == ("announce" if announced is None else "remove")


def test_an_announcement_from_the_future_counts_for_nothing() -> None:
    late = DELETED_KEPT + DAY
    assert next_step(AT, AT + late + 365 * DAY, AT + late) == "announce"
