"""Every challenge in real runs: its model solution earns all stars, and each near miss lacks the star that it names."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from rosy_sim.config import discover
from rosy_sim.lessons.challenges import challenges, starred_step
from rosy_sim.lessons.lesson_document import LessonDocument
from rosy_sim.lessons.rehearsal import attempt
from rosy_sim.worker.blocking_worker import BlockingWorker
from rosy_sim.worlds.gallery import usable_arena

from .real_runs import LIMITS, worker_started

pytestmark = pytest.mark.real

CHALLENGES = challenges(discover().examples / "challenges")


@pytest.fixture(scope="module")
def worker() -> Iterator[BlockingWorker]:
    yield from worker_started()


def missed(worker: BlockingWorker, challenge: LessonDocument, source: str | None) -> set[str]:
    """The stars that a program does not earn."""
    assert source is not None
    arena = usable_arena(challenge.room, challenge.name)
    did = attempt(worker, source, starred_step(challenge), [], arena, 1, LIMITS)
    assert did.run.ended in ("time", "done"), did.run.problems
    return {verdict.id for verdict in did.verdicts if verdict.state != "done"}


@pytest.mark.parametrize("challenge", CHALLENGES, ids=lambda challenge: challenge.name)
def test_the_solution_earns_all_stars_and_near_misses_lack_one(
    worker: BlockingWorker, challenge: LessonDocument
) -> None:
    assert missed(worker, challenge, challenge.solution) == set()
    for wrong in challenge.steps[0].wrong:
        assert wrong.check in missed(worker, challenge, wrong.program), wrong.program
