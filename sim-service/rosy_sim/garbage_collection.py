"""
Garbage collection of the service: what is there at the start stays, and is not looked at again; full collections are
rare.

A full collection looks at every object and stops the event loop meanwhile: 20 to 50 ms for the 40,000 objects of the
modules alone, several times a second while rooms come in that are refused, and 10 ms for each large room that is open.
Rooms do not need one: they are freed when nothing refers to them (``world/obstacles.py``).
"""

from __future__ import annotations

import gc

__all__ = ["keep_what_is_loaded"]


_FULL = 500
"""Collections of the middle generation before a full one. Python's own value is 10: one for every ten large rooms."""


def keep_what_is_loaded() -> None:
    """Take all objects that there are now out of later collections, which become rare."""
    gc.collect()
    gc.freeze()
    youngest, middle, _ = gc.get_threshold()
    gc.set_threshold(youngest, middle, _FULL)
