"""
Sockets of projectors: pages that show the room of the pupil whom the teacher has chosen on the board.
``protocol/README.md``, section 11.

A projector is told nothing before it has given the teacher's key, and afterwards nothing about other pupils.
"""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Mapping

from starlette.websockets import WebSocket

from ...accounting.slots import Evictions
from ...classroom.classroom import Classroom
from ...classroom.messages.message_fields import Refused
from ...classroom.messages.projector_messages import Invitation, Projected, RoomProjected, read_projector_request
from ...classroom.store.database import StoreError, fault_of
from ...sentences.sentence import tr
from ...sentences.wording import in_terminal
from ..pacing.loop_scheduler import LoopScheduler
from ..sessions.page_session import PageSession
from .class_connection import ClassConnection, locked

__all__ = ["ProjectorSockets"]

_log = logging.getLogger(__name__)

_PERIOD = 0.1
"""Between two looks at the robot, s."""


class ProjectorSockets:
    """
    The sockets of the projectors of a running class.

    Args:
        classroom: the class.
        sessions: the page sessions by their random names.
        scheduler: of the event loop.
        slots: for those that have not given the key yet.
    """

    def __init__(
        self,
        classroom: Classroom,
        sessions: Mapping[str, PageSession],
        scheduler: LoopScheduler,
        slots: Evictions,
    ) -> None:
        self._scheduler = scheduler
        self._classroom = classroom
        self._sessions = sessions
        self._slots = slots

    async def serve(self, socket: WebSocket) -> None:
        """Serve a projector until it disconnects."""
        async with locked(socket, self._scheduler, self._slots) as connection:

            async def serve(text: str | bytes) -> None:
                connection.unlock(self._classroom, read_projector_request(text).key)

            await connection.complete(serve, self._watch)

    async def _watch(self, connection: ClassConnection) -> None:
        """Tell the projector what it shows. One that reads slowly misses frames, nothing else."""
        shown: Projected | None = None
        room: object = None
        frame: object = None
        connection.put(Invitation(self._classroom.admission.code, self._classroom.addresses()))
        while True:
            try:
                newest = await self._classroom.projected()
            except StoreError as error:
                _log.error("%s", in_terminal(tr("The class cannot be read or stored: {why}", why=error)))
                connection.put(Refused(fault_of(error)))
                return
            if newest != shown:
                if shown is None or newest.number != shown.number:
                    room = frame = None
                shown = newest
                connection.put(newest)
            session = self._session()
            if session is not None and connection.is_idle:
                if session.room_json is not room:
                    room, frame = session.room_json, None
                    connection.put(RoomProjected(room))
                if (look := session.snapshot()) != frame:
                    frame = look
                    connection.put(look)
            await asyncio.sleep(_PERIOD)

    def _session(self) -> PageSession | None:
        """A page session of the chosen pupil."""
        pupil = self._classroom.projection.choice.pupil
        for page in self._classroom.pages_to_show():
            session = self._sessions.get(page.session or "")
            if session is not None and page.pupil is not None and page.pupil.id == pupil:
                return session
        return None
