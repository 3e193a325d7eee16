"""
Memory of a service at rest: of `./rosy start` when it is ready and computes nothing, before the first page.

Pages of memory that several processes share count for each by its share (the kernel's ``Pss``). What no file backs is
told beside it: the rest are programs and libraries, which the system may drop and read again.

GHC 9.0: 244 MB in all (goal 250), 140 to 144 MB without a file; GHC 9.6: 145 MB without a file.
"""

from __future__ import annotations

import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path

import psutil

from ..text_lines import text_lines

__all__ = ["GOAL", "Share", "at_rest", "report", "share_of"]

GOAL = 250.0
"""All of a service at rest, MB."""

_LOOK = 1.0
"""Between two looks at the processor time, s."""

_RESTING = 0.02
"""Processor time between two looks of a service that is at rest, s."""

_PATIENCE = 60.0


@dataclass(frozen=True, slots=True)
class Share:
    """The memory of one process, MB."""

    name: str
    proportional: float
    without_file: float


def share_of(rollup: str, name: str) -> Share:
    """What a process has, by proc(5), ``smaps_rollup``, in kB."""
    figures = {key: words[1] for key, *words in (line.replace(":", " :", 1).split() for line in text_lines(rollup)[1:])}
    kilobytes = {key: int(figures[key]) for key in ("Pss", "Pss_File")}
    return Share(name, kilobytes["Pss"] / 1024, (kilobytes["Pss"] - kilobytes["Pss_File"]) / 1024)


def at_rest(root: psutil.Process) -> list[Share]:
    """The memory of a process and all below it, once they compute nothing."""
    deadline = time.monotonic() + _PATIENCE
    before = -1.0
    while time.monotonic() < deadline:
        processes = [root, *root.children(recursive=True)]
        now = sum(sum(process.cpu_times()[:2]) for process in processes)
        if 0 <= now - before < _RESTING:
            break
        before = now
        time.sleep(_LOOK)
    return [
        share_of(Path(f"/proc/{process.pid}/smaps_rollup").read_text(), process.name())
        for process in [root, *root.children(recursive=True)]
    ]


def report() -> int:
    """Print a row for each process, and one for all; 0, or the exit status of a service that does not start."""
    command = [sys.executable, "-m", "rosy_sim", "serve", "--no-browser", "--port", "0"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as service:
        try:
            assert service.stdout is not None
            if not service.stdout.readline():
                # It has said why.
                return service.wait() or 1
            shares = at_rest(psutil.Process(service.pid))
        finally:
            service.terminate()
    print(f"{'a service at rest, before the first page':44}{'MB':>9}{'of them without a file':>26}")
    every = Share("all", sum(one.proportional for one in shares), sum(one.without_file for one in shares))
    for one in [*shares, every]:
        print(f"  {one.name:42}{one.proportional:9.1f}{one.without_file:26.1f}")
    print(f"  goal: {GOAL:.0f} MB")
    return 0
