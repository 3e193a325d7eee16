"""Replays every golden conversation that names the simulator, the service or the worker's service side."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import msgspec
import pytest

from rosy_sim.wire import page
from rosy_sim.wire.link_messages import Ended, Settled
from rosy_sim.wire.page import jobs, lesson_rehearsals, room_tests
from rosy_sim.wire.robot_link import SimulatorLink, start_line, step_line, stop_line
from rosy_sim.wire.robot_process import decode_line, encode_alive, encode_request, encode_switch
from rosy_sim.wire.topics import CHANNELS, COMMAND_TOPICS, ODOMETRY, SENSOR_TOPICS, odometry_line, reading_line
from rosy_sim.wire.worker import Answer, WorkerStream
from rosy_sim.world.events import Command, Reading

GOLDENS = Path(__file__).resolve().parents[3] / "protocol" / "goldens"


def files(kind: str) -> list[Path]:
    return sorted((GOLDENS / kind).glob("*.jsonl"))


def conversation(path: Path) -> list[tuple[str, dict[str, Any]]]:
    lines = [json.loads(line) for line in path.read_text("utf-8").splitlines() if line.strip()]
    return [(line["from"], line["line"]) for line in lines]


def name(path: Path) -> str:
    return path.stem


def shape(value: Any) -> Any:
    """Names and nesting, without the numbers."""
    return {key: shape(inner) for key, inner in value.items()} if isinstance(value, dict) else None


def sensed(line: dict[str, Any]) -> Reading | None:
    """The reading of a sensor message; ``None`` for odometry. Fails when we would not send it like that."""
    if line["topic"] == ODOMETRY.topic:
        assert shape(line) == shape(json.loads(odometry_line((0.0, 0.0, 0.0, 0.0, 0.0))))
        return None
    [channel] = [c for c in CHANNELS.values() if c.topic == line["topic"]]
    reading = Reading(channel.name, channel.read(line["msg"]))
    ours = json.loads(reading_line(reading))
    assert {**line["msg"], **ours["msg"]} == line["msg"]
    return reading


@pytest.mark.parametrize("path", files("link"), ids=name)
def test_the_simulator_holds_each_conversation_with_a_program(path: Path) -> None:
    link = SimulatorLink()
    events = 0
    commands = 0
    for robot_executable, line in conversation(path):
        if robot_executable == "sim":
            match line["op"]:
                case "start":
                    assert line == json.loads(start_line(line["seed"], line["trace"], "quiet" in line))
                    traced = line["trace"]
                case "publish":
                    events += sensed(line) is not None
                case "step":
                    asked = [line.get(what, False) for what in ("memory", "firings", "late")]
                    assert line == json.loads(step_line(line["step"], *asked))
                    link.step = line["step"]
                case op:
                    assert (op, line) == ("stop", json.loads(stop_line()))
            continue
        if line["op"] in ("advertise", "subscribe"):
            assert {**COMMAND_TOPICS, **SENSOR_TOPICS}[line["topic"]] == line["type"]
        for message in link.feed(json.dumps(line).encode() + b"\n"):
            if isinstance(message, Settled | Ended):
                assert len(message.sensed) == events
                if traced:
                    # User events, which only the program knows, stand between those it sensed.
                    assert [shown for shown in message.events if shown in message.sensed] == message.sensed
                    assert len(message.commands) == commands
                events = commands = 0
            elif line["op"] == "publish":
                assert isinstance(message, Command)
                commands += 1


@pytest.mark.parametrize("path", files("link"), ids=name)
def test_every_split_of_a_programs_words_gives_the_same_messages(path: Path) -> None:
    spoken = [line for robot_executable, line in conversation(path) if robot_executable == "prog"]
    first = next(i for i, line in enumerate(spoken) if line["op"] in ("settled", "ended"))
    batch = b"".join(json.dumps(line).encode() + b"\n" for line in spoken[: first + 1])

    def fed(*pieces: bytes) -> list[object]:
        link = SimulatorLink()
        link.step = 0
        return [message for piece in pieces for message in link.feed(piece)]

    whole = fed(batch)
    assert all(fed(batch[:cut], batch[cut:]) == whole for cut in range(len(batch)))


@pytest.mark.parametrize("path", files("worker"), ids=name)
def test_the_service_understands_all_the_worker_says(path: Path) -> None:
    stream = WorkerStream()
    for robot_executable, line in conversation(path):
        if robot_executable == "worker":
            [answer] = stream.feed(json.dumps(line).encode() + b"\n")
            assert isinstance(answer, Answer)
            understood = json.loads(msgspec.json.encode(answer))
            assert {k: v for k, v in understood.items() if k in line and k not in ("problems", "problem")} == {
                k: v for k, v in line.items() if k in understood and k not in ("problems", "problem")
            }


@pytest.mark.parametrize("path", files("page"), ids=name)
def test_the_service_speaks_each_conversation_with_a_page(path: Path) -> None:
    decoder = msgspec.json.Decoder(page.Answer)
    for robot_executable, line in conversation(path):
        if robot_executable == "page":
            assert page.read_request(json.dumps(line))
        else:
            assert json.loads(page.encode(decoder.decode(json.dumps(line)))) == line


@pytest.mark.parametrize("path", files("holder"), ids=name)
def test_the_service_holds_each_conversation_about_a_robot(path: Path) -> None:
    for robot_executable, line in conversation(path):
        if robot_executable == "holder":
            understood = json.loads(msgspec.json.encode(decode_line(json.dumps(line).encode())))
            assert {k: v for k, v in understood.items() if k != "problem"} == {
                k: v for k, v in line.items() if k != "problem"
            }
        else:
            if line["op"] == "alive":
                sent = encode_alive(line["time"])
            else:
                sent = encode_switch(line["op"], line["on"]) if "on" in line else encode_request(line["op"])
            assert json.loads(sent) == line


def test_there_are_goldens_for_each_border_of_the_service() -> None:
    assert files("link")
    assert files("page")
    assert files("holder")


@pytest.mark.parametrize("path", files("room-test"), ids=name)
def test_the_service_reads_and_answers_each_test_in_many_rooms(path: Path) -> None:
    for end, line in conversation(path):
        if end == "service":
            answer = msgspec.convert(line, jobs.Queued | room_tests.Progress | room_tests.Reported | jobs.Failed)
            assert json.loads(jobs.encode_answer(answer)) == line
        elif line["rooms"]:
            assert msgspec.to_builtins(room_tests.read_test(json.dumps(line))) == {**line, "world": None}
        else:
            with pytest.raises(jobs.BadJob):
                room_tests.read_test(json.dumps(line))


@pytest.mark.parametrize("path", files("rehearsals"), ids=name)
def test_the_service_reads_and_answers_the_rehearsals_of_a_lesson(path: Path) -> None:
    for end, line in conversation(path):
        if end == "service":
            answer = msgspec.convert(line, jobs.Queued | lesson_rehearsals.AttemptJudged | jobs.Failed)
            assert json.loads(jobs.encode_answer(answer)) == line
        elif line["attempts"]:
            request = lesson_rehearsals.read_request(json.dumps(line))
            assert [attempt.source for attempt in request.attempts] == [one["source"] for one in line["attempts"]]
            assert request.world == line["world"]
        else:
            with pytest.raises(jobs.BadJob):
                lesson_rehearsals.read_request(json.dumps(line))
