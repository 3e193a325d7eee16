"""
Sockets of class mode: one for each pupil's page, one for each board of the teacher. ``protocol/README.md``, section 11.

The classroom decides; here are connections, their limits, and the rooms of the page sessions that the board shows.
"""

from __future__ import annotations

import asyncio
import logging
import time
from collections.abc import Callable, Mapping

import msgspec
from starlette.websockets import WebSocket

from ...accounting.resources import Budgets
from ...classroom.class_roster import PupilPage
from ...classroom.classroom import Classroom
from ...classroom.hand_in_checks import HandInChecks
from ...classroom.messages import board_messages as b
from ...classroom.messages import pupil_messages as p
from ...classroom.messages.check_messages import (
    CancelCheck,
    CheckAll,
    Checking,
    CheckNew,
    OpenRun,
    ResultShown,
    ShowResults,
    ShowRooms,
)
from ...classroom.messages.message_fields import BadRequest, Refused
from ...classroom.messages.projector_messages import Project, Projecting
from ...classroom.messages.shared_messages import SHARING_OPS, AskToShare, Cursor, EndSharing, Push
from ...classroom.shared_editing import Participant
from ...classroom.store.database import StoreError, StoreFault, fault_of
from ...sentences.sentence import tr
from ...sentences.wording import in_terminal
from ..pacing.loop_scheduler import LoopScheduler
from ..sessions.page_session import PageSession
from .class_connection import ClassConnection, connected, locked

__all__ = ["SUSPENDED_FROM", "ClassSockets"]

_log = logging.getLogger(__name__)

_PLACES_PERIOD = 0.1
"""Between two looks at the robots for the board, s."""

_LOOKS_PER_LIST = 10
"""Looks at the robots for each look at the list of pupils: the list is compared once a second."""


SUSPENDED_FROM = 5.0
"""
A pause between two looks, s, after which the service counts as suspended: longer than those of a busy machine, and
shorter than the 6 s of silence after which a page may say that it has no connection (``class_socket.ts``).
"""

_SUSPENSION_PERIOD = 0.5
"""Between two looks at the clock, s."""


def _boot_time() -> float:
    """Seconds since the machine was started; they go on while it sleeps, and no correction of the date changes them."""
    return time.clock_gettime(time.CLOCK_BOOTTIME)


class ClassSockets:
    """
    The sockets of a running class.

    Args:
        classroom: the class.
        checks: the checks of hand-ins.
        sessions: the page sessions by their random names.
        scheduler: of the event loop.
        budgets: have the slots of connections.
        clock: in s, going on while the machine sleeps.
    """

    def __init__(
        self,
        classroom: Classroom,
        checks: HandInChecks,
        sessions: Mapping[str, PageSession],
        scheduler: LoopScheduler,
        budgets: Budgets,
        clock: Callable[[], float] = _boot_time,
    ) -> None:
        self.clock = clock
        self._scheduler = scheduler
        self._classroom = classroom
        self._checks = checks
        self._sessions = sessions
        self._budgets = budgets

    async def watch_suspension(self) -> None:
        """
        Notice, until it is cancelled, that the service was suspended.

        It does not depend on a board: a board's connection may be lost in the same moment in which the service goes on.
        """
        looked_at = self.clock()
        while True:
            await asyncio.sleep(_SUSPENSION_PERIOD)
            before, looked_at = looked_at, self.clock()
            if looked_at - before >= SUSPENDED_FROM:
                self._classroom.suspended = b.Suspended(time.time(), looked_at - before)

    async def serve_pupil(self, socket: WebSocket) -> None:
        """Serve a pupil's page until it disconnects."""
        async with connected(socket, self._scheduler, self._budgets.class_pages) as connection:
            if connection is None:
                return
            page = PupilPage(connection.address, connection.put)
            connection.put(p.ClassNamed(self._classroom.admission.class_id()))

            async def serve(text: str | bytes) -> None:
                try:
                    request = p.read_pupil_request(text)
                except BadRequest as error:
                    if page.pupil is not None and error.op in SHARING_OPS:
                        self._classroom.sharing.page_unreadable(page.pupil.id, page)
                    raise
                await self._classroom.serve(page, request)
                session = self._sessions.get(page.session or "")
                if session is not None:
                    session.client.pupil = page.pupil.id if page.pupil is not None else None

            try:
                await connection.complete(serve)
            finally:
                self._classroom.leave(page)

    async def serve_board(self, socket: WebSocket) -> None:
        """Serve a board until it disconnects; it is told nothing before it has given the key."""
        async with locked(socket, self._scheduler, self._budgets.locked) as connection:

            async def serve(text: str | bytes) -> None:
                try:
                    request = b.read_board_request(text)
                except BadRequest as error:
                    if error.op in SHARING_OPS:
                        self._classroom.sharing.board_left(connection)
                    raise
                if connection.is_unlocked:
                    await self._try_to_serve(connection, request)
                elif not isinstance(request, b.Unlock):
                    connection.put(Refused("key"))
                elif connection.unlock(self._classroom, request.key):
                    room = self._classroom
                    connection.put(b.BoardShown(room.admission.code, room.addresses(), room.attention))

            try:
                await connection.complete(serve, self._watch)
            finally:
                self._classroom.sharing.board_left(connection)

    async def _try_to_serve(self, connection: ClassConnection, request: b.BoardRequest) -> None:
        try:
            await self._serve_teacher(connection, request)
        except StoreError as error:
            _log.error("%s", in_terminal(tr("The class cannot be read or stored: {why}", why=error)))
            connection.put(Refused(fault_of(error)))

    async def _serve_teacher(self, connection: ClassConnection, request: b.BoardRequest) -> None:
        match request:
            case b.OpenProgram():
                connection.comments_of = request.pupil
                connection.followed = await self._classroom.program_shown(request)
                connection.put(connection.followed)
            case b.SetAttention():
                self._classroom.set_attention(request.message)
            case b.AddPupils():
                connection.put(await self._classroom.roster.add(request))
            case b.RenamePupil():
                if refused := await self._classroom.roster.rename(request):
                    connection.put(refused)
            case b.RemovePupils():
                await self._classroom.roster.remove(request.pupils)
            case b.RestorePupil():
                if refused := await self._classroom.roster.restore(request.pupil):
                    connection.put(refused)
            case b.MergePupils():
                if refused := await self._classroom.roster.merge(request):
                    connection.put(refused)
            case b.LockDoor():
                await self._classroom.roster.lock_door(request.locked)
            case b.SetStudy():
                if refused := await self._classroom.set_study(request):
                    connection.put(refused)
            case b.LowerHand():
                self._classroom.lower_hand(request.pupil)
            case b.Send():
                connection.put(self._classroom.send(request))
            case b.OpenTask():
                if refused := await self._classroom.open_task(request):
                    connection.put(refused)
            case b.CloseTask():
                await self._classroom.close_task(request.task)
            case b.OpenHandIn():
                connection.put(await self._classroom.hand_in_shown(request))
            case b.Comment():
                await self._classroom.comment(request)
            case b.AddComment():
                if refused := await self._classroom.add_comment(request):
                    connection.put(refused)
            case b.RemoveComment():
                await self._classroom.remove_comment(request.comment)
            case Project():
                if refused := self._classroom.project(request):
                    connection.put(refused)
            case CheckAll() | CheckNew():
                self._checks.start(request, connection.put)
            case CancelCheck():
                await self._checks.cancel()
            case ShowResults():
                connection.results_of = request.task
            case ShowRooms():
                for rooms in await self._classroom.rooms_shown(request):
                    connection.put(rooms)
            case OpenRun():
                connection.put(await self._classroom.run_shown(request))
            case AskToShare():
                board = Participant(connection, connection.put)
                if refused := await self._classroom.ask_to_share(board, request):
                    connection.put(refused)
            case Push() | Cursor() | EndSharing():
                board = Participant(connection, connection.put)
                if refused := self._classroom.sharing.serve_board(board, request):
                    connection.put(refused)
            case b.Unlock():
                connection.put(Refused("request"))

    async def _watch(self, connection: ClassConnection) -> None:
        """Tell the board what changes. A board that reads slowly misses positions, nothing else."""
        rooms: dict[int, object] = {}
        places: dict[int, b.Place] = {}
        shown: b.PupilsShown | None = None
        tasks: b.BoardTasks | None = None
        lessons: b.LessonsShown | None = None
        door = b.DoorShown(False, [])
        study = b.StudyShown(None, 0)
        comments: b.CommentsShown | None = None
        looked: tuple[b.ProgramShown | None, float | None] = (None, None)
        projecting = Projecting(None, False, False)
        checking = Checking()
        results: dict[tuple[int, int], bytes] = {}
        store_fault: StoreFault | None = None
        suspended: b.Suspended | None = None
        looks = 0
        while True:
            if self._classroom.suspended != suspended:
                suspended = self._classroom.suspended
                if suspended is not None:
                    connection.put(suspended)
            if looks % _LOOKS_PER_LIST == 0:
                if (fault := self._classroom.store_fault()) != store_fault:
                    store_fault = fault
                    connection.put(b.StoreShown(fault))
                pupils = self._classroom.pupils_shown()
                if pupils != shown:
                    shown = pupils
                    connection.put(pupils)
                if (seen := self._classroom.roster.door_shown()) != door:
                    door = seen
                    connection.put(door)
                if (studied := self._classroom.study_shown()) != study:
                    study = studied
                    connection.put(study)
                if (newest := self._classroom.tasks.shown()) != tasks:
                    tasks = newest
                    connection.put(newest)
                if (progressed := self._classroom.lessons_shown()) != lessons:
                    lessons = progressed
                    connection.put(progressed)
                if (pupil := connection.comments_of) is not None:
                    commented = b.CommentsShown(pupil, self._classroom.comments.of_pupil(pupil))
                    if commented != comments:
                        comments = commented
                        connection.put(commented)
                if (followed := connection.followed) is not None:
                    current = followed, self._classroom.changed(followed.pupil)
                    if current != looked:
                        looked = current
                        await self._tell_change(connection, followed)
                if (choice := self._classroom.projection.choice) != projecting:
                    projecting = choice
                    connection.put(choice)
                for result in self._new_results(connection.results_of, results):
                    connection.put(result)
                if (progress := self._checks.progress) != checking:
                    checking = progress
                    connection.put(progress)
            looks += 1
            if connection.is_idle:
                for room in self._new_rooms(rooms):
                    connection.put(room)
                if moved := self._new_places(places):
                    connection.put(b.PlacesShown(moved))
            await asyncio.sleep(_PLACES_PERIOD)

    async def _tell_change(self, connection: ClassConnection, followed: b.ProgramShown) -> None:
        try:
            changed = await self._classroom.program_changed(followed)
        except StoreError as error:
            _log.error("%s", in_terminal(tr("The class cannot be read or stored: {why}", why=error)))
            connection.put(Refused(fault_of(error)))
            return
        # The board may have opened another one meanwhile.
        if changed is not None and connection.followed is followed:
            connection.followed = b.ProgramShown(followed.pupil, changed.name, changed.text, changed.program)
            connection.put(changed)

    def _new_results(self, task: int | None, known: dict[tuple[int, int], bytes]) -> list[ResultShown]:
        """The results of a task that are not those in ``known``, where they are entered."""
        new: list[ResultShown] = []
        if task is None:
            return new
        for pupil, result in self._classroom.tasks.results(task).items():
            if known.get((task, pupil), b"") != result:
                known[task, pupil] = result
                new.append(ResultShown(task, pupil, msgspec.Raw(result or b"null")))
        return new

    def _new_rooms(self, known: dict[int, object]) -> list[b.RoomShown]:
        """The rooms that are not those in ``known``, where they are entered."""
        new: list[b.RoomShown] = []
        for pupil, session in self._shown_sessions():
            if known.get(pupil) is not session.room_json:
                known[pupil] = session.room_json
                new.append(b.RoomShown(pupil, session.room_json))
        return new

    def _new_places(self, known: dict[int, b.Place]) -> list[b.Place]:
        """The positions that are not those in ``known``, where they are entered."""
        new: list[b.Place] = []
        for pupil, session in self._shown_sessions():
            world = session.world
            place = b.Place(pupil, round(world.x, 3), round(world.y, 3), round(world.theta, 3))
            if known.get(pupil) != place:
                known[pupil] = place
                new.append(place)
        return new

    def _shown_sessions(self) -> list[tuple[int, PageSession]]:
        """One page session for each pupil."""
        found: dict[int, PageSession] = {}
        for page in self._classroom.pages_to_show():
            session = self._sessions.get(page.session or "")
            if page.pupil is not None and session is not None:
                found.setdefault(page.pupil.id, session)
        return list(found.items())
