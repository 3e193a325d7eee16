"""A run on a base is recorded, and replayed into its program and into others."""

from __future__ import annotations

import argparse
import json
from dataclasses import replace
from functools import partial
from pathlib import Path

import pytest
from mcap.reader import make_reader

from rosy_sim.config import Config, discover
from rosy_sim.recordings.command import DIFFERENT, replay_recording
from rosy_sim.recordings.mcap_file import open_recording
from rosy_sim.recordings.replay import ReplayResult, replay
from rosy_sim.worker.blocking_worker import BlockingWorker

from ..system.real_runs import LIMITS
from .stand_in_base import recorded

pytestmark = pytest.mark.skipif(discover().robot_executable is None, reason="rosy-robot is not built")

SCRIPT = "drive:0.2 bump led:2@3 say:hi@4 done@100"


def replayed(config: Config, path: Path, source: str | None = None) -> ReplayResult:
    with open_recording(path) as recording, BlockingWorker(config) as worker:
        worker.ready()
        return replay(worker, source or recording.details.program, recording.lines())


def time_of(path: Path, step: int) -> float:
    """When a step was in the recorded run, s."""
    with open_recording(path) as recording:
        ops = [json.loads(line.text) for line in recording.lines() if line.source == "to_program"]
    return next(float(op["time"]) for op in ops if op.get("step") == step)


def test_the_same_program_sends_the_same_commands_byte_for_byte(config: Config, tmp_path: Path) -> None:
    path = recorded(config, SCRIPT, tmp_path).path
    same = replayed(config, path)
    assert same.difference is None
    assert (same.commands, same.time) == (24, time_of(path, 100))
    other = replayed(config, path, SCRIPT.replace("led:2", "led:3"))
    assert other.difference is not None
    assert other.difference.time == time_of(path, 3)
    assert json.loads(other.difference.recorded or b"")["msg"] == {"value": 2}
    assert json.loads(other.difference.replayed or b"")["msg"] == {"value": 3}
    silent = replayed(config, path, SCRIPT.replace("led:2@3 ", ""))
    assert silent.difference is not None
    assert silent.difference.replayed is None
    longer = replayed(config, path, SCRIPT.replace("done@100", "done@200"))
    assert longer.difference is not None
    assert longer.difference.time == time_of(path, 100)


PROGRAM = """
backOff :: Bumper -> Velocity
backOff (Bumper _ Pressed) = Velocity (-0.1) 0
backOff (Bumper _ Released) = Velocity 0.1 0.2

light :: Bumper -> Led1
light _ = Led1 Orange

main = simulate (backOff, light)
"""


@pytest.mark.real
@pytest.mark.skipif(not discover().worker, reason="the worker is not built")
def test_a_program_of_the_worker_sends_the_same_commands(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    config = replace(discover(), limits=LIMITS, recordings=tmp_path / "recordings")
    path = recorded(config, PROGRAM, tmp_path, seconds=1.0).path
    with path.open("rb") as stream:
        topics = {channel.topic for _, channel, _ in make_reader(stream).iter_messages()}
    assert {"/mobile_base/commands/velocity", "/mobile_base/commands/led1"} <= topics
    same = replayed(config, path)
    assert same.difference is None
    assert same.commands >= 3
    changed = tmp_path / "changed.hs"
    changed.write_text(PROGRAM.replace("-0.1", "-0.2"))
    say = partial(print, flush=True)
    options = argparse.Namespace(file=path, program=changed, encoding=None, fit=False, world=None, output=None)
    assert replay_recording(config, options, say, lambda _, __: None) == DIFFERENT
    said = capsys.readouterr().out.splitlines()[-1]
    assert '"x":-0.2' in said
    assert '"x":-0.1' in said
    changed.write_text("main = simulate nonsense")
    assert replay_recording(config, options, say, lambda _, __: None) == 1


def test_another_reader_finds_all_channels_in_both_directions(config: Config, tmp_path: Path) -> None:
    with recorded(config, SCRIPT, tmp_path).path.open("rb") as stream:
        reader = make_reader(stream, validate_crcs=True)
        found = [(channel.topic, message) for _, channel, message in reader.iter_messages()]
        summary = reader.get_summary()
    topics = {topic for topic, _ in found}
    assert {
        "/odom",
        "/mobile_base/events/bumper",
        "/mobile_base/sensors/imu_data",
        "/mobile_base/sensors/core",
        "/rosy/to_program",
        "/rosy/from_program",
        "/sent/mobile_base/commands/velocity",
        "/sent/mobile_base/commands/led1",
    } <= topics
    times = [message.log_time for _, message in found]
    assert times == sorted(set(times))
    assert all(isinstance(json.loads(message.data), dict) for _, message in found)
    assert summary is not None
    schemas = {schema.name: json.loads(schema.data) for schema in summary.schemas.values()}
    assert schemas["nav_msgs/Odometry"]["properties"]["pose"]["type"] == "object"
    assert {schema.encoding for schema in summary.schemas.values()} == {"jsonschema"}
    assert {channel.message_encoding for channel in summary.channels.values()} == {"json"}
