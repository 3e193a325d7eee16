"""
State of a pupil while the class runs: connected pages, hand, errors, runs; and why the pupil may need help. No I/O;
time is an argument in s.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from .messages.board_messages import Need
from .messages.message_fields import LessonProgress
from .messages.pupil_messages import Status

__all__ = ["ERROR_NEEDS_HELP", "IDLE_NEEDS_HELP", "PupilState"]

ERROR_NEEDS_HELP = 60.0
"""A program that has had errors for so long, s, is a reason to help."""

IDLE_NEEDS_HELP = 300.0
"""So long without a run while the page is open, s, is a reason to help."""


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

    def needs(self, now: float) -> list[Need]:
        """Why the pupil may need help, the most urgent first."""
        found: list[Need] = ["hand"] if self.hand else []
        if self.online_since is None:
            return found
        if self.errors_since is not None and now - self.errors_since >= ERROR_NEEDS_HELP:
            found.append("error")
        since = max(self.online_since, self.last_run or 0.0)
        if not self.running and now - since >= IDLE_NEEDS_HELP:
            found.append("idle")
        return found
