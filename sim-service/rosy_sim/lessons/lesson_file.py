"""
Files of a lesson: a folder with ``lesson.json``, programs, and its texts in each language.

``examples/lessons/README.md`` describes them, and ``protocol/lesson.schema.json`` is generated from the types here. The
reader turns the first mistake into one sentence with the file and the place in it.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, Literal, TypeVar

import msgspec
from msgspec import Meta

from ..errors import BadInput
from ..files import read_json, read_text, refuse_newer
from ..sentences.sentence import Sentence, tr, verbatim
from ..wire.user_input import TimedInput
from ..world.arena import Arena
from ..worlds.gallery import named_world, usable_arena
from .checks import Check, Identifier
from .lesson_watch import MAX_SECONDS, BadStep, CheckedStep, examine_step

__all__ = [
    "VERSION",
    "Lesson",
    "LessonFile",
    "LessonTexts",
    "Step",
    "StepTexts",
    "attempts",
    "checked_step",
    "decoded",
    "read_lesson",
]

VERSION = 1
"""Of the format."""

_LANGUAGES = re.compile(r"[a-z]{2,3}(-[A-Z]{2})?")


class Step(msgspec.Struct, frozen=True, forbid_unknown_fields=True, kw_only=True, omit_defaults=True):
    """
    A step: ``predict`` and ``investigate`` ask a question with ``answers``; ``run``, ``modify`` and ``make`` end with
    a run that is watched for ``seconds``, and that passes the ``checks``.
    """

    id: Identifier
    kind: Literal["predict", "run", "investigate", "modify", "make"]
    seconds: Annotated[float, Meta(gt=0, le=MAX_SECONDS, description="How long a run is watched, s.")] | None = None
    checks: Annotated[list[Check], Meta(max_length=20)] = []
    # Of a challenge: each check is a star, and the first is the goal (`CheckedStep`).
    stars: bool = False
    answers: Annotated[list[Identifier], Meta(max_length=6)] = []
    right: Identifier | None = None
    # The file of the program that the step begins with; absent: the program as it is.
    program: Annotated[str, Meta(pattern=r"^[A-Za-z0-9-]+\.hs$")] | None = None
    # Numbers of the lesson's `other_rooms`, from 0, in which a program is run as well before it has passed the step.
    also_in: Annotated[list[Annotated[int, Meta(ge=0)]], Meta(max_length=2)] = []
    # What hands do in a rehearsal without a learner: lines of `./rosy run --input`.
    hands: list[TimedInput] = []


class LessonFile(msgspec.Struct, frozen=True, forbid_unknown_fields=True, kw_only=True, omit_defaults=True):
    """``lesson.json``."""

    schema: str | None = msgspec.field(name="$schema", default=None)
    lesson: Annotated[int, Meta(ge=1, description="Version of the format.")]
    course: Identifier
    number: Annotated[int, Meta(ge=1, le=999, description="Place in the list of all lessons.")]
    # Of a strand, a course beside the others: the number of the lesson that it may follow. Its toolbox holds the blocks
    # of lessons until that one and of earlier ones of the strand.
    after: Annotated[int, Meta(ge=1, le=999)] | None = None
    # A world of the gallery by name, or a world.
    room: str | dict[str, Any]
    # What blocks say that this lesson brings, as Haskell writes it; the toolbox holds those of earlier lessons as well.
    blocks: list[str]
    steps: Annotated[list[Step], Meta(min_length=1, max_length=12)]
    # In which the last step's reference solution passes as well; each has the fields that differ from `room`.
    other_rooms: list[dict[str, Any]] = []


class StepTexts(msgspec.Struct, frozen=True, forbid_unknown_fields=True, kw_only=True, omit_defaults=True):
    """``say`` is the step in one sentence, ``after`` what is to be seen when it is done."""

    say: str
    answers: dict[str, str] = {}
    replies: dict[str, str] = {}
    after: str = ""


class LessonTexts(msgspec.Struct, frozen=True, forbid_unknown_fields=True, kw_only=True, omit_defaults=True):
    """All that a lesson says in one language. ``hints`` of a check: a question, a pointer, a piece to take."""

    title: str
    idea: str
    learned: str
    steps: dict[str, StepTexts]
    checks: dict[str, str] = {}
    hints: dict[str, Annotated[list[str], Meta(max_length=3)]] = {}


@dataclass(frozen=True, slots=True)
class Lesson:
    """A lesson as its folder holds it. ``world`` is the room as JSON, ``programs`` are texts by file name."""

    name: str
    file: LessonFile
    world: dict[str, Any]
    arena: Arena
    start: str
    programs: dict[str, str]
    texts: dict[str, LessonTexts]

    def step(self, ident: str) -> Step:
        """A step by its id."""
        return next(step for step in self.file.steps if step.id == ident)

    def other_worlds(self) -> list[dict[str, Any]]:
        """The other rooms in full."""
        return [{**self.world, **change} for change in self.file.other_rooms]


def checked_step(step: Step) -> CheckedStep | None:
    """What is to be watched of a step's run; ``None`` for a question."""
    return None if step.seconds is None else CheckedStep(seconds=step.seconds, checks=step.checks, stars=step.stars)


def read_lesson(folder: Path) -> Lesson:
    """
    The lesson in a folder.

    Raises:
        BadInput: the first mistake in its files.
    """
    path = folder / "lesson.json"
    value = read_json(path, tr("lesson"))
    # First: a newer format may have other fields.
    if isinstance(value, dict) and isinstance(version := value.get("lesson"), int):
        refuse_newer(path, version, VERSION)
    file = decoded(value, LessonFile, path)
    world = _world(file, path)
    arena = usable_arena(world, f"{path}: room")
    _examine(file, arena, path)
    others = [
        usable_arena({**world, **change}, f"{path}: other_rooms[{i}]") for i, change in enumerate(file.other_rooms)
    ]
    _examine_other_rooms(file, others, path)
    start = read_text(folder / "start.hs", tr("program"))
    programs = {step.program: read_text(folder / step.program, tr("program")) for step in file.steps if step.program}
    return Lesson(folder.name, file, world, arena, start, programs, _texts(folder, file))


def attempts(folder: Path, of: Literal["solutions", "wrong"], step: str) -> list[Path]:
    """
    The programs in ``solutions/<step>`` (``reference.hs`` first) or ``wrong/<step>``, whose names begin with the id of
    the check that they fail: ``in-ring.too-slow.hs``.
    """
    found = sorted((folder / of / step).glob("*.hs"))
    return sorted(found, key=lambda path: path.name != "reference.hs")


_T = TypeVar("_T")


def decoded(value: object, kind: type[_T], path: Path) -> _T:
    """
    The content of a file as one of the types here.

    Raises:
        BadInput: the first mistake, with its place.
    """
    try:
        return msgspec.convert(value, kind)
    except msgspec.ValidationError as error:
        raise BadInput(tr("{path}: {why}", path=path, why=_decoding_fault(str(error)))) from error


_EXPECTED = re.compile(r"Expected `(.+?)`(?:, got `(.+?)`)?")


def _type_word(name: str) -> Sentence:
    """A type of JSON in everyday words."""
    match name:
        case "str":
            return tr("a text")
        case "int":
            return tr("a whole number")
        case "float":
            return tr("a number")
        case "object":
            return tr("named values in curly brackets")
        case "array":
            return tr("a list")
        case "null":
            return tr("nothing")
        case _:
            return verbatim(name)


def _decoding_fault(fault: str) -> Sentence:
    """The decoder's fault in everyday words, with the place in front."""
    what, _, where = fault.partition(" - at ")
    place = where.strip("`").removeprefix("$").removeprefix(".")
    why = _decoding_cause(what)
    return tr("at {path}: {why}", path=place, why=why) if place else why


def _decoding_cause(what: str) -> Sentence:
    if found := re.match(r"Object missing required field `(.+?)`", what):
        return tr("{name} is missing.", name=found[1])
    if found := re.match(r"Object contains unknown field `(.+?)`", what):
        return tr("there is no field {name} here.", name=found[1])
    if found := re.match(r"Invalid value '(.+?)'", what):
        return tr("there is no kind called {name}.", name=found[1])
    if found := re.match(r"Invalid enum value '(.+?)'", what):
        return tr("{name} is none of the words that may stand here.", name=found[1])
    if what.startswith("Expected `str` matching regex"):
        return tr("expected a name of lower-case letters, digits and hyphens.")
    if found := _EXPECTED.match(what):
        if found[2] is None:
            return tr("expected {wanted}.", wanted=_types(found[1]))
        return tr("expected {wanted}, found {found}.", wanted=_types(found[1]), found=_types(found[2]))
    return verbatim(f"{what}.")


def _types(names: str) -> Sentence:
    """Types that the decoder names, such as ``int | null``."""
    first, bar, rest = names.partition(" | ")
    return tr("{one} | {other}", one=_type_word(first), other=_types(rest)) if bar else _type_word(first)


def _world(file: LessonFile, path: Path) -> dict[str, Any]:
    if isinstance(file.room, dict):
        return file.room
    try:
        return named_world(file.room)
    except BadInput as error:
        raise BadInput(tr("{path}: at room: {why}", path=path, why=error)) from error


def _examine(file: LessonFile, arena: Arena, path: Path) -> None:
    """What the types alone cannot say."""
    seen: set[str] = set()
    for i, step in enumerate(file.steps):
        where = f"{path}: at steps[{i}]"
        for name in (step.id, *(check.id for check in step.checks)):
            if name in seen:
                raise BadInput(tr("{where}: the id {name} is there twice.", where=where, name=name))
            seen.add(name)
        if step.kind in ("predict", "investigate"):
            if len(step.answers) < 2 or step.right not in step.answers:
                raise BadInput(
                    tr("{where}: a question needs at least two answers, and right must be one of them.", where=where)
                )
        elif step.seconds is None:
            raise BadInput(tr("{where}: seconds is missing: how long the run is watched.", where=where))
        elif step.kind != "run" and not step.checks:
            raise BadInput(tr("{where}: a step to {kind} needs at least one check.", where=where, kind=step.kind))
        if (watched := checked_step(step)) is not None:
            try:
                examine_step(watched, arena)
            except BadStep as error:
                raise BadInput(tr("{where}.{path}: {why}", where=where, path=error.path, why=error.why)) from error


def _examine_other_rooms(file: LessonFile, others: list[Arena], path: Path) -> None:
    for i, step in enumerate(file.steps):
        where = f"{path}: at steps[{i}].also_in"
        watched = checked_step(step)
        for number in step.also_in:
            if watched is None or number >= len(others):
                raise BadInput(tr("{where}: there is no other room {number} for a run.", where=where, number=number))
            try:
                examine_step(watched, others[number])
            except BadStep as error:
                raise BadInput(tr("{where}.{path}: {why}", where=where, path=error.path, why=error.why)) from error


def _texts(folder: Path, file: LessonFile) -> dict[str, LessonTexts]:
    found: dict[str, LessonTexts] = {}
    for path in sorted((folder / "texts").glob("*.json")):
        if not _LANGUAGES.fullmatch(path.stem):
            raise BadInput(tr("{path}: the name of the file must be that of a language, such as de.json.", path=path))
        found[path.stem] = texts = decoded(read_json(path, tr("lesson's text")), LessonTexts, path)
        for missing in _missing_texts(file, texts):
            raise BadInput(tr("{path}: {missing} is missing.", path=path, missing=missing))
    if "en" not in found:
        raise BadInput(
            tr("{folder} has no texts/en.json: English is shown where another language is missing.", folder=folder)
        )
    return found


def _missing_texts(file: LessonFile, texts: LessonTexts) -> list[str]:
    missing: list[str] = []
    for step in file.steps:
        said = texts.steps.get(step.id)
        if said is None:
            missing.append(f"steps.{step.id}")
            continue
        missing += [f"steps.{step.id}.answers.{answer}" for answer in step.answers if answer not in said.answers]
        missing += [f"checks.{check.id}" for check in step.checks if check.id not in texts.checks]
    return missing
