"""
Choice of the command by the options.

Every expected failure ends as one sentence on stderr; the exit status is the error's own.
"""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Sequence
from dataclasses import replace

import msgspec

from ..classroom.command import run_class_command
from ..classroom.store.class_places import class_place
from ..cluster.command import run_cluster_command
from ..config import Config, discover
from ..errors import BadInput, OutputFailed, RosyError
from ..maps.command import make_room
from ..ownership.robot_configuration import read_robot_configuration
from ..recordings.command import replay_recording
from ..run.program_file import read_program
from ..sentences.sentence import tr
from ..sentences.terminal_text import escape_json, neutralize_line
from ..sentences.wording import in_terminal
from ..wire.problem import is_complete
from ..worker.native_build import build_program
from .checked_worker import started_worker, warn_without_sandbox
from .output import flush_output, print_error, print_problem, print_sentence, print_text
from .parser import options_parser
from .problem_text import format_problem
from .run_command import run_command

__all__ = ["main"]


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a command; returns the exit status."""
    try:
        status = _command(arguments)
        flush_output()
        return status
    except OutputFailed as error:
        # What is still buffered would fail again at the exit of the interpreter.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        if not error.reader_left:
            print_error(error)
        return error.exit_status
    except RosyError as error:
        print_error(error)
        return error.exit_status
    except KeyboardInterrupt:
        return 130


def _command(arguments: Sequence[str] | None) -> int:
    options, unknown = options_parser().parse_known_args(arguments)
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
        from ..web.server import serve

        if options.runs is not None:
            if options.runs < 1:
                raise BadInput(tr("--runs says how many programs may run at once: at least 1."))
            config = config.with_limits(replace(config.limits, runs=options.runs))
        robots = read_robot_configuration(config.robot_executable, options.robot, options.robots)
        config = replace(config, robots=robots, class_name=options.class_name, records=not options.no_record)
        host = options.host or ("127.0.0.1" if options.class_name is None else "0.0.0.0")
        return serve(config, host, options.port, not options.no_browser, options.unprotected)
    if options.command == "node":
        return run_cluster_command(config, options, print_text)
    if options.command == "class":
        return run_class_command(class_place(config.classes, config.class_database), options, print_text)
    if options.command == "lsp":
        # Imported for this command alone: the types of the protocol take a third of a second.
        from ..lsp.server import serve_editor

        warn_without_sandbox(config)
        return serve_editor(config)
    if options.command == "build":
        return _build(config, options)
    if options.command == "check":
        return _check(config, options)
    if options.command == "room":
        return make_room(options, print_sentence)
    if options.command == "replay":
        if not options.fit:
            warn_without_sandbox(config)
        return replay_recording(config, options, print_sentence, print_problem)
    return run_command(config, options)


def _check(config: Config, options: argparse.Namespace) -> int:
    program = read_program(options.file)
    with started_worker(config) as worker:
        worker.ready()
        checked = worker.check(program.source)
    if options.json:
        answer = {"problems": checked.problems, "declarations": checked.declarations, "graph": checked.graph}
        print_text(escape_json(msgspec.json.encode(answer).decode()))
    else:
        for found in checked.problems:
            print_text(format_problem(options.file, found, sys.stdout.isatty()))
        if not checked.problems:
            print_text(f"{neutralize_line(str(options.file))}: {in_terminal(tr('no problems.'))}")
    return 0 if is_complete(checked.problems) else 1


def _build(config: Config, options: argparse.Namespace) -> int:
    """A native program, of what the worker would run."""
    program = read_program(options.file)
    with started_worker(config) as worker:
        worker.ready()
        checked = worker.check(program.source)
    for found in checked.problems:
        print_text(format_problem(options.file, found, sys.stdout.isatty()))
    if not is_complete(checked.problems):
        return 1
    return build_program(config.root, program.source, options.output)
