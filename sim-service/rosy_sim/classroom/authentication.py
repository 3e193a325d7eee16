"""
Authentication in a class: of pupils, by code, words or token, and of the teacher, by a key.

A pupil gives the code of the class with a new nickname or with the words of an earlier lesson, or the device's token.
Wrong ones are counted for each client address and for all together.
"""

from __future__ import annotations

import asyncio
import secrets
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass, field

from ..accounting.client import network_of
from ..accounting.resources import JOINS_EACH
from ..accounting.slots import Slots
from ..attempts import Attempts, Rate
from .messages import pupil_messages as p
from .messages.message_fields import Refused
from .messages.nickname import BadNickname, read_nickname
from .store.class_store import Admission, ClassStore, NicknameTaken, Pupil, PupilRemoved, StoreFull
from .store.store_thread import StoreThread
from .word_list import draw_words, read_words

__all__ = ["ADDRESS_ATTEMPTS", "ALL_ATTEMPTS", "Admitted", "Authenticator"]

ADDRESS_ATTEMPTS = Rate(0.2, 10.0)
"""Wrong codes, words, tokens and keys from one address."""

ALL_ATTEMPTS = Rate(5.0, 300.0)
"""From all addresses together: a class of thirty mistypes without being locked out."""


@dataclass(frozen=True, slots=True)
class Admitted:
    """A pupil, and the token of the page's device; ``is_new`` unless the page gave it."""

    pupil: Pupil
    token: str = field(repr=False)
    is_new: bool


class Authenticator:
    """Of one class. ``now`` is a clock in s that only goes forward."""

    def __init__(self, admission: Admission, store: StoreThread, now: Callable[[], float]) -> None:
        self._admission = admission
        self._store = store
        self._now = now
        # No new pupils are let in; those of the class are.
        self.is_locked = False
        # New pupils from each network.
        self._joins = Slots(sys.maxsize, JOINS_EACH)
        self._attempts = Attempts([ADDRESS_ATTEMPTS], ALL_ATTEMPTS, now())
        # Held while a request to be let in is decided: the right ones of a class behind one address, sent at the same
        # time, would count as wrong attempts until each is decided.
        self._deciding = asyncio.Lock()

    async def admit(self, address: str, request: p.PupilRequest) -> Admitted | Refused:
        """
        Decide a request of a page at ``address`` that is in no class.

        Raises:
            StoreError: the class cannot be read or stored.
        """
        if not isinstance(request, p.Join | p.Resume | p.Enter):
            return Refused("token")
        async with self._deciding:
            if isinstance(request, p.Enter) and not isinstance(entered := await self._find(request, address), Refused):
                # A token is too long to be guessed.
                return entered
            if not self._attempts.begin([address], self._now()):
                return Refused("attempts")
            found = await self._find(request, address)
            is_wrong = isinstance(found, Refused) and found.reason in ("code", "words", "token")
            if not is_wrong:
                self._attempts.succeeded([address], self._now())
            return found

    async def _find(self, request: p.Join | p.Resume | p.Enter, address: str) -> Admitted | Refused:
        if isinstance(request, p.Enter):
            pupil = await self._store.call(ClassStore.pupil_of, request.token)
            if isinstance(pupil, PupilRemoved):
                return Refused("removed")
            return Refused("token") if pupil is None else Admitted(pupil, request.token, is_new=False)
        if not self._is_code(request.code):
            return Refused("code")
        token = secrets.token_urlsafe(24)
        if isinstance(request, p.Resume):
            pupil = await self._store.call(ClassStore.resume, read_words(request.words), token, time.time())
            if isinstance(pupil, PupilRemoved):
                return Refused("removed")
            return Refused("words") if pupil is None else Admitted(pupil, token, is_new=True)
        if self.is_locked:
            return Refused("locked")
        nickname = read_nickname(request.nickname)
        if isinstance(nickname, BadNickname):
            return Refused(nickname.fault)
        network = network_of(address)
        if not self._joins.take(network):
            return Refused("joins")
        language = request.language
        joined = await self._store.call(ClassStore.join, nickname, lambda: draw_words(language), token, time.time())
        if not isinstance(joined, Pupil):
            self._joins.free(network)
        if isinstance(joined, NicknameTaken):
            return Refused("taken")
        return Refused("full") if isinstance(joined, StoreFull) else Admitted(joined, token, is_new=True)

    def _is_code(self, typed: str) -> bool:
        """Capitals, spaces and dashes do not matter."""
        tried = "".join(c for c in typed.lower() if c.isalnum())
        return secrets.compare_digest(tried.encode(), self._admission.code.encode())

    def admits_teacher(self, typed: str, address: str) -> bool | None:
        """Whether this is the teacher's key; ``None`` for an address that has tried too many wrong ones."""
        # The right key always enters: it is too long to be guessed, so wrong ones need not keep it out.
        if secrets.compare_digest(typed.strip().encode(), self._admission.teacher_key.encode()):
            return True
        return False if self._attempts.begin([address], self._now()) else None
