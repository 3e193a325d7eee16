"""
Process that reads a recording for the service: ``python -m rosy_sim.recordings.reading_process NAME``.

In: an MCAP file on standard input, which may come from anywhere, and what messages call it. Out: a line of JSON, then
the lines of the robot link as in a log (protocol/README.md, section 7.1). A file that takes more memory or processor
time than this process may use ends it and nothing else.
"""

from __future__ import annotations

import os
import resource
import sys
from pathlib import Path

import msgspec

from ..errors import BadInput
from ..wire.problem import Sentence, to_wire
from .link_log import log_line
from .mcap_file import RunDetails, read_recording

__all__ = ["Heading", "Unreadable"]

_MEMORY = 500_000_000
"""Bytes of address space: twice what it takes with a record of the largest size (``mcap_records``)."""

_COMPUTING = 60
"""s of processor time; ten minutes of a run take one."""

_PRIORITY = 10
"""setpriority(2)"""


class Heading(msgspec.Struct, tag="recording", tag_field="is"):
    """The first line about a recording. ``seconds`` is its length."""

    details: RunDetails
    is_complete: bool
    left_out: int
    seconds: float


class Unreadable(msgspec.Struct, tag="unreadable", tag_field="is"):
    """The only line about a file that is none."""

    message: str
    sentence: Sentence | None


def main(name: str) -> int:
    """Returns the exit status."""
    os.nice(_PRIORITY)
    resource.setrlimit(resource.RLIMIT_AS, (_MEMORY, _MEMORY))
    resource.setrlimit(resource.RLIMIT_CPU, (_COMPUTING, _COMPUTING))
    output = sys.stdout.buffer
    try:
        recording = read_recording(sys.stdin.buffer, Path(name))
        heading = Heading(recording.details, recording.is_complete, recording.left_out, recording.seconds)
        output.write(msgspec.json.encode(heading) + b"\n")
        for line in recording.lines():
            output.write(log_line(line))
        # Without the last line of a log the file is damaged.
        output.write(b". %d\n" % recording.left_out)
    except BadInput as error:
        said = Unreadable(str(error.sentence), to_wire(error.sentence))
        output.write(msgspec.json.encode(said) + b"\n")
    except BrokenPipeError:
        # The service has read enough. Nothing is to be flushed at the end.
        os._exit(0)
    output.flush()
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
