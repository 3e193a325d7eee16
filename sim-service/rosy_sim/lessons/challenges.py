"""
Challenges: lessons with a single step whose checks are stars. Each is one file, a lesson document with texts, a model
solution and near misses (``examples/challenges/README.md``).

Read by ``GET /api/challenges``; a run is judged as that of any lesson.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import msgspec

from ..errors import BadInput
from ..files import read_json
from ..sentences.sentence import tr
from ..worlds.gallery import usable_arena
from .lesson_document import LessonDocument
from .lesson_file import checked_step, decoded
from .lesson_watch import BadStep, CheckedStep, examine_step

__all__ = ["challenge_json", "challenge_list", "challenges", "starred_step"]

_FOR_TEACHERS = ("solution", "wrong")
"""Fields that a page does not get."""


def challenges(folder: Path) -> list[LessonDocument]:
    """
    All challenges of a folder in their order.

    Raises:
        BadInput: a challenge has a mistake.
    """
    paths = sorted(folder.glob("*.json"))
    return list(_read(tuple(paths), tuple(path.stat().st_mtime_ns for path in paths)))


@cache
def _read(paths: tuple[Path, ...], _changed: tuple[int, ...]) -> tuple[LessonDocument, ...]:
    return tuple(sorted((_challenge(path) for path in paths), key=lambda challenge: challenge.number or 0))


def _challenge(path: Path) -> LessonDocument:
    challenge = decoded(read_json(path, tr("lesson")), LessonDocument, path)
    arena = usable_arena(challenge.room, f"{path}: room")
    try:
        examine_step(starred_step(challenge), arena)
    except BadStep as error:
        raise BadInput(tr("{path}: {why}", path=path, why=error.why)) from error
    return challenge


def starred_step(challenge: LessonDocument) -> CheckedStep:
    """What is to be watched of a run: the only step."""
    (step,) = challenge.steps
    watched = checked_step(step)
    if watched is None or not watched.stars:
        raise BadInput(tr("{path}: {missing} is missing.", path=challenge.name, missing="steps[0].stars"))
    return watched


def challenge_list(folder: Path) -> list[dict[str, Any]]:
    """Name, number, ids of the stars and titles of each challenge, with the fields of a lesson in its list."""
    return [
        {
            "name": challenge.name,
            "course": challenge.course,
            "number": challenge.number,
            "steps": star_ids(challenge),
            "titles": {language: texts.title for language, texts in challenge.texts.items()},
            "ideas": {language: texts.idea for language, texts in challenge.texts.items()},
        }
        for challenge in challenges(folder)
    ]


def star_ids(challenge: LessonDocument) -> list[str]:
    """What the progress of a learner holds: one id for each star of the best run."""
    return [f"star-{number}" for number, _ in enumerate(starred_step(challenge).checks, 1)]


def challenge_json(folder: Path, name: str) -> dict[str, Any] | None:
    """A challenge as a page needs it, without what is for teachers; ``None`` when there is none of this name."""
    found = challenges(folder)
    place = next((i for i, challenge in enumerate(found) if challenge.name == name), None)
    if place is None:
        return None
    value: dict[str, Any] = msgspec.to_builtins(found[place])
    room = {**found[place].room, "name": f"lesson {name}"}
    following = found[place + 1].name if place + 1 < len(found) else None
    kept = {field: one for field, one in value.items() if field not in _FOR_TEACHERS}
    steps = [{field: one for field, one in step.items() if field not in _FOR_TEACHERS} for step in value["steps"]]
    return {**kept, "room": room, "steps": steps, "next": following}
