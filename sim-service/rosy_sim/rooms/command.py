"""
Command ``./rosy run … --rooms N``: options in, tests of one program after the other, reports out.

Progress is shown on a terminal only. The smallest failing room of each program becomes a file in the folder
that ``--smallest`` names, or in the current one.
"""

from __future__ import annotations

import argparse
import os
import shlex
import sys
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

import msgspec

from ..atomic_file import AtomicFile
from ..config import Config
from ..errors import BadInput
from ..programs.program_file import read_program
from ..run.grading import programs_in
from ..run.steps.velocity_guard import SafetySettings
from ..sentences.sentence import tr
from ..sentences.terminal_text import escape_json, neutralize_line
from ..sentences.wording import in_terminal, machine_wording
from ..wire.problem import worded
from ..worker.background_process import WorkerSetup
from ..worker.native_build import is_native
from ..world.properties import BadProperty, read_properties
from .generation.families import read_family
from .programs import Pool, Progress, Tested, test_programs
from .report_text import format_report, report_values, worst_status
from .room_test import MAX_ROOMS, Report, RoomTest, check_goals
from .trial_pool import TrialPool

__all__ = ["add_options", "check_options", "test_in_rooms"]

DEFAULT_FAMILY, DEFAULT_SEED, DEFAULT_PROPERTIES = "obstacles", 1, "reaches-goal never-falls"
"""What is tested when the options do not say."""

MAX_SECONDS = 3600.0
"""Longest run in each room, s."""

_ONLY_WITH_ROOMS = ("family", "hold", "json", "processes", "cluster", "smallest")
_NOT_WITH_ROOMS = ("world", "speed", "trace", "input", "robot")


@dataclass(frozen=True, slots=True)
class _Output:
    """Where results and progress go."""

    write: Callable[[str], None]
    is_terminal: bool

    def progress(self, text: str) -> None:
        """Replace the last line of a terminal."""
        if self.is_terminal:
            sys.stderr.write(f"\r\033[K{text}")
            sys.stderr.flush()


def add_options(parser: argparse.ArgumentParser) -> None:
    """The options that belong to tests in many rooms."""
    parser.add_argument("--rooms", type=int, metavar="N")
    parser.add_argument("--family", metavar="NAME")
    parser.add_argument("--hold", nargs="+", action="extend", metavar="PROPERTY")
    parser.add_argument("--json", action="store_true", default=None)
    parser.add_argument("--processes", type=int, metavar="N")
    parser.add_argument("--cluster", metavar="ADDRESS")
    parser.add_argument("--smallest", type=Path, metavar="FOLDER")


def check_options(options: argparse.Namespace) -> None:
    """
    Refuse options that do not go together.

    Raises:
        BadInput: one sentence about the first of them.
    """
    if options.rooms is None:
        for name in _ONLY_WITH_ROOMS:
            if getattr(options, name) is not None:
                raise BadInput(tr("--{name} is for a test in many rooms; say how many with --rooms.", name=name))
        return
    if options.csv:
        raise BadInput(tr("--csv is for the table of a folder; with --rooms there is --json."))
    for name in _NOT_WITH_ROOMS:
        if getattr(options, name) is not None:
            if name == "world":
                raise BadInput(
                    tr("--world is for one run, not for --rooms; for rooms like one, use --family like:ROOM.")
                )
            raise BadInput(tr("--{name} is for one run, not for --rooms.", name=name))


def test_in_rooms(
    config: Config,
    options: argparse.Namespace,
    seconds: float,
    safety: SafetySettings,
    write: Callable[[str], None],
    connect: Callable[[str], Pool],
) -> int:
    """
    Test the programs of some files and folders; returns the exit status. ``connect`` gives the pool of the cluster at
    an address.
    """
    test = replace(_room_test(options, seconds), safety=safety)
    processes = options.processes if options.processes is not None else len(os.sched_getaffinity(0))
    if not 1 <= processes <= 256:
        raise BadInput(tr("--processes must be between 1 and 256."))
    files = programs_in(options.files)
    for file in files:
        if is_native(file):
            raise BadInput(tr("{file} is a built program; --rooms tests programs from their text.", file=file))
    output = _Output(write, sys.stderr.isatty())
    sources = [read_program(file, options.encoding).source for file in files]
    reports: list[Report] = []
    values: list[dict[str, object]] = []
    folder: Path = options.smallest or Path()
    _make_folder(folder)
    local = min(processes, test.rooms * len(files))
    with TrialPool(WorkerSetup.of(config), local) if options.cluster is None else connect(options.cluster) as pool:
        progress = Progress(partial(_show_progress, output, test.rooms * len(files)))
        for file, tested in zip(files, test_programs(test, sources, pool, progress), strict=True):
            output.progress("")
            reports.append(tested.report)
            room_file = _write_smallest(folder, file, files, tested.report)
            values.append(report_values(str(file), tested.report, room_file))
            if not options.json:
                _print_report(file, test, tested, room_file, output)
    if options.json:
        head = {
            "family": test.family.name,
            "rooms": test.rooms,
            "seed": test.seed,
            "seconds": test.seconds,
            "properties": [str(wanted) for wanted in test.properties],
        }
        write(escape_json(msgspec.json.encode({**head, "programs": values}).decode()))
    return worst_status(reports)


def _room_test(options: argparse.Namespace, seconds: float) -> RoomTest:
    if not 1 <= options.rooms <= MAX_ROOMS:
        raise BadInput(tr("--rooms must be between 1 and {most}.", most=MAX_ROOMS))
    if not 0 < seconds <= MAX_SECONDS:
        raise BadInput(tr("--seconds must be more than 0 and at most {most} with --rooms.", most=MAX_SECONDS))
    try:
        properties = read_properties(" ".join(options.hold or [DEFAULT_PROPERTIES]))
    except BadProperty as error:
        raise BadInput(tr("--hold: {why}", why=error)) from error
    family = read_family(options.family or DEFAULT_FAMILY)
    seed = DEFAULT_SEED if options.seed is None else options.seed
    check_goals(family, properties)
    return RoomTest(family, options.rooms, seed, seconds, properties)


def _show_progress(output: _Output, rooms: int, done: int, passed: int, shrunk: int) -> None:
    counted = in_terminal(tr("{done} of {all} rooms, {passed} passed", done=done, all=rooms, passed=passed))
    shrinking = in_terminal(tr("looking for the smallest failing room, {tried} tried", tried=shrunk)) if shrunk else ""
    output.progress("; ".join(filter(None, (counted, shrinking))))


def _make_folder(folder: Path) -> None:
    """Before the test, which may take long."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise BadInput(
            tr("The folder {folder} cannot be made: {why}.", folder=folder, why=error.strerror or "")
        ) from error


def _write_smallest(folder: Path, file: Path, files: list[Path], report: Report) -> str | None:
    """The smallest failing room as a file that ``--world`` opens."""
    if report.smallest is None:
        return None
    # Programs in folders are often all called program.rosy.
    stem = file.stem if len(files) == 1 else "-".join((*file.parent.parts[-1:], file.stem))
    path = folder / f"{stem}-smallest-room.json"
    with AtomicFile(path) as written:
        written.write(msgspec.json.format(msgspec.json.encode(report.smallest.shrunk.world), indent=2) + b"\n")
    return str(path)


def _print_report(file: Path, test: RoomTest, tested: Tested, room_file: str | None, output: _Output) -> None:
    report = tested.report
    if report.lost is not None:
        lost = tr("this program ended the compiler part of Rosy twice: {why}", why=report.lost)
        output.write(neutralize_line(f"{file}: {in_terminal(lost)}"))
        return
    if report.refused:
        for refused in report.refused:
            problem = worded(refused, machine_wording())
            where = f":{problem.start.line}:{problem.start.column}" if problem.start is not None else ""
            output.write(neutralize_line(f"{file}{where}: {problem.message} {problem.hint}".rstrip()))
        return
    output.write(format_report(str(file), report))
    if report.smallest is None or room_file is None:
        return
    shrunk, outcome = report.smallest.shrunk, report.smallest.outcome
    proof = tr("no smaller one fails") if shrunk.is_minimal else tr("a smaller one may fail as well")
    smallest = tr(
        "Smallest failing room: room {room} with {things} of its {all} things; {proof}.",
        room=outcome.room,
        things=shrunk.things,
        all=shrunk.of,
        proof=proof,
    )
    output.write(neutralize_line(in_terminal(smallest)))
    tried = tr(
        "Rooms tried for it: {tried}, in {seconds} s.", tried=shrunk.trials, seconds=f"{tested.shrink_seconds:.1f}"
    )
    output.write(neutralize_line(in_terminal(tried)))
    options = f"--world {shlex.quote(room_file)} --seed {outcome.seed} --seconds {test.seconds:g}"
    if test.safety.on:
        limits = {"max-speed": test.safety.max_speed, "max-turn": test.safety.max_turn}
        options += " --safety on" + "".join(f" --{name} {most:g}" for name, most in limits.items() if most is not None)
    output.write(
        neutralize_line(in_terminal(tr("See it: {command}", command=f"./rosy run {shlex.quote(str(file))} {options}")))
    )
