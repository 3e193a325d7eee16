"""
Garbage collection of the service: what is there at the start stays, and is not looked at again.

A full collection looks at every object and stops the event loop meanwhile: 20 to 50 ms for the 40,000 objects of the
modules alone, several times a second while rooms come in that are refused.
"""

from __future__ import annotations

import gc

__all__ = ["keep_what_is_loaded"]


def keep_what_is_loaded() -> None:
    """Take all objects that there are now out of later collections."""
    gc.collect()
    gc.freeze()
