"""Pages whose messages are many, long or take long are read more slowly, with a clock of the test's own."""

from __future__ import annotations

import pytest

from rosy_sim.web.pacing.reading_pace import ReadingPace


def seconds_to_read(messages: int, characters: int, work: float) -> float:
    """The s in which a page's messages are read that are all there at once."""
    now = 0.0
    pace = ReadingPace(now)
    for _ in range(messages):
        now += work
        now += pace.wait(characters, work, now)
    return now


@pytest.mark.parametrize(
    ("messages", "characters", "work", "seconds"),
    [
        pytest.param(100, 100, 0.0005, 0.05, id="an input in each step is read at once"),
        pytest.param(60, 5000, 0.003, 0.18, id="a minute of typing is read at once"),
        pytest.param(1500, 100, 0.01, 147.51, id="work on the event loop gets a tenth of it"),
        pytest.param(1, 0, 8.5, 8.5 + 82.5, id="one long piece of work is waited for"),
        pytest.param(2200, 0, 0.0, 20.0, id="a hundred messages a second"),
        pytest.param(300, 20_000, 0.0, 31.0, id="long messages count as several"),
    ],
)
def test_seconds_to_read(messages: int, characters: int, work: float, seconds: float) -> None:
    assert seconds_to_read(messages, characters, work) == pytest.approx(seconds)


def test_what_was_spent_comes_back() -> None:
    pace = ReadingPace(0)
    assert pace.wait(0, 1, 1) > 7
    assert pace.wait(0, 0, 20) == 0
