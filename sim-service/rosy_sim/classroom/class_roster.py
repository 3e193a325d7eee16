"""
Roster of a running class: who is in it, on which connected pages, and what the teacher changes of it.

The store keeps it (``store/roster_store.py``); here are the pupils as the board shows them.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from typing import Protocol

from .authentication import Authenticator
from .messages import board_messages as b
from .messages import pupil_messages as p
from .messages.message_fields import Refused
from .messages.nickname import BadNickname, read_nickname
from .pupil_state import PupilState
from .store.class_store import ClassStore, NicknameTaken, Pupil, StoreFull, Version
from .store.database import StoreError
from .store.retention import kept_until
from .store.roster_store import RemovedPupil
from .store.store_thread import StoreThread
from .word_list import draw_words

__all__ = ["ClassRoster", "Member", "PupilPage"]


@dataclass(eq=False, slots=True)
class PupilPage:
    """The connection of a pupil's page. ``put`` sends an answer and never blocks."""

    address: str
    put: Callable[[p.PupilAnswer], None]
    # Set by `join`, `resume` or `enter`.
    pupil: Pupil | None = None
    token: str | None = field(default=None, repr=False)
    # The page session whose room the board shows.
    session: str | None = None
    # The teacher has removed the pupil of this page.
    is_removed: bool = False


@dataclass(slots=True)
class Member:
    """A pupil as the board shows it."""

    pupil: Pupil
    state: PupilState
    # Name of the program that was changed last, and when, in s since 1970.
    program: str | None = None
    changed: float | None = None


class RosterChanges(Protocol):
    """What a class does when it has other pupils."""

    def pupil_left(self, pupil: int) -> None:
        """A pupil is not in the class any more."""

    async def reload(self) -> None:
        """Read what belongs to other pupils than before."""

    def show_entered(self, page: PupilPage, member: Member, programs: list[Version]) -> None:
        """Tell a page that it belongs to another entry of its pupil."""


class ClassRoster:
    """
    The pupils of a running class.

    Args:
        store: the open class, which is read once.
        thread: where the store is used from then on.
        authenticator: which lets new pupils in, unless the door is locked.
        changes: of the class, when it has other pupils.
        now: a clock in s that only goes forward.
    """

    def __init__(
        self,
        store: ClassStore,
        thread: StoreThread,
        authenticator: Authenticator,
        changes: RosterChanges,
        now: Callable[[], float],
    ) -> None:
        self._store = thread
        self._authenticator = authenticator
        self._changes = changes
        self._now = now
        # The connected pages of pupils.
        self.pages: set[PupilPage] = set()
        # In the order in which they joined.
        self.members: dict[int, Member] = {}
        authenticator.is_locked = store.roster.is_locked()
        self._removed: list[RemovedPupil] = store.roster.removed()
        for pupil in store.pupils():
            latest = next(iter(store.programs(pupil.id)), None)
            member = Member(pupil, PupilState())
            if latest is not None:
                member.program, member.changed = latest.name, latest.at
            self.members[pupil.id] = member

    def door_shown(self) -> b.DoorShown:
        """Whether new pupils are let in, and who was removed."""
        removed = [
            b.RemovedShown(one.id, one.nickname, one.at, kept_until(one.at, one.announced)) for one in self._removed
        ]
        return b.DoorShown(self._authenticator.is_locked, removed)

    async def lock_door(self, locked: bool) -> None:
        """Let no new pupils in, or let them in again; those of the class return at any time."""
        await self._store.call(lambda store: store.roster.set_locked(locked))
        self._authenticator.is_locked = locked

    async def add(self, request: b.AddPupils) -> b.PupilsAdded:
        """Add pupils before they join."""
        read = [(typed.strip(), read_nickname(typed)) for typed in request.nicknames]
        names = [name for _, name in read if isinstance(name, str)]
        language = request.language
        results = iter(
            await self._store.call(lambda store: store.roster.add(names, lambda: draw_words(language), time.time()))
        )
        added, refused = 0, []
        for typed, name in read:
            result = name if isinstance(name, BadNickname) else next(results)
            match result:
                case Pupil():
                    added += 1
                    self.members.setdefault(result.id, Member(result, PupilState()))
                case BadNickname(fault):
                    refused.append(b.NicknameRefused(typed, fault))
                case NicknameTaken():
                    refused.append(b.NicknameRefused(typed, "taken"))
                case StoreFull():
                    refused.append(b.NicknameRefused(typed, "full"))
        return b.PupilsAdded(added, refused)

    async def rename(self, request: b.RenamePupil) -> Refused | None:
        """Give a pupil another nickname; what is returned says why not."""
        nickname = read_nickname(request.nickname)
        if isinstance(nickname, BadNickname):
            return Refused(nickname.fault)
        renamed = await self._store.call(lambda store: store.roster.rename(request.pupil, nickname))
        if isinstance(renamed, NicknameTaken):
            return Refused("taken")
        member = self.members.get(request.pupil)
        if renamed is None or member is None:
            return Refused("request")
        member.pupil = renamed
        for page in self.pages_of(renamed.id):
            page.pupil = renamed
            page.put(p.Renamed(nickname))
        return None

    async def remove(self, pupils: Iterable[int]) -> None:
        """Remove pupils with everything that is stored of them; their pages leave the class at once."""
        members = {pupil: self.members.pop(pupil) for pupil in set(pupils) & self.members.keys()}
        # Before it is stored, so that nothing more is stored for them. If that fails they are in the class as before,
        # and their pages come back with their tokens.
        for pupil, member in members.items():
            for page in self.pages_of(pupil):
                self.pages.discard(page)
                member.state.disconnect(id(page), self._now())
                page.pupil, page.is_removed = None, True
                page.put(Refused("removed"))
            self._changes.pupil_left(pupil)
        try:
            now = time.time()
            await self._store.call(lambda store: store.roster.remove(list(members), now))
        except StoreError:
            self.members |= members
            raise
        await self._reload()

    async def restore(self, pupil: int) -> Refused | None:
        """Bring a removed pupil back; what is returned says why not."""
        restored = await self._store.call(lambda store: store.roster.restore(pupil))
        if not isinstance(restored, Pupil):
            return Refused("request" if restored is None else "full")
        self.members[pupil] = Member(restored, PupilState())
        await self._reload(pupil)
        return None

    async def merge(self, request: b.MergePupils) -> Refused | None:
        """Make two entries of one pupil one; what is returned says why not."""
        into = self.members.get(request.into)
        member = self.members.get(request.pupil)
        if into is None or member is None or into is member:
            return Refused("request")
        pages = self.pages_of(request.pupil)
        del self.members[request.pupil]
        # Before it is stored, so that what the pages store from now on belongs to the entry that stays.
        for page in pages:
            _move_page(page, member, into, self._now())
        self._changes.pupil_left(request.pupil)
        try:
            now = time.time()
            await self._store.call(lambda store: store.roster.merge(request.pupil, request.into, now))
        except StoreError:
            self.members[request.pupil] = member
            for page in pages:
                _move_page(page, into, member, self._now())
            raise
        into.state.hand = into.state.hand or member.state.hand
        programs = await self._reload(request.into)
        for page in self.pages_of(request.into):
            self._changes.show_entered(page, into, programs)
        return None

    def pages_of(self, pupil: int) -> list[PupilPage]:
        """The connected pages of a pupil."""
        return [page for page in self.pages if page.pupil is not None and page.pupil.id == pupil]

    async def _reload(self, changed: int | None = None) -> list[Version]:
        """Read what belongs to other pupils now; returns the programs of the pupil whose programs are others."""

        def read(store: ClassStore) -> tuple[list[Version], list[RemovedPupil]]:
            return [] if changed is None else store.programs(changed), store.roster.removed()

        programs, self._removed = await self._store.call(read)
        await self._changes.reload()
        self.members = dict(sorted(self.members.items()))
        if programs and (member := self.members.get(changed or 0)) is not None:
            member.program, member.changed = programs[0].name, programs[0].at
        return programs


def _move_page(page: PupilPage, before: Member, after: Member, now: float) -> None:
    status = before.state.pages.get(id(page))
    before.state.disconnect(id(page), now)
    after.state.connect(id(page), now)
    if status is not None:
        after.state.report(id(page), status, now)
    page.pupil = after.pupil
