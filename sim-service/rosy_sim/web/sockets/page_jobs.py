"""
Background jobs of pages, each on a socket of its own: one at a time per page, few at a time in the service, within a
budget of time, which is shorter when a client waits that has no job.

The processes of a job are apart from the service and from the worker of the runs, so live pages keep their pace. A job
is cancelled when the page closes the socket, leaves, or has used up its budget.
"""

from __future__ import annotations

import asyncio
import contextlib
from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping
from typing import Generic, TypeVar

import msgspec
from starlette.status import WS_1008_POLICY_VIOLATION
from starlette.websockets import WebSocket, WebSocketDisconnect

from ...accounting.fair_queue import FairQueue
from ...rooms.background_trials import BUDGET
from ...sentences.sentence import Sentence, SentenceError, tr
from ...wire.page.jobs import Queued, encode_answer, failed
from ..sessions.page_session import PageSession
from .first_completed import first_completed

__all__ = ["PageJobs", "Say"]

Say = Callable[[msgspec.Struct], None]
"""Sends a message to the page; never blocks."""

_Answers = asyncio.Queue[msgspec.Struct | None]
"""``None``: the last message has been sent."""

_Job = TypeVar("_Job")


class PageJobs(ABC, Generic[_Job]):
    """
    Serves the sockets of one kind of job.

    Args:
        sessions: the page sessions by their random names.
        queue: the slots of all kinds of jobs together.
        too_long: said when a job has used up its budget.
    """

    def __init__(self, sessions: Mapping[str, PageSession], queue: FairQueue, too_long: Sentence) -> None:
        self._sessions = sessions
        self._queue = queue
        self._too_long = too_long
        # The sessions of pages with a job.
        self._busy: set[str] = set()

    @property
    def is_busy(self) -> bool:
        """Whether a page has a job."""
        return bool(self._busy)

    @abstractmethod
    async def read(self, text: str | bytes, session: PageSession) -> _Job:
        """
        The job that a page asks for.

        Raises:
            SentenceError: it asks for none, or for one that cannot be done.
        """

    @abstractmethod
    async def work(self, job: _Job, say: Say) -> None:
        """
        Do a job, and send its messages but the failure.

        Raises:
            SentenceError: it could not be done.
        """

    async def serve(self, socket: WebSocket) -> None:
        """Serve one job of the page of a session."""
        session = self._sessions.get(socket.path_params["session"])
        if session is None:
            await socket.close(WS_1008_POLICY_VIOLATION)
            return
        await socket.accept()
        with contextlib.suppress(RuntimeError, WebSocketDisconnect):
            message = await socket.receive()
            if message["type"] == "websocket.disconnect":
                return
            text = message.get("text") or message.get("bytes") or ""
            if session.id in self._busy:
                await socket.send_text(encode_answer(failed(tr("A test of this page is still running."))))
            else:
                await self._serve(socket, session, text)
            await socket.close()

    async def _serve(self, socket: WebSocket, session: PageSession, text: str | bytes) -> None:
        """Work and send until the last message is sent, the socket is closed, or the page has left."""
        self._busy.add(session.id)
        answers: _Answers = asyncio.Queue()
        work = asyncio.create_task(self._complete(text, session, answers))
        try:
            await first_completed(_send(socket, answers), _wait_for_end(socket), session.closed.wait())
        finally:
            work.cancel()
            await asyncio.gather(work, return_exceptions=True)
            self._busy.discard(session.id)

    async def _complete(self, text: str | bytes, session: PageSession, answers: _Answers) -> None:
        say = answers.put_nowait
        try:
            job = await self.read(text, session)
            deadline = asyncio.timeout(None)
            loop = asyncio.get_running_loop()
            place = await self._queue.acquire(
                session.client, lambda place: say(Queued(place)), lambda: deadline.reschedule(loop.time())
            )
            try:
                async with deadline:
                    deadline.reschedule(loop.time() + BUDGET)
                    await self.work(job, say)
            finally:
                place.release()
        except TimeoutError:
            say(failed(self._too_long))
        except SentenceError as error:
            say(failed(error.sentence))
        finally:
            say(None)


async def _send(socket: WebSocket, answers: _Answers) -> None:
    """Send until the last message, or until the page has closed the socket."""
    with contextlib.suppress(WebSocketDisconnect, RuntimeError):
        while (answer := await answers.get()) is not None:
            await socket.send_text(encode_answer(answer))


async def _wait_for_end(socket: WebSocket) -> None:
    """A page says nothing after its request; it closes the socket to cancel."""
    while (await socket.receive())["type"] != "websocket.disconnect":
        continue
