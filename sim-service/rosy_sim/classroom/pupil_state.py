"""
State of a pupil while the class runs: connected pages, hand, errors, runs; and why the pupil may need help. No I/O;
time is an argument in s.

Pupils run nothing while something is explained to the class. So the time without a run counts from when the class was
free to run (``RunClock``), and no single pupil is named while most of the class has not run.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

from .messages.board_messages import Need
from .messages.message_fields import LessonProgress
from .messages.pupil_messages import Status

__all__ = ["ERROR_NEEDS_HELP", "IDLE_NEEDS_HELP", "MOST_IDLE_NAMED", "PupilState", "RunClock"]

ERROR_NEEDS_HELP = 60.0
"""A program that has had errors for so long, s, is a reason to help."""

IDLE_NEEDS_HELP = 300.0
"""So long without a run while the page is open and the class is free to run, s, is a reason to help."""

MOST_IDLE_NAMED = 3
"""So many pupils without a run are named also where they are most of the class."""


@dataclass(slots=True)
class PupilState:
    """Times are ``None`` while the condition does not hold."""

    # Since when a page of the pupil is connected.
    online_since: float | None = None
    # Since when a program has had errors.
    errors_since: float | None = None
    # The end of the last run, or now while one is going.
    last_run: float | None = None
    hand: bool = False
    lesson: LessonProgress | None = None
    # What the connected pages reported last, by an arbitrary key; the page that reported last comes last.
    pages: dict[int, Status] = field(default_factory=dict)

    @property
    def running(self) -> bool:
        """Whether a program runs on a page of the pupil."""
        return any(status.running for status in self.pages.values())

    def connect(self, page: int, now: float) -> None:
        """A page of the pupil connects."""
        if not self.pages:
            self.online_since = now
        self.pages[page] = Status(errors=False, running=False)

    def disconnect(self, page: int, now: float) -> None:
        """A page of the pupil has disconnected; its errors and runs are over."""
        was_running = self.running
        self.pages.pop(page, None)
        self._changed(was_running, now)
        if not self.pages:
            self.online_since = None

    def report(self, page: int, status: Status, now: float) -> None:
        """A page reports what it shows. Another page of the pupil, on another device, may show something else."""
        was_running = self.running
        self.pages.pop(page, None)
        self.pages[page] = status
        self._changed(was_running, now)
        newest_first = reversed(self.pages.values())
        self.lesson = next((shown.lesson for shown in newest_first if shown.lesson is not None), None)

    def _changed(self, was_running: bool, now: float) -> None:
        errors = any(status.errors for status in self.pages.values())
        if errors != (self.errors_since is not None):
            self.errors_since = now if errors else None
        if was_running or self.running:
            self.last_run = now

    def in_order(self) -> list[int]:
        """The pages of the pupil: those with a running program first, and of these the one that reported last."""
        newest_first = list(reversed(self.pages))
        return sorted(newest_first, key=lambda page: not self.pages[page].running)

    def is_idle(self, now: float, free_since: float | None) -> bool:
        """Whether the pupil has not run anything for long; ``free_since`` as in ``RunClock``."""
        if self.online_since is None or free_since is None or self.running:
            return False
        return now - max(self.online_since, self.last_run or 0.0, free_since) >= IDLE_NEEDS_HELP

    def needs(self, now: float, *, idle: bool) -> list[Need]:
        """Why the pupil may need help, the most urgent first; ``idle``: the time without a run is a reason."""
        found: list[Need] = ["hand"] if self.hand else []
        if self.errors_since is not None and now - self.errors_since >= ERROR_NEEDS_HELP:
            found.append("error")
        if idle:
            found.append("idle")
        return found


@dataclass(slots=True)
class RunClock:
    """Since when the class is free to run: its start, or the end of an explanation; ``None`` while pages are paused."""

    free_since: float | None

    def pause(self) -> None:
        """All pages are paused."""
        self.free_since = None

    def resume(self, now: float) -> None:
        """The class is free to run from now on: the time without a run starts anew for each pupil."""
        self.free_since = now

    def run_begins(self, states: Iterable[PupilState], now: float) -> None:
        """A program begins to run. Where most of the class had not run, an explanation without a pause has ended."""
        if self.most_idle(states, now):
            self.resume(now)

    def most_idle(self, states: Iterable[PupilState], now: float) -> bool:
        """Whether most of the connected pupils have not run for long, and are too many to be named one by one."""
        online = [state for state in states if state.online_since is not None]
        idle = sum(state.is_idle(now, self.free_since) for state in online)
        return idle > MOST_IDLE_NAMED and 2 * idle > len(online)
