"""
Choice of the command by the options.

Every expected failure ends as one sentence on stderr; the exit status is the error's own.
"""

from __future__ import annotations

import argparse
import asyncio
import os
import sys
import time
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import msgspec

from ..classroom.command import run_class_command
from ..classroom.exports.written_tests import mark_answers
from ..classroom.store.class_places import class_place
from ..cluster.command import run_cluster_command
from ..config import Config, discover
from ..errors import BadInput, OutputFailed, RosyError
from ..maps.command import make_room
from ..ownership.robot_configuration import read_nearby_addresses, read_robot_configuration, read_simulator_address
from ..programs.program_file import ProgramFile, read_program
from ..recordings.command import replay_recording
from ..run.grading import programs_in
from ..sentences.sentence import tr
from ..sentences.terminal_text import escape_json, neutralize_line
from ..sentences.wording import in_terminal
from ..wire.problem import Problem, is_complete
from ..worker.native_build import build_program, refuse_other_processor
from .checked_worker import started_worker, warn_without_sandbox
from .output import flush_output, print_error, print_note, print_problem, print_sentence, print_text
from .parser import options_parser
from .problem_text import format_problem
from .robots_command import list_robots
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
        from ..web.public_address import with_public_address
        from ..web.server import serve

        if options.runs is not None:
            if options.runs < 1:
                raise BadInput(tr("--runs says how many programs may run at once: at least 1."))
            config = config.with_limits(replace(config.limits, runs=options.runs))
        named, nearby = read_nearby_addresses(config.robot_executable, options.robot)
        robots = read_robot_configuration(config.robot_executable, named, options.robots)
        config = replace(config, robots=robots, nearby=nearby)
        config = replace(config, class_name=options.class_name, records=not options.no_record)
        if options.ros2 is not None:
            if options.class_name is not None or options.public is not None:
                raise BadInput(
                    tr("--ros2 is for the robot of one page, your own; it does not go with --class or --public.")
                )
            config = replace(config, simulator_address=read_simulator_address(options.ros2))
        if options.public is not None:
            config = with_public_address(config, options.public)
        is_local = options.class_name is None or config.public is not None
        host = options.host or ("127.0.0.1" if is_local else "0.0.0.0")
        opens_browser = not options.no_browser and config.public is None
        return serve(config, host, options.port, opens_browser, options.unprotected)
    if options.command == "node":
        return run_cluster_command(config, options, print_text)
    if options.command == "class" and options.action == "marks":
        return mark_answers(config.examples / "written-tests.json", options.name, options.output, print_text)
    if options.command == "class":
        classes = class_place(config.classes, config.class_database)
        return run_class_command(classes, options, time.time(), print_text, _typed_line, config.examples)
    if options.command == "lsp":
        # Imported for this command alone: the types of the protocol take a third of a second.
        from ..lsp.server import serve_editor

        warn_without_sandbox(config)
        return serve_editor(config)
    if options.command == "build":
        return _build(config, options)
    if options.command == "check":
        return _check(config, options)
    if options.command == "robots":
        return list_robots(config.robot_executable, options.addresses, options.seconds, print_text)
    if options.command == "room":
        return make_room(options, print_sentence)
    if options.command == "replay":
        if not options.fit:
            warn_without_sandbox(config)
        return replay_recording(config, options, print_sentence, print_problem)
    return run_command(config, options)


def _typed_line() -> str | None:
    """The next line that a person types; ``None`` when standard input is no terminal."""
    if not sys.stdin.isatty():
        return None
    flush_output()
    return sys.stdin.readline()


def _check(config: Config, options: argparse.Namespace) -> int:
    if os.path.isdir(options.file):
        return _check_folder(config, options)
    program = read_program(options.file, options.encoding)
    with started_worker(config) as worker:
        [conflicts] = _conflicts(config, [program.source])
        worker.ready()
        checked = worker.check(program.source)
    problems = program.in_file([*checked.problems, *conflicts])
    if options.json:
        answer: dict[str, object] = {"problems": problems}
        for name, value in (("declarations", checked.declarations), ("graph", checked.graph)):
            literate = program.literate
            answer[name] = literate.json_in_file(msgspec.json.decode(value)) if literate is not None else value
        print_text(escape_json(msgspec.json.encode(answer).decode()))
    else:
        _print_problems(options.file, problems)
    return 0 if is_complete(problems) else 1


def _conflicts(config: Config, sources: Sequence[str]) -> list[list[Problem]]:
    """Functions of each program that override each other's commands; a sentence says where they cannot be found."""
    # Imported for this command alone, like the language server that it belongs to; the worker starts meanwhile.
    from ..lsp.document import Document
    from ..lsp.text_service import TextService, TextServiceMissing

    async def ask() -> list[list[Problem]]:
        service = TextService(config.text_service)
        try:
            return [await service.conflicts(Document("", source, None)) for source in sources]
        finally:
            await service.close()

    try:
        return asyncio.run(ask())
    except TextServiceMissing as error:
        print_note(error.no_conflicts)
        return [[] for _ in sources]


def _check_folder(config: Config, options: argparse.Namespace) -> int:
    """Every program of a folder; one that cannot be read is reported, and the next one is checked."""
    if options.json:
        raise BadInput(tr("--{name} is for one program at a time.", name="json"))
    files = programs_in([options.file])
    with started_worker(config) as worker:
        programs: dict[Path, ProgramFile] = {}
        for file in files:
            try:
                programs[file] = read_program(file, options.encoding)
            except BadInput as error:
                print_error(error)
        status = 0 if len(programs) == len(files) else 1
        found = _conflicts(config, [program.source for program in programs.values()])
        worker.ready()
        for (file, program), conflicts in zip(programs.items(), found, strict=True):
            problems = program.in_file([*worker.check(program.source).problems, *conflicts])
            _print_problems(file, problems)
            status = status if is_complete(problems) else 1
    return status


def _print_problems(file: Path, problems: Sequence[Problem]) -> None:
    for found in problems:
        print_text(format_problem(file, found, sys.stdout.isatty()))
    if not problems:
        print_text(f"{neutralize_line(str(file))}: {in_terminal(tr('no problems.'))}")


def _build(config: Config, options: argparse.Namespace) -> int:
    """A native program, of what the worker would run."""
    if options.processor:
        refuse_other_processor(options.processor, options.file, options.output)
    program = read_program(options.file, options.encoding)
    with started_worker(config) as worker:
        worker.ready()
        checked = worker.check(program.source)
    for found in program.in_file(checked.problems):
        print_text(format_problem(options.file, found, sys.stdout.isatty()))
    if not is_complete(checked.problems):
        return 1
    return build_program(config.root, program.source, options.output)
