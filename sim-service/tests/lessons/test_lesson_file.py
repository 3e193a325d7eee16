"""The reader of lesson files: the lessons of the repository, and one mistake after another, each with its sentence."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import msgspec
import pytest

from rosy_sim.config import discover
from rosy_sim.errors import BadInput
from rosy_sim.lessons.catalogue import lesson_json, lesson_list, lessons
from rosy_sim.lessons.lesson_document import LessonDocument
from rosy_sim.lessons.lesson_file import read_lesson
from rosy_sim.lessons.schema import document_schema, lesson_schema, schema_text

FOLDER = discover().examples / "lessons"
TRANSLATED = {"en", "de", "pt", "es", "fr"}
"""Every lesson is written in these; in another registered language it may be."""

LESSON: dict[str, Any] = {
    "lesson": 1,
    "course": "drive",
    "number": 1,
    "room": {"size": [4, 3], "start": {"x": 1, "y": 1}, "goals": [{"kind": "reach", "x": 3, "y": 1, "r": 0.3}]},
    "blocks": ["Velocity"],
    "steps": [
        {"id": "guess", "kind": "predict", "answers": ["a", "b"], "right": "a"},
        {"id": "go", "kind": "make", "seconds": 5, "checks": [{"kind": "at", "id": "there", "time": 4}]},
    ],
}
TEXTS: dict[str, Any] = {
    "title": "T",
    "idea": "I",
    "learned": "L",
    "steps": {"guess": {"say": "S", "answers": {"a": "A", "b": "B"}}, "go": {"say": "S"}},
    "checks": {"there": "C"},
}

Change = Callable[[dict[str, Any]], object]


def written(folder: Path, change: Change = lambda _: None, retell: Change = lambda _: None) -> Path:
    """A lesson in a folder, with one thing changed."""
    lesson, texts = json.loads(json.dumps(LESSON)), json.loads(json.dumps(TEXTS))
    change(lesson)
    retell(texts)
    (folder / "texts").mkdir(parents=True)
    (folder / "lesson.json").write_text(json.dumps(lesson))
    (folder / "start.hs").write_text("main = simulate (Velocity 0.2 0)\n")
    (folder / "texts" / "en.json").write_text(json.dumps(texts))
    return folder


def test_a_small_lesson_is_read(tmp_path: Path) -> None:
    lesson = read_lesson(written(tmp_path / "small"))
    assert lesson.name == "small"
    assert [step.id for step in lesson.file.steps] == ["guess", "go"]
    assert lesson.texts["en"].checks == {"there": "C"}


MISTAKES: list[tuple[str, Change, str]] = [
    ("no course", lambda at: at.pop("course"), "course is missing."),
    ("unknown field", lambda at: at.update(rom=1), "there is no field rom here."),
    ("text for a number", lambda at: at.update(number="one"), "at number: expected a whole number, found a text."),
    (
        "a newer version",
        lambda at: at.update(lesson=2, rom=1),
        "newer Rosy: its version is 2, and this Rosy reads up to 1",
    ),
    ("no such room", lambda at: at.update(room="cellar"), "There is no world called 'cellar'"),
    ("a room that is none", lambda at: at.update(room={"size": [4, 3]}), "is not a world"),
    (
        "another room that is none",
        lambda at: at.update(other_rooms=[{"size": [0, 3]}]),
        "other_rooms[0] is not a world",
    ),
    ("unknown kind of step", lambda at: at["steps"][0].update(kind="guess"), "at steps[0].kind: guess is none of"),
    (
        "unknown kind of check",
        lambda at: at["steps"][1]["checks"][0].update(kind="near"),
        "there is no kind called near",
    ),
    ("no right answer", lambda at: at["steps"][0].update(right="c"), "right must be one of them"),
    ("no time", lambda at: at["steps"][1].pop("seconds"), "seconds is missing: how long the run is watched."),
    ("nothing to check", lambda at: at["steps"][1].update(checks=[]), "a step to make needs at least one check."),
    ("an id twice", lambda at: at["steps"][1].update(id="guess"), "the id guess is there twice."),
    ("a place too far", lambda at: at["steps"][1]["checks"][0].update(goal=1), "the room has 1 goals with a place"),
    (
        "no such command",
        lambda at: at["steps"][1].update(checks=[{"kind": "sends", "id": "there", "command": "Led3 Red"}]),
        "there is no command Led3;",
    ),
    (
        "no such colour",
        lambda at: at["steps"][1].update(checks=[{"kind": "sends", "id": "there", "command": "Led1 Pink"}]),
        "Pink is none of Black, Green, Orange, Red.",
    ),
    (
        "no such property",
        lambda at: at["steps"][1].update(checks=[{"kind": "holds", "id": "there", "property": "never-sleeps"}]),
        "There is no property called 'never-sleeps'",
    ),
]


@pytest.mark.parametrize(("change", "sentence"), [m[1:] for m in MISTAKES], ids=[m[0] for m in MISTAKES])
def test_a_mistake_is_told_with_its_place(tmp_path: Path, change: Change, sentence: str) -> None:
    with pytest.raises(BadInput) as told:
        read_lesson(written(tmp_path / "wrong", change))
    assert "lesson.json" in str(told.value)
    assert sentence in str(told.value)


@pytest.mark.parametrize(
    ("retell", "sentence"),
    [
        (lambda at: at["steps"].pop("go"), "steps.go is missing."),
        (lambda at: at["steps"]["guess"]["answers"].pop("b"), "steps.guess.answers.b is missing."),
        (lambda at: at["checks"].pop("there"), "checks.there is missing."),
    ],
)
def test_a_missing_text_is_told(tmp_path: Path, retell: Change, sentence: str) -> None:
    with pytest.raises(BadInput, match=r"en\.json") as told:
        read_lesson(written(tmp_path / "wrong", retell=retell))
    assert sentence in str(told.value)


def test_the_lessons_of_the_repository_are_complete() -> None:
    found = lessons(FOLDER)
    assert [lesson.file.number for lesson in found] == list(range(1, len(found) + 1))
    for lesson in found:
        assert set(lesson.texts) >= TRANSLATED, lesson.name
        assert len(lesson.file.other_rooms) >= 3, lesson.name
        for texts in lesson.texts.values():
            for step in texts.steps.values():
                assert len(step.say.split()) <= 15, step.say


def test_the_toolbox_of_a_lesson_has_the_blocks_of_earlier_lessons(tmp_path: Path) -> None:
    written(tmp_path / "one")
    written(tmp_path / "two", lambda at: at.update(number=2, blocks=["Led1"]))
    assert [entry["name"] for entry in lesson_list(tmp_path)] == ["one", "two"]
    second = lesson_json(tmp_path, "two")
    assert second is not None
    assert second["toolbox"] == ["Led1", "Velocity"]
    first = lesson_json(tmp_path, "one")
    assert first is not None
    assert (first["toolbox"], first["next"]) == (["Velocity"], "two")
    assert lesson_json(tmp_path, "../one") is None


def test_the_schemas_are_those_of_the_readers() -> None:
    protocol = discover().root / "protocol"
    assert (protocol / "lesson.schema.json").read_text("utf-8") == schema_text(lesson_schema())
    assert (protocol / "lesson-document.schema.json").read_text("utf-8") == schema_text(document_schema())


def test_a_lesson_for_a_page_is_a_lesson_document() -> None:
    for lesson in lessons(FOLDER):
        document = msgspec.convert(lesson_json(FOLDER, lesson.name), LessonDocument)
        assert document.name == lesson.name


def test_a_strand_has_the_blocks_of_the_lessons_that_it_follows_and_no_course_leads_into_it(tmp_path: Path) -> None:
    written(tmp_path / "one")
    written(tmp_path / "two", lambda at: at.update(number=2, blocks=["Led1"]))
    written(tmp_path / "three", lambda at: at.update(number=3, blocks=["+"], course="strand", after=1))
    written(tmp_path / "four", lambda at: at.update(number=4, blocks=["*"], course="strand", after=1))
    two, three, four = (lesson_json(tmp_path, name) for name in ("two", "three", "four"))
    assert two is not None
    assert three is not None
    assert four is not None
    assert [lesson["next"] for lesson in (two, three, four)] == [None, "four", None]
    assert four["toolbox"] == ["*", "+", "Velocity"]
