"""A run without a page, with programs that behave and programs that do not."""

from __future__ import annotations

import io
import json
import socket
from dataclasses import replace

import pytest

from rosy_sim.config import Config, Limits
from rosy_sim.run.headless_run import RunOutput, RunResult, RunSettings, run_over_link, run_program
from rosy_sim.worker.blocking_worker import BlockingWorker
from rosy_sim.world.arena import Pose
from rosy_sim.world.events import Press, Teleport

from ..conftest import hall, playing


def run(
    script: str, limits: Limits, seconds: float = 1.0, trace: io.BytesIO | None = None
) -> tuple[RunResult, list[str]]:
    said: list[str] = []
    with playing(script) as link:
        outcome = run_over_link(link, hall(), RunSettings(seconds, 1, limits=limits), RunOutput(said.append, trace))
    return outcome, said


def test_time_ends_a_run_that_goes_on(limits: Limits) -> None:
    outcome, _ = run("drive:0.5", limits)
    assert (outcome.ended, outcome.steps, outcome.problems) == ("time", 50, [])


def test_a_run_ends_when_the_program_is_done(limits: Limits) -> None:
    outcome, said = run("drive:0.5 say:hello@3 done@7", limits)
    assert (outcome.ended, outcome.steps, said) == ("done", 7, ["hello"])


def test_what_a_program_said_is_read_when_it_has_ended_before_the_run_begins(limits: Limits) -> None:
    lines = [
        {"op": "advertise", "topic": "/rosy/say", "type": "std_msgs/String"},
        {"op": "publish", "topic": "/rosy/say", "msg": {"data": "hello"}},
        {"op": "ended", "how": "done", "fired": []},
    ]
    said: list[str] = []
    link, program = socket.socketpair()
    with link:
        with program:
            program.sendall(b"".join(json.dumps(line).encode() + b"\n" for line in lines))
        outcome = run_over_link(link, hall(), RunSettings(1.0, 1, limits=limits), RunOutput(said.append, None))
    assert (outcome.ended, outcome.problems, said) == ("done", [], ["hello"])


@pytest.mark.parametrize(
    ("script", "ended", "kind"),
    [
        ("error@4", "error", "exception"),
        ("hang@4", "stuck", "stuck"),
        ("close@4", "error", "died"),
        ("garble@4", "error", "broken-link"),
        ("lie@4", "error", "broken-link"),
        ("flood@4", "error", "too-much"),
        ("long@4", "error", "too-much"),
        ("mute", "stuck", "stuck"),
    ],
)
def test_a_bad_program_ends_with_one_problem(
    script: str, ended: str, kind: str, limits: Limits, impatient: Limits
) -> None:
    if ended == "stuck":
        limits = replace(impatient, ready=1.0) if script == "mute" else impatient
    outcome, _ = run(script, limits)
    assert outcome.ended == ended
    assert [p.kind for p in outcome.problems] == [kind]
    assert outcome.problems[0].message


def test_a_program_that_ignores_stop_does_not_hold_up_the_end(limits: Limits) -> None:
    outcome, _ = run("deaf", limits)
    assert outcome.ended == "time"


def test_a_program_that_writes_byte_by_byte_gives_the_same_trace(limits: Limits) -> None:
    traces = [io.BytesIO(), io.BytesIO()]
    for script, trace in zip(("drive:0.5 turn:0.3", "drive:0.5 turn:0.3 drip"), traces, strict=True):
        run(script, limits, seconds=0.4, trace=trace)
    assert traces[0].getvalue() == traces[1].getvalue() != b""


def test_a_trace_has_a_line_per_step_with_the_pose_at_its_start(limits: Limits) -> None:
    trace = io.BytesIO()
    run("drive:0.5", limits, seconds=0.2, trace=trace)
    lines = [json.loads(line) for line in trace.getvalue().splitlines()]
    assert [line["t"] for line in lines] == [k / 50 for k in range(10)]
    assert set(lines[0]) == {"t", "x", "y", "theta", "v", "w", "events", "commands", "fired"}
    assert lines[0]["x"] == 10.0
    assert lines[9]["x"] > lines[1]["x"] > 10.0


def test_the_last_line_tells_what_fired_at_the_end(limits: Limits) -> None:
    trace = io.BytesIO()
    run("drive:0.5 done@3", limits, trace=trace)
    lines = [json.loads(line) for line in trace.getvalue().splitlines()]
    assert (lines[-1]["fired"], lines[-1]["commands"]) == (["script"], ["Velocity 0.0 0.0"])


def test_hands_act_at_their_time(limits: Limits) -> None:
    world = hall()
    actions = ((0.1, Press(1, True)), (0.2, Teleport(Pose(3.0, 4.0, 1.0))))
    with playing("") as link:
        run_over_link(link, world, RunSettings(0.3, 1, actions=actions, limits=limits), RunOutput())
    assert (world.x, world.y, world.theta) == (3.0, 4.0, 1.0)
    assert world.sensors.buttons == 2


def test_a_worker_runs_a_program(config: Config) -> None:
    with BlockingWorker(config) as worker:
        assert worker.ready().protocol == 1
        outcome = run_program(worker, "drive:0.5", hall(), RunSettings(1.0, 1, limits=config.limits), RunOutput())
    assert outcome.ended == "time"


def test_a_worker_names_the_function_that_hangs(config: Config, impatient: Limits) -> None:
    with BlockingWorker(config) as worker:
        worker.ready()
        outcome = run_program(worker, "hang@4", hall(), RunSettings(1.0, 1, limits=impatient), RunOutput())
    assert outcome.problems[0].function == "move"
    assert "`move`" in outcome.problems[0].message


def test_what_became_of_a_program_is_known_as_often_as_it_is_asked(config: Config) -> None:
    with BlockingWorker(config) as worker:
        worker.ready()
        outcome = run_program(worker, "close@4", hall(), RunSettings(1.0, 1, limits=config.limits), RunOutput())
        first = worker.gone()
        assert first is not None
        assert worker.gone() is first
    assert outcome.problems[0].kind == "died"


def test_a_program_that_does_not_compile_is_refused(config: Config) -> None:
    with BlockingWorker(config) as worker:
        worker.ready()
        outcome = run_program(worker, "refuse", hall(), RunSettings(1.0, 1, limits=config.limits), RunOutput())
    assert (outcome.ended, outcome.problems[0].kind) == ("refused", "type-mismatch")
