"""
Values of commands as Haskell shows them.
"""

from __future__ import annotations

import re

__all__ = ["velocity_values"]

_VELOCITY = re.compile(r"Velocity \(?(-?[\d.e+-]+)\)? \(?(-?[\d.e+-]+)\)?")


def velocity_values(value: str) -> tuple[float, float] | None:
    """Speed, m/s, and turn rate, rad/s, of ``Velocity 0.5 (-0.1)``; None when it is no velocity."""
    found = _VELOCITY.fullmatch(value)
    return (float(found[1]), float(found[2])) if found is not None else None
