"""
Rule of when what was deleted is removed for good. A clock that jumps ahead does not decide it alone: what has been kept
for long enough is announced first, and removed at a start a day or more after that. When the clock has been put right
before then, the announcement is withdrawn.
"""

from __future__ import annotations

from typing import Literal

__all__ = ["DELETED_KEPT", "NOTICE", "Step", "kept_until", "next_step"]

DELETED_KEPT = 30 * 86_400.0
"""How long a deleted class and a removed pupil can be restored at least, s."""

NOTICE = 86_400.0
"""From the announcement to the removal, s. A choice of ours: a wrong clock is noticed on the day of a lesson."""

Step = Literal["keep", "announce", "withdraw", "remove"]


def kept_until(at: float, announced: float | None) -> float:
    """
    Until when something can be restored for certain; a start after that removes it, or announces that first.

    Args:
        at: when it was deleted, s since 1970.
        announced: when its removal was announced, s since 1970.
    """
    return at + DELETED_KEPT if announced is None else announced + NOTICE


def next_step(at: float, announced: float | None, now: float) -> Step:
    """
    What becomes of something now.

    Args:
        at: when it was deleted, s since 1970.
        announced: when its removal was announced, s since 1970.
        now: s since 1970.
    """
    if now - at <= DELETED_KEPT:
        return "keep" if announced is None else "withdraw"
    # An announcement in the future is one of a clock that was wrong.
    if announced is None or announced > now:
        return "announce"
    return "remove" if now - announced >= NOTICE else "keep"
