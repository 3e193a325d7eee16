"""
Command line of the service: ``serve``, ``node``, ``class``, ``run``, ``room``, ``replay``, ``check``, ``build``,
``lsp``.
``./rosy help COMMAND`` explains them.

Every expected failure ends as one sentence on stderr; the exit status is the error's own.
"""

from __future__ import annotations

import argparse
import contextlib
import math
import os
import random
import sys
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import NoReturn

import msgspec

from .atomic_file import AtomicFile
from .classroom.command import add_class_options, run_class_command
from .classroom.store.class_places import class_place
from .cluster.command import add_cluster_options, run_cluster_command
from .cluster.node import use_token
from .config import Config, discover
from .errors import BadInput, OutputFailed, RosyError
from .explain.causal_chain import explain
from .explain.recorded_run import RecordedRun
from .explain.why_not import RobotLimits
from .explain.wording import words_of
from .maps.command import add_room_options, make_room
from .ownership.robot_configuration import read_robot_configuration
from .problem_text import format_problem
from .recordings.command import add_replay_options, replay_recording
from .recordings.mcap_file import RunDetails
from .recordings.recording_folder import RecordingFolder, named_recording, recorded_sentence
from .robots import DEFAULT_ROBOT
from .rooms.command import add_options, check_options, test_in_rooms
from .rooms.programs import Pool
from .run.grading import format_table, grade_programs, programs_in
from .run.headless_run import RunOutput, RunResult, RunSettings, run_native, run_program
from .run.input_file import read_inputs
from .run.program_file import ProgramFile, read_program
from .run.steps.velocity_guard import SafetySettings
from .sentence import Sentence, tr
from .terminal_text import escape_json, neutralize, neutralize_line
from .usage_errors import usage_error
from .wire.problem import Problem, is_complete
from .wording import in_terminal, machine_wording
from .worker.blocking_worker import BlockingWorker
from .worker.launcher import missing_sandbox, sandbox_warning
from .worker.native_build import build_program, is_native
from .world.arena import Arena
from .world.time_step import STEPS_PER_SECOND
from .world.world import World
from .worlds.gallery import DEFAULT_WORLD, load_world, named_world, usable_arena

__all__ = ["main"]

DEFAULT_SECONDS = 60.0
"""How long `run` simulates when neither `--seconds` nor the program says, s."""

MAX_SECONDS = 7 * 24 * 3600.0
"""Longest run, s."""

GOAL_MISSED = 3
"""Exit status of a run that went well but missed a goal of its world."""

_EXIT_STATUS = {"time": 0, "done": 0, "error": 2, "stuck": 2, "refused": 1}


class _Parser(argparse.ArgumentParser):
    """One sentence instead of a page of usage; `scripts/help` has that."""

    def error(self, message: str) -> NoReturn:
        raise BadInput(
            tr("{message}. ./{program} --help says what there is.", message=usage_error(message), program=self.prog)
        )


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a command; returns the exit status."""
    try:
        status = _command(arguments)
        _flush_output()
        return status
    except OutputFailed as error:
        # What is still buffered would fail again at the exit of the interpreter.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        if not error.reader_left:
            _print_error(error)
        return error.exit_status
    except RosyError as error:
        _print_error(error)
        return error.exit_status
    except KeyboardInterrupt:
        return 130


def _command(arguments: Sequence[str] | None) -> int:
    options, unknown = _parser().parse_known_args(arguments)
    if unknown:
        command = "start" if options.command in ("serve", "node") else options.command
        raise BadInput(
            tr(
                "{command} does not take {unknown}. ./rosy {command} --help says what there is.",
                command=command,
                unknown=" ".join(unknown),
            )
        )
    config = discover()
    if options.command == "serve":
        from .web.server import serve

        if options.runs is not None:
            if options.runs < 1:
                raise BadInput(tr("--runs says how many programs may run at once: at least 1."))
            config = config.with_limits(replace(config.limits, runs=options.runs))
        robots = read_robot_configuration(config.robot_executable, options.robot, options.robots)
        config = replace(config, robots=robots, class_name=options.class_name, records=not options.no_record)
        host = options.host or ("127.0.0.1" if options.class_name is None else "0.0.0.0")
        return serve(config, host, options.port, not options.no_browser, options.unprotected)
    if options.command == "node":
        return run_cluster_command(config, options, _print)
    if options.command == "class":
        return run_class_command(class_place(config.classes, config.class_database), options, _print)
    if options.command == "lsp":
        # Imported for this command alone: the types of the protocol take a third of a second.
        from .lsp.server import serve_editor

        _warn_without_sandbox(config)
        return serve_editor(config)
    if options.command == "build":
        return _build(config, options)
    if options.command == "check":
        return _check(config, options)
    if options.command == "room":
        return make_room(options, _print_sentence)
    if options.command == "replay":
        if not options.fit:
            _warn_without_sandbox(config)
        return replay_recording(config, options, _print_sentence, _print_problem)
    check_options(options)
    if options.rooms is not None:
        _warn_without_sandbox(config)
        return test_in_rooms(config, options, _seconds(options.seconds), _safety(options), _print, _cluster_pool)
    if len(options.files) > 1 or options.files[0].is_dir():
        return _grade(config, options)
    options.file = options.files[0]
    return _run(config, options)


def _parser() -> argparse.ArgumentParser:
    parser = _Parser(prog="rosy", add_help=False, allow_abbrev=False)
    commands = parser.add_subparsers(dest="command", required=True, parser_class=_Parser)
    serve = commands.add_parser("serve", prog="rosy start", add_help=False, allow_abbrev=False)
    serve.add_argument("--port", type=int, default=8080)
    serve.add_argument("--host")
    serve.add_argument("--class", dest="class_name", nargs="?", const="class", metavar="NAME")
    serve.add_argument("--no-browser", action="store_true")
    serve.add_argument("--runs", type=int)
    serve.add_argument("--robot", action="append", default=[], metavar="NAME=ADDRESS")
    serve.add_argument("--robots", type=Path, metavar="FILE")
    serve.add_argument("--unprotected", action="store_true")
    serve.add_argument("--no-record", action="store_true")
    add_cluster_options(commands.add_parser("node", prog="rosy start", add_help=False, allow_abbrev=False))
    check = commands.add_parser("check", prog="rosy check", add_help=False, allow_abbrev=False)
    check.add_argument("file", type=Path)
    check.add_argument("--json", action="store_true")
    build = commands.add_parser("build", prog="rosy build", add_help=False, allow_abbrev=False)
    build.add_argument("file", type=Path)
    build.add_argument("-o", dest="output", type=Path, required=True, metavar="BIN")
    lsp = commands.add_parser("lsp", prog="rosy lsp", add_help=False, allow_abbrev=False)
    # Editors add it to name the transport; there is no other one.
    lsp.add_argument("--stdio", action="store_true")
    add_room_options(commands.add_parser("room", prog="rosy room", add_help=False, allow_abbrev=False))
    add_replay_options(commands.add_parser("replay", prog="rosy replay", add_help=False, allow_abbrev=False))
    add_class_options(commands.add_parser("class", prog="rosy class", add_help=False, allow_abbrev=False))
    run = commands.add_parser("run", prog="rosy run", add_help=False, allow_abbrev=False)
    run.add_argument("files", type=Path, nargs="+", metavar="file")
    run.add_argument("--world")
    run.add_argument("--seconds", type=float)
    run.add_argument("--seed", type=int)
    run.add_argument("--speed")
    run.add_argument("--trace", type=Path)
    run.add_argument("--input", type=Path)
    run.add_argument("--robot")
    run.add_argument("--record", type=Path, metavar="FILE")
    run.add_argument("--no-record", action="store_true")
    add_options(run)
    run.add_argument("--safety", choices=("on", "off"))
    run.add_argument("--max-speed", type=float)
    run.add_argument("--max-turn", type=float)
    run.add_argument("--provenance", action="store_true")
    run.add_argument("--explain", nargs="?", const="")
    return parser


def _cluster_pool(address: str) -> Pool:
    # Only the environment of `./rosy run --cluster` has Ray, which reads how it is to be used when it is imported.
    use_token()
    from .cluster.trials import ClusterPool

    return ClusterPool(address)


def _worker(config: Config) -> BlockingWorker:
    """A worker; a missing sandbox is reported."""
    worker = BlockingWorker(config)
    _warn_without_sandbox(config)
    return worker


def _warn_without_sandbox(config: Config) -> None:
    fault = missing_sandbox(config)
    if fault is not None:
        print(f"rosy: {in_terminal(sandbox_warning(fault))}", file=sys.stderr)


def _check(config: Config, options: argparse.Namespace) -> int:
    program = read_program(options.file)
    with _worker(config) as worker:
        worker.ready()
        checked = worker.check(program.source)
    if options.json:
        answer = {"problems": checked.problems, "declarations": checked.declarations, "graph": checked.graph}
        _print(escape_json(msgspec.json.encode(answer).decode()))
    else:
        for found in checked.problems:
            _print(format_problem(options.file, found, sys.stdout.isatty()))
        if not checked.problems:
            _print(f"{neutralize_line(str(options.file))}: {in_terminal(tr('no problems.'))}")
    return 0 if is_complete(checked.problems) else 1


def _build(config: Config, options: argparse.Namespace) -> int:
    """A native program, of what the worker would run."""
    program = read_program(options.file)
    with _worker(config) as worker:
        worker.ready()
        checked = worker.check(program.source)
    for found in checked.problems:
        _print(format_problem(options.file, found, sys.stdout.isatty()))
    if not is_complete(checked.problems):
        return 1
    return build_program(config.root, program.source, options.output)


def _run(config: Config, options: argparse.Namespace) -> int:
    native = is_native(options.file)
    program = ProgramFile("") if native else read_program(options.file)
    if options.robot is not None:
        if native:
            raise BadInput(
                tr("A built program drives by itself: {file} --robot {robot}", file=options.file, robot=options.robot)
            )
        return _drive(config, program, options)
    if options.record is not None or options.no_record:
        raise BadInput(tr("--record and --no-record are for --robot; a simulated run has --trace."))
    arena = _arena(program, options)
    settings = RunSettings(
        seconds=_seconds(options.seconds),
        seed=_seed(options),
        speed=_speed(options.speed),
        actions=tuple(read_inputs(options.input)) if options.input is not None else (),
        limits=config.limits,
        safety=_safety(options),
    )
    world = World(arena, DEFAULT_ROBOT, settings.seed)
    moment = _moment(options.explain)
    record = RecordedRun(moment) if options.explain is not None else None
    if options.provenance and options.trace is None:
        raise BadInput(tr("--provenance is for --trace: it adds causes and reads to its lines."))
    with contextlib.ExitStack() as stack:
        trace = None
        if options.trace is not None:
            trace = stack.enter_context(AtomicFile(options.trace, keep_interrupted=True))
        output = RunOutput(_say, trace, provenance=options.provenance, record=record)
        if native:
            outcome = run_native(options.file, world, settings, output)
        else:
            worker = stack.enter_context(_worker(config))
            worker.ready()
            outcome = run_program(worker, program.source, world, settings, output)
    if record is not None:
        _print_explanation(record, moment)
    return _report(options.file, world, outcome)


def _print_explanation(record: RecordedRun, moment: float | None) -> None:
    """Why what was sent at a time, s, or last, was sent; in the language of the terminal."""
    limits = RobotLimits(DEFAULT_ROBOT.limits.speed, DEFAULT_ROBOT.limits.angular_speed)
    language = machine_wording()
    mark = language.forms.decimal_mark if language.forms is not None else "."
    for link in explain(record, limits, moment):
        _print(neutralize(language.put(words_of(link.said, mark)).replace("**", "")))


def _grade(config: Config, options: argparse.Namespace) -> int:
    """Several programs: a table, and the worst of their exit statuses."""
    for name in ("trace", "input", "robot", "explain"):
        if getattr(options, name) is not None:
            raise BadInput(tr("--{name} is for one program at a time.", name=name))
    if options.world is not None:
        usable_arena(load_world(options.world), options.world)
    given = {"--world": options.world, "--seconds": options.seconds, "--seed": options.seed, "--speed": options.speed}
    _warn_without_sandbox(config)
    given |= {f"--{name.replace('_', '-')}": value for name, value in _safety_options(options).items()}
    passed = [text for name, value in given.items() if value is not None for text in (name, str(value))]
    grades = grade_programs(programs_in(options.files), passed)
    _print(format_table(grades))
    return max(g.status for g in grades)


def _drive(config: Config, program: ProgramFile, options: argparse.Namespace) -> int:
    """A real robot: only the time of a run can be chosen."""
    from .ownership.headless_robot_run import run_on_robot

    for name in ("world", "seed", "speed", "trace", "input", "explain"):
        if getattr(options, name) is not None:
            raise BadInput(tr("--{name} is for the simulator; a real robot cannot have it.", name=name))
    if options.record is not None and options.no_record:
        raise BadInput(tr("--record and --no-record exclude each other."))
    seconds = MAX_SECONDS if options.seconds is None else _seconds(options.seconds)
    address = _with_options(options.robot, _safety_options(options))
    details = RunDetails(program.source, address, str(options.file))
    with _worker(config) as worker:
        worker.ready()
        pending = None
        if options.record is not None:
            pending = named_recording(options.record)
        elif not options.no_record:
            pending = RecordingFolder(config.recordings).begin(details)
        log = pending.log if pending is not None else None
        try:
            problems, status = run_on_robot(worker, config.robot_executable, program.source, address, seconds, log)
        finally:
            finished = pending.finish(details) if pending is not None else None
    for found in problems:
        _print_problem(options.file, found)
    if finished is not None:
        print(f"rosy: {neutralize_line(in_terminal(recorded_sentence(finished)))}", file=sys.stderr)
    return status


def _print_problem(file: Path, found: Problem) -> None:
    print(format_problem(file, found, sys.stderr.isatty()), file=sys.stderr)


def _print_sentence(sentence: Sentence) -> None:
    _print(neutralize_line(in_terminal(sentence)))


def _safety_options(options: argparse.Namespace) -> dict[str, str | float]:
    """The options about safety that were given, named as in the address of a robot."""
    given = {name: getattr(options, name) for name in ("safety", "max_speed", "max_turn")}
    for name in ("max_speed", "max_turn"):
        if given[name] is not None and not 0 <= given[name] < math.inf:
            raise BadInput(tr("--{name} must be a number from 0.", name=name.replace("_", "-")))
    return {name: value for name, value in given.items() if value is not None}


def _safety(options: argparse.Namespace) -> SafetySettings:
    """Safety rules and limits of the simulated robot: off, unless one of the options is given."""
    given = _safety_options(options)
    default = SafetySettings()
    return SafetySettings(
        on=given.get("safety", "on" if given else "off") == "on",
        max_speed=float(given.get("max_speed", default.max_speed)),
        max_turn=float(given.get("max_turn", default.max_turn)),
    )


def _with_options(address: str, given: dict[str, str | float]) -> str:
    """The address of a robot with further options, which come after its own."""
    if not given:
        return address
    return address + ("&" if "?" in address else "?") + "&".join(f"{name}={value}" for name, value in given.items())


def _seed(options: argparse.Namespace) -> int:
    seed: int | None = options.seed
    return seed if seed is not None else random.SystemRandom().randrange(2**31)


def _report(file: Path, world: World | None, outcome: RunResult) -> int:
    _flush_output()
    for found in outcome.problems:
        print(format_problem(file, found, sys.stderr.isatty()), file=sys.stderr)
    last: dict[str, object] = {
        "time": outcome.steps / STEPS_PER_SECOND,
        "pose": {"x": world.x, "y": world.y, "theta": world.theta} if world is not None else None,
        "ended": outcome.ended if outcome.ended != "refused" else "error",
        "steps": outcome.steps,
        "wall": round(outcome.wall, 6),
    }
    if outcome.goals:
        last["goals"] = [state._asdict() for state in outcome.goals]
    _print(escape_json(msgspec.json.encode(last).decode()))
    status = _EXIT_STATUS[outcome.ended]
    missed = any(state.state != "done" for state in outcome.goals)
    return GOAL_MISSED if status == 0 and missed else status


def _say(text: str) -> None:
    _print(neutralize(text))
    _flush_output()


def _print_error(error: RosyError) -> None:
    print(f"rosy: {neutralize_line(in_terminal(error.sentence))}", file=sys.stderr)


def _print(text: str) -> None:
    try:
        print(text)
    except OSError as error:
        raise OutputFailed(error) from error


def _flush_output() -> None:
    try:
        sys.stdout.flush()
    except OSError as error:
        raise OutputFailed(error) from error


def _arena(program: ProgramFile, options: argparse.Namespace) -> Arena:
    if options.world is not None:
        return usable_arena(load_world(options.world), options.world)
    if program.world is None:
        return usable_arena(named_world(DEFAULT_WORLD), DEFAULT_WORLD)
    if isinstance(program.world, str):
        return usable_arena(named_world(program.world), program.world)
    return usable_arena(program.world, tr("The world in {file}", file=options.file))


def _seconds(wanted: float | None) -> float:
    if wanted is None:
        return DEFAULT_SECONDS
    if not 0 <= wanted <= MAX_SECONDS:
        raise BadInput(tr("--seconds must be between 0 and {most}.", most=MAX_SECONDS))
    return wanted


def _moment(wanted: str | None) -> float | None:
    """The time that is to be explained, s; None for the last command."""
    if not wanted:
        return None
    try:
        moment = float(wanted)
    except ValueError:
        moment = math.nan
    if not 0 <= moment <= MAX_SECONDS:
        raise BadInput(tr("--explain stands at the end, or takes a time in seconds: --explain 3.4."))
    return moment


def _speed(wanted: str | None) -> float | None:
    if wanted is None or wanted == "max":
        return None
    try:
        speed = float(wanted)
    except ValueError:
        speed = math.nan
    if not 0.01 <= speed <= 1000:
        raise BadInput(tr("--speed must be a number between 0.01 and 1000, or max."))
    return speed
