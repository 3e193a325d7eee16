"""A clock that runs while the computer sleeps. The counterpart of ``Rosy.Robots.BootClock``."""

from __future__ import annotations

import time

__all__ = ["boot_seconds"]


def boot_seconds() -> float:
    """Seconds since the computer was started, counted while it sleeps: ``clock_gettime(2)``, CLOCK_BOOTTIME."""
    return time.clock_gettime(time.CLOCK_BOOTTIME)
