"""The command ``run``: a program in the simulator or on a robot, several programs, and programs in many rooms."""

from __future__ import annotations

import argparse
import contextlib
import math
import os
import sys
from pathlib import Path

import msgspec

from ..atomic_file import AtomicFile
from ..classroom.exports.spreadsheet import spreadsheet
from ..cluster.node import use_token
from ..config import Config
from ..errors import BadInput
from ..explain.causal_chain import explain
from ..explain.function_types import with_synonyms, written_memories
from ..explain.recorded_run import RecordedRun
from ..explain.why_not import RobotLimits
from ..explain.wording import words_of
from ..programs.input_file import read_inputs
from ..programs.program_file import ProgramFile, read_program
from ..recordings.mcap_file import RunDetails
from ..recordings.recording_folder import RecordingFolder, named_recording, recorded_sentence
from ..robots import robot_in
from ..rooms.command import check_options, test_in_rooms
from ..rooms.programs import Pool
from ..run.grading import Grade, csv_rows, format_table, grade_programs, programs_in
from ..run.headless_run import RunOutput, RunResult, RunSettings, run_native, run_program
from ..run.steps.lockstep import Lockstep, no_such_server
from ..sentences.sentence import Sentence, tr
from ..sentences.terminal_text import escape_json, neutralize, neutralize_line
from ..sentences.wording import in_terminal, machine_wording
from ..worker.native_build import is_native
from ..world.time_step import STEPS_PER_SECOND
from ..world.world import World
from ..worlds.gallery import load_world, usable_arena
from .checked_worker import started_worker, warn_without_sandbox
from .output import flush_output, print_bytes, print_note, print_problem, print_sentence, print_text, say
from .problem_text import format_problem
from .run_options import (
    MAX_SECONDS,
    arena_of,
    is_simulated,
    moment_of,
    safety_of,
    safety_options,
    seconds_of,
    seed_of,
    speed_of,
    with_options,
)

__all__ = ["run_command"]

GOAL_MISSED = 3
"""Exit status of a run that went well but missed a goal of its world."""

_EXIT_STATUS = {"time": 0, "done": 0, "error": 2, "stuck": 2, "refused": 1}


def run_command(config: Config, options: argparse.Namespace) -> int:
    """Runs what the options name; returns the exit status."""
    check_options(options)
    if options.rooms is not None:
        warn_without_sandbox(config)
        return test_in_rooms(
            config, options, seconds_of(options.seconds), safety_of(options), print_text, _cluster_pool
        )
    if options.csv or len(options.files) > 1 or os.path.isdir(options.files[0]):
        return _grade(config, options)
    options.file = options.files[0]
    return _run(config, options)


def _run(config: Config, options: argparse.Namespace) -> int:
    native = is_native(options.file)
    program = ProgramFile("") if native else read_program(options.file, options.encoding)
    if not is_simulated(options):
        if native:
            raise BadInput(
                tr("A built program drives by itself: {file} --robot {robot}", file=options.file, robot=options.robot)
            )
        return _drive(config, program, options)
    if options.record is not None or options.no_record:
        raise BadInput(tr("--record and --no-record are for --robot; a simulated run has --trace."))
    arena = arena_of(program, options)
    settings = RunSettings(
        seconds=seconds_of(options.seconds),
        seed=seed_of(options),
        speed=speed_of(options.speed),
        actions=tuple(read_inputs(options.input)) if options.input is not None else (),
        limits=config.limits,
        safety=safety_of(options),
        busy_waits=True,
    )
    world = World(arena, robot_in(arena), settings.seed)
    moment = moment_of(options.explain)
    record = RecordedRun(moment) if options.explain is not None else None
    memories: dict[str, str] = {}
    if options.provenance and options.trace is None:
        raise BadInput(tr("--provenance is for --trace: it adds causes and reads to its lines."))
    with contextlib.ExitStack() as stack:
        trace = None
        if options.trace is not None:
            trace = stack.enter_context(AtomicFile(options.trace, keep_interrupted=True))
        # The standard error of a run that another program reads is empty when all went well.
        observe = _note_problems if sys.stdout.isatty() else _note_unavailable
        output = RunOutput(say, trace, observe, options.provenance, record)
        if native:
            outcome = run_native(options.file, world, settings, output)
        else:
            worker = stack.enter_context(started_worker(config))
            worker.ready()
            outcome = run_program(worker, program.source, world, settings, output)
            if record is not None and outcome.ended != "refused":
                memories = written_memories(worker.check(program.source).graph)
    if record is not None:
        _print_explanation(record, RobotLimits.of_motors(world.robot.limits), moment, memories)
    outcome.problems = program.in_file(outcome.problems)
    return _report(options.file, world, outcome)


def _note_problems(lockstep: Lockstep) -> None:
    """For a person: why nothing seems to happen any more, and what the robot lacks."""
    _note_unavailable(lockstep)
    if lockstep.is_blocked:
        print_note(tr("{time} s: the robot pushes against something and cannot drive on.", time=lockstep.time))


def _note_unavailable(lockstep: Lockstep) -> None:
    for name in lockstep.unavailable:
        print_note(no_such_server(name))


def _report(file: Path, world: World | None, outcome: RunResult) -> int:
    flush_output()
    for found in outcome.problems:
        print(format_problem(file, found, sys.stderr.isatty()), file=sys.stderr)
    status = _EXIT_STATUS[outcome.ended]
    missed = [state for state in outcome.goals if state.state != "done"]
    status = GOAL_MISSED if status == 0 and missed else status
    if sys.stdout.isatty():
        done = len(outcome.goals) - len(missed)
        remark = "; ".join(state.title for state in missed)
        time = outcome.steps / STEPS_PER_SECOND
        grade = Grade(file.name, status, time, (done, len(outcome.goals)), remark)
        print_text(neutralize(format_table([grade])))
        if world is not None:
            print_sentence(_place(world))
    else:
        print_text(escape_json(msgspec.json.encode(_values(world, outcome)).decode()))
    return status


def _values(world: World | None, outcome: RunResult) -> dict[str, object]:
    """The end of a run for other programs."""
    values: dict[str, object] = {
        "time": outcome.steps / STEPS_PER_SECOND,
        "pose": {"x": world.x, "y": world.y, "theta": world.theta} if world is not None else None,
        "ended": outcome.ended if outcome.ended != "refused" else "error",
        "steps": outcome.steps,
        "wall": round(outcome.wall, 6),
    }
    if outcome.goals:
        values["goals"] = [state._asdict() for state in outcome.goals]
    return values


def _place(world: World) -> Sentence:
    degrees = round(math.degrees(math.remainder(world.theta, math.tau)))
    return tr(
        "The robot is at x = {x} m, y = {y} m and looks in direction {degrees}°.",
        x=round(world.x, 2),
        y=round(world.y, 2),
        degrees=degrees,
    )


def _print_explanation(
    record: RecordedRun, limits: RobotLimits, moment: float | None, memories: dict[str, str]
) -> None:
    """
    Why what was sent at a time, s, or last, was sent; in the language of the terminal. ``memories``: as the program
    writes their types.
    """
    language = machine_wording()
    mark = language.forms.decimal_mark if language.forms is not None else "."
    for link in explain(record, limits, moment):
        said = with_synonyms(link.said, memories)
        print_text(neutralize(language.put(words_of(said, mark)).replace("**", "")))


def _grade(config: Config, options: argparse.Namespace) -> int:
    """Several programs: a table, and the worst of their exit statuses."""
    for name in ("trace", "input", "robot", "explain"):
        if getattr(options, name) is not None and not (name == "robot" and is_simulated(options)):
            raise BadInput(tr("--{name} is for one program at a time.", name=name))
    if options.world is not None:
        usable_arena(load_world(options.world), options.world)
    warn_without_sandbox(config)
    given = {f"--{name}": getattr(options, name) for name in ("world", "robot", "seconds", "seed", "speed", "encoding")}
    given |= {f"--{name.replace('_', '-')}": value for name, value in safety_options(options).items()}
    passed = [text for name, value in given.items() if value is not None for text in (name, str(value))]
    grades = grade_programs(programs_in(options.files), passed)
    if options.csv:
        print_bytes(spreadsheet(csv_rows(grades)))
    else:
        print_text(format_table(grades))
    return max(g.status for g in grades)


def _drive(config: Config, program: ProgramFile, options: argparse.Namespace) -> int:
    """A real robot: only the time of a run can be chosen."""
    from ..ownership.headless_robot_run import run_on_robot

    for name in ("world", "seed", "speed", "trace", "input", "explain"):
        if getattr(options, name) is not None:
            raise BadInput(tr("--{name} is for the simulator; a real robot cannot have it.", name=name))
    if options.record is not None and options.no_record:
        raise BadInput(tr("--record and --no-record exclude each other."))
    seconds = MAX_SECONDS if options.seconds is None else seconds_of(options.seconds)
    address = with_options(options.robot, safety_options(options))
    details = RunDetails(program.source, address, str(options.file))
    with started_worker(config) as worker:
        worker.ready()
        pending = None
        if options.record is not None:
            pending = named_recording(options.record, details)
        elif not options.no_record:
            pending = RecordingFolder(config.recordings).begin(details)
        log = pending.log if pending is not None else None
        try:
            problems, status = run_on_robot(worker, config.robot_executable, program.source, address, seconds, log)
        finally:
            finished = pending.finish(details) if pending is not None else None
    for found in program.in_file(problems):
        print_problem(options.file, found)
    if finished is not None:
        print(f"rosy: {neutralize_line(in_terminal(recorded_sentence(finished)))}", file=sys.stderr)
    return status


def _cluster_pool(address: str) -> Pool:
    # Only the environment of `./rosy run --cluster` has Ray, which reads how it is to be used when it is imported.
    use_token()
    from ..cluster.trials import ClusterPool

    return ClusterPool(address)
