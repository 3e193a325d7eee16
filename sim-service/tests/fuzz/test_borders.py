"""
Fuzz test of every border of the service that reads foreign bytes: a case is a value, or is refused with the border's
own exception and a sentence. Nothing else may come out.

In ``nightly`` there are 1,000,000 cases.
"""

from __future__ import annotations

import json
import random
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import msgspec
import pytest

from rosy_sim.classroom.messages.board_messages import BoardRequest, read_board_request
from rosy_sim.classroom.messages.message_fields import BadRequest
from rosy_sim.classroom.messages.nickname import read_nickname
from rosy_sim.classroom.messages.projector_messages import UnlockProjector, read_projector_request
from rosy_sim.classroom.messages.pupil_messages import PupilRequest, read_pupil_request
from rosy_sim.classroom.word_list import read_words
from rosy_sim.errors import BadInput
from rosy_sim.lessons.program_graph import read_graph
from rosy_sim.programs.input_file import read_inputs
from rosy_sim.programs.program_file import read_program
from rosy_sim.rooms.generation.families import read_family
from rosy_sim.run.steps.hands import Hand, read_hands
from rosy_sim.web.sessions.simulator.ros_bridge import RosBridge
from rosy_sim.wire import page, robot_process, worker
from rosy_sim.wire.channels import BadMessage
from rosy_sim.wire.line_splitter import LineTooLong
from rosy_sim.wire.link_messages import ProgramLine
from rosy_sim.wire.page import lesson_rehearsals, room_tests
from rosy_sim.wire.page.jobs import BadJob
from rosy_sim.wire.robot_link import LinkError, SimulatorLink
from rosy_sim.wire.topics import COMMAND_TOPICS, TopicMessage, read_message
from rosy_sim.wire.user_input import TimedInput, published, user_actions
from rosy_sim.world.arena import read_arena
from rosy_sim.world.events import Command
from rosy_sim.world.field_readers import ArenaError
from rosy_sim.world.properties import BadProperty, read_properties

from ..extent import NIGHTLY, SEED
from .mutation import Fuzzer, encoded, generated

ROOT = Path(__file__).resolve().parents[3]

MESSAGES = 45_000 if NIGHTLY else 1_500
"""Cases of each border."""


@dataclass(frozen=True)
class Border:
    """What reads, what it may raise, and values to start from: of a type, or seeds."""

    name: str
    read: Callable[[bytes], object]
    refusals: tuple[type[Exception], ...]
    kind: Any = None
    seeds: Callable[[], list[Any]] = list


def lines(*globs: str) -> Callable[[], list[Any]]:
    """The messages of golden files, in both directions."""

    def found() -> list[Any]:
        values = []
        for pattern in globs:
            for path in sorted((ROOT / "protocol/goldens").glob(pattern)):
                values += [json.loads(line)["line"] for line in path.read_text().splitlines()]
        assert values, globs
        return values

    return found


def documents(*globs: str) -> Callable[[], list[Any]]:
    """JSON files of the repository."""
    return lambda: [json.loads(path.read_text()) for pattern in globs for path in sorted(ROOT.glob(pattern))]


def of_user(data: bytes) -> object:
    message = msgspec.json.decode(data, type=TimedInput)
    return [*user_actions(message), *published(message)]


def of_topic(data: bytes) -> object:
    value = msgspec.json.decode(data)
    topics = (*sorted(COMMAND_TOPICS), "/odom", "/mine")
    return read_message(topics[len(data) % len(topics)], value)


def of_program(data: bytes) -> object:
    link = SimulatorLink()
    link.step = 0
    return link.feed(data + b"\n")


def of_worker(data: bytes) -> object:
    return worker.WorkerStream().feed(data + b"\n")


def of_robot(data: bytes) -> object:
    line = robot_process.decode_line(data)
    return robot_process.read_observed(line) if isinstance(line, robot_process.CommandsLine) else line


def of_ros_client(data: bytes) -> object:
    """What one client sends, as the others see it in each encoding."""
    bridge = RosBridge()
    sender, *others = [bridge.join() for _ in range(4)]
    bridge.receive(sender, b'{"op":"advertise","topic":"/mine","type":"std_msgs/String"}', 0.0)
    bridge.receive(sender, b'{"op":"advertise","topic":"/yours","type":"my_msgs/Own"}', 0.0)
    for other, encoding in zip(others, ("none", "png", "cbor"), strict=True):
        for topic in ("/mine", "/yours", "/mobile_base/commands/velocity"):
            bridge.receive(other, encoded({"op": "subscribe", "topic": topic, "compression": encoding}), 0.0)
        bridge.receive(
            other, b'{"op":"advertise_service","type":"my_srvs/Own","service":"/%s"}' % encoding.encode(), 0.0
        )
    found = bridge.receive(sender, data, 0.1)
    for message in found:
        if isinstance(message, TopicMessage):
            bridge.post(message, 0.1)
        elif isinstance(message, Command):
            bridge.post_command(message, 0.1)
    bridge.leave(sender)
    return found


def of_hands(data: bytes) -> object:
    return read_hands(msgspec.json.decode(data, type=list[Hand]))


def of_room(data: bytes) -> object:
    return read_arena(msgspec.json.decode(data))


JSON = (msgspec.DecodeError, UnicodeDecodeError, RecursionError)
"""What msgspec says of bytes; for readers to which a caller gives a value that was decoded."""

BORDERS = [
    Border("page", page.read_request, (page.BadRequest,), page.Request),
    Border("pupil", read_pupil_request, (BadRequest,), PupilRequest),
    Border("board", read_board_request, (BadRequest,), BoardRequest),
    Border("projector", read_projector_request, (BadRequest,), UnlockProjector),
    Border("room test", room_tests.read_test, (BadJob,), room_tests.RoomTestRequest),
    Border(
        "rehearsal",
        lesson_rehearsals.read_request,
        (BadJob,),
        lesson_rehearsals.RehearsalRequest,
    ),
    Border("user input", of_user, (*JSON, BadMessage), TimedInput),
    Border(
        "topics",
        of_topic,
        (*JSON, BadMessage),
        seeds=lambda: [line["msg"] for line in lines("link/*.jsonl")() if "msg" in line],
    ),
    Border("program", of_program, (LinkError,), ProgramLine, lines("link/*.jsonl")),
    Border("worker", of_worker, (*JSON, LineTooLong), worker.Answer, lines("worker/*.jsonl")),
    Border("robot process", of_robot, JSON, robot_process.Line, lines("holder/*.jsonl")),
    Border("ROS client", of_ros_client, (), seeds=lambda: ROS_SEEDS),
    Border("hands", of_hands, JSON, list[Hand], lambda: HAND_SEEDS),
    Border("room", of_room, (*JSON, ArenaError), seeds=documents("sim-service/rosy_sim/worlds/*.json")),
    Border("graph", read_graph, JSON, seeds=documents("protocol/goldens/graphs/*.json")),
]

ROS_SEEDS: list[Any] = [
    {"op": "set_level", "level": "info", "id": "1"},
    {"op": "advertise", "topic": "/chat", "type": "std_msgs/String", "queue_size": 3, "latch": True},
    {"op": "unadvertise", "topic": "/mine"},
    {"op": "publish", "topic": "/mine", "msg": {"data": "hello"}, "latch": False},
    {"op": "publish", "topic": "/mobile_base/commands/velocity", "msg": {"linear": {"x": 0.5}, "angular": {"z": 1}}},
    {
        "op": "subscribe",
        "topic": "/odom",
        "type": "nav_msgs/Odometry",
        "throttle_rate": 10,
        "queue_length": 2,
        "fragment_size": 100,
        "compression": "png",
    },
    {"op": "subscribe", "topic": "/mobile_base/events/bumper", "id": "b", "compression": "cbor-raw"},
    {"op": "unsubscribe", "topic": "/odom", "id": "b"},
    {
        "op": "call_service",
        "service": "/rosapi/topics",
        "args": [],
        "id": "c",
        "fragment_size": 50,
        "compression": "cbor",
    },
    {"op": "call_service", "service": "/rosapi/message_details", "args": {"type": "geometry_msgs/Twist"}},
    {"op": "advertise_service", "type": "std_srvs/Empty", "service": "/clear"},
    {"op": "unadvertise_service", "service": "/clear"},
    {"op": "service_response", "service": "/clear", "id": "c", "values": {}, "result": True},
    {"op": "fragment", "id": "f", "data": '{"op":"status"}', "num": 0, "total": 1},
    {"op": "auth", "mac": "x", "client": "y", "dest": "z", "rand": "r", "t": 1, "level": "admin", "end": 2},
    {"op": "status", "level": "error", "msg": "no"},
]

HAND_SEEDS: list[Any] = [
    [[0, "Press", {"button": 0, "down": True}], [5, "Teleport", {"to": {"x": 1, "y": 1, "theta": 0}}]]
]


class Case:
    """A case is read, or refused with one of ``refusals`` and a sentence; anything else fails the test and shows it."""

    def __init__(self, name: str, case: bytes | str, refusals: tuple[type[Exception], ...]) -> None:
        self._name = name
        self._case = case
        self._refusals = refusals

    def __enter__(self) -> None:
        return None

    def __exit__(self, _kind: object, error: BaseException | None, _traceback: object) -> bool:
        if error is None:
            return False
        if not isinstance(error, self._refusals):
            raise AssertionError(f"{self._name} of seed {SEED}: {self._case[:600]!r}") from error
        assert str(error).strip(), f"{self._name} of seed {SEED} is refused without a word: {self._case[:600]!r}"
        return True


@pytest.mark.parametrize("border", BORDERS, ids=lambda border: border.name)
def test_every_case_is_a_value_or_a_refusal(border: Border) -> None:
    rng = random.Random(f"{border.name} {SEED}")
    fuzzer = Fuzzer(rng, border.kind, border.seeds())
    taken = 0
    for number in range(MESSAGES):
        case = fuzzer.case()
        with Case(f"{border.name} {number}", case, border.refusals):
            border.read(case)
            taken += 1
    # A fuzzer that everything refuses tests the first line of a reader only.
    assert MESSAGES // 50 < taken <= MESSAGES, taken


DEEP = b"[" * 200_000
HUGE = b"1" + b"0" * 400

FOUND: list[tuple[str, bytes]] = [
    # Each ended a connection or a run when the fuzzer was written.
    ("pupil", b'{"op":' + DEEP),
    ("board", b'{"op":' + DEEP),
    ("projector", b'{"op":' + DEEP),
    ("room", b'{"size":[' + HUGE + b',4],"start":{"x":1,"y":1}}'),
    (
        "user input",
        b'{"t":0,"publish":{"topic":"/mobile_base/commands/velocity","msg":{"linear":{"x":' + HUGE + b"}}}}",
    ),
    ("program", b'{"op":"publish","topic":"/mobile_base/commands/velocity","msg":{"linear":{"x":' + HUGE + b"}}}"),
    ("ROS client", b'{"op":"publish","topic":"/mobile_base/commands/velocity","msg":{"linear":{"x":' + HUGE + b"}}}"),
    ("ROS client", b'{"op":"subscribe","topic":"/odom","queue_length":' + HUGE + b"}"),
]


@pytest.mark.parametrize(("name", "case"), FOUND, ids=[name for name, _ in FOUND])
def test_what_the_fuzzer_found_is_read_or_refused(name: str, case: bytes) -> None:
    border = next(border for border in BORDERS if border.name == name)
    with Case(name, case, border.refusals):
        border.read(case)


def test_the_name_of_a_room_with_a_null_byte_is_refused() -> None:
    with pytest.raises(BadInput):
        read_family("like:/x\x00")


@pytest.mark.parametrize(
    "border", [border for border in BORDERS if border.kind is not None], ids=lambda border: border.name
)
def test_undamaged_messages_are_mostly_understood(border: Border) -> None:
    rng = random.Random(f"{border.name} {SEED}")
    taken = 0
    for _ in range(200):
        try:
            border.read(encoded(generated(border.kind, rng)))
            taken += 1
        except border.refusals:
            continue
    assert taken > 20


FILES: list[tuple[str, str, Callable[[Path], object], Callable[[], list[Any]]]] = [
    ("project", "a.rosy", read_program, documents("examples/*/program.rosy")),
    (
        "inputs",
        "a.jsonl",
        read_inputs,
        lambda: [{"t": 1.5, "press": "Button0"}, {"t": 2, "publish": {"topic": "/mine", "msg": {}}}],
    ),
]


@pytest.mark.parametrize(("kind", "name", "read", "seeds"), FILES, ids=[row[0] for row in FILES])
def test_every_file_is_read_or_refused_with_a_sentence(
    kind: str, name: str, read: Callable[[Path], object], seeds: Callable[[], list[Any]], tmp_path: Path
) -> None:
    fuzzer = Fuzzer(random.Random(f"{kind} {SEED}"), None, seeds())
    path = tmp_path / name
    for number in range(MESSAGES // 5):
        case = fuzzer.case()
        path.write_bytes(case)
        with Case(f"{kind} {number}", case, (BadInput,)):
            read(path)


WORDS: list[tuple[str, Callable[[str], object], tuple[type[Exception], ...], list[str]]] = [
    (
        "properties",
        read_properties,
        (BadProperty,),
        ["never-falls never-pushes 1 s", "covers 50 %", "returns,reaches-goal"],
    ),
    ("family", read_family, (BadInput,), ["maze", "like:room", "in:maze", "like:../x", "like:/x\x00"]),
    ("nickname", read_nickname, (), ["Ada", "Ö. d'Arc 2", "李明"]),
    ("words", read_words, (), ["river lamp garden", "River, lamp-GARDEN"]),
]


@pytest.mark.parametrize(("kind", "read", "refusals", "seeds"), WORDS, ids=[row[0] for row in WORDS])
def test_every_typed_text_is_read_or_refused(
    kind: str, read: Callable[[str], object], refusals: tuple[type[Exception], ...], seeds: list[str]
) -> None:
    rng = random.Random(f"{kind} {SEED}")
    for number in range(MESSAGES // 2):
        letters = list(rng.choice(seeds))
        for _ in range(rng.choice((1, 2, 5))):
            place = rng.randrange(len(letters) + 1)
            letters[place : place + rng.randrange(2)] = rng.choice(
                (" ", "%", "-", "1e999", "nan", "\u0301" * 9, "\ud800", "\U0001f600", "\x00", "ﷺ" * 20, ":", "/", "s")
            )
        text = "".join(letters)
        with Case(f"{kind} {number}", text, refusals):
            read(text)
