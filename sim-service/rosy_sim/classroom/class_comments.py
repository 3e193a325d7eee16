"""
The teacher's comments on places in the programs of a running class: what each pupil and the board see of them.

The store has all that must last; here is the same, so that showing it does not read the disk. Where a place is after
edits is found by the page.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import msgspec

from .messages import board_messages as b
from .messages.message_fields import PlaceInProgram, Refused
from .messages.pupil_messages import OwnComment
from .store.class_store import ClassStore
from .store.comment_store import CommentKept
from .store.store_thread import StoreThread

__all__ = ["ClassComments"]


class ClassComments:
    """
    The comments of an open class.

    Args:
        store: the open class, read once.
        thread: where the store is called from then on.
        today: s since 1970.
    """

    def __init__(self, store: ClassStore, thread: StoreThread, today: Callable[[], float]) -> None:
        self._thread = thread
        self._today = today
        # By their numbers, oldest first.
        self._comments = {one.id: one for one in store.comments.comments()}

    def reload(self, comments: list[CommentKept]) -> None:
        """Take over the comments that are stored now, oldest first: they belong to other pupils than before."""
        self._comments = {one.id: one for one in comments}

    def of_pupil(self, pupil: int) -> list[OwnComment]:
        """The comments on the programs of a pupil, oldest first."""
        return [_shown(one) for one in self._comments.values() if one.pupil == pupil]

    def counts(self) -> dict[int, tuple[int, int]]:
        """By pupil: the number of comments, and of those that the pupil has dealt with."""
        found: dict[int, tuple[int, int]] = {}
        for one in self._comments.values():
            of, done = found.get(one.pupil, (0, 0))
            found[one.pupil] = of + 1, done + one.done
        return found

    async def add(self, request: b.AddComment) -> Refused | None:
        """
        Add a comment to a program that the pupil has; what is returned says why not.

        Raises:
            StoreError: the disk is full or broken; nothing was changed.
        """
        text = request.text.strip()
        place = request.place
        if not text or not place.start <= place.end <= len(place.piece.encode("utf-16-le", "surrogatepass")) // 2:
            return Refused("request")
        if await self._thread.call(ClassStore.latest, request.pupil, request.program) is None:
            return Refused("request")
        encoded, now = msgspec.json.encode(place), self._today()
        added = await self._thread.call(
            lambda store: store.comments.add(request.pupil, request.program, text, encoded, now)
        )
        if added is None:
            return Refused("comments")
        self._comments[added.id] = added
        return None

    async def set_done(self, pupil: int, comment: int, done: bool) -> bool:
        """Set whether a pupil has dealt with a comment; returns whether it is one of the pupil's."""
        found = self._comments.get(comment)
        if found is None or found.pupil != pupil:
            return False
        await self._thread.call(lambda store: store.comments.set_done(comment, done))
        # It may have been removed meanwhile.
        if comment in self._comments:
            self._comments[comment] = replace(found, done=done)
        return True

    async def remove(self, comment: int) -> int | None:
        """Remove a comment; returns the pupil, ``None`` if there is no such comment."""
        if comment not in self._comments:
            return None
        await self._thread.call(lambda store: store.comments.remove(comment))
        removed = self._comments.pop(comment, None)
        return None if removed is None else removed.pupil


def _shown(kept: CommentKept) -> OwnComment:
    place = msgspec.json.decode(kept.place, type=PlaceInProgram)
    return OwnComment(kept.id, kept.program, kept.at, kept.text, place, kept.done)
