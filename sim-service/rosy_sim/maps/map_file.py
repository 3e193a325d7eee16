"""
Map files of ROS's ``map_server``: a YAML file that names an image and says what its pixels mean.

PyYAML reads the YAML, in block and flow style, as texts; numbers and flags are read here as ``map_server`` reads them.
Keys that ``map_server`` does not know are passed over, as it does.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from pathlib import Path
from typing import Literal, cast

import yaml

from ..errors import BadInput
from ..files import read_text
from ..sentences.sentence import tr

__all__ = ["MapFile", "Mode", "read_map_file"]

Mode = Literal["trinary", "scale", "raw"]
"""How pixels stand for occupancies: https://docs.nav2.org/configuration/packages/configuring-map-server.html."""

_MODES = ("trinary", "scale", "raw")
_NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
_FLAGS = {
    "0": False, "n": False, "no": False, "false": False, "off": False,
    "1": True, "y": True, "yes": True, "true": True, "on": True,
}  # fmt: skip
_NEEDED = ("image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh")

_MAX_LENGTH = 100_000
"""Of a map file, characters; savers write some 150. PyYAML takes a second for a few hundred thousand."""


@dataclass(frozen=True, slots=True)
class MapFile:
    """What a map file says. An occupancy is a share of black, or of white when ``negate`` is set."""

    image: Path
    mode: Mode
    # Side of a pixel, m.
    resolution: float
    # Where the lower left corner of the image is in the map: m, m, rad.
    origin: tuple[float, float, float]
    negate: bool
    # A pixel is occupied from the first occupancy on, and free up to the second; else unknown.
    occupied_from: float
    free_to: float


_Fields = dict[str, str | list[str]]


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
    if mode not in _MODES:
        raise BadInput(tr("{path}: there is no mode {mode}; use {modes}.", path=path, mode=mode, modes=_MODES))
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
    origin = _origin(path, fields)
    return MapFile(path.parent / image, cast("Mode", mode), resolution, origin, negate, occupied, free)


def _fields(path: Path) -> _Fields:
    """The fields of a file; what is neither a text nor a list of texts is an empty text."""
    text = read_text(path, tr("map"))
    if len(text) > _MAX_LENGTH:
        raise BadInput(tr("{path} is too large to be a {kind}.", path=path, kind=tr("map")))
    try:
        # Nodes instead of values: they know their lines, and a key that stands twice is seen.
        root = yaml.compose(text, yaml.BaseLoader)
    except yaml.MarkedYAMLError as error:
        raise _no_map(path, error.problem_mark) from error
    except (yaml.YAMLError, RecursionError) as error:
        raise _no_map(path, None) from error
    if not isinstance(root, yaml.MappingNode):
        raise _no_map(path, root.start_mark if root else None)
    fields: _Fields = {}
    for key, value in root.value:
        if not isinstance(key, yaml.ScalarNode) or key.value in fields:
            raise _no_map(path, key.start_mark)
        if isinstance(value, yaml.SequenceNode):
            fields[key.value] = [_scalar(item) for item in value.value]
        else:
            fields[key.value] = _scalar(value)
    return fields


def _scalar(node: yaml.Node) -> str:
    return str(node.value) if isinstance(node, yaml.ScalarNode) else ""


def _no_map(path: Path, mark: yaml.Mark | None) -> BadInput:
    number = mark.line + 1 if mark else 1
    return BadInput(
        tr("{path} is not a map of ROS: line {number} is not of the form key: value.", path=path, number=number)
    )


def _origin(path: Path, fields: _Fields) -> tuple[float, float, float]:
    value = fields["origin"]
    if isinstance(value, str) or len(value) != 3:
        raise _wrong(path, "origin", fields)
    # Savers write nan for the yaw of a map whose orientation was never set; ROS shows it as one that is not turned.
    yaw = "0" if value[2].lower().lstrip("+-.") == "nan" else value[2]
    x, y, turned = (_as_number(item) for item in (value[0], value[1], yaw))
    if not all(math.isfinite(n) and abs(n) < 1e6 for n in (x, y, turned)):
        raise _wrong(path, "origin", fields)
    return x, y, turned


def _number(path: Path, fields: _Fields, key: str) -> float:
    value = _as_number(_text(fields[key]))
    if not math.isfinite(value):
        raise _wrong(path, key, fields)
    return value


def _as_number(text: str) -> float:
    """Not a number, unless it is one."""
    return float(text) if _NUMBER.fullmatch(text) else math.nan


def _text(value: str | list[str]) -> str:
    """A value; empty for a list."""
    return "" if isinstance(value, list) else value


def _wrong(path: Path, key: str, fields: _Fields) -> BadInput:
    value = fields[key]
    shown = value if isinstance(value, str) else ", ".join(value)
    return BadInput(tr("{path}: this cannot be the {key} of a map: {value}", path=path, key=key, value=shown))
