"""
Projection of a running class: whose room the projectors show, with or without nickname and program, or the standings of
a task. Nothing else of a pupil is in it. It ends with the service.
"""

from __future__ import annotations

from collections.abc import Awaitable, Callable, Mapping

from .messages.projector_messages import Project, Projected, Projecting, Standings
from .program_fingerprint import source_of
from .standings import Results, standings
from .store.class_store import Pupil, Version

__all__ = ["Projection"]


class Projection:
    """
    What the projectors show.

    Args:
        newest: the program of a pupil that was changed last.
    """

    def __init__(self, newest: Callable[[int], Awaitable[Version | None]]) -> None:
        self._newest = newest
        self._number = 0
        self._choice = Projecting(None, False, False)
        # The program text, and the time of the change that it was read after.
        self._haskell: tuple[int, float | None, str] | None = None
        # The standings, and what they were made of.
        self._standings: tuple[tuple[str, dict[int, bytes], dict[int, str]], Standings] | None = None

    @property
    def choice(self) -> Projecting:
        """The teacher's choice."""
        return self._choice

    def choose(self, request: Project) -> None:
        """Show another pupil, or the same one in another way."""
        if request.pupil != self._choice.pupil:
            self._number += 1
        task = request.task if request.pupil is None else None
        self._choice = Projecting(request.pupil, request.named, request.program, task)

    def standings_shown(self, title: str, results: Results, nicknames: Mapping[int, str]) -> Projected:
        """What a projector shows while the standings of a task are chosen."""
        seen = title, dict(results), dict(nicknames)
        # The projectors ask ten times a second.
        if self._standings is None or self._standings[0] != seen:
            self._standings = seen, Standings(title, standings(results, nicknames))
        return Projected(self._number, False, None, False, False, None, self._standings[1])

    async def shown(self, pupil: Pupil | None, changed: float | None, online: bool, running: bool) -> Projected:
        """
        What a projector shows.

        Args:
            pupil: the chosen one, if any.
            changed: when a program of theirs was stored last.

        Raises:
            StoreError: the disk is broken.
        """
        if pupil is None:
            return Projected(self._number, False, None, False, False, None)
        choice, number = self._choice, self._number
        haskell = await self._read(pupil.id, changed) if choice.program else None
        return Projected(number, True, pupil.nickname if choice.named else None, online, running, haskell)

    async def _read(self, pupil: int, changed: float | None) -> str:
        if self._haskell is None or self._haskell[:2] != (pupil, changed):
            newest = await self._newest(pupil)
            self._haskell = pupil, changed, "" if newest is None else source_of(newest.text)
        return self._haskell[2]
