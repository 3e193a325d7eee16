"""
Watch over a velocity: when it has to be set to zero because its sender is silent. Pure; time is an argument.

A TurtleBot 3's node keeps the last velocity for as long as it runs.
"""

from __future__ import annotations

from typing import Any

__all__ = ["MAX_REPEATS", "REPEAT", "STOPPED", "TIMEOUT", "VELOCITIES", "VelocityWatch", "as_type", "is_moving"]

TIMEOUT = 0.6
"""Seconds of silence until the robot is stopped: ``heartbeatTimeout`` of the other links (Rosy.Robots.Guardian)."""

REPEAT = 0.1
"""Seconds between the repetitions of a stop."""

MAX_REPEATS = 10
"""Of a stop; others may drive the robot too."""

VELOCITIES = ("geometry_msgs/Twist", "geometry_msgs/TwistStamped")

STOPPED: dict[str, Any] = {"linear": {}, "angular": {}}
"""A Twist whose fields are all zero."""


def as_type(message: Any, kind: str) -> Any:
    """A velocity of either type as one of this type; a message that is no object stays."""
    if not isinstance(message, dict):
        return message
    twist = message.get("twist", {}) if "twist" in message else {k: v for k, v in message.items() if k != "header"}
    if kind == "geometry_msgs/Twist":
        return twist
    return {"header": message["header"], "twist": twist} if "header" in message else {"twist": twist}


def is_moving(message: Any) -> bool:
    """Whether a velocity of either type is not zero."""
    twist = as_type(message, "geometry_msgs/Twist")
    parts = [twist.get(name) for name in ("linear", "angular")] if isinstance(twist, dict) else []
    return any(bool(value) for part in parts if isinstance(part, dict) for value in part.values())


class VelocityWatch:
    """Of one sender. ``due`` tells whether a stop is to be sent now."""

    def __init__(self, now: float) -> None:
        self._next = now + TIMEOUT
        self._repeats = 0

    def heard(self, now: float) -> bool:
        """The sender is there. Whether it was away for so long that a stop was due."""
        late = now >= self._next and self._repeats == 0
        self._next, self._repeats = now + TIMEOUT, 0
        return late

    def due(self, now: float) -> bool:
        """Whether a stop is to be sent now; counts it as sent."""
        if now < self._next or self._repeats >= MAX_REPEATS:
            return False
        self._next, self._repeats = now + REPEAT, self._repeats + 1
        return True

    def wait(self, now: float) -> float | None:
        """Seconds until something is due; ``None`` while nothing is."""
        return None if self._repeats >= MAX_REPEATS else max(0.0, self._next - now)
