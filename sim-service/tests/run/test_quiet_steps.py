"""Steps that a program has called quiet: nothing is sent in them, and the program catches up before the next one."""

from __future__ import annotations

import json
from typing import Any

from rosy_sim.run.steps.lockstep import Lockstep
from rosy_sim.run.steps.quiet_steps import MemoryRequest
from rosy_sim.wire.topics import TopicMessage
from rosy_sim.world.events import Lift, Press

from ..conftest import hall

TWIST = "/mobile_base/commands/velocity"


def begun(drive: float = 0.0, quiet: int = 0) -> Lockstep:
    """A run whose first step has settled: the program has sent a velocity and called so many steps quiet."""
    lockstep = Lockstep(hall(), seed=1)
    assert json.loads(lockstep.begin())["quiet"] is True
    lockstep.feed(b'{"op":"ready"}\n')
    lockstep.sense()
    twist = {"op": "publish", "topic": TWIST, "msg": {"linear": {"x": drive}, "angular": {"z": 0.5}}}
    lockstep.feed(json.dumps(twist).encode() + b"\n")
    settle(lockstep, quiet)
    return lockstep


def settle(lockstep: Lockstep, quiet: int = 0) -> None:
    lockstep.feed(json.dumps({"op": "settled", "step": lockstep.step, "fired": [], "quiet": quiet}).encode() + b"\n")
    lockstep.integrate()


def sent(lockstep: Lockstep, memory: MemoryRequest = "none") -> list[dict[str, Any]]:
    return [json.loads(line) for line in lockstep.sense(memory).splitlines()]


def steps_of(lines: list[dict[str, Any]]) -> list[tuple[int, bool]]:
    return [(line["step"], line.get("late", False)) for line in lines if line["op"] == "step"]


def test_nothing_is_sent_in_a_quiet_step_and_the_world_moves_on() -> None:
    lockstep = begun(drive=0.2, quiet=40)
    for step in range(1, 41):
        assert (lockstep.step, sent(lockstep), lockstep.state) == (step, [], "settled")
        assert lockstep.settled is not None
        assert (lockstep.settled.step, lockstep.settled.fired, lockstep.commands) == (step, [], [])
        lockstep.integrate()
    assert lockstep.world.x > 10.1
    assert steps_of(sent(lockstep)) == [(40, True), (41, False)]


def test_the_late_batch_has_the_states_that_have_changed_and_the_odometry_of_the_last_quiet_step() -> None:
    quiet, asked = begun(drive=0.2, quiet=9), begun(drive=0.2)
    everything = []
    for _ in range(1, 10):
        quiet.sense()
        quiet.integrate()
        everything += sent(asked)
        settle(asked)
    latest = {(line["topic"], *line["msg"]): line for line in everything if line["op"] == "publish"}
    lines = sent(quiet)
    late = lines[: lines.index({"op": "step", "step": 9, "time": 0.18, "late": True})]
    assert late[-1]["topic"] == "/odom"
    assert {(line["topic"], *line["msg"]): line for line in late} == latest
    assert lines[len(late) + 1 :] == sent(asked), "the next batch is what it would have been"


def test_an_event_ends_the_quiet() -> None:
    lockstep = begun(quiet=100)
    assert sent(lockstep) == []
    lockstep.integrate()
    lockstep.world.apply(Press(0, True))
    lines = sent(lockstep)
    assert steps_of(lines) == [(1, True), (2, False)]
    assert [line["topic"] for line in lines if line.get("topic", "").endswith("button")]
    settle(lockstep)
    assert steps_of(sent(lockstep)) == [(3, False)], "what was called quiet before the event is quiet no more"


def test_a_message_for_the_program_ends_the_quiet() -> None:
    lockstep = begun(quiet=100)
    lockstep.post(TopicMessage("/nobody", {}))
    assert sent(lockstep) == [], "it takes no such topic"


def test_a_program_that_takes_topics_of_its_own_gets_every_step() -> None:
    lockstep = Lockstep(hall(), seed=1)
    lockstep.feed(b'{"op":"subscribe","topic":"/there","type":"a/B"}\n{"op":"ready"}\n')
    lockstep.sense()
    settle(lockstep, quiet=100)
    assert steps_of(sent(lockstep)) == [(1, False)]


def test_an_observed_step_is_never_quiet() -> None:
    lockstep = begun(quiet=100)
    lockstep.observes = True
    assert steps_of(sent(lockstep)) == [(1, False)]


def test_a_request_for_the_memory_waits_for_the_next_tick_unless_that_is_far() -> None:
    near, far = begun(quiet=4), begun(quiet=100)
    assert sent(near, "soon") == []
    assert steps_of(sent(far, "soon")) == [(1, False)]
    settle(far, quiet=100)
    assert sent(far, "soon") == [], "the program has done nothing since"
    assert steps_of(sent(begun(quiet=4), "now")) == [(1, False)]


def test_the_program_catches_up_before_it_stops() -> None:
    lockstep = begun(drive=0.2, quiet=100)
    for _ in range(10):
        lockstep.sense()
        lockstep.integrate()
    lines = [json.loads(line) for line in lockstep.stop().splitlines()]
    assert [line["op"] for line in lines[-2:]] == ["step", "stop"]
    assert steps_of(lines) == [(10, True)]
    assert [json.loads(line) for line in begun().stop().splitlines()] == [{"op": "stop"}]


def test_hands_move_the_robot_in_quiet_steps() -> None:
    lockstep = begun(drive=0.2, quiet=100)
    lockstep.world.apply(Lift("both", True))
    assert steps_of(sent(lockstep)) == [(1, False)], "the wheels tell of it"


def test_without_quiet_steps_the_program_is_asked_in_every_step() -> None:
    lockstep = Lockstep(hall(), seed=1, quiet=False)
    assert "quiet" not in json.loads(lockstep.begin())
    lockstep.feed(b'{"op":"ready"}\n')
    lockstep.sense()
    settle(lockstep, quiet=100)
    assert steps_of(sent(lockstep)) == [(1, False)]
