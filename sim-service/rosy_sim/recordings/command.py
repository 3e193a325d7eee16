"""
Command ``replay``: a recorded run goes into a program again, or the simulated robot is fitted to the recorded one.
"""

from __future__ import annotations

import argparse
import math
import sys
from collections.abc import Callable
from pathlib import Path

import msgspec

from ..atomic_file import AtomicFile
from ..config import Config
from ..errors import BadInput
from ..programs.program_file import ProgramFile, read_program
from ..sentences.sentence import Sentence, tr
from ..wire.problem import Problem
from ..worker.blocking_worker import BlockingWorker
from ..worlds.gallery import DEFAULT_WORLD, load_world, usable_world
from .fit import Fit, fit, recorded_drive
from .mcap_file import Recording, open_recording
from .recording_folder import finish_left
from .replay import Difference, replay, shown

__all__ = ["DIFFERENT", "add_replay_options", "replay_recording"]

DIFFERENT = 3
"""Exit status when the program sends other commands than the recorded ones."""


def add_replay_options(parser: argparse.ArgumentParser) -> None:
    """What ``replay`` takes."""
    parser.add_argument("file", type=Path)
    parser.add_argument("program", type=Path, nargs="?")
    parser.add_argument("--fit", action="store_true")
    parser.add_argument("--world")
    parser.add_argument("-o", dest="output", type=Path, metavar="ROOM")


def replay_recording(
    config: Config,
    options: argparse.Namespace,
    say: Callable[[Sentence], None],
    tell_problem: Callable[[Path, Problem], None],
) -> int:
    """
    Replay a recording into its own program, or into another one, or fit the simulator to it; returns the exit status.

    Raises:
        BadInput: the recording or the room cannot be used, or the robot drove too little.
    """
    finish_left(options.file)
    if options.file.suffix == ".log":
        options.file = options.file.with_suffix(".mcap")
    if options.fit:
        if options.program is not None:
            raise BadInput(tr("--fit looks at the recorded run alone and takes no program."))
        return _fit_recording(options, say)
    if options.world is not None or options.output is not None:
        raise BadInput(tr("--world and -o are for --fit."))
    with open_recording(options.file) as recording, BlockingWorker(config) as worker:
        worker.ready()
        program = ProgramFile(recording.details.program)
        if options.program is not None:
            program = read_program(options.program, options.encoding)
        result = replay(worker, program.source, recording.lines())
        for problem in program.in_file(result.problems):
            tell_problem(options.program or options.file, problem)
        sys.stderr.flush()
        if result.is_refused:
            return 1
        _tell_gaps(recording, say)
        if result.difference is not None:
            say(_difference_sentence(result.difference))
            return DIFFERENT
        say(
            tr(
                "The same commands as recorded, byte for byte: {commands}, in {seconds} s.",
                commands=result.commands,
                seconds=round(result.time, 2),
            )
        )
    return 0


def _fit_recording(options: argparse.Namespace, say: Callable[[Sentence], None]) -> int:
    """Fit the simulated robot to the recorded one, and write a room with it."""
    name = options.world if options.world is not None else DEFAULT_WORLD
    world = load_world(name)
    robot = usable_world(world, name).robot
    with open_recording(options.file) as recording:
        found = fit(recorded_drive(recording.lines()), robot.limits)
        _tell_gaps(recording, say)
    if not found.realism():
        raise BadInput(
            tr(
                "The robot drives {way} m and turns {turn}° in this run; to tell how it drives, it takes 0.3 m or 60°.",
                way=round(found.way, 2),
                turn=round(math.degrees(found.turn)),
            )
        )
    for sentence in _fit_sentences(found):
        say(sentence)
    output: Path = options.output or options.file.with_suffix(".json")
    fitted = {**world, "name": output.stem, "realism": {**world.get("realism", {}), **found.realism()}}
    usable_world(fitted, str(output))
    with AtomicFile(output) as file:
        file.write(msgspec.json.format(msgspec.json.encode(fitted), indent=2) + b"\n")
    say(tr("{output}: the room {room} with such a robot; --world and the page open it.", output=output, room=name))
    return 0


def _fit_sentences(found: Fit) -> list[Sentence]:
    said: list[Sentence] = []
    if found.travel is not None:
        said.append(
            tr("travel {travel}: it drove {percent} % of the way that it was told.",
               travel=round(found.travel, 3), percent=round(100 * found.travel))
        )  # fmt: skip
    else:
        said.append(tr("travel: it drove too little to tell."))
    if found.turning is not None:
        said.append(
            tr("turning {turning}: it turned {percent} % of the angle that it was told.",
               turning=round(found.turning, 3), percent=round(100 * found.turning))
        )  # fmt: skip
    else:
        said.append(tr("turning: it turned too little to tell."))
    if found.veer is not None:
        said.append(
            tr("veer {veer}: for each metre it turned {degrees}° to the left (to the right, if negative).",
               veer=round(found.veer, 3), degrees=round(math.degrees(found.veer), 1))
        )  # fmt: skip
    else:
        said.append(tr("veer: it needs some way straight ahead to tell."))
    if found.latency is not None:
        said.append(tr("latency {latency}: so many s from a command to the wheels.", latency=round(found.latency, 2)))
    said.extend(
        tr("A room cannot have that {name}; the nearest that it can have is written: {limit}.", name=name, limit=limit)
        for name, limit in found.beyond().items()
    )
    return said


def _tell_gaps(recording: Recording, say: Callable[[Sentence], None]) -> None:
    if not recording.is_complete:
        say(tr("The end of the run is not in the recording."))
    if recording.left_out:
        say(
            tr("The disk was too slow for the recording; batches of lines that are missing: {n}.", n=recording.left_out)
        )


def _difference_sentence(difference: Difference) -> Sentence:
    recorded, replayed = shown(difference.recorded), shown(difference.replayed)
    time = round(difference.time, 2)
    if recorded is not None and replayed is not None:
        return tr(
            "After {time} s the program sends {replayed}. Recorded is {recorded}.",
            time=time,
            replayed=replayed,
            recorded=recorded,
        )
    if replayed is not None:
        return tr("After {time} s the program sends {replayed}. Recorded is nothing.", time=time, replayed=replayed)
    if recorded is not None:
        return tr("After {time} s the program sends nothing. Recorded is {recorded}.", time=time, recorded=recorded)
    return tr("After {time} s the program ends, or does not end, other than recorded.", time=time)
