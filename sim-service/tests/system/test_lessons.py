"""
Every lesson: its solutions pass, the reference in other rooms as well, and wrong attempts fail as they are named.

What a check has seen of a wrong attempt stands in ``docs/teaching/near-misses.json``, from which the pages for teachers
are made; ``UPDATE_GOLDENS=1`` writes it anew, in one process (``-n 0``).
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import msgspec
import pytest

from rosy_sim.config import discover
from rosy_sim.lessons.catalogue import lessons
from rosy_sim.lessons.lesson_file import Lesson, Step, attempts, checked_step
from rosy_sim.lessons.rehearsal import attempt
from rosy_sim.wire.verdict import Seen
from rosy_sim.worker.blocking_worker import BlockingWorker
from rosy_sim.worlds.gallery import usable_arena

from .real_runs import LIMITS, worker_started

pytestmark = pytest.mark.real

FOLDER = discover().examples / "lessons"

NEAR_MISSES = Path(__file__).resolve().parents[3] / "docs" / "teaching" / "near-misses.json"

LESSONS = {lesson.name: lesson for lesson in lessons(FOLDER)}


@dataclass(frozen=True, slots=True)
class Case:
    """An attempt at a step of a lesson in one of its rooms; ``fails`` is the check that it fails."""

    lesson: Lesson
    step: Step
    path: Path
    world: dict[str, object]
    where: str
    fails: str | None

    def __str__(self) -> str:
        return f"{self.lesson.name}/{self.step.id}/{self.path.stem}{self.where}"


def _cases() -> Iterator[Case]:
    for lesson in LESSONS.values():
        for step in lesson.file.steps:
            for path in attempts(FOLDER / lesson.name, "solutions", step.id):
                yield Case(lesson, step, path, lesson.world, "", None)
            for path in attempts(FOLDER / lesson.name, "wrong", step.id):
                yield Case(lesson, step, path, lesson.world, "", path.stem.split(".")[0])
        last = lesson.file.steps[-1]
        reference = FOLDER / lesson.name / "solutions" / last.id / "reference.hs"
        for number, world in enumerate(lesson.other_worlds(), 1):
            yield Case(lesson, last, reference, world, f" in room {number}", None)


@pytest.fixture(scope="module")
def worker() -> Iterator[BlockingWorker]:
    yield from worker_started()


@pytest.mark.parametrize("case", list(_cases()), ids=str)
def test_attempts_are_judged_rightly(worker: BlockingWorker, case: Case) -> None:
    arena = usable_arena(case.world, str(case))
    step = checked_step(case.step)
    assert step is not None
    did = attempt(worker, case.path.read_text("utf-8"), step, case.step.hands, arena, 1, LIMITS)
    assert did.run.ended in ("time", "done"), did.run.problems
    missed = {verdict.id: verdict.seen for verdict in did.verdicts if verdict.state != "done"}
    if case.fails is None:
        assert did.is_passed, missed
    else:
        assert not did.is_passed
        seen = missed.get(case.fails)
        assert seen is not None, "it fails another check, or without a word about what was seen"
        if os.environ.get("UPDATE_GOLDENS") == "1":
            _write_near_miss(str(case), _plain(seen))
        assert json.loads(NEAR_MISSES.read_text("utf-8")).get(str(case)) == _plain(seen)


def _plain(seen: Seen) -> object:
    """As JSON; numbers have the digits that a sentence about them shows, and two more."""
    number = None if seen.number is None else round(seen.number, 4)
    return msgspec.to_builtins(msgspec.structs.replace(seen, number=number))


def _write_near_miss(attempted: str, seen: object) -> None:
    attempts_of_lessons = {str(case) for case in _cases() if case.fails is not None}
    known = json.loads(NEAR_MISSES.read_text("utf-8")) if NEAR_MISSES.exists() else {}
    kept = {name: one for name, one in {**known, attempted: seen}.items() if name in attempts_of_lessons}
    NEAR_MISSES.write_text(json.dumps(dict(sorted(kept.items())), indent=1) + "\n", "utf-8")


def test_no_near_miss_is_left_over() -> None:
    assert set(json.loads(NEAR_MISSES.read_text("utf-8"))) == {str(case) for case in _cases() if case.fails is not None}


@pytest.mark.parametrize("name", LESSONS)
def test_each_lesson_has_five_solutions_three_other_rooms_and_wrong_attempts(name: str) -> None:
    lesson = LESSONS[name]
    last = lesson.file.steps[-1]
    solutions = [path.read_text("utf-8") for path in attempts(FOLDER / name, "solutions", last.id)]
    assert len(set(solutions)) >= 5
    assert len(lesson.file.other_rooms) >= 3
    assert attempts(FOLDER / name, "wrong", last.id)
