"""
Tests in many rooms for pages: one at a time per page, few at a time in the service, at the lowest priority.

A socket carries one test. Its trial processes are apart from the service and from the worker of the runs, so live pages
keep their pace; they end when the page closes the socket, leaves, or has used up its budget of time.
"""

from __future__ import annotations

import asyncio
import os
from collections.abc import Callable
from dataclasses import replace

from starlette.websockets import WebSocket, WebSocketDisconnect

from ...config import Config
from ...errors import BadInput, RosyError
from ...rooms.background_trials import BUDGET, try_in_background
from ...rooms.generation.families import Family, family_like
from ...rooms.room_test import Report, RoomTest, check_goals, worst_first
from ...rooms.tested_room import tested_room
from ...run.run_queue import RunQueue
from ...run.steps.velocity_guard import SafetySettings
from ...sentence import tr
from ...wire.room_tests import (
    BadTest,
    Failed,
    Progress,
    Queued,
    Reported,
    RoomTestRequest,
    SmallestRoom,
    encode_answer,
    failed,
    read_test,
)
from ...world.properties import BadProperty, read_properties
from .job_socket import serve_job

__all__ = ["RoomTests"]

_PROGRESS_INTERVAL = 0.1
"""Between two messages about the progress, s."""

_Answer = Queued | Progress | Reported | Failed


class RoomTests:
    """Serves the sockets; half of the cores, but at least one, may be busy with tests."""

    def __init__(self, config: Config) -> None:
        self._config = config
        # Shared with the checks of hand-ins and the rehearsals of lessons.
        self.queue = RunQueue(max(1, len(os.sched_getaffinity(0)) // 2))
        # The sessions of pages with a test.
        self._busy: set[str] = set()

    @property
    def is_busy(self) -> bool:
        """Whether a page has a test."""
        return bool(self._busy)

    async def serve(self, socket: WebSocket, session: str, closed: asyncio.Event, safety: SafetySettings) -> None:
        """Serve one test of the page of a session; ``closed`` is set when the page has left."""
        try:
            text = await socket.receive_text()
            if session in self._busy:
                await socket.send_text(encode_answer(failed(tr("A test of this page is still running."))))
                return
        except WebSocketDisconnect:
            # The page left before it said what to test.
            return
        self._busy.add(session)
        outbox: asyncio.Queue[_Answer] = asyncio.Queue()
        try:
            await serve_job(socket, closed, self._test(text, safety, outbox.put_nowait), _send(socket, outbox))
        finally:
            self._busy.discard(session)

    async def _test(self, text: str, safety: SafetySettings, say: Callable[[_Answer], None]) -> None:
        """Make one test; the last message is a report or says why there is none."""
        try:
            request = read_test(text)
            test = replace(_room_test(request), safety=safety)
        except (BadTest, BadInput, BadProperty) as error:
            say(failed(error.sentence))
            return
        await self.queue.acquire(lambda place: say(Queued(place)))
        try:
            async with asyncio.timeout(BUDGET):
                say(_reported(await self._run(request.source, test, say)))
        except TimeoutError:
            say(failed(tr("The test took too long. Try fewer rooms.")))
        except RosyError as error:
            say(failed(error.sentence))
        finally:
            self.queue.release()

    async def _run(self, source: str, test: RoomTest, say: Callable[[_Answer], None]) -> Report:
        loop = asyncio.get_running_loop()
        counts = Progress(0, 0, 0)
        next_time = loop.time()

        def show(changed: Progress) -> None:
            nonlocal counts, next_time
            counts = changed
            if loop.time() >= next_time:
                next_time = loop.time() + _PROGRESS_INTERVAL
                say(counts)

        return await try_in_background(
            self._config,
            source,
            test,
            lambda outcome: show(Progress(counts.done + 1, counts.passed + outcome.has_passed, 0)),
            lambda tried: show(Progress(counts.done, counts.passed, tried)),
        )


async def _send(socket: WebSocket, outbox: asyncio.Queue[_Answer]) -> None:
    """Send until the last message of a test."""
    while True:
        answer = await outbox.get()
        try:
            await socket.send_text(encode_answer(answer))
        except (WebSocketDisconnect, RuntimeError):
            # The page closed the socket during a send.
            return
        if isinstance(answer, Reported | Failed):
            return


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
