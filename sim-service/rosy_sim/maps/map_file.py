"""
Map files of ROS's ``map_server``: a YAML file that names an image and says what its pixels mean.

Read is the part of YAML that ``map_saver`` writes: one ``key: value`` a line, a list of numbers in brackets or one a
line, quotes, comments. Keys that ``map_server`` does not know are passed over, as it does.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from pathlib import Path

from ..errors import BadInput
from ..files import read_text
from ..sentences.sentence import tr

__all__ = ["MapFile", "read_map_file"]

_LINE = re.compile(r"([A-Za-z_]\w*)\s*:(?:\s+(.*))?")
_ITEM = re.compile(r"\s*-\s+(.*)")
_COMMENT = re.compile(r"(?:^|\s)#.*")
_NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
_FLAGS = {"0": False, "1": True, "false": False, "true": True}
_NEEDED = ("image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh")


@dataclass(frozen=True, slots=True)
class MapFile:
    """What a map file says. An occupancy is a share of black, or of white when ``negate`` is set."""

    image: Path
    # Side of a pixel, m.
    resolution: float
    # Where the lower left corner of the image is in the map: m, m, rad.
    origin: tuple[float, float, float]
    negate: bool
    # A pixel is occupied above the first occupancy and free below the second; else unknown.
    occupied_above: float
    free_below: float


def read_map_file(path: Path) -> MapFile:
    """
    The YAML file of a map.

    Raises:
        BadInput: it cannot be read, or something in it is missing or wrong.
    """
    fields = _fields(path)
    for key in _NEEDED:
        if key not in fields:
            raise BadInput(tr("{path} does not say {key}; a map of ROS has {keys}.", path=path, key=key, keys=_NEEDED))
    mode = _text(fields.get("mode", "trinary"))
    if mode not in ("trinary", "scale"):
        raise BadInput(tr("{path}: the mode {mode} is not supported; use trinary or scale.", path=path, mode=mode))
    resolution = _number(path, fields, "resolution")
    if not 0 < resolution <= 10:
        raise _wrong(path, "resolution", fields)
    occupied, free = _number(path, fields, "occupied_thresh"), _number(path, fields, "free_thresh")
    if not 0 <= free <= occupied <= 1:
        raise _wrong(path, "free_thresh", fields)
    image = _text(fields["image"])
    if not image:
        raise _wrong(path, "image", fields)
    negate = _FLAGS.get(_text(fields["negate"]).lower())
    if negate is None:
        raise _wrong(path, "negate", fields)
    return MapFile(path.parent / image, resolution, _origin(path, fields), negate, occupied, free)


def _fields(path: Path) -> dict[str, str | list[str]]:
    fields: dict[str, str | list[str]] = {}
    key = ""
    for number, line in enumerate(read_text(path, tr("map")).splitlines(), 1):
        text = _COMMENT.sub("", line).rstrip()
        if not text or text in ("---", "..."):
            continue
        items = fields.get(key)
        if (item := _ITEM.fullmatch(text)) and isinstance(items, list):
            items.append(item[1])
        elif (found := _LINE.fullmatch(text)) and found[1] not in fields:
            key = found[1]
            fields[key] = found[2].strip() if found[2] else []
        else:
            raise BadInput(
                tr("{path} is not a map of ROS: line {number} is not of the form key: value.", path=path, number=number)
            )
    return fields


def _origin(path: Path, fields: dict[str, str | list[str]]) -> tuple[float, float, float]:
    value = fields["origin"]
    if isinstance(value, str):
        if not (value.startswith("[") and value.endswith("]")):
            raise _wrong(path, "origin", fields)
        value = value[1:-1].split(",")
    numbers = [_as_number(item) for item in value]
    if len(numbers) != 3 or not all(math.isfinite(n) and abs(n) < 1e6 for n in numbers):
        raise _wrong(path, "origin", fields)
    return numbers[0], numbers[1], numbers[2]


def _number(path: Path, fields: dict[str, str | list[str]], key: str) -> float:
    value = _as_number(_text(fields[key]))
    if not math.isfinite(value):
        raise _wrong(path, key, fields)
    return value


def _as_number(text: str) -> float:
    """Not a number, unless it is one."""
    return float(text) if _NUMBER.fullmatch(text.strip()) else math.nan


def _text(value: str | list[str]) -> str:
    """A value without its quotes; empty for a list."""
    if isinstance(value, list):
        return ""
    quoted = len(value) >= 2 and value[0] in "\"'" and value[-1] == value[0]
    return value[1:-1] if quoted else value


def _wrong(path: Path, key: str, fields: dict[str, str | list[str]]) -> BadInput:
    value = fields[key]
    shown = value if isinstance(value, str) else ", ".join(value)
    return BadInput(tr("{path}: this cannot be the {key} of a map: {value}", path=path, key=key, value=shown))
