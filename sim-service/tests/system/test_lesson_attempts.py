"""
Solutions and near misses of each lesson (``attempts.txt``), written from its text: each right one passes, also in the
other rooms of its step, and each wrong one fails in one of them. The hints, put into the start program, pass as well.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass

import pytest

from rosy_sim.config import discover
from rosy_sim.lessons.catalogue import lessons
from rosy_sim.lessons.lesson_file import Lesson, attempts, checked_step
from rosy_sim.lessons.rehearsal import attempt
from rosy_sim.worker.blocking_worker import BlockingWorker
from rosy_sim.worlds.gallery import usable_arena

from .real_runs import LIMITS, worker_started

FOLDER = discover().examples / "lessons"
LESSONS = {lesson.name: lesson for lesson in lessons(FOLDER)}

_HEAD = re.compile(r"^== (?:(right|wrong) ([a-z-]+): (.+)|given)\n", re.MULTILINE)


@dataclass(frozen=True, slots=True)
class Attempt:
    """A program, the step that it is an attempt at, and whether it is a solution."""

    is_right: bool
    step: str
    name: str
    source: str


def _attempts(lesson: str) -> list[Attempt]:
    """The attempts of a lesson's file; what is ``given`` at its end is part of each."""
    parts = _HEAD.split((FOLDER / lesson / "attempts.txt").read_text("utf-8"))
    given = parts[-1] if parts[-4] is None else ""
    heads = zip(parts[1::4], parts[2::4], parts[3::4], parts[4::4], strict=True)
    return [Attempt(of == "right", step, name, f"{text}\n{given}") for of, step, name, text in heads if of]


@pytest.fixture(scope="module")
def worker() -> Iterator[BlockingWorker]:
    yield from worker_started()


def _missed(worker: BlockingWorker, lesson: Lesson, tried: Attempt) -> str | None:
    """What of a step an attempt does not pass, and where; None when it passes."""
    step = lesson.step(tried.step)
    watched = checked_step(step)
    assert watched is not None
    others = lesson.other_worlds()
    for world in (lesson.world, *(others[number] for number in step.also_in)):
        did = attempt(worker, tried.source, watched, step.hands, usable_arena(world, lesson.name), 1, LIMITS)
        assert did.run.ended in ("time", "done"), (tried.name, did.run.ended, did.run.problems)
        if not did.is_passed:
            return ", ".join(f"{one.id}: {one.seen}" for one in did.verdicts if one.state != "done")
    return None


@pytest.mark.real
@pytest.mark.parametrize("name", LESSONS)
def test_solutions_pass_and_near_misses_fail(worker: BlockingWorker, name: str) -> None:
    wrongly: list[str] = []
    for tried in _attempts(name):
        missed = _missed(worker, LESSONS[name], tried)
        if tried.is_right and missed is not None:
            wrongly.append(f"{tried.step}: {tried.name}: is right, and fails {missed}")
        if not tried.is_right and missed is None:
            wrongly.append(f"{tried.step}: {tried.name}: is wrong, and passes")
    assert not wrongly, "\n".join(wrongly)


@pytest.mark.parametrize("name", LESSONS)
def test_each_lesson_has_four_solutions_and_six_near_misses(name: str) -> None:
    last = LESSONS[name].file.steps[-1].id
    count = Counter(tried.is_right for tried in _attempts(name) if tried.step == last)
    assert count[True] >= 4
    assert count[False] >= 6


@pytest.mark.parametrize("name", LESSONS)
def test_a_guess_gets_the_same_reply_whether_it_is_right_or_not(name: str) -> None:
    for language, texts in LESSONS[name].texts.items():
        for step in LESSONS[name].file.steps:
            if step.kind == "predict":
                assert len(set(texts.steps[step.id].replies.values())) == 1, (language, step.id)


@pytest.mark.parametrize("name", LESSONS)
def test_each_piece_of_a_hint_is_in_a_program_that_passes(name: str) -> None:
    lesson = LESSONS[name]
    for step in lesson.file.steps:
        passing = [path.read_text("utf-8") for path in attempts(FOLDER / name, "solutions", step.id)]
        passing += [tried.source for tried in _attempts(name) if tried.is_right and tried.step == step.id]
        lines = [_spaced(line) for source in passing for line in source.splitlines()]
        for check in step.checks:
            for language, texts in lesson.texts.items():
                for piece in texts.hints.get(check.id, [])[2:]:
                    for line in piece.splitlines():
                        assert any(_spaced(line) in other for other in lines), (language, check.id, line)


def _spaced(line: str) -> str:
    return " ".join(line.split())
