"""
State of a pupil while the class runs: connected pages, hand, errors, runs; and why the pupil may need help. No I/O;
time is an argument in s.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from .board_messages import Need
from .message_fields import LessonProgress
from .pupil_messages import Status

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
    # Since when the program has had errors.
    errors_since: float | None = None
    # The end of the last run, or now while one is going.
    last_run: float | None = None
    running: bool = False
    hand: bool = False
    lesson: LessonProgress | None = None
    # Pages that are connected, by an arbitrary key.
    pages: set[int] = field(default_factory=set)

    def connect(self, page: int, now: float) -> None:
        """A page of the pupil connects."""
        if not self.pages:
            self.online_since = now
        self.pages.add(page)

    def disconnect(self, page: int, now: float) -> None:
        """A page of the pupil has disconnected; with the last one its errors and runs are over."""
        self.pages.discard(page)
        if self.pages:
            return
        if self.running:
            self.last_run = now
        self.online_since = self.errors_since = None
        self.running = False

    def report(self, status: Status, now: float) -> None:
        """A page reports what it shows."""
        if status.errors != (self.errors_since is not None):
            self.errors_since = now if status.errors else None
        if status.running or self.running:
            self.last_run = now
        self.running = status.running
        self.lesson = status.lesson

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
