"""
Definitions in files: those of a robot's own actions, in ``protocol/robots/definitions``, and those of the person at
this computer, in the folders of ``ROSY_MSG_PATH``, which colons separate, as ``rosy-robot`` reads them
(Rosy.Robots.DynamicMessage).

In: the name of a type. Out: the fields in its file, ``package/msg/Name.msg``, ``package/srv/Name.srv`` or
``package/action/Name.action``, also without the folder in between; ``None`` where there is none that can be read.
"""

from __future__ import annotations

import os
import re
from pathlib import Path

from ...robot_description import ROBOTS

__all__ = ["own_definition"]

_SEPARATOR = "---"

_FIELD = re.compile(r"([\w/]+)(?:<=\d+)?(?:\[(?:<=\d+|(\d*))\])?\s+(\w+)(?:\s.*)?")
"""ROS 2 adds bounds, ``string<=5`` and ``int32[<=3]``, and values that a field has at first; none is in the bytes."""

_CONSTANT = re.compile(r"\w+(?:<=\d+)?\s+\w+\s*=.*")


def own_definition(kind: str, ending: str) -> str | None:
    """``ending`` is ``msg``, ``srv`` or ``action``; its parts are divided as in the file."""
    if re.fullmatch(r"\w+/\w+", kind) is None:
        return None
    package, _, name = kind.partition("/")
    own = filter(None, os.environ.get("ROSY_MSG_PATH", "").split(":"))
    for folder in (ROBOTS / "definitions", *map(Path, own)):
        for place in (folder / package, folder / package / ending):
            try:
                return _fields((place / f"{name}.{ending}").read_text(encoding="utf-8"))
            except (OSError, UnicodeDecodeError):
                continue
    return None


def _fields(text: str) -> str | None:
    """A definition without what its bytes do not have; ``None`` for one with a line that cannot be read."""
    lines: list[str] = []
    for line in (whole.partition("#")[0].strip() for whole in text.split("\n")):
        field = _FIELD.fullmatch(line)
        if line == _SEPARATOR:
            lines.append(line)
        elif _CONSTANT.fullmatch(line) or not line:
            continue
        elif field is None:
            return None
        else:
            length = "" if "[" not in line.split()[0] else f"[{field[2] or ''}]"
            lines.append(f"{field[1]}{length} {field[3]}")
    return "\n".join(lines)
