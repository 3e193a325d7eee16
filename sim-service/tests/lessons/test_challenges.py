"""The challenges of the repository: their files, the stars of a run, and what a page gets of them."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import msgspec
import pytest

from rosy_sim.config import discover
from rosy_sim.errors import BadInput
from rosy_sim.lessons.catalogue import lesson_names
from rosy_sim.lessons.challenges import challenge_json, challenge_list, challenges, starred_step
from rosy_sim.lessons.checks import Check
from rosy_sim.lessons.lesson_document import LessonDocument
from rosy_sim.lessons.lesson_watch import CheckedStep, LessonWatch
from rosy_sim.world.goals import GoalState
from rosy_sim.worlds.gallery import usable_arena

FOLDER = discover().examples / "challenges"
LANGUAGES = {"en", "de", "pt", "es", "fr"}


def test_each_has_three_stars_texts_in_all_languages_a_solution_and_two_near_misses() -> None:
    found = challenges(FOLDER)
    assert [challenge.number for challenge in found] == [1, 2, 3, 4, 5]
    for challenge in found:
        step = starred_step(challenge)
        assert len(step.checks) == 3, challenge.name
        assert challenge.solution is not None, challenge.name
        assert {wrong.check for wrong in challenge.steps[0].wrong} == {check.id for check in step.checks[1:]}
        assert set(challenge.texts) == LANGUAGES, challenge.name
        for texts in challenge.texts.values():
            assert set(texts.checks) == {check.id for check in step.checks}, challenge.name
            assert len(texts.steps["go"].say.split()) <= 15, texts.steps["go"].say


def test_no_challenge_is_called_like_a_lesson() -> None:
    names = {path.stem for path in FOLDER.glob("*.json")}
    assert names == {challenge.name for challenge in challenges(FOLDER)}
    assert not names & lesson_names(discover().examples / "lessons")


def test_the_list_has_an_id_for_each_star() -> None:
    first = challenge_list(FOLDER)[0]
    assert (first["name"], first["number"], first["steps"]) == ("sprint", 1, ["star-1", "star-2", "star-3"])
    assert set(first["titles"]) == LANGUAGES


def test_a_page_gets_neither_the_solution_nor_the_near_misses() -> None:
    value = challenge_json(FOLDER, "sprint")
    assert value is not None
    assert "solution" not in value
    assert "wrong" not in value["steps"][0]
    assert (value["room"]["name"], value["next"]) == ("lesson sprint", "behind-the-box")
    assert msgspec.convert(value, LessonDocument).name == "sprint"
    assert challenge_json(FOLDER, "../sprint") is None
    last = challenge_json(FOLDER, "race-on-the-line")
    assert last is not None
    assert last["next"] is None


Change = Callable[[dict[str, Any]], object]


@pytest.mark.parametrize(
    ("change", "why"),
    [
        (lambda step: step.update(stars=False), "sprint: steps[0].stars is missing."),
        (
            lambda step: step["checks"].insert(0, {"kind": "still", "id": "stands", "after": 1}),
            "the first star must be about the goals of the room.",
        ),
        (lambda step: step["checks"].append({"kind": "never", "id": "n", "event": "Bumpy"}), "there is no event Bumpy"),
    ],
)
def test_a_challenge_with_a_mistake_is_refused(tmp_path: Path, change: Change, why: str) -> None:
    value = json.loads((FOLDER / "sprint.json").read_text("utf-8"))
    change(value["steps"][0])
    (tmp_path / "sprint.json").write_text(json.dumps(value))
    with pytest.raises(BadInput) as refused:
        challenges(tmp_path)
    assert why in str(refused.value)


def watched(*steps: tuple[float, str, bool]) -> LessonWatch:
    """A run of ``sprint`` with one more star, to touch nothing; a step: its time, the state of the goal, a bump."""
    challenge = challenges(FOLDER)[0]
    checks = [*starred_step(challenge).checks, msgspec.convert(NEVER, Check)]
    watch = LessonWatch(CheckedStep(seconds=60, checks=checks, stars=True), usable_arena(challenge.room, "room"))
    for time, state, bumps in steps:
        goal = GoalState("reach", "Ring", state, 0.5, time if state == "done" else None)  # type: ignore[arg-type]
        events = [("Bumper", (0, 1))] if bumps else []
        world = SimpleNamespace(x=1, y=1, theta=0, v=0, w=0, sensors=SimpleNamespace(bumpers=0, wheels=0))
        watch.on_step(
            SimpleNamespace(  # type: ignore[arg-type]
                world=world, time=time, events=events, commands=[], goals=SimpleNamespace(states=[goal]), ended=None
            )
        )
    return watch


NEVER = {"kind": "never", "id": "clean", "event": "Bumper _ Pressed"}


def stars(watch: LessonWatch) -> list[str]:
    """The ids of the stars that are earned."""
    return [verdict.id for verdict in watch.verdicts if verdict.state == "done"]


def test_the_stars_are_judged_in_the_step_that_reaches_the_goal_and_never_again() -> None:
    assert not watched((0.02, "open", False)).is_over
    reached = watched((0.02, "open", False), (9.02, "done", False))
    assert reached.is_over
    assert stars(reached) == ["there", "quick", "clean"]
    # What happens behind the goal takes no star away.
    assert stars(watched((0.02, "open", False), (7.02, "done", False), (7.04, "done", True))) == [
        "there",
        "quick",
        "quickest",
        "clean",
    ]


def test_a_bump_before_the_goal_costs_a_star() -> None:
    assert stars(watched((0.02, "open", True), (13.02, "done", False))) == ["there"]
