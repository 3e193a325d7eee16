"""
Parts of real robots: the types that a program uses and a robot at an address does not have, by the robot descriptions.

A channel with an ``option``, such as that of a laser scanner or a pen, is there when the address says so
(``scanner=on``): the simulated robot has it, a bought one does not, and some have it added, which a serial cable does
not reach.
"""

from __future__ import annotations

from pathlib import Path
from urllib.parse import parse_qs

from ..errors import BadInput
from ..files import read_json
from ..robot_description import description, known_robots, lacking
from ..sentences.sentence import tr
from ..wire.problem import Problem, problem

__all__ = ["missing_parts", "missing_parts_problem"]


def missing_parts(address: str, uses: list[str]) -> list[str]:
    """Those of the types whose channel the robot lacks, in their order; none for a robot that is not known."""
    name = _robot_name(address)
    if name not in known_robots():
        return []
    is_serial = address.startswith("serial:")
    return lacking(name, uses, lambda option: not is_serial and _option(address, option) == "on")


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
    """The robot of an address; the simulated one when it names none."""
    return _option(address, "robot") or known_robots()[0]


def _option(address: str, name: str) -> str | None:
    """The value of an option of an address, from the address or its profile."""
    options = parse_qs(address.partition("?")[2])
    if name in options:
        return options[name][0]
    for file in options.get("profile", []):
        try:
            profile = read_json(Path(file), tr("robot's profile"))
        except BadInput:
            # rosy-robot says what is wrong with it.
            continue
        if not isinstance(profile, dict):
            continue
        value = profile.get(name)
        if isinstance(value, str | bool):
            # As rosy-robot reads a profile.
            return value if isinstance(value, str) else "on" if value else "off"
    return None
