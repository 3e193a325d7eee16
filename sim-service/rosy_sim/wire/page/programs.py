"""Messages of a page about programs that do not run: checks, completions, previews, steps of lessons."""

from __future__ import annotations

from typing import Any, Literal

import msgspec

from ..problem import Problem
from ..verdict import Verdict
from .runs import Goal

__all__ = ["MAX_PREVIEW", "Check", "ChecksShown", "ChooseLessonStep", "Complete", "Preview", "Previewed"]

MAX_PREVIEW = 300.0
"""Longest run that a page may have previewed, s, simulated."""


class ChooseLessonStep(msgspec.Struct, tag="lesson", tag_field="op"):
    """The checks of a lesson's step, as JSON, for the next runs; ``None`` for none."""

    step: Any


class Check(msgspec.Struct, tag="check", tag_field="op"):
    """Type-check while typing."""

    id: int
    source: str


class Complete(msgspec.Struct, tag="complete", tag_field="op"):
    """What can stand at a place?"""

    id: int
    source: str
    line: int
    column: int


class Preview(msgspec.Struct, tag="preview", tag_field="op"):
    """Where would this program drive? ``seconds`` are simulated."""

    id: int
    source: str
    seconds: float


class PreparePreviews(msgspec.Struct, tag="prepare-previews", tag_field="op"):
    """Previews are likely to be asked for soon."""


class Previewed(msgspec.Struct, tag="previewed", tag_field="op"):
    """
    Where a program would drive, with the room, the seed and the hands of the last run. Points are time (s), x, y (m),
    the pose is x, y, theta (m, rad). ``time`` (s) is how long it ran. ``unrepeatable``: the last run had more actions
    than are recorded. ``pen`` has what the pen is from a time (s) on: 0 up or 1 down, the number of its colour, its
    width (m); it is up before the first.
    """

    id: int
    ended: Literal["time", "done", "error", "stuck", "refused", "unrepeatable"]
    time: float
    pose: tuple[float, float, float]
    path: list[tuple[float, float, float]]
    collisions: list[tuple[float, float, float]]
    goals: list[Goal]
    problems: list[Problem]
    pen: list[tuple[float, int, int, float]] = []


class ChecksShown(msgspec.Struct, tag="checks", tag_field="op"):
    """
    The checks of the lesson's step that the page has chosen. ``run`` is ``None`` while they are about the program only;
    ``over``: the time of the step or the run is over.
    """

    run: int | None
    passed: bool
    over: bool
    checks: list[Verdict]
