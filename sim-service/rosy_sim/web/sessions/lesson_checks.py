"""
Checks of the lesson's step that a page is at: about the program whenever it was checked, and about each run.
"""

from __future__ import annotations

from collections.abc import Callable

import msgspec

from ...errors import BadInput
from ...lessons.lesson_watch import BadStep, CheckedStep, LessonWatch, examine_step
from ...lessons.program_graph import ProgramGraph, read_graph
from ...run.steps.lockstep import Lockstep
from ...sentences.sentence import tr
from ...wire import page
from ...wire.problem import is_complete
from ...wire.worker import Checked
from ...world.arena import Arena

__all__ = ["LessonChecks"]


class LessonChecks:
    """Of one page. ``send`` puts a message into the page's outbox."""

    def __init__(self, send: Callable[[page.ChecksShown], None]) -> None:
        self._send = send
        self._step: CheckedStep | None = None
        # The run that is watched, and its number; None before the first.
        self._watch: LessonWatch | None = None
        self._run = 0
        # The source that is run, until the compiler has told its graph.
        self._source: str | None = None
        # The latest program that was checked, and its graph.
        self._checked: tuple[str, ProgramGraph] | None = None

    def choose(self, step: object, arena: Arena) -> None:
        """
        The page is at another step, or at none.

        Raises:
            BadInput: this is no step, or its checks do not fit the room.
        """
        self._watch = None
        self._step = None
        if step is None:
            return
        try:
            self._step = msgspec.convert(step, CheckedStep)
            examine_step(self._step, arena)
        except (msgspec.ValidationError, BadStep) as error:
            self._step = None
            raise BadInput(tr("The checks of this lesson cannot be used: {why}.", why=error)) from error
        self._show_structure(arena)

    def on_checked(self, source: str, checked: Checked, arena: Arena) -> None:
        """The compiler has answered about a program."""
        if not is_complete(checked.problems):
            return
        self._checked = (source, read_graph(checked.graph))
        if self._watch is None:
            self._show_structure(arena)
        elif source == self._source and self._watch.set_graph(self._checked[1]):
            self._show(self._watch, self._run)

    def start(self, run: int, source: str, arena: Arena) -> None:
        """A run begins."""
        self._watch = None
        if self._step is None or not _is_judged_in(self._step, arena):
            return
        self._run = run
        self._source = source
        self._watch = LessonWatch(self._step, arena)
        if self._checked is not None and self._checked[0] == source:
            self._watch.set_graph(self._checked[1])
        self._show(self._watch, run)

    def on_step(self, lockstep: Lockstep) -> None:
        """A step of the run has passed."""
        if self._watch is not None and self._watch.on_step(lockstep):
            self._show(self._watch, self._run)

    def on_over(self) -> None:
        """The run is over."""
        if self._watch is not None and self._watch.finish():
            self._show(self._watch, self._run)

    def _show_structure(self, arena: Arena) -> None:
        """What is known before a run."""
        if self._step is None:
            return
        watch = LessonWatch(self._step, arena)
        if self._checked is not None:
            watch.set_graph(self._checked[1])
        self._show(watch, None)

    def _show(self, watch: LessonWatch, run: int | None) -> None:
        self._send(page.ChecksShown(run, watch.is_passed, watch.is_over, list(watch.verdicts)))


def _is_judged_in(step: CheckedStep, arena: Arena) -> bool:
    """Whether the room has the places of the checks; the learner may have chosen another one."""
    try:
        examine_step(step, arena)
    except BadStep:
        return False
    return True
