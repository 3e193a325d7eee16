"""
Runs that the worker compiles before they are asked for: at most one of each page, and a bounded number of all.

A prepared program waits in a process of its own, with all its rights given up, at its robot link. What it does not do:
decide what to prepare and when (``web.sessions.page_preparation``).
"""

from __future__ import annotations

import socket
from dataclasses import dataclass

from .supervisor import RunningProgram, WorkerSupervisor

__all__ = ["PreparedRun", "PreparedRuns"]


@dataclass(frozen=True, slots=True)
class PreparedRun:
    """A run that has not been asked for. Its owner closes the link."""

    source: str
    program: RunningProgram
    # Our end of its robot link.
    link: socket.socket


class PreparedRuns:
    """
    The prepared runs of all pages.

    Args:
        most: how many there are at once; the page that has not prepared one for longest loses its own.
    """

    def __init__(self, worker: WorkerSupervisor, most: int) -> None:
        self._worker = worker
        self._most = most
        # By page, the one that was prepared first comes first.
        self._runs: dict[object, PreparedRun] = {}

    def __len__(self) -> int:
        return len(self._runs)

    def prepare(self, page: object, source: str) -> None:
        """Prepare a run of this text, unless that has been done; what the page had prepared before is discarded."""
        known = self._runs.get(page)
        if known is not None and known.source == source and not known.program.started.done():
            return
        self.discard(page)
        if self._most < 1:
            return
        ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_STREAM)
        program = self._worker.prepare(source, theirs)
        if program is None:
            ours.close()
            return
        while len(self._runs) >= self._most:
            self.discard(next(iter(self._runs)))
        self._runs[page] = PreparedRun(source, program, ours)

    def take(self, page: object, source: str) -> PreparedRun | None:
        """The page's prepared run of exactly this text, which is the caller's now."""
        known = self._runs.get(page)
        if known is None or known.source != source:
            return None
        if known.program.started.done():
            # Refused by a worker that has too many, or lost with its worker.
            self.discard(page)
            return None
        del self._runs[page]
        return known

    def discard(self, page: object) -> None:
        """End what this page has prepared, if anything."""
        known = self._runs.pop(page, None)
        if known is not None:
            known.link.close()
            self._worker.kill(known.program)
