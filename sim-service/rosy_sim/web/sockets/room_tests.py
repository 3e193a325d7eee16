"""
Tests in many rooms for pages: trial processes at the lowest priority, progress, and one report.
"""

from __future__ import annotations

import asyncio
from collections.abc import Mapping
from dataclasses import replace

from ...accounting.fair_queue import FairQueue
from ...config import Config
from ...rooms.background_trials import try_in_background
from ...rooms.generation.families import Family, family_like
from ...rooms.room_test import Report, RoomTest, check_goals, worst_first
from ...rooms.tested_room import tested_room
from ...sentences.sentence import tr
from ...wire.page.room_tests import Progress, Reported, RoomTestRequest, SmallestRoom, read_test
from ...world.properties import read_properties
from ..sessions.page_session import PageSession
from .page_jobs import PageJobs, Say

__all__ = ["RoomTests"]

_PROGRESS_INTERVAL = 0.1
"""Between two messages about the progress, s."""


class RoomTests(PageJobs[tuple[str, RoomTest]]):
    """Tests a program in the rooms of a family."""

    def __init__(self, config: Config, sessions: Mapping[str, PageSession], queue: FairQueue) -> None:
        super().__init__(sessions, queue, tr("The test took too long. Try fewer rooms."))
        self._config = config

    async def read(self, text: str | bytes, session: PageSession) -> tuple[str, RoomTest]:
        """The program, and the test with the safety rules of the page."""
        request = read_test(text)
        return request.source, replace(_room_test(request), safety=session.safety)

    async def work(self, job: tuple[str, RoomTest], say: Say) -> None:
        """Make a test; the last message is its report."""
        source, test = job
        loop = asyncio.get_running_loop()
        counts = Progress(0, 0, 0)
        next_time = loop.time()

        def show(changed: Progress) -> None:
            nonlocal counts, next_time
            counts = changed
            if loop.time() >= next_time:
                next_time = loop.time() + _PROGRESS_INTERVAL
                say(counts)

        report = await try_in_background(
            self._config,
            source,
            test,
            lambda outcome: show(Progress(counts.done + 1, counts.passed + outcome.has_passed, 0)),
            lambda tried: show(Progress(counts.done, counts.passed, tried)),
        )
        say(_reported(report))


def _room_test(request: RoomTestRequest) -> RoomTest:
    like = request.family == "like"
    family = family_like(request.world, "like:this room") if like else Family(request.family)
    properties = read_properties(request.properties)
    check_goals(family, properties)
    return RoomTest(family, request.rooms, request.seed, request.seconds, properties)


def _reported(report: Report) -> Reported:
    worlds = {outcome.room: world for outcome, world in zip(report.outcomes, report.worlds, strict=True)}
    rooms = [tested_room(outcome, worlds[outcome.room]) for outcome in worst_first(report.outcomes)]
    smallest = None
    if report.smallest is not None:
        shrunk = report.smallest.shrunk
        tested = tested_room(report.smallest.outcome, shrunk.world)
        smallest = SmallestRoom(shrunk.things, shrunk.of, shrunk.is_minimal, tested)
    return Reported(report.passed, rooms, smallest, report.refused)
