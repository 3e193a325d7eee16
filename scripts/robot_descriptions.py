"""
Robot descriptions, read and checked: `protocol/robots/*.json` in the order of the registry, and what their types consist of.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, NamedTuple

ROOT = Path(__file__).resolve().parent.parent
ROBOTS = ROOT / "protocol" / "robots"

Json = dict[str, Any]


class BadRobot(Exception):
    """A robot description contradicts itself or another one; the text says where."""


def robots() -> list[Json]:
    """The robots in the order of the registry; the first one is simulated."""
    names = json.loads((ROBOTS / "robots.json").read_text())
    return [json.loads((ROBOTS / f"{name}.json").read_text()) for name in names]


def merged(all_robots: list[Json], part: str) -> list[Json]:
    """The types or channels of all robots; one that several have is told once, by the first."""
    found: dict[str, Json] = {}
    for robot in all_robots:
        for entry in robot.get(part, []):
            known = found.setdefault(entry["name"], entry)
            if part == "channels" and known["kind"] != entry["kind"] and "command" in (known["kind"], entry["kind"]):
                # A channel that is sensed and one that is sent have one name in different robots.
                raise BadRobot(f"{robot['name']}: {entry['name']} is a {entry['kind']} here and a {known['kind']} elsewhere")
    return list(found.values())


class Roles(NamedTuple):
    """
    Types by what they do in a program. ``events`` trigger a function, ``views`` are those that show one place of another
    type of event; ``states`` have a current value, those of ``odometry`` from the message that triggers functions of states;
    ``held`` commands last until the next one; ``records`` have one constructor, with the type's name.
    """

    events: list[str]
    views: dict[str, str]
    states: list[str]
    odometry: list[str]
    commands: list[str]
    held: list[str]
    records: list[str]


class Vocabulary:
    """The types of all robots, and what they consist of."""

    def __init__(self, types: list[Json]) -> None:
        self.types = {entry["name"]: entry for entry in types}

    def leaves(self, name: str) -> list[tuple[str, str]]:
        """Name and type of each leaf: enumerations, numbers, truths and texts."""
        entry = self.types.get(name)
        if entry is None or "values" in entry:
            return [("", name)]
        if "alias" in entry:
            return self.leaves(entry["alias"])
        found: list[tuple[str, str]] = []
        for field in entry["fields"]:
            inner = self.leaves(field["type"])
            found += [(name or field.get("name", ""), kind) for name, kind in inner]
        return found

    def places(self, channel: Json) -> int:
        """How many sensors or outputs share a channel whose first field says which; 0 for one."""
        leaves = self.leaves(channel["name"])
        first = self.types.get(leaves[0][1], {})
        return len(first["values"]) if channel["kind"] in ("event", "command") and len(leaves) == 2 and "values" in first else 0

    def codes(self, type_name: str) -> dict[str, int]:
        """The numbers of a choice by its values; none for what is no choice."""
        entry = self.types.get(type_name, {})
        return self.codes(entry["alias"]) if "alias" in entry else dict(entry.get("values", {}))

    def code(self, type_name: str, value: str) -> int:
        """The number of a choice in messages."""
        entry = self.types[type_name]
        return int(self.types[entry["alias"]]["values"][value] if "alias" in entry else entry["values"][value])

    def family(self, name: str, channels: list[Json]) -> tuple[str, str] | None:
        """
        The kind of a type's values and of its patterns, by the channels that contain it: `command`, `event` or `state`.
        None for a type that programs do not see.
        """
        entry = self.types[name]
        if "alias" in entry or entry.get("internal"):
            return None
        kinds = {c["kind"] for c in channels if name in self._contained(c["name"])}
        if "view" in entry:
            kinds |= {c["kind"] for c in channels if c["name"] == entry["view"]["of"]}
        sensed = "event" if "event" in kinds else "state" if kinds & {"state", "clock"} else ""
        sent = "command" if "command" in kinds else ""
        return (sent or sensed, sensed or sent) if sensed or sent else None

    def roles(self, channels: list[Json]) -> Roles:
        """What the types of channels and their views do in a program (rules R1 to R4 and R9)."""
        kinds = {c["name"]: c["kind"] for c in channels}
        views = {name: entry["view"] for name, entry in self.types.items() if "view" in entry}
        seen = {name: kinds[views[name]["of"]] if name in views else kinds.get(name) for name in self.types}
        # A view of an odometry message may have the name of a command, as Velocity has.
        commands = [c for c in channels if c["kind"] == "command"]
        return Roles(
            events=[name for name in self.types if seen[name] == "event"],
            views={name: view["of"] for name, view in views.items() if seen[name] == "event"},
            states=[name for name in self.types if seen[name] in ("state", "clock") and not self.types[name].get("internal")],
            odometry=[name for name in views if seen[name] == "clock"],
            commands=[c["name"] for c in commands],
            held=[c["name"] for c in commands if {"rest", "holds"} & set(c) and not self.places(c)],
            records=[name for name, entry in self.types.items() if "fields" in entry and not entry.get("internal")],
        )

    def _contained(self, name: str) -> set[str]:
        """A type and the types of its fields."""
        entry = self.types.get(name, {})
        if "alias" in entry:
            return {name} | self._contained(entry["alias"])
        return {name}.union(*(self._contained(field["type"]) for field in entry.get("fields", [])))
