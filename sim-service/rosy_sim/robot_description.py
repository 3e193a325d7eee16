"""
Robot descriptions, ``protocol/robots/*.json``, as plain values.

Read once, when the modules that need them are imported; the format is in ``protocol/robots/README.md``.
"""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterable
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

__all__ = [
    "ROBOTS",
    "TypeRoles",
    "description",
    "known_robots",
    "lacking",
    "simulated",
    "simulated_action",
    "simulated_actions",
    "type_roles",
]

ROBOTS = Path(os.environ.get("ROSY_ROOT") or Path(__file__).resolve().parents[2]) / "protocol" / "robots"
"""Where the robot descriptions are."""


class TypeRoles(NamedTuple):
    """What the types of all robots do in a program, by name (language rules R1 to R4 and R9)."""

    # Sensed types with a current value at any time, which never trigger a function that takes an event as well.
    states: frozenset[str]
    commands: frozenset[str]
    # Commands that last until the next one.
    held: frozenset[str]
    # Types that show one place of another type of event, such as BumperLeft, and how the shown values begin.
    views: dict[str, str]


@cache
def type_roles() -> TypeRoles:
    """The roles of the types of all robots."""
    robots = [description(name) for name in known_robots()]
    channels = {channel["name"]: channel for robot in reversed(robots) for channel in robot["channels"]}
    views = {entry["name"]: entry["view"] for robot in robots for entry in robot.get("types", ()) if "view" in entry}
    sensed = {"state", "clock"}
    return TypeRoles(
        states=frozenset(name for name, channel in channels.items() if channel["kind"] in sensed)
        | {name for name, view in views.items() if channels[view["of"]]["kind"] in sensed},
        commands=frozenset(name for name, channel in channels.items() if channel["kind"] == "command"),
        held=frozenset(name for name, channel in channels.items() if {"rest", "holds"} & set(channel)),
        views={name: " ".join((view["of"], *view["when"].values())) for name, view in views.items() if "when" in view},
    )


@cache
def description(name: str) -> dict[str, Any]:
    """The description of a robot."""
    found: dict[str, Any] = json.loads((ROBOTS / f"{name}.json").read_text())
    return found


@cache
def known_robots() -> list[str]:
    """The names of the registry; the first is that of a room that names no robot."""
    found: list[str] = json.loads((ROBOTS / "robots.json").read_text())
    return found


def lacking(name: str, uses: Iterable[str], has: Callable[[str], bool]) -> list[str]:
    """
    Those of a program's types whose channel a robot lacks, in their order.

    Args:
        name: of the robot.
        uses: types; one that no robot senses or obeys is left out.
        has: whether a part is there that the description calls an ``option``.
    """
    own = {c["name"] for c in description(name)["channels"] if "option" not in c or has(c["option"])}
    channels = _channels_of_types()
    return [used for used in uses if used in channels and channels[used] not in own]


@cache
def _channels_of_types() -> dict[str, str]:
    """The channel of each type that is one or a part of one, over all robots."""
    found: dict[str, str] = {}
    for robot in map(description, known_robots()):
        found |= {channel["name"]: channel["name"] for channel in robot["channels"]}
        found |= {
            kind["name"]: kind["view"]["of"] for kind in robot["types"] if "view" in kind and kind["name"] not in found
        }
    return found


def simulated() -> dict[str, Any]:
    """The description whose messages the robot link uses, for every robot."""
    return description(known_robots()[0])


@cache
def simulated_actions(version: str) -> dict[str, str]:
    """The actions that its description names, each with its name in a version of ROS, ``ros1`` or ``ros2``."""
    profile = simulated()["profiles"][version]
    return {
        name: given.replace("{prefix}", profile["prefix"])
        for name, given in profile.items()
        if f"{name}_type" in profile
    }


def simulated_action(action: str) -> str:
    """The name that the simulated robots give an action of the description; others stay as they are."""
    own, other = simulated_actions("ros1"), simulated_actions("ros2")
    return own.get(action) or other.get(action, action)
