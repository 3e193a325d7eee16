"""
Preparation of one page's next run: its program is compiled when a check has found no mistake in it.

So Run starts a program that is compiled already. The text has to stand still for a moment first; a program that runs
is prepared again, for the next press of Run.
"""

from __future__ import annotations

import asyncio

from ...wire.problem import Problem
from ...worker.prepared_runs import PreparedRun, PreparedRuns

__all__ = ["PagePreparation"]

_PAUSE = 0.15
"""How long a text stands still before it is prepared, s: a pause in typing, and sooner than a hand is at Run."""


class PagePreparation:
    """Of one page; close() ends what is prepared."""

    def __init__(self, runs: PreparedRuns) -> None:
        self._runs = runs
        # The text in which the latest check found no mistake.
        self._source: str | None = None
        self._timer: asyncio.TimerHandle | None = None

    def on_edited(self, source: str) -> None:
        """The page asks for a check of this text: what is prepared of another is of no use any more."""
        if source != self._source:
            self._source = None
            self.close()

    def on_checked(self, source: str, problems: list[Problem]) -> None:
        """The answer to a check."""
        if any(problem.severity == "error" for problem in problems):
            return
        self._source = source
        self._prepare_soon()

    def take(self, source: str) -> PreparedRun | None:
        """What is prepared of this text, for a run that begins now."""
        prepared = self._runs.take(self, source)
        if source == self._source:
            self._prepare_soon()
        return prepared

    def close(self) -> None:
        """Prepare nothing, and discard what is prepared."""
        self._cancel()
        self._runs.discard(self)

    def _prepare_soon(self) -> None:
        self._cancel()
        self._timer = asyncio.get_running_loop().call_later(_PAUSE, self._prepare)

    def _prepare(self) -> None:
        self._timer = None
        if self._source is not None:
            self._runs.prepare(self, self._source)

    def _cancel(self) -> None:
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None
