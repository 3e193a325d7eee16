"""
Whether a worker still lives: it answers a ``ping`` at once, whatever is being compiled. One that does not is wedged.

A worker that merely waits for the processor, on a machine that is too busy, is not: it is given more time. What the
system knows about the process tells the two apart. proc(5).
"""

from __future__ import annotations

import contextlib
import os
from pathlib import Path

__all__ = ["BEAT", "Pulse", "inside"]

BEAT = 0.15
"""Between two looks, s."""

_SILENT = 4
"""Looks without an answer, after which a worker that does nothing is wedged: it is replaced within a second."""

_SILENT_WAITING = 40
"""The same for one that waits for the processor or the disk."""

_COMPUTED = 0.4
"""Computing without an answer, s, after which it runs in circles. The longest that it does at a time, tidying its
memory, is half of that."""


class Pulse:
    """Of one worker process. ``heard`` at every sign of life, ``beat`` at every look, ``stopped`` before it is warm."""

    def __init__(self, pid: int) -> None:
        self._pid = pid
        self._silent = 0
        self._computed = 0.0
        self._stopped = 0

    def heard(self) -> None:
        """It has said something."""
        self._silent = 0

    def beat(self) -> bool:
        """Look once more; whether it is wedged."""
        state, computed = _looks(inside(self._pid))
        if self._silent == 0:
            self._computed = computed
        self._silent += 1
        if state == "R":
            return (self._silent > _SILENT and computed - self._computed >= _COMPUTED) or self._silent > _SILENT_WAITING
        return self._silent > (_SILENT_WAITING if state == "D" else _SILENT)

    def stopped(self) -> bool:
        """Look at one that is not warm yet and so cannot answer; whether somebody has stopped it."""
        self._stopped = self._stopped + 1 if _looks(inside(self._pid))[0] in "Tt" else 0
        return self._stopped >= _SILENT


def inside(pid: int) -> int:
    """The process that a sandbox is around."""
    with contextlib.suppress(OSError, ValueError, IndexError):
        while Path(f"/proc/{pid}/comm").read_text() == "bwrap\n":
            pid = int(Path(f"/proc/{pid}/task/{pid}/children").read_text().split()[0])
    return pid


def _looks(pid: int) -> tuple[str, float]:
    """The letter of a process's state, and how long it has computed, s."""
    try:
        fields = Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
        return fields[0], (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
    except (OSError, IndexError, ValueError):
        return "X", 0.0
