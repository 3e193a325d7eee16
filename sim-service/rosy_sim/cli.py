"""
The command line: ``serve``, ``run``, ``check``, ``build``. What each does and how it exits is in DESIGN.md, section 5.

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
from typing import BinaryIO, NoReturn
from unicodedata import category

import msgspec

from .build import build_program, is_native
from .config import Config, discover
from .errors import BadInput, RosyError
from .grade import grade, programs_in, table
from .inputs import read_inputs
from .library import DEFAULT_WORLD, load_world, named_world, usable_arena
from .program import ProgramFile, read_program
from .roster import configured
from .run import Order, Outcome, run_native, run_program
from .wire.problem import Problem
from .worker.blocking import BlockingWorker
from .world.arena import Arena
from .world.world import World

__all__ = ["main"]

DEFAULT_SECONDS = 60.0
"""How long `run` simulates when neither `--seconds` nor the program says, s."""

MAX_SECONDS = 7 * 24 * 3600.0
"""Longest run, s."""

GOAL_MISSED = 3
"""Exit status of a run that went well but missed a goal of its world."""

_EXITS = {"time": 0, "done": 0, "error": 2, "stuck": 2, "refused": 1}


class _Parser(argparse.ArgumentParser):
    """One sentence instead of a page of usage; `scripts/help` has that."""

    def error(self, message: str) -> NoReturn:
        raise BadInput(f"{message}. ./{self.prog} --help says what there is.")


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a command; returns the exit status."""
    try:
        options, unknown = _parser().parse_known_args(arguments)
        if unknown:
            command = "start" if options.command == "serve" else options.command
            raise BadInput(f"{command} does not take {' '.join(unknown)}. ./rosy {command} --help says what there is.")
        config = discover()
        if options.command == "serve":
            from .serve import serve

            if options.runs is not None:
                if options.runs < 1:
                    raise BadInput("--runs says how many programs may run at once: at least 1.")
                config = config.with_limits(replace(config.limits, runs=options.runs))
            config = replace(config, robots=configured(config.speaker, options.robot, options.robots))
            return serve(config, options.host, options.port, not options.no_browser, options.unprotected)
        if options.command == "build":
            return _build(config, options)
        if options.command == "check":
            return _check(config, options)
        if len(options.files) > 1 or options.files[0].is_dir():
            return _grade(options)
        options.file = options.files[0]
        return _run(config, options)
    except RosyError as error:
        print(f"rosy: {error}", file=sys.stderr)
        return error.exit_status
    except KeyboardInterrupt:
        return 130
    except BrokenPipeError:
        # Whoever read our output has left; nothing more can be said to them.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 1


def _parser() -> argparse.ArgumentParser:
    parser = _Parser(prog="rosy", add_help=False, allow_abbrev=False)
    commands = parser.add_subparsers(dest="command", required=True, parser_class=_Parser)
    serve = commands.add_parser("serve", prog="rosy start", add_help=False, allow_abbrev=False)
    serve.add_argument("--port", type=int, default=8080)
    serve.add_argument("--host", default="127.0.0.1")
    serve.add_argument("--no-browser", action="store_true")
    serve.add_argument("--runs", type=int)
    serve.add_argument("--robot", action="append", default=[], metavar="NAME=ADDRESS")
    serve.add_argument("--robots", type=Path, metavar="FILE")
    serve.add_argument("--unprotected", action="store_true")
    check = commands.add_parser("check", prog="rosy check", add_help=False, allow_abbrev=False)
    check.add_argument("file", type=Path)
    check.add_argument("--json", action="store_true")
    build = commands.add_parser("build", prog="rosy build", add_help=False, allow_abbrev=False)
    build.add_argument("file", type=Path)
    build.add_argument("-o", dest="output", type=Path, required=True, metavar="BIN")
    run = commands.add_parser("run", prog="rosy run", add_help=False, allow_abbrev=False)
    run.add_argument("files", type=Path, nargs="+", metavar="file")
    run.add_argument("--world")
    run.add_argument("--seconds", type=float)
    run.add_argument("--seed", type=int)
    run.add_argument("--speed")
    run.add_argument("--trace", type=Path)
    run.add_argument("--input", type=Path)
    run.add_argument("--robot")
    return parser


def _check(config: Config, options: argparse.Namespace) -> int:
    program = read_program(options.file)
    with BlockingWorker(config) as worker:
        worker.ready()
        checked = worker.check(program.source)
    if options.json:
        answer = {"problems": checked.problems, "declarations": checked.declarations, "graph": checked.graph}
        print(msgspec.json.encode(answer).decode())
    else:
        for found in checked.problems:
            print(_sentence(options.file, found))
        if not checked.problems:
            print(f"{options.file}: no problems.")
    return 1 if any(p.severity == "error" for p in checked.problems) else 0


def _build(config: Config, options: argparse.Namespace) -> int:
    """A native program, of what the worker would run."""
    program = read_program(options.file)
    with BlockingWorker(config) as worker:
        worker.ready()
        checked = worker.check(program.source)
    for found in checked.problems:
        print(_sentence(options.file, found))
    if any(p.severity == "error" for p in checked.problems):
        return 1
    return build_program(config.root, program.source, options.output)


def _run(config: Config, options: argparse.Namespace) -> int:
    native = is_native(options.file)
    program = ProgramFile("") if native else read_program(options.file)
    if options.robot is not None:
        if native:
            raise BadInput(f"A built program drives by itself: {options.file} --robot {options.robot}")
        return _drive(config, program, options)
    arena = _arena(program, options)
    order = Order(
        seconds=_seconds(options.seconds),
        seed=_seed(options),
        speed=_speed(options.speed),
        hands=tuple(read_inputs(options.input)) if options.input is not None else (),
    )
    world = World(arena, order.seed)
    with contextlib.ExitStack() as stack:
        trace = stack.enter_context(_writable(options.trace)) if options.trace is not None else None
        if native:
            outcome = run_native(options.file, world, order, config.limits, _say, trace)
        else:
            worker = stack.enter_context(BlockingWorker(config))
            worker.ready()
            outcome = run_program(worker, program.source, world, order, config.limits, _say, trace)
    return _report(options.file, world, outcome)


def _grade(options: argparse.Namespace) -> int:
    """Several programs: a table, and the worst of their exit statuses."""
    for name in ("trace", "input", "robot"):
        if getattr(options, name) is not None:
            raise BadInput(f"--{name} is for one program at a time.")
    if options.world is not None:
        usable_arena(load_world(options.world), options.world)
    given = {"--world": options.world, "--seconds": options.seconds, "--seed": options.seed, "--speed": options.speed}
    passed = [text for name, value in given.items() if value is not None for text in (name, str(value))]
    grades = grade(programs_in(options.files), passed)
    print(table(grades))
    return max(g.status for g in grades)


def _drive(config: Config, program: ProgramFile, options: argparse.Namespace) -> int:
    """A real robot: only the time of a run can be chosen."""
    from .native import run_natively

    for name in ("world", "seed", "speed", "trace", "input"):
        if getattr(options, name) is not None:
            raise BadInput(f"--{name} is for the simulator; a real robot cannot have it.")
    seconds = MAX_SECONDS if options.seconds is None else _seconds(options.seconds)
    with BlockingWorker(config) as worker:
        worker.ready()
        problems, status = run_natively(worker, config.speaker, program.source, options.robot, seconds)
    for found in problems:
        print(_sentence(options.file, found), file=sys.stderr)
    return status


def _seed(options: argparse.Namespace) -> int:
    seed: int | None = options.seed
    return seed if seed is not None else random.SystemRandom().randrange(2**31)


def _report(file: Path, world: World | None, outcome: Outcome) -> int:
    sys.stdout.flush()
    for found in outcome.problems:
        print(_sentence(file, found), file=sys.stderr)
    last: dict[str, object] = {
        "time": outcome.steps / 50,
        "pose": {"x": world.x, "y": world.y, "theta": world.theta} if world is not None else None,
        "ended": outcome.ended if outcome.ended != "refused" else "error",
        "steps": outcome.steps,
        "wall": round(outcome.wall, 6),
    }
    if outcome.goals:
        last["goals"] = [state._asdict() for state in outcome.goals]
    print(msgspec.json.encode(last).decode())
    status = _EXITS[outcome.ended]
    missed = any(state.state != "done" for state in outcome.goals)
    return GOAL_MISSED if status == 0 and missed else status


def _say(text: str) -> None:
    print(_harmless(text), flush=True)


def _sentence(file: Path, found: Problem) -> str:
    where = f"{file}:{found.start.line}:{found.start.column}: " if found.start is not None else f"{file}: "
    who = "warning: " if found.severity == "warning" else ""
    return _harmless(" ".join(part for part in (f"{where}{who}{found.message}", found.hint, _moment(found)) if part))


def _moment(found: Problem) -> str:
    """When it happened in a run, and what the function was given then."""
    if found.time is None:
        return ""
    return f"(at {found.time:g} s" + (f", given: {', '.join(found.inputs)})" if found.inputs else ")")


def _harmless(text: str) -> str:
    """A program's words for a terminal, which would obey control characters: a sign in the place of each."""
    return "".join("\N{REPLACEMENT CHARACTER}" if category(c) in ("Cc", "Cs") and c not in "\t\n" else c for c in text)


def _arena(program: ProgramFile, options: argparse.Namespace) -> Arena:
    if options.world is not None:
        return usable_arena(load_world(options.world), options.world)
    if program.world is None:
        return usable_arena(named_world(DEFAULT_WORLD), DEFAULT_WORLD)
    if isinstance(program.world, str):
        return usable_arena(named_world(program.world), program.world)
    return usable_arena(program.world, f"The world in {options.file}")


def _seconds(wanted: float | None) -> float:
    if wanted is None:
        return DEFAULT_SECONDS
    if not 0 <= wanted <= MAX_SECONDS:
        raise BadInput(f"--seconds must be between 0 and {MAX_SECONDS:g}.")
    return wanted


def _speed(wanted: str | None) -> float | None:
    if wanted is None or wanted == "max":
        return None
    try:
        speed = float(wanted)
    except ValueError:
        speed = math.nan
    if not 0.01 <= speed <= 1000:
        raise BadInput("--speed must be a number between 0.01 and 1000, or max.")
    return speed


def _writable(path: Path) -> BinaryIO:
    try:
        return path.open("wb")
    except OSError as error:
        raise BadInput(f"{path} cannot be written: {error.strerror}.") from error
