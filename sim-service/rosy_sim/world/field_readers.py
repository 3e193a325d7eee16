"""Readers of plain values (as JSON gives them), field by field, with errors that say where and why."""

from __future__ import annotations

from typing import NamedTuple

from ..sentences.sentence import Sentence, SentenceError, tr

__all__ = [
    "MAX_POINTS",
    "MAX_SIDE",
    "MIN_LENGTH",
    "ArenaError",
    "Pose",
    "flag",
    "items",
    "number",
    "object_fields",
    "point",
    "points",
    "positive",
    "required",
]

MAX_SIDE = 100.0
"""Largest length in a world, m. Keeps a hostile world from costing memory."""

MIN_LENGTH = 0.01
"""Smallest length of a thing in a world, m."""


MAX_POINTS = 200
"""Most points of a goal or of a line on the floor."""


class Pose(NamedTuple):
    """Where something stands: m, m, rad."""

    x: float
    y: float
    theta: float


class ArenaError(SentenceError):
    """A description that is no room: ``path`` says where (``boxes[2].w``), ``why`` says what is wrong."""

    def __init__(self, path: str, why: Sentence) -> None:
        super().__init__(tr("at {path}: {why}", path=path, why=why) if path else why)
        self.path = path
        self.why = why


def object_fields(value: object, path: str) -> dict[str, object]:
    """A value with named fields."""
    if not isinstance(value, dict):
        raise ArenaError(
            path,
            tr("expected named values in curly brackets, such as {example}.", example='{"x": 1, "y": 1}')
            if path
            else tr(
                "this is no world; a world looks like {example}.",
                example='{"size": [5, 4], "start": {"x": 1, "y": 1}}',
            ),
        )
    return value


def number(value: object, path: str) -> float:
    """A number of sensible size."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise ArenaError(path, tr("this number is missing.") if value is None else tr("expected a number."))
    # A whole number may be larger than any float; only comparing it is safe.
    if not -1e6 < value < 1e6:
        raise ArenaError(path, tr("the number is too large."))
    return float(value)


def required(fields: dict[str, object], key: str, path: str) -> float:
    """A number that must be there."""
    return number(fields.get(key), f"{path}.{key}")


def positive(fields: dict[str, object], key: str, path: str, most: float = MAX_SIDE) -> float:
    """A length (or time) that must be there."""
    value = required(fields, key, path)
    if not MIN_LENGTH <= value <= most:
        raise ArenaError(f"{path}.{key}", tr("it must be between 0.01 and {most}.", most=most))
    return value


def flag(fields: dict[str, object], key: str, path: str = "", missing: bool = False) -> bool:
    """True or false; ``missing`` when it is not there."""
    value = fields.get(key, missing)
    if not isinstance(value, bool):
        raise ArenaError(f"{path}.{key}" if path else key, tr("expected true or false."))
    return value


def items(fields: dict[str, object], key: str, path: str = "") -> list[tuple[object, str]]:
    """The items of a list, each with its path; none when it is not there."""
    where = f"{path}.{key}" if path else key
    value = fields.get(key, [])
    if not isinstance(value, list):
        raise ArenaError(where, tr("expected a list."))
    return [(item, f"{where}[{i}]") for i, item in enumerate(value)]


def point(value: object, path: str) -> tuple[float, float]:
    """Two numbers, x and y."""
    if value is None:
        raise ArenaError(path, tr("this point is missing."))
    if not isinstance(value, list) or len(value) != 2:
        raise ArenaError(path, tr("expected a point: two numbers, x and y."))
    return number(value[0], f"{path}[0]"), number(value[1], f"{path}[1]")


def points(fields: dict[str, object], path: str, least: int) -> tuple[tuple[float, float], ...]:
    """The ``points`` of a thing: at least so many, and at most ``MAX_POINTS``."""
    found = tuple(point(value, where) for value, where in items(fields, "points", path))
    if not least <= len(found) <= MAX_POINTS:
        raise ArenaError(
            f"{path}.points", tr("expected at least {least} and at most {most} points.", least=least, most=MAX_POINTS)
        )
    return found
