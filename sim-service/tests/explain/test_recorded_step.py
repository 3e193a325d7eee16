"""A step that keeps its firings as they were told says the same as one that has read them."""

import msgspec
import pytest

from rosy_sim.explain.recorded_run import RecordedRun
from rosy_sim.explain.recorded_step import EncodedContent
from rosy_sim.wire.firing import Cause, Firing, Given, count_firings, read_firings
from rosy_sim.world.events import velocity


def firing(number: int) -> Firing:
    gave = [Given("command", "Velocity 0.5 0.0", "Velocity"), Given("event", "Moved 1.0", "Moved", number)]
    return Firing(number, "move", 0, Cause("tick", instant=number), [], gave)


def told(*firings: Firing) -> EncodedContent:
    return EncodedContent(msgspec.json.encode(firings), ["Bumper"], [velocity(0.5, 0.0) for _ in firings])


def test_it_is_read_when_something_asks() -> None:
    step = told(firing(3), firing(4))
    assert step.count == 2
    assert step.firings == [firing(3), firing(4)]
    assert step.events == ["Bumper", "Moved 1.0", "Moved 1.0"]
    assert [command.value for command in step.commands] == ["Velocity 0.5 0.0"] * 2
    assert step.first_number == 3


def test_a_run_finds_its_firings_and_keeps_the_latest() -> None:
    run = RecordedRun(most=5)
    for step in range(10):
        run.add(step / 50, told(firing(2 * step), firing(2 * step + 1)))
        run.add(step / 50 + 0.01, EncodedContent(b"[]", ["Bumper"], []))
    assert run.count == 4
    assert [found.n for _, found in run.firings()] == [16, 17, 18, 19]
    assert run.firing(15) is None
    assert run.firing(17) == firing(17)
    assert run.time_of(firing(17)) == 8 / 50
    assert run.known_since == 7 / 50 + 0.01


@pytest.mark.parametrize("bad", [b"null", b"7", b'[{"n":1}]', b'[{"n":"x"}]', b"", b'["\xff"]', b"[" * 5000])
def test_what_is_no_list_of_firings_tells_nothing(bad: bytes) -> None:
    step = EncodedContent(bad, [], [])
    assert step.firings == read_firings(bad) == []
    assert step.first_number == -1


def test_long_firings_count_more() -> None:
    assert count_firings(b'[{"n":1}]') == 1
    assert count_firings(b'[{"n":1,"text":"' + b"x" * 20_000 + b'"}]') == 10
