"""
Study in which a running class takes part: the teacher switches it on, and each pupil takes part or does not.

The store keeps it; here is the same, so that showing it does not read the disk.
"""

from __future__ import annotations

from collections.abc import Callable

from .messages import board_messages as b
from .messages import pupil_messages as p
from .store.class_store import ClassStore
from .store.store_thread import StoreThread

__all__ = ["ClassStudy"]


class ClassStudy:
    """
    The study of an open class.

    Args:
        store: the open class, read once.
        thread: where the store is called from then on.
        today: s since 1970.
    """

    def __init__(self, store: ClassStore, thread: StoreThread, today: Callable[[], float]) -> None:
        self._thread = thread
        self._today = today
        self._study = store.study.study()
        # Since when each pupil takes part; 0 for one who does not want to.
        self._answers = store.study.answers()

    def of_pupil(self, pupil: int) -> p.OwnStudy:
        """What the page of a pupil is told."""
        if self._study is None:
            return p.OwnStudy(None, None)
        since = self._answers.get(pupil)
        return p.OwnStudy(self._study.contact, None if since is None else since > 0)

    @property
    def is_on(self) -> bool:
        """Whether the class takes part in a study."""
        return self._study is not None

    def shown(self, pupils: set[int]) -> b.StudyShown:
        """What the board shows; ``pupils`` are those of the class."""
        if self._study is None:
            return b.StudyShown(None, 0)
        return b.StudyShown(self._study.contact, sum(self._answers.get(pupil, 0) > 0 for pupil in pupils))

    async def set(self, request: b.SetStudy) -> bool:
        """Begin or end the study; returns whether it could: pupils need someone whom they can ask."""
        if request.contact is None:
            await self._thread.call(lambda store: store.study.end())
            self._study, self._answers = None, {}
            return True
        contact, now = request.contact.strip(), self._today()
        if not contact:
            return False
        self._study = await self._thread.call(lambda store: store.study.begin(contact, now))
        return True

    async def answer(self, pupil: int, takes_part: bool) -> bool:
        """A pupil takes part from now on, or does not; returns whether there is a study."""
        if self._study is None:
            return False
        before = self._answers.get(pupil, 0)
        since = (before or self._today()) if takes_part else 0
        await self._thread.call(lambda store: store.study.answer(pupil, since))
        self._answers[pupil] = since
        return True

    async def reload(self) -> None:
        """Read the answers again: entries of pupils were merged, removed or restored."""
        self._answers = await self._thread.call(lambda store: store.study.answers())

    async def run_begins(self, pupil: int, program: str | None) -> None:
        """Store that a program of a pupil who takes part runs."""
        if self._study is None or program is None or self._answers.get(pupil, 0) == 0:
            return
        now = self._today()

        def add(store: ClassStore) -> None:
            if (latest := store.latest(pupil, program)) is not None:
                store.study.add_run(latest.number, now)

        await self._thread.call(add)
