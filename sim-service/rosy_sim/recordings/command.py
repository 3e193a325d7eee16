"""
Command ``replay``: a recorded run goes into a program again.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable
from pathlib import Path

from ..config import Config
from ..run.program_file import read_program
from ..sentence import Sentence, tr
from ..wire.problem import Problem
from ..worker.blocking_worker import BlockingWorker
from .mcap_file import Recording, open_recording
from .replay import Difference, replay, shown

__all__ = ["DIFFERENT", "add_replay_options", "replay_recording"]

DIFFERENT = 3
"""Exit status when the program sends other commands than the recorded ones."""


def add_replay_options(parser: argparse.ArgumentParser) -> None:
    """What ``replay`` takes."""
    parser.add_argument("file", type=Path)
    parser.add_argument("program", type=Path, nargs="?")


def replay_recording(
    config: Config,
    options: argparse.Namespace,
    say: Callable[[Sentence], None],
    tell_problem: Callable[[Path, Problem], None],
) -> int:
    """Replay a recording into its own program, or into another one; returns the exit status."""
    with open_recording(options.file) as recording, BlockingWorker(config) as worker:
        worker.ready()
        source = recording.details.program if options.program is None else read_program(options.program).source
        result = replay(worker, source, recording.lines())
        for problem in result.problems:
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
