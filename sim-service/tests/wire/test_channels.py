"""The table-driven codec of channels: it reads what it has written, and refuses what does not fit."""

from __future__ import annotations

import json
import subprocess
import sys
from typing import Any

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from rosy_sim.robot_description import ROBOTS
from rosy_sim.wire.channels import BadMessage, Channel, simulated_channels

CHANNELS = simulated_channels()


def values_of(channel: Channel) -> st.SearchStrategy[tuple[Any, ...]]:
    """Values that a message of a channel can have."""

    def leaf(kind: str, codes: frozenset[int], yaw: bool, scale: float) -> st.SearchStrategy[Any]:
        if scale != 1.0:
            # A whole number in the message.
            return st.integers(0, 255).map(lambda n: n * scale)
        if yaw:
            return st.floats(-3.1, 3.1)
        if codes:
            return st.sampled_from(sorted(codes))
        whole: dict[str, st.SearchStrategy[Any]] = {
            "Double": st.floats(-1e6, 1e6),
            "Bool": st.integers(0, 1),
            "String": st.text(),
        }
        return whole.get(kind, st.integers(0, 255))

    if channel.places[-1].ranges:
        # Two angles, the shortest and the longest distance, and distances between them.
        head = st.tuples(st.floats(-3, 3), st.floats(-1, 1), st.floats(0.01, 0.1), st.floats(10, 20))
        return st.builds(lambda a, b: (*a, *b), head, st.lists(st.floats(0.1, 9), max_size=20))
    return st.tuples(*[leaf(p.leaf.kind, p.leaf.codes, p.yaw, p.scale) for p in channel.places])


@pytest.mark.parametrize("name", list(CHANNELS))
@given(data=st.data())
def test_a_channel_reads_what_it_has_written(name: str, data: st.DataObject) -> None:
    channel = CHANNELS[name]
    values = data.draw(values_of(channel))
    line = json.loads(channel.line(values))
    assert (line["op"], line["topic"]) == ("publish", channel.topic)
    assert channel.read(line["msg"]) == pytest.approx(values)
    assert channel.read(channel.full(values, 1.5, 7)) == pytest.approx(values)


@pytest.mark.parametrize("name", list(CHANNELS))
@given(data=st.data())
def test_a_line_has_the_bytes_of_its_encoded_message(name: str, data: st.DataObject) -> None:
    channel = CHANNELS[name]
    values = data.draw(values_of(channel))
    encoded = msgspec.json.encode({"op": "publish", "topic": channel.topic, "msg": channel.message(values)})
    assert channel.line(values) == encoded + b"\n"


@pytest.mark.parametrize("values", [(-0.0, 1e-7, 0.0, 1e22, 5e-324), (0, 1, 2, -3, 4), (float("nan"),) * 5])
def test_the_odometry_line_has_the_bytes_of_its_encoded_message(values: tuple[Any, ...]) -> None:
    odometry = CHANNELS["Odometry"]
    encoded = msgspec.json.encode({"op": "publish", "topic": odometry.topic, "msg": odometry.message(values)})
    assert odometry.line(values) == encoded + b"\n"


@pytest.mark.parametrize(
    ("name", "msg"),
    [
        ("Led1", {"value": 4}),
        ("Led1", {"value": 1.0}),
        ("Led1", {"value": True}),
        ("Velocity", {"linear": {"x": "fast"}}),
        ("Velocity", 3),
        ("Say", {"data": 3}),
    ],
)
def test_a_channel_refuses_what_does_not_fit(name: str, msg: Any) -> None:
    with pytest.raises(BadMessage):
        CHANNELS[name].read(msg)


def test_a_field_that_is_missing_is_zero_as_in_ros() -> None:
    assert CHANNELS["Velocity"].read({"linear": {"x": 0.5}}) == (0.5, 0.0)


def test_the_haskell_modules_are_generated_from_the_descriptions() -> None:
    root = ROBOTS.parent.parent
    made = subprocess.run([sys.executable, root / "scripts" / "robots.py", "--check"], capture_output=True, text=True)
    assert made.returncode == 0, made.stdout
