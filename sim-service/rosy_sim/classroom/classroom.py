"""
Classroom: the running class between the sockets of pupils and of the teacher's board.

Keeps who is connected and what the board shows; the store has all that must last. A pupil is identified by the
connection that gave the code or a device's token; a request never names another pupil.
"""

from __future__ import annotations

import asyncio
import logging
import secrets
import tempfile
import time
from collections.abc import Callable, Collection, Iterator
from contextlib import ExitStack, closing
from typing import IO

from ..sentences.sentence import Sentence, tr
from ..sentences.wording import in_terminal
from .authentication import Authenticator
from .class_comments import ClassComments
from .class_roster import ClassRoster, Member, PupilPage
from .class_study import ClassStudy
from .class_tasks import ClassTasks
from .exports.class_export import write_export
from .exports.hand_in_export import hand_ins_zip
from .exports.study_export import new_key, write_study
from .messages import board_messages as b
from .messages import pupil_messages as p
from .messages.check_messages import ROOMS_OF_A_MESSAGE, OpenRun, RoomsShown, RunShown, ShowRooms
from .messages.message_fields import Refused
from .messages.projector_messages import Project, Projected
from .messages.shared_messages import AskToShare, Cursor, Decline, EndSharing, Push, Share
from .projection import Projection
from .pupil_state import PupilState, RunClock
from .shared_editing import Participant, SharedEditing
from .store.class_store import ClassStore, Conflict, Pupil, Saved, StoreFull, Version
from .store.comment_store import CommentKept
from .store.database import ClassTaken, StoreAway, StoreError, StoreFault, fault_of
from .store.progress_store import LessonDone
from .store.store_thread import StoreThread
from .store.task_store import HandIn

__all__ = ["Classroom"]

_PAUSE, _PAUSE_AWAY = 5.0, 1.0
"""Between looks whether the database server is there, and when it was not, s."""

_log = logging.getLogger(__name__)


class Classroom:
    """
    A running class.

    Args:
        store: the open class.
        addresses: where pupils open the page.
        now: a clock in s that only goes forward.
    """

    def __init__(self, store: ClassStore, addresses: Callable[[], list[str]], now: Callable[[], float]) -> None:
        self.admission = store.admission()
        self.addresses = addresses
        self.now = now
        self.attention: str | None = None
        self._run_clock = RunClock(now())
        self._store = StoreThread(store)
        self.authenticator = Authenticator(self.admission, self._store, now)
        # The last suspension of the service.
        self.suspended: b.Suspended | None = None
        # The last save found the disk full or broken.
        self._disk_fault = False
        self.tasks = ClassTasks(store, self._store, time.time)
        self.comments = ClassComments(store, self._store, time.time)
        self.study = ClassStudy(store, self._store, time.time)
        self.projection = Projection(self._newest_program)
        self.sharing = SharedEditing(self._participants)
        # The newest one for each pupil, and the newest one for those without one of their own.
        self._handouts: dict[int, p.Handout] = {}
        self._handout: p.Handout | None = None
        self._progress = {(one.pupil, one.lesson): one for one in store.progress.all()}
        self.roster = ClassRoster(store, self._store, self.authenticator, self, now)

    async def keep_store(self) -> Sentence:
        """
        Keep the class locked for this service, after lost connections too; returns, as a sentence, why that was not
        possible any more: this service must end.
        """
        while True:
            try:
                await self._store.keep()
            except StoreAway:
                pause = _PAUSE_AWAY
            except ClassTaken:
                return tr("Another Rosy has opened the class while the database did not answer; this one ends.")
            except StoreError as error:
                _log.error("%s", in_terminal(tr("The class cannot be read or stored: {why}", why=error)))
                pause = _PAUSE
            else:
                pause = _PAUSE
            await asyncio.sleep(pause)

    def store_fault(self) -> StoreFault | None:
        """Why nothing can be stored now."""
        if self._store.is_away:
            return "database"
        return "disk" if self._disk_fault else None

    async def close(self) -> None:
        """Finish what is being stored."""
        await self._store.close()

    # Pupils

    def leave(self, page: PupilPage) -> None:
        """A page has disconnected."""
        self.roster.pages.discard(page)
        if page.pupil is not None:
            self.roster.members[page.pupil.id].state.disconnect(id(page), self.now())
            self.sharing.page_left(page.pupil.id, page)

    def pages_to_show(self) -> Iterator[PupilPage]:
        """The pages of all pupils; of a pupil with several, the page whose room the board shows comes first."""
        connected = {id(page): page for page in self.roster.pages}
        for member in self.roster.members.values():
            for page in member.state.in_order():
                if page in connected:
                    yield connected[page]

    async def serve(self, page: PupilPage, request: p.PupilRequest) -> None:
        """Serve a request of a pupil's page."""
        try:
            if page.pupil is None:
                if page.is_removed and not isinstance(request, p.Join | p.Resume | p.Enter):
                    # It was sent before the page knew.
                    return
                await self._admit(page, request)
            else:
                await self._serve_member(page, self.roster.members[page.pupil.id], request)
        except StoreError as error:
            _log.error("%s", in_terminal(tr("The class cannot be stored: {why}", why=error)))
            fault = fault_of(error)
            if isinstance(request, p.Save):
                self._disk_fault = fault == "disk"
                page.put(p.SaveFailed(request.program, request.mark, fault))
            elif isinstance(request, p.HandIn):
                page.put(p.NotHandedIn(request.task, "database" if fault == "database" else "full"))
            else:
                page.put(Refused(fault))

    async def _admit(self, page: PupilPage, request: p.PupilRequest) -> None:
        admitted = await self.authenticator.admit(page.address, request)
        if isinstance(admitted, Refused):
            page.put(admitted)
            return
        page.token = admitted.token
        await self._enter(page, admitted.pupil, admitted.token if admitted.is_new else None)

    async def _enter(self, page: PupilPage, pupil: Pupil, token: str | None) -> None:
        # The pupil may have been removed, renamed or merged with another entry meanwhile.
        entering = await self._store.call(_entering, pupil.id)
        if entering is None:
            page.put(Refused("removed"))
            return
        pupil, programs = entering
        member = self.roster.members.setdefault(pupil.id, Member(pupil, PupilState()))
        page.pupil, page.is_removed = pupil, False
        self.roster.pages.add(page)
        member.state.connect(id(page), self.now())
        self.show_entered(page, member, programs, token)

    def show_entered(self, page: PupilPage, member: Member, programs: list[Version], token: str | None = None) -> None:
        """What a page is told when its pupil is let in, and when it belongs to another entry of the pupil."""
        pupil = member.pupil
        names = [p.ProgramName(v.program, v.name, v.number, v.at) for v in programs]
        progress = {one.lesson: one.done for one in self._progress.values() if one.pupil == pupil.id}
        page.put(p.Entered(pupil.id, pupil.nickname, pupil.words, token, member.state.hand, names, progress))
        self._show_tasks(page)
        if comments := self.comments.of_pupil(pupil.id):
            page.put(p.OwnComments(comments))
        if self.study.is_on:
            page.put(self.study.of_pupil(pupil.id))
        if self.attention is not None:
            page.put(p.Attention(self.attention))
        if (handout := self._handouts.get(pupil.id, self._handout)) is not None:
            page.put(handout)
        self.sharing.page_entered(pupil.id, _participant(page))

    async def _serve_member(self, page: PupilPage, member: Member, request: p.PupilRequest) -> None:
        match request:
            case p.Here():
                page.session = request.session
            case p.Status():
                begins = request.running and not member.state.running
                if begins:
                    self._run_clock.run_begins(self._states(), self.now())
                member.state.report(id(page), request, self.now())
                if begins:
                    await self.study.run_begins(member.pupil.id, request.program)
            case p.Hand():
                member.state.hand = request.up
            case p.Save():
                await self._save(page, member, request)
            case p.HandIn():
                await self._hand_in(page, member, request)
            case p.Progress():
                await self._add_progress(member.pupil.id, request)
            case p.AnswerStudy():
                if await self.study.answer(member.pupil.id, request.agrees):
                    self._show_study(member.pupil.id)
                else:
                    page.put(Refused("request"))
            case p.CommentDone():
                if await self.comments.set_done(member.pupil.id, request.comment, request.done):
                    self._show_comments(member.pupil.id)
                else:
                    page.put(Refused("request"))
            case p.Read():
                latest = await self._store.call(ClassStore.latest, member.pupil.id, request.program)
                if latest is not None:
                    page.put(p.Stored(latest.program, latest.number, latest.name, latest.text))
            case p.Forget():
                if page.token is not None:
                    await self._store.call(ClassStore.forget_device, page.token)
                self.leave(page)
                page.pupil = page.token = None
            case Share() | Decline() | Push() | Cursor() | EndSharing():
                if refused := self.sharing.serve_page(member.pupil.id, _participant(page), request):
                    page.put(refused)
            case p.Join() | p.Resume() | p.Enter():
                page.put(Refused("request"))

    async def _save(self, page: PupilPage, member: Member, request: p.Save) -> None:
        saved = await self._store.call(
            ClassStore.save,
            member.pupil.id,
            request.program,
            request.name,
            request.text,
            request.reason,
            request.base,
            request.mark,
            request.unacknowledged,
            time.time(),
        )
        match saved:
            case Saved():
                self._disk_fault = False
                member.program, member.changed = request.name, time.time()
                page.put(p.Saved(request.program, request.mark, saved.number))
            case Conflict(latest):
                page.put(p.Conflicting(latest.program, request.mark, latest.number, latest.name, latest.text))
            case StoreFull():
                page.put(p.SaveFailed(request.program, request.mark, "full"))

    async def _add_progress(self, pupil: int, request: p.Progress) -> None:
        known = self._progress.get((pupil, request.lesson))
        done = list(dict.fromkeys([*(known.done if known is not None else []), *request.done]))
        newest = LessonDone(pupil, request.lesson, request.title, request.steps, done)

        def add(store: ClassStore) -> bool:
            return store.progress.add(pupil, request.lesson, request.title, request.steps, request.done, time.time())

        if newest != known and await self._store.call(add):
            self._progress[pupil, request.lesson] = newest

    def lessons_shown(self) -> b.LessonsShown:
        """The progress of all pupils in lessons."""
        return b.LessonsShown(
            [
                b.LessonShown(one.pupil, one.lesson, one.title, len(one.done), one.steps)
                for one in self._progress.values()
            ]
        )

    async def _hand_in(self, page: PupilPage, member: Member, request: p.HandIn) -> None:
        if not await self.tasks.hand_in(member.pupil.id, request):
            page.put(p.NotHandedIn(request.task, "late"))
            self._show_tasks(page)
            return
        self._show_all_tasks(member.pupil.id)

    def _show_tasks(self, page: PupilPage) -> None:
        if page.pupil is not None and (tasks := self.tasks.of_pupil(page.pupil.id)) is not None:
            page.put(tasks)

    def pupil_left(self, pupil: int) -> None:
        """A pupil is not in the class any more."""
        self._handouts.pop(pupil, None)
        self.sharing.pupil_left(pupil)
        if self.projection.choice.pupil == pupil:
            self.projection.choose(Project(None, False, False))

    async def reload(self) -> None:
        """Read what belongs to other pupils than before."""

        def read(store: ClassStore) -> tuple[list[HandIn], list[CommentKept], list[LessonDone]]:
            return store.tasks.hand_ins(), store.comments.comments(), store.progress.all()

        hand_ins, comments, progress = await self._store.call(read)
        await self.study.reload()
        self.tasks.reload(hand_ins)
        self.comments.reload(comments)
        self._progress = {(one.pupil, one.lesson): one for one in progress}

    # The board

    async def open_task(self, request: b.OpenTask) -> Refused | None:
        """Begin a task on all pages; what is returned says why not."""
        refused = await self.tasks.open(request)
        if refused is None:
            self._show_all_tasks()
        return refused

    async def close_task(self, task: int) -> None:
        """End a task on all pages."""
        await self.tasks.close(task)
        self._show_all_tasks()

    async def comment(self, request: b.Comment) -> None:
        """Show a comment on a hand-in to its pupil."""
        if await self.tasks.comment(request):
            self._show_all_tasks(request.pupil)

    async def add_comment(self, request: b.AddComment) -> Refused | None:
        """Comment on a place in a pupil's program; what is returned says why not."""
        refused = await self.comments.add(request)
        if refused is None:
            self._show_comments(request.pupil)
        return refused

    async def remove_comment(self, comment: int) -> None:
        """Take back a comment on a place in a program."""
        if (pupil := await self.comments.remove(comment)) is not None:
            self._show_comments(pupil)

    async def set_study(self, request: b.SetStudy) -> Refused | None:
        """Let the class take part in a study, or end that; what is returned says why not."""
        if not await self.study.set(request):
            return Refused("request")
        for pupil in self.roster.members:
            self._show_study(pupil)
        return None

    def study_shown(self) -> b.StudyShown:
        """The study of the class as the board shows it."""
        return self.study.shown(set(self.roster.members))

    def _show_study(self, pupil: int) -> None:
        study = self.study.of_pupil(pupil)
        for page in self.roster.pages_of(pupil):
            page.put(study)

    def _show_comments(self, pupil: int) -> None:
        comments = p.OwnComments(self.comments.of_pupil(pupil))
        for page in self.roster.pages_of(pupil):
            page.put(comments)

    def _show_all_tasks(self, pupil: int | None = None) -> None:
        for page in self.roster.pages if pupil is None else self.roster.pages_of(pupil):
            self._show_tasks(page)

    async def hand_ins_zip(self, task: int) -> bytes | None:
        """All programs of a task and a table of them, as a ZIP file; ``None`` if there is no such task."""
        if self.tasks.task(task) is None:
            return None
        kept = await self.tasks.kept(task)
        nicknames = {member.pupil.id: member.pupil.nickname for member in self.roster.members.values()}
        return await asyncio.to_thread(hand_ins_zip, nicknames, kept, self.tasks.alike(task))

    async def hand_in_shown(self, request: b.OpenHandIn) -> b.ProgramShown:
        """A pupil's hand-in for a task."""
        for kept in await self.tasks.kept(request.task):
            if kept.pupil == request.pupil:
                return b.ProgramShown(request.pupil, kept.name, kept.text)
        return b.ProgramShown(request.pupil, "", None)

    async def rooms_shown(self, request: ShowRooms) -> list[RoomsShown]:
        """All rooms in which a hand-in was tried, in several messages."""
        _, rooms = await self.tasks.graded(request.task, request.pupil) or (None, [])
        return [
            RoomsShown(request.task, request.pupil, after, rooms[after : after + ROOMS_OF_A_MESSAGE])
            for after in range(0, len(rooms), ROOMS_OF_A_MESSAGE)
        ]

    async def run_shown(self, request: OpenRun) -> RunShown:
        """A hand-in with one of the rooms in which it was tried."""
        found = await self.tasks.graded(request.task, request.pupil)
        if found is not None:
            hand_in, rooms = found
            for tried in rooms:
                if tried.room == request.room:
                    return RunShown(request.pupil, tried.room, hand_in.name, hand_in.text, tried.world, tried.seed)
        return RunShown(request.pupil, request.room, "", None)

    def pupils_shown(self) -> b.PupilsShown:
        """All pupils as the board shows them now."""
        now, date = self.now(), time.time()
        comments = self.comments.counts()
        most_idle = self._run_clock.most_idle(self._states(), now)
        free_since = None if most_idle else self._run_clock.free_since
        return b.PupilsShown(
            [
                b.PupilShown(
                    member.pupil.id,
                    member.pupil.nickname,
                    member.pupil.words,
                    bool(member.state.pages),
                    member.state.running,
                    member.program,
                    None if member.changed is None else max(0.0, round(date - member.changed)),
                    member.state.lesson,
                    member.state.needs(now, idle=member.state.is_idle(now, free_since)),
                    *comments.get(member.pupil.id, (0, 0)),
                )
                for member in self.roster.members.values()
            ],
            most_idle,
        )

    def set_attention(self, message: str | None) -> None:
        """Pause all pages with a message, or let them go on."""
        if message is not None:
            self._run_clock.pause()
        elif self.attention is not None:
            self._run_clock.resume(self.now())
        self.attention = message
        for page in self.roster.pages:
            page.put(p.Attention(message))

    def _states(self) -> list[PupilState]:
        return [member.state for member in self.roster.members.values()]

    def lower_hand(self, pupil: int) -> None:
        """The raised hand of a pupil was seen."""
        if pupil not in self.roster.members:
            return
        self.roster.members[pupil].state.hand = False
        for page in self.roster.pages_of(pupil):
            page.put(p.Lowered())

    def send(self, request: b.Send) -> b.Sent | Refused:
        """Send something to the pages of all pupils or of some, and to those of them that connect later."""
        to = set(self.roster.members if request.pupils is None else request.pupils)
        if not to <= self.roster.members.keys():
            return Refused("request")
        handout = p.Handout(secrets.token_urlsafe(9), request.what, request.name, request.text)
        if request.pupils is None:
            self._handout = handout
            self._handouts.clear()
        else:
            self._handouts |= dict.fromkeys(to, handout)
        reached = [page for page in self.roster.pages if page.pupil is not None and page.pupil.id in to]
        for page in reached:
            page.put(handout)
        return b.Sent(len(reached), len(to - {page.pupil.id for page in reached if page.pupil is not None}))

    async def ask_to_share(self, board: Participant, request: AskToShare) -> Refused | None:
        """Ask a pupil whether the teacher may edit a program together with the pupil; what is returned says why not."""
        latest = await self._store.call(ClassStore.latest, request.pupil, request.program)
        return Refused("request") if latest is None else self.sharing.ask(board, request, latest.name)

    def _participants(self, pupil: int) -> list[Participant]:
        return [_participant(page) for page in self.roster.pages_of(pupil)]

    def project(self, request: Project) -> Refused | None:
        """Choose what the projectors show; what is returned says why not."""
        if request.pupil is not None and request.pupil not in self.roster.members:
            return Refused("request")
        if request.task is not None and self.tasks.task(request.task) is None:
            return Refused("request")
        self.projection.choose(request)
        return None

    async def projected(self) -> Projected:
        """
        What the projectors show.

        Raises:
            StoreError: the disk is broken.
        """
        task = self.tasks.task(self.projection.choice.task or 0)
        if task is not None:
            nicknames = {member.pupil.id: member.pupil.nickname for member in self.roster.members.values()}
            return self.projection.standings_shown(task.title, self.tasks.results(task.id), nicknames)
        member = self.roster.members.get(self.projection.choice.pupil or 0)
        if member is None:
            return await self.projection.shown(None, None, False, False)
        state = member.state
        return await self.projection.shown(member.pupil, member.changed, bool(state.pages), state.running)

    def changed(self, pupil: int) -> float | None:
        """When a program of a pupil was stored last, in s since 1970."""
        member = self.roster.members.get(pupil)
        return None if member is None else member.changed

    async def program_changed(self, shown: b.ProgramShown) -> b.ProgramChanged | None:
        """
        The newest version of a program if it is another than the one shown.

        Raises:
            StoreError: the database cannot be read.
        """
        if shown.program is None:
            return None
        latest = await self._store.call(ClassStore.latest, shown.pupil, shown.program)
        if latest is None or (latest.name, latest.text) == (shown.name, shown.text):
            return None
        return b.ProgramChanged(shown.pupil, latest.program, latest.name, latest.text)

    async def backup(self) -> IO[bytes]:
        """
        Everything that the class stores, as the ZIP file of ``./rosy class export``, from its start.

        Raises:
            StoreError: the database cannot be read.
            OSError: it is full.
        """
        return await asyncio.to_thread(_in_file, await self._store.call(ClassStore.beside, time.time()), write_export)

    async def study_export(self, lessons: Collection[str]) -> IO[bytes]:
        """
        The study of the class, as the ZIP file of ``./rosy class study``, from its start; ``lessons`` as there.

        Raises:
            BadInput: the class takes part in none, or nothing of it can be exported.
            StoreError: the database cannot be read.
            OSError: it is full.
        """

        def write(store: ClassStore, file: IO[bytes]) -> None:
            write_study(store, file, new_key(), lessons)

        return await asyncio.to_thread(_in_file, await self._store.call(ClassStore.beside, time.time()), write)

    async def _newest_program(self, pupil: int) -> Version | None:
        return next(iter(await self._store.call(ClassStore.programs, pupil)), None)

    async def program_shown(self, request: b.OpenProgram) -> b.ProgramShown:
        """The newest version of a pupil's program."""
        if request.program is None:
            latest = await self._newest_program(request.pupil)
        else:
            latest = await self._store.call(ClassStore.latest, request.pupil, request.program)
        if latest is None:
            return b.ProgramShown(request.pupil, "", None)
        return b.ProgramShown(request.pupil, latest.name, latest.text, latest.program)


def _entering(store: ClassStore, pupil: int) -> tuple[Pupil, list[Version]] | None:
    found = store.roster.pupil(pupil)
    return None if found is None else (found, store.programs(found.id))


def _participant(page: PupilPage) -> Participant:
    return Participant(page, page.put)


def _in_file(store: ClassStore, write: Callable[[ClassStore, IO[bytes]], object]) -> IO[bytes]:
    # A store of its own, so that pupils' pages save meanwhile. The file has no name and is gone when it is closed.
    with closing(store), ExitStack() as stack:
        file = stack.enter_context(tempfile.TemporaryFile())
        write(store, file)
        file.seek(0)
        stack.pop_all()
        return file
