"""
Process that makes the MCAP file of a run, and says where it is: ``python -m rosy_sim.recordings FOLDER NAME ENDED``;
without a name those of runs that were killed.
"""

from __future__ import annotations

import os
import sys
from dataclasses import replace
from pathlib import Path

from ..errors import BadInput
from ..sentences.sentence import Sentence
from ..sentences.terminal_text import neutralize_line
from ..sentences.wording import in_terminal
from .recording_folder import Finished, RecordingFolder, recorded_sentence

_LOWEST_PRIORITY = 19
"""setpriority(2)"""


def main(folder: str, name: str | None = None, ended: str = "") -> int:
    """Returns the exit status."""
    os.nice(_LOWEST_PRIORITY)
    if name is None:
        for path in RecordingFolder(Path(folder)).finish_abandoned():
            _say(recorded_sentence(Finished(path, 0)))
        return 0
    try:
        pending, details = RecordingFolder(Path(folder)).pending(name)
        finished = pending.finish(replace(details, ended=ended))
    except BadInput as error:
        _say(error.sentence)
        return error.exit_status
    if finished is not None:
        _say(recorded_sentence(finished))
    return 0


def _say(sentence: Sentence) -> None:
    print(f"rosy: {neutralize_line(in_terminal(sentence))}", file=sys.stderr)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:4]))
