"""
Checks of all hand-ins of a task in the same rooms, by the code of ``./rosy run FOLDER --rooms``.

One check at a time for a class. Each program takes a slot of the tests in many rooms, so a check and the tests of pages
take turns; its result is stored as soon as it is there.
"""

from __future__ import annotations

import asyncio
import contextlib
import logging
from collections.abc import Callable, Iterator
from typing import Any

import msgspec

from ..accounting.client import SERVICE
from ..accounting.fair_queue import FairQueue
from ..config import Config
from ..errors import BadInput, RosyError
from ..rooms.background_trials import BUDGET, try_in_background
from ..rooms.generation.families import Family, family_like
from ..rooms.room_test import Report, RoomTest, check_goals, worst_first
from ..rooms.tested_room import tested_room
from ..sentences.sentence import tr
from ..sentences.wording import in_terminal
from ..wire.page.room_tests import TestedRoom
from ..world.properties import BadProperty, read_properties
from ..worlds.gallery import DEFAULT_WORLD, named_world
from .class_tasks import ClassTasks
from .lesson_checks import check_by_lesson
from .messages.check_messages import CheckAll, Checking, CheckNew, CheckResult, Fault
from .messages.message_fields import Refused
from .program_fingerprint import source_of
from .standings import mean_time
from .store.database import StoreError, fault_of
from .store.task_store import HandInKept

__all__ = ["HandInChecks"]

_log = logging.getLogger(__name__)


class _Project(msgspec.Struct):
    """The room of a project file. ``protocol/README.md``, section 5."""

    world: str | dict[str, Any] | None = None


class HandInChecks:
    """
    The check of a running class.

    Args:
        tasks: has the hand-ins, and takes the results.
        config: how trial processes start workers.
        queue: slots of tests in many rooms.
    """

    def __init__(self, tasks: ClassTasks, config: Config, queue: FairQueue) -> None:
        self._tasks = tasks
        self._config = config
        self._queue = queue
        self._check: asyncio.Task[None] | None = None
        self.progress = Checking()

    def start(self, request: CheckAll | CheckNew, refuse: Callable[[Refused], None]) -> None:
        """Begin a check. ``refuse`` is called when it cannot begin, or when a result cannot be stored."""
        is_new = isinstance(request, CheckNew)
        check = self._tasks.newest_check(request.task) if isinstance(request, CheckNew) else request
        if self._check is not None or check is None or self._tasks.task(request.task) is None:
            refuse(Refused("request"))
            return
        self.progress = Checking(self.progress.number + 1, request.task)
        self._check = asyncio.get_running_loop().create_task(self._run(check, is_new, refuse))

    async def cancel(self) -> None:
        """End the check, if one goes on, and its processes."""
        check = self._check
        if check is not None:
            check.cancel()
            await asyncio.gather(check, return_exceptions=True)
            # One that was cancelled before its first step has not done it.
            self._end()

    def _end(self) -> None:
        self.progress = Checking(self.progress.number)
        self._check = None

    async def _run(self, request: CheckAll, is_new: bool, refuse: Callable[[Refused], None]) -> None:
        try:
            if request.family != "lesson":
                read_properties(request.properties)
            if request.family not in ("own", "lesson"):
                await asyncio.to_thread(_room_test, request, "")
            if not is_new:
                await self._tasks.keep_check(request)
            kept = [one for one in await self._tasks.kept(request.task) if not (is_new and one.result)]
            self.progress = msgspec.structs.replace(self.progress, of=len(kept))
            await self._check_all(request, kept)
        except (BadInput, BadProperty):
            refuse(Refused("rooms"))
        except StoreError as error:
            _log.error("%s", in_terminal(tr("Results cannot be stored: {why}", why=error)))
            refuse(Refused(fault_of(error)))
        finally:
            self._end()

    async def _check_all(self, request: CheckAll, kept: list[HandInKept]) -> None:
        waiting = iter(kept)
        works = [asyncio.create_task(self._check_each(request, waiting)) for _ in range(self._queue.policy.places)]
        try:
            await asyncio.gather(*works)
        finally:
            for work in works:
                work.cancel()
            await asyncio.gather(*works, return_exceptions=True)

    async def _check_each(self, request: CheckAll, waiting: Iterator[HandInKept]) -> None:
        for one in waiting:
            async with self._queue.place(SERVICE):
                judged = self._result_by_lesson if request.family == "lesson" else self._result
                result, rooms = await judged(request, one.text)
            await self._tasks.grade(request.task, one.pupil, one.at, result, rooms)
            self.progress = msgspec.structs.replace(self.progress, done=self.progress.done + 1)

    async def _result(self, request: CheckAll, project: str) -> tuple[CheckResult, list[TestedRoom]]:
        try:
            test = await asyncio.to_thread(_room_test, request, project)
        except BadInput:
            return self._faulty(request, "room"), []
        try:
            async with asyncio.timeout(BUDGET):
                report = await try_in_background(
                    self._config, source_of(project), test, lambda _: self._count_room(), None
                )
        except TimeoutError:
            return self._faulty(request, "time"), []
        except RosyError as error:
            _log.warning("%s", in_terminal(tr("A hand-in could not be checked: {why}", why=error)))
            return self._faulty(request, "lost"), []
        if report.refused:
            return msgspec.structs.replace(self._faulty(request, "compile"), problems=report.refused), []
        rooms = _rooms(report)
        return msgspec.structs.replace(
            self._faulty(request, None), passed=report.passed, worst=rooms[0], time=mean_time(rooms)
        ), rooms

    async def _result_by_lesson(self, request: CheckAll, project: str) -> tuple[CheckResult, list[TestedRoom]]:
        try:
            async with asyncio.timeout(BUDGET):
                outcome = await check_by_lesson(self._config, project, source_of(project))
        except TimeoutError:
            return self._faulty(request, "time"), []
        except RosyError as error:
            _log.warning("%s", in_terminal(tr("A hand-in could not be checked: {why}", why=error)))
            return self._faulty(request, "lost"), []
        if outcome is None:
            return self._faulty(request, "lesson"), []
        if outcome.problems:
            return msgspec.structs.replace(self._faulty(request, "compile"), problems=outcome.problems), []
        result = self._faulty(request, None)
        return msgspec.structs.replace(result, rooms=outcome.rooms, passed=outcome.passed, unmet=outcome.unmet), []

    def _count_room(self) -> None:
        self.progress = msgspec.structs.replace(self.progress, rooms=self.progress.rooms + 1)

    def _faulty(self, request: CheckAll, fault: Fault | None) -> CheckResult:
        return CheckResult(
            self._tasks.today(),
            request.family,
            request.rooms,
            request.seed,
            request.seconds,
            request.properties,
            fault=fault,
        )


def _rooms(report: Report) -> list[TestedRoom]:
    """All rooms, worst first."""
    worlds = {outcome.room: world for outcome, world in zip(report.outcomes, report.worlds, strict=True)}
    return [tested_room(outcome, worlds[outcome.room]) for outcome in worst_first(report.outcomes)]


def _room_test(request: CheckAll, project: str) -> RoomTest:
    """
    What a program is tested for. Blocking: a room with many things takes a while to build.

    Raises:
        BadInput: the room cannot be used.
        BadProperty: the properties are none.
    """
    family = _family(request, project)
    properties = read_properties(request.properties)
    check_goals(family, properties)
    return RoomTest(family, request.rooms, request.seed, request.seconds, properties)


def _family(request: CheckAll, project: str) -> Family:
    match request.family:
        case "room":
            world = request.world
            return family_like(named_world(world) if isinstance(world, str) else world, "in:this room")
        case "own":
            return family_like(_room_of(project), "in:own room")
        case name:
            return Family(name)


def _room_of(project: str) -> dict[str, Any]:
    """The room of a project file; that of programs without one for a text that is none."""
    world: str | dict[str, Any] | None = None
    with contextlib.suppress(msgspec.MsgspecError, UnicodeError, RecursionError):
        world = msgspec.json.decode(project, type=_Project).world
    return world if isinstance(world, dict) else named_world(world or DEFAULT_WORLD)
