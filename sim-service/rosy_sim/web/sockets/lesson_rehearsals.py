"""
Rehearsals of a lesson that a teacher is writing: the solution and wrong attempts are run and judged beside the pages.
"""

from __future__ import annotations

import asyncio
from collections.abc import Mapping
from itertools import count
from typing import Any

import msgspec

from ...accounting.fair_queue import FairQueue
from ...config import Config
from ...errors import BadInput
from ...lessons.background_rehearsals import rehearse_in_background
from ...lessons.lesson_watch import CheckedStep, examine_step
from ...lessons.rehearsal_process import Rehearsed, RehearsedAttempt
from ...sentences.sentence import tr
from ...wire.page.lesson_rehearsals import AttemptJudged, RehearsalRequest, read_request
from ...worlds.gallery import usable_arena
from ..sessions.page_session import PageSession
from .page_jobs import PageJobs, Say

__all__ = ["LessonRehearsals"]

_Rehearsal = tuple[Any, list[RehearsedAttempt]]
"""The room as JSON, and the attempts there."""


class LessonRehearsals(PageJobs[_Rehearsal]):
    """Judges the attempts at the steps of one lesson."""

    def __init__(self, config: Config, sessions: Mapping[str, PageSession], queue: FairQueue) -> None:
        too_long = tr("The attempts took too long. Try steps that are watched for a shorter time.")
        super().__init__(sessions, queue, too_long)
        self._config = config

    async def read(self, text: str | bytes, _session: PageSession) -> _Rehearsal:
        """The attempts in their room."""
        request = read_request(text)
        # A room with many things takes a while to build.
        return request.world, await asyncio.to_thread(_attempts, request)

    async def work(self, job: _Rehearsal, say: Say) -> None:
        """Rehearse; a message for each attempt."""
        world, attempts = job
        numbers = count()

        def on_answer(did: Rehearsed) -> None:
            say(AttemptJudged(next(numbers), did.ended, did.passed, list(did.checks), did.problems))

        await rehearse_in_background(self._config, world, attempts, on_answer)


def _attempts(request: RehearsalRequest) -> list[RehearsedAttempt]:
    """
    The attempts with their steps as values.

    Raises:
        BadInput: the room or a step cannot be used.
        BadStep: a check does not fit the room.
    """
    arena = usable_arena(request.world, tr("room"))
    found = []
    for one in request.attempts:
        try:
            step = msgspec.convert(one.step, CheckedStep)
        except msgspec.ValidationError as error:
            raise BadInput(tr("The checks of this lesson cannot be used: {why}.", why=error)) from error
        examine_step(step, arena)
        found.append(RehearsedAttempt(one.source, step, one.hands))
    return found
