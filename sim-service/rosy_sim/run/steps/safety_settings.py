"""
Settings of the safety rules of a run. They are sent to other processes, so this module is not compiled: msgspec looks
into their types.
"""

from __future__ import annotations

from dataclasses import dataclass

__all__ = ["OFF", "SafetySettings"]


@dataclass(frozen=True, slots=True)
class SafetySettings:
    """
    Whether the safety rules are on, and the fastest that a program may drive while they are, m/s and rad/s; None for as
    fast as the robot can.
    """

    on: bool = False
    max_speed: float | None = None
    max_turn: float | None = None


OFF = SafetySettings()
"""The safety rules are off."""
