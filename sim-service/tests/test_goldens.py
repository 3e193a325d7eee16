"""Replays every golden conversation that names the simulator, the service or the worker's service side."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import msgspec
import pytest

from rosy_sim.wire import page
from rosy_sim.wire.holder import ask, read_line
from rosy_sim.wire.link import Ended, Settled, SimulatorLink, start_line, step_line, stop_line
from rosy_sim.wire.topics import (
    COMMAND_TOPICS,
    EVENT_TOPICS,
    ODOM,
    SENSOR_TOPICS,
    event_message,
    odometry_line,
    show_command,
    show_event,
)
from rosy_sim.wire.worker import Answer, WorkerStream
from rosy_sim.world.events import Event

GOLDENS = Path(__file__).resolve().parents[2] / "protocol" / "goldens"


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


def sensed(line: dict[str, Any]) -> Event | None:
    """The event of a sensor message; ``None`` for odometry. Fails when we would not send it like that."""
    if line["topic"] == ODOM:
        assert shape(line) == shape(json.loads(odometry_line((0.0, 0.0, 0.0, 0.0, 0.0))))
        return None
    [(kind, field)] = [(k, f) for k, (topic, _, f) in EVENT_TOPICS.items() if topic == line["topic"]]
    msg = line["msg"]
    event = Event(kind, msg[field] if field else 0, msg["state"])
    topic, ours = event_message(event)
    assert (topic, {**ours, **({"bottom": msg["bottom"]} if kind == "cliff" else {})}) == (line["topic"], msg)
    return event


@pytest.mark.parametrize("path", files("link"), ids=name)
def test_the_simulator_holds_each_conversation_with_a_program(path: Path) -> None:
    link = SimulatorLink()
    events: list[str] = []
    commands: list[str] = []
    for speaker, line in conversation(path):
        if speaker == "sim":
            match line["op"]:
                case "start":
                    assert line == json.loads(start_line(line["seed"], line["trace"]))
                    traced = line["trace"]
                case "publish":
                    event = sensed(line)
                    events += [show_event(event)] if event is not None else []
                case "step":
                    assert line == json.loads(step_line(line["step"], line.get("memory", False)))
                    link.step = line["step"]
                case op:
                    assert (op, line) == ("stop", json.loads(stop_line()))
            continue
        if line["op"] in ("advertise", "subscribe"):
            assert {**COMMAND_TOPICS, **SENSOR_TOPICS}[line["topic"]] == line["type"]
        for message in link.feed(json.dumps(line).encode() + b"\n"):
            if isinstance(message, Settled | Ended):
                if traced:
                    # User events, which only the program knows, stand between those it sensed.
                    assert [shown for shown in message.events if shown in events] == events
                    assert message.commands == commands
                events, commands = [], []
            elif line["op"] == "publish":
                commands.append(show_command(message))  # type: ignore[arg-type]


@pytest.mark.parametrize("path", files("link"), ids=name)
def test_every_split_of_a_programs_words_gives_the_same_messages(path: Path) -> None:
    spoken = [line for speaker, line in conversation(path) if speaker == "prog"]
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
    for speaker, line in conversation(path):
        if speaker == "worker":
            [answer] = stream.feed(json.dumps(line).encode() + b"\n")
            assert isinstance(answer, Answer)
            understood = json.loads(msgspec.json.encode(answer))
            assert {k: v for k, v in understood.items() if k in line and k not in ("problems", "problem")} == {
                k: v for k, v in line.items() if k in understood and k not in ("problems", "problem")
            }


@pytest.mark.parametrize("path", files("page"), ids=name)
def test_the_service_speaks_each_conversation_with_a_page(path: Path) -> None:
    decoder = msgspec.json.Decoder(page.Answer)
    for speaker, line in conversation(path):
        if speaker == "page":
            assert page.read_request(json.dumps(line))
        else:
            assert json.loads(page.encode(decoder.decode(json.dumps(line)))) == line


@pytest.mark.parametrize("path", files("holder"), ids=name)
def test_the_service_holds_each_conversation_about_a_robot(path: Path) -> None:
    for speaker, line in conversation(path):
        if speaker == "holder":
            understood = json.loads(msgspec.json.encode(read_line(json.dumps(line).encode())))
            assert {k: v for k, v in understood.items() if k != "problem"} == {
                k: v for k, v in line.items() if k != "problem"
            }
        else:
            assert json.loads(ask(line["op"])) == line


def test_there_are_goldens_for_each_border_of_the_service() -> None:
    assert files("link")
    assert files("page")
    assert files("holder")
