"""
Parts of real robots: the types that a program uses and a robot at an address does not have, by the robot descriptions.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any
from urllib.parse import parse_qs

import msgspec

from ..robot_description import description, known_robots
from ..sentence import tr
from ..wire.problem import Problem, problem

__all__ = ["missing_parts", "missing_parts_problem"]


def missing_parts(address: str, uses: list[str]) -> list[str]:
    """Those of the types whose channel the robot lacks, in their order; none for a robot that is not known."""
    name = _robot_name(address)
    if name not in known_robots():
        return []
    has = {channel["name"] for channel in description(name)["channels"]}
    channels = _channels()
    return [used for used in uses if used in channels and channels[used] not in has]


def missing_parts_problem(address: str, uses: list[str]) -> Problem | None:
    """Why a program cannot run on a robot; ``None`` when it can."""
    missing = missing_parts(address, uses)
    if not missing:
        return None
    return problem(
        "missing-part",
        tr(
            "The robot ({robot}) has no {parts}.",
            robot=description(_robot_name(address))["title"],
            parts=", ".join(missing),
        ),
        tr("Take out the functions that use it, or choose another robot."),
    )


def _robot_name(address: str) -> str:
    """The robot of an address, from its options or its profile; the simulated one without either."""
    options = parse_qs(address.partition("?")[2])
    if "robot" in options:
        return options["robot"][0]
    for file in options.get("profile", []):
        try:
            profile: dict[str, Any] = msgspec.json.decode(Path(file).read_bytes(), type=dict[str, Any])
        except (OSError, msgspec.DecodeError):
            continue
        if isinstance(named := profile.get("robot"), str):
            return named
    return known_robots()[0]


@cache
def _channels() -> dict[str, str]:
    """The channel of each type that is one or a part of one, over all robots."""
    found: dict[str, str] = {}
    for robot in map(description, known_robots()):
        found |= {channel["name"]: channel["name"] for channel in robot["channels"]}
        found |= {
            kind["name"]: kind["view"]["of"] for kind in robot["types"] if "view" in kind and kind["name"] not in found
        }
    return found
