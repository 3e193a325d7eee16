"""
Rehearsals of a lesson that a teacher is writing: the solution and wrong attempts are run and judged beside the pages.

A socket carries the rehearsals of one lesson, one at a time per page; they share the queue of the tests in many rooms.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable

import msgspec
from starlette.websockets import WebSocket, WebSocketDisconnect

from ...config import Config
from ...errors import BadInput, RosyError
from ...lessons.background_rehearsals import rehearse_in_background
from ...lessons.lesson_watch import BadStep, CheckedStep, examine_step
from ...lessons.rehearsal_process import Rehearsed, RehearsedAttempt
from ...rooms.background_trials import BUDGET
from ...run.run_queue import RunQueue
from ...sentence import tr
from ...wire.lesson_rehearsals import (
    AttemptJudged,
    BadRehearsal,
    Failed,
    Queued,
    RehearsalRequest,
    encode_answer,
    failed,
    read_request,
)
from ...worlds.gallery import usable_arena
from .job_socket import serve_job

__all__ = ["LessonRehearsals"]

_Answer = Queued | AttemptJudged | Failed
# None: the last message has been sent.
_Outbox = asyncio.Queue[_Answer | None]


class LessonRehearsals:
    """Serves the sockets. ``queue`` has the slots of tests in many rooms."""

    def __init__(self, config: Config, queue: RunQueue) -> None:
        self._config = config
        self._queue = queue
        # The sessions of pages with rehearsals.
        self._busy: set[str] = set()

    @property
    def is_busy(self) -> bool:
        """Whether a page has rehearsals."""
        return bool(self._busy)

    async def serve(self, socket: WebSocket, session: str, closed: asyncio.Event) -> None:
        """Serve the rehearsals of the page of a session; ``closed`` is set when the page has left."""
        try:
            text = await socket.receive_text()
            if session in self._busy:
                await socket.send_text(encode_answer(failed(tr("A test of this page is still running."))))
                return
        except WebSocketDisconnect:
            # The page left before it said what to rehearse.
            return
        self._busy.add(session)
        outbox: _Outbox = asyncio.Queue()
        try:
            await serve_job(socket, closed, self._rehearse(text, outbox.put_nowait), _send(socket, outbox))
        finally:
            self._busy.discard(session)

    async def _rehearse(self, text: str, say: Callable[[_Answer | None], None]) -> None:
        try:
            request = read_request(text)
            # A room with many things takes a while to build.
            attempts = await asyncio.to_thread(_attempts, request)
        except (BadRehearsal, BadInput, BadStep) as error:
            say(failed(error.sentence))
            say(None)
            return
        number = 0

        def on_answer(did: Rehearsed) -> None:
            nonlocal number
            say(AttemptJudged(number, did.ended, did.passed, list(did.checks), did.problems))
            number += 1

        await self._queue.acquire(lambda place: say(Queued(place)))
        try:
            async with asyncio.timeout(BUDGET):
                await rehearse_in_background(self._config, request.world, attempts, on_answer)
        except TimeoutError:
            say(failed(tr("The attempts took too long. Try steps that are watched for a shorter time.")))
        except RosyError as error:
            say(failed(error.sentence))
        finally:
            self._queue.release()
        say(None)


async def _send(socket: WebSocket, outbox: _Outbox) -> None:
    """Send until the last message."""
    while (answer := await outbox.get()) is not None:
        try:
            await socket.send_text(encode_answer(answer))
        except (WebSocketDisconnect, RuntimeError):
            # The page closed the socket during a send.
            return


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
