"""
Robot descriptions, ``protocol/robots/*.json``, as plain values.

Read once, when the modules that need them are imported; the format is in ``protocol/robots/README.md``.
"""

from __future__ import annotations

import json
import os
from functools import cache
from pathlib import Path
from typing import Any

__all__ = ["ROBOTS", "description", "known_robots", "simulated"]

ROBOTS = Path(os.environ.get("ROSY_ROOT") or Path(__file__).resolve().parents[2]) / "protocol" / "robots"
"""Where the robot descriptions are."""


@cache
def description(name: str) -> dict[str, Any]:
    """The description of a robot."""
    found: dict[str, Any] = json.loads((ROBOTS / f"{name}.json").read_text())
    return found


@cache
def known_robots() -> list[str]:
    """The names of the registry; the first is the robot that the simulator has."""
    found: list[str] = json.loads((ROBOTS / "robots.json").read_text())
    return found


def simulated() -> dict[str, Any]:
    """The description of the robot that the simulator has."""
    return description(known_robots()[0])
