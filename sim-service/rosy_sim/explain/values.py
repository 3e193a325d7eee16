"""
Values of commands and memories as Haskell shows them.
"""

from __future__ import annotations

import re

from ..wire.firing import Firing

__all__ = ["inside", "velocity_values", "written"]

_VELOCITY = re.compile(r"Velocity \(?(-?[\d.e+-]+)\)? \(?(-?[\d.e+-]+)\)?")


def velocity_values(value: str) -> tuple[float, float] | None:
    """Speed, m/s, and turn rate, rad/s, of ``Velocity 0.5 (-0.1)``; None when it is no velocity."""
    found = _VELOCITY.fullmatch(value)
    return (float(found[1]), float(found[2])) if found is not None else None


def written(firing: Firing, kind: str) -> str | None:
    """What a firing wrote last to a memory of a type (``Memory Int``); None when it wrote none."""
    return next(
        (given.value for given in reversed(firing.gave) if given.to in ("memory", "param") and given.type == kind), None
    )


def inside(value: str) -> str:
    """``Memory (Hit True)`` without its constructor."""
    inner = value.partition(" ")[2]
    return inner[1:-1] if inner.startswith("(") and inner.endswith(")") and _closes_last(inner) else inner


def _closes_last(text: str) -> bool:
    """Whether the first bracket of a text is closed by its last one."""
    depth = 0
    for index, char in enumerate(text):
        depth += (char == "(") - (char == ")")
        if depth == 0:
            return index == len(text) - 1
    return False
