"""
Safety switch of one page: the settings that hold for the simulator and for the robot of the page, and what the page is
told about them.
"""

from __future__ import annotations

from collections.abc import Callable

from ...run.steps.velocity_guard import SafetySettings
from ...wire import page

__all__ = ["SafetySwitch"]


class SafetySwitch:
    """
    Sends a message whenever it changes.

    Args:
        run: the number of the current run.
    """

    def __init__(self, send: Callable[[page.Answer], None], run: Callable[[], int]) -> None:
        self._send = send
        self._run = run
        self.settings = SafetySettings()
        # The page's last message; before it the rules are off, as at the page.
        self._told = page.Safety(False)

    def set(self, settings: SafetySettings) -> None:
        """Other settings. While the rules are off they do not override anything."""
        self.settings = settings
        if settings.on != self._told.on:
            self._tell(page.Safety(settings.on))

    def report(self, overriding: bool, time: float) -> None:
        """Whether the rules override the program at ``time`` s of the run."""
        if overriding != (self._told.since is not None):
            on = self.settings.on
            self._tell(page.Safety(on, self._run(), round(time, 2)) if overriding else page.Safety(on))

    def _tell(self, state: page.Safety) -> None:
        self._told = state
        self._send(state)
