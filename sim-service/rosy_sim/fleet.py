"""
The robots that the person who started the service lets pages drive, and who has which.

They are open to those who know the code that is printed where the service was started. Not to everybody who can reach
the page: a class reaches it, and so does every other user of a shared computer; a simulated robot harms nobody, a real
one may. Eight of 28 letters and digits, at twenty tries a second, are not guessed in a lifetime.
"""

from __future__ import annotations

import secrets
from collections.abc import Callable
from dataclasses import dataclass

from .budget import Budget
from .drivers import drivers, way
from .errors import BadInput
from .wire import page

__all__ = ["Fleet", "Hold"]

_LETTERS = "bcdfghjkmnpqrstvwxyz23456789"
"""Without vowels, which make words, and without what looks like something else."""

_CODE_LENGTH = 8

_TRIES, _BURST = 20.0, 40.0
"""Codes that all pages together may try, a second and at once."""

_MAX_WHO = 40
"""Characters of a name that others see."""


@dataclass(slots=True)
class Hold:
    """Somebody has a robot."""

    session: str
    who: str


class Fleet:
    """All robots by the names that pages see."""

    def __init__(self, robots: dict[str, str], now: Callable[[], float], changed: Callable[[], None]) -> None:
        self._robots = robots
        self._now = now
        # Called when somebody takes a robot or leaves one.
        self._changed = changed
        self._holds: dict[str, Hold] = {}
        self._tries = Budget(_TRIES, _BURST, now())
        # What a page must know.
        self.code = "".join(secrets.choice(_LETTERS) for _ in range(_CODE_LENGTH))

    def __bool__(self) -> bool:
        return bool(self._robots)

    def opens(self, code: str) -> bool:
        """Whether this is the code; capitals, spaces and dashes do not matter."""
        tried = "".join(c for c in code.lower() if c.isalnum())
        return self._tries.spend(1, self._now()) and secrets.compare_digest(tried.encode(), self.code.encode())

    def shown(self, session: str) -> list[page.RobotName]:
        """The robots as a session sees them."""
        holds = [(name, self._holds.get(name)) for name in self._robots]
        return [page.RobotName(name, h.who if h else None, h is not None and h.session == session) for name, h in holds]

    def take(self, name: str, session: str, who: str) -> str:
        """
        Have a robot; returns its address.

        Raises:
            BadInput: it is no robot of ours, or somebody has it.
        """
        if name not in self._robots:
            raise BadInput(f"There is no robot called {name}.")
        held = self._holds.get(name)
        if held is not None:
            who = "This page" if held.session == session else held.who
            raise BadInput(f"{who} has {name} at the moment; it is free again when they leave it.")
        address = self._robots[name]
        if any(way(d.address) == way(address) for d in drivers()):
            raise BadInput(f"{name} is being driven from a terminal at the moment.")
        self._holds[name] = Hold(session, who.strip()[:_MAX_WHO] or "Somebody")
        self._changed()
        return address

    def leave(self, name: str, session: str) -> None:
        """Others may have it."""
        held = self._holds.get(name)
        if held is not None and held.session == session:
            del self._holds[name]
            self._changed()
