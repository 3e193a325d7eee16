"""Lines of the robot link become messages, and the same lines again, byte for byte."""

from __future__ import annotations

import json

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rosy_sim.recordings.link_log import LinkLine, LogEnd, Source, read_log, to_line, to_message

SOURCES: list[Source] = ["to_program", "from_program", "to_robot"]

LINES = [
    b'{"op":"publish","topic":"/odom","msg":{"twist":{"twist":{"linear":{"x":0.5}}}}}',
    b'{"op":"publish","topic":"/rosy/to_program","msg":{"data":1}}',
    b'{"op": "publish", "topic": "/spaced", "msg": {}}',
    b'{"op":"publish","topic":"/list","msg":[1,2]}',
    b'{"op":"step","step":3,"time":0.06}',
    b'{"base64":"no"}',
    b'{"base64":"bm8="}',
    b"\xff\x00 not JSON",
    b"",
]


@pytest.mark.parametrize("source", SOURCES)
@pytest.mark.parametrize("line", LINES)
def test_a_line_survives_being_a_message(line: bytes, source: Source) -> None:
    message = to_message(source, line)
    assert isinstance(json.loads(message.data), dict)
    assert to_line(source, message) == line


JSON = st.recursive(
    st.none() | st.booleans() | st.floats(allow_nan=False, allow_infinity=False) | st.text(),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(), inner, max_size=3),
    max_leaves=8,
)


@given(st.binary() | JSON.map(lambda value: json.dumps(value).encode()), st.sampled_from(SOURCES))
def test_any_line_survives(line: bytes, source: Source) -> None:
    assert to_line(source, to_message(source, line)) == line


@given(JSON, st.text(), st.booleans(), st.sampled_from(SOURCES))
def test_any_publication_survives(msg: object, topic: str, is_compact: bool, source: Source) -> None:
    separators = (",", ":") if is_compact else None
    line = json.dumps({"op": "publish", "topic": topic, "msg": msg}, separators=separators).encode()
    assert to_line(source, to_message(source, line)) == line


def test_what_is_published_is_a_message_on_its_topic() -> None:
    assert to_message("to_program", LINES[0]) == ("/odom", b'{"twist":{"twist":{"linear":{"x":0.5}}}}')
    assert to_message("to_program", LINES[4]).topic == "/rosy/to_program"


def test_a_log_is_read_up_to_a_line_that_is_not_whole() -> None:
    whole = [b'12 > {"op":"stop"}\n', b"13 < {}\n", b"14 ! x y\n"]
    expected = [LinkLine(12, "to_program", b'{"op":"stop"}'), LinkLine(13, "from_program", b"{}")]
    assert list(read_log([*whole, b"15 > {"])) == [*expected, LinkLine(14, "to_robot", b"x y")]
    assert list(read_log([*whole[:2], b". 7\n", whole[2]])) == [*expected, LogEnd(7)]
    assert list(read_log([*whole[:2], b"nonsense\n", whole[2]])) == expected
