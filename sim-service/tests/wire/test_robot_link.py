"""The robot link without I/O: any split gives the same messages, any break of the rules is found."""

from __future__ import annotations

import json

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rosy_sim.run.steps.lockstep import Lockstep
from rosy_sim.wire.link_messages import Ended, Ready, Settled
from rosy_sim.wire.robot_link import MAX_COMMANDS, MAX_LINE, LinkError, SimulatorLink, step_line
from rosy_sim.wire.topics import odometry_line
from rosy_sim.world.events import Command, velocity

from ..conftest import hall

READY = b'{"op":"advertise","topic":"/rosy/say","type":"std_msgs/String"}\n{"op":"ready"}\n'
TALK = READY + (
    b'{"op":"publish","topic":"/mobile_base/commands/velocity","msg":{"linear":{"x":0.5,"y":0},"angular":{"z":-1}}}\n'
    b'{"op":"publish","topic":"/mobile_base/commands/led2","msg":{"value":3}}\n'
    b'{"op":"publish","topic":"/mobile_base/commands/sound","msg":{"value":6}}\n'
    b'{"op":"publish","topic":"/rosy/say","msg":{"data":"gr\xc3\xbc\xc3\x9fe \\u00e9"}}\n'
    b'{"op":"settled","step":0,"fired":["a","b"]}\n'
    b'{"op":"ended","how":"done"}\n'
)


def link() -> SimulatorLink:
    made = SimulatorLink()
    made.step = 0
    return made


def test_a_conversation_gives_its_messages() -> None:
    messages = link().feed(TALK)
    assert messages == [
        Ready(),
        velocity(0.5, -1.0),
        Command("Led2", (3,)),
        Command("Sound", (6,)),
        Command("Say", ("grüße é",)),
        Settled(0, ["a", "b"]),
        Ended("done"),
    ]


def test_every_split_gives_the_same_messages() -> None:
    whole = link().feed(TALK)
    for cut in range(len(TALK) + 1):
        one = link()
        assert one.feed(TALK[:cut]) + one.feed(TALK[cut:]) == whole


@given(st.lists(st.integers(0, len(TALK)), max_size=20))
def test_any_pieces_give_the_same_messages(cuts: list[int]) -> None:
    one, messages = link(), []
    for start, end in zip([0, *sorted(cuts)], [*sorted(cuts), len(TALK)], strict=True):
        messages += one.feed(TALK[start:end])
    assert messages == link().feed(TALK)


@pytest.mark.parametrize(
    "line",
    [
        b"",
        b"{}",
        b"[]",
        b"\xff",
        b'{"op":"fly"}',
        b'{"op":"settled","step":1,"fired":[]}',
        b'{"op":"settled","step":"0","fired":[]}',
        b'{"op":"settled","step":0,"fired":[1]}',
        b'{"op":"publish","topic":"/nowhere","msg":{}}',
        b'{"op":"publish","topic":"/rosy/say","msg":7}',
        b'{"op":"publish","topic":"/mobile_base/commands/led1","msg":{"value":4}}',
        b'{"op":"publish","topic":"/mobile_base/commands/sound","msg":{"value":-1}}',
        b'{"op":"publish","topic":"/mobile_base/commands/velocity","msg":{"linear":{"x":1e999}}}',
        b'{"op":"publish","topic":"/mobile_base/commands/velocity","msg":{"linear":{"x":NaN}}}',
        b'{"op":"ended","how":"bored"}',
        b'{"op":"ready"}',
        b"[" * 10_000,
    ],
)
def test_what_breaks_the_rules_is_found(line: bytes) -> None:
    one = link()
    one.feed(READY)
    with pytest.raises(LinkError):
        one.feed(line + b"\n")


def test_a_flood_of_commands_is_stopped() -> None:
    one = link()
    one.feed(READY)
    command = b'{"op":"publish","topic":"/rosy/say","msg":{"data":"x"}}\n'
    one.feed(command * MAX_COMMANDS)
    with pytest.raises(LinkError):
        one.feed(command)


def test_a_command_is_refused_after_the_end_also_when_its_line_was_read_before() -> None:
    command = TALK.splitlines(keepends=True)[2]
    for _ in range(2):
        one = link()
        assert one.feed(READY + command) == [Ready(), velocity(0.5, -1.0)]
        one.feed(b'{"op":"ended","how":"done"}\n')
        with pytest.raises(LinkError):
            one.feed(command)


def test_a_line_without_end_is_stopped() -> None:
    one = link()
    one.feed(b"x" * (MAX_LINE - 10))
    with pytest.raises(LinkError):
        one.feed(b"x" * 100)


@given(st.binary(max_size=300))
def test_any_bytes_give_messages_or_a_link_error(data: bytes) -> None:
    try:
        link().feed(data + b"\n")
    except LinkError:
        return


def test_a_step_is_sensed_sent_and_integrated() -> None:
    lockstep = Lockstep(hall(), seed=5, trace=True)
    assert json.loads(lockstep.begin()) == {"op": "start", "protocol": 1, "seed": 5, "trace": True, "quiet": True}
    assert lockstep.feed(READY) == "ready"
    lines = [json.loads(line) for line in lockstep.sense().splitlines()]
    assert {line["op"] for line in lines[:-1]} == {"publish"}
    assert [lines[0]["topic"], lines[-2]["topic"]] == ["/mobile_base/events/robot_state", "/odom"]
    assert lines[-1] == {"op": "step", "step": 0, "time": 0.0}
    assert lockstep.feed(b'{"op":"settled","step":0,"fired":["f"],"events":["Online"],"commands":[]}\n') == "settled"
    trace = json.loads(lockstep.trace_line())
    assert trace == {
        "t": 0.0, "x": 10.0, "y": 10.0, "theta": 0.0, "v": 0.0, "w": 0.0,
        "events": ["Online"], "commands": [], "fired": ["f"],
    }  # fmt: skip
    lockstep.integrate()
    assert lockstep.time == 0.02


@given(*[st.floats(-1e6, 1e6)] * 5)
def test_odometry_is_json_that_reads_back(x: float, y: float, theta: float, v: float, w: float) -> None:
    msg = json.loads(odometry_line((x, y, theta, v, w)))["msg"]
    assert msg["pose"]["pose"]["position"] == {"x": x, "y": y}
    assert msg["twist"]["twist"] == {"linear": {"x": v}, "angular": {"z": w}}


@pytest.mark.parametrize("step", [0, 1, 3, 35, 10**6])
def test_times_are_the_nearest_numbers_to_the_decimal(step: int) -> None:
    assert json.loads(step_line(step)) == {"op": "step", "step": step, "time": float(f"{step * 2 / 100:.2f}")}
