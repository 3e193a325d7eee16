"""
Body, motor limits and laser scanner of a robot from its description, ``protocol/robots/<name>.json``, which has the
units and the source of each number.
"""

from __future__ import annotations

import math
from typing import Any

from ...robot_description import description
from ...world.robot import Body, MotorLimits, ScannerModel
from ...world.time_step import STEPS_PER_SECOND

__all__ = ["CONTACT_GAP", "body_of", "limits_of", "numbers_of", "scanner_of"]

CONTACT_GAP = 0.001
"""A thing nearer to the body than this touches it, m. Our choice: the travel of a bumper is a few millimetres, and the
physics keeps bodies apart to a tenth of one."""


def numbers_of(robot: str) -> dict[str, Any]:
    """The numbers of its body by name, without units and sources."""
    return {name: entry["value"] for name, entry in description(robot)["body"].items()}


def body_of(robot: str) -> Body:
    """Its body."""
    numbers = numbers_of(robot)
    return Body(numbers["radius"], numbers["mass"], numbers["inertia"], numbers["wheelbase"], CONTACT_GAP)


def limits_of(robot: str) -> MotorLimits:
    """
    What its motors can do. ``limits`` are those of all models of a robot; ``turn`` and ``wheel`` in the body are those
    of the simulated model, where it differs.
    """
    numbers = numbers_of(robot)
    limits = {name: entry["value"] for name, entry in description(robot)["limits"].items()}
    return MotorLimits(
        speed=limits["speed"],
        angular_speed=numbers.get("turn", limits["turn"]),
        wheel_speed=numbers["wheel"] if "wheel" in numbers else limits["wheel"],
        wheelbase=numbers["wheelbase"],
        acceleration=numbers["acceleration"],
        angular_acceleration=numbers["angularAcceleration"],
        command_timeout=numbers["commandTimeout"],
    )


def scanner_of(robot: str) -> ScannerModel:
    """Its laser scanner."""
    numbers = numbers_of(robot)
    return ScannerModel(
        beams=numbers["scannerBeams"],
        nearest=numbers["scannerNearest"],
        farthest=numbers["scannerFarthest"],
        period=round(numbers["scannerPeriod"] * STEPS_PER_SECOND),
        ahead=math.radians(numbers["aheadHalfWidth"]),
        forwards=numbers.get("scannerForwards", 0.0),
    )
