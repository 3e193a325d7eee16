"""
Robot registry: the real robots that pages may drive, and which page owns which.

The robots are open to pages that know the code printed where the service was started. A page that is merely reachable
does not suffice: a class reaches it, and so does every other user of a shared computer, and a real robot can do harm.
Eight of 28 letters and digits, at twenty attempts a second, are not guessed in a lifetime. A page or an address that
sends wrong codes is not heard any more; the others are.
"""

from __future__ import annotations

import secrets
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from ..attempts import Attempts, Rate
from ..errors import BadInput
from ..ros2.nearby_robots import NearbyRobot
from ..sentences.sentence import tr
from ..wire import page
from .driver_locks import active_drivers, canonical_address
from .run_recorder import RunRecorder

__all__ = ["Owner", "RobotRegistry"]

_LETTERS = "bcdfghjkmnpqrstvwxyz23456789"
"""Without vowels, which form words, and without letters and digits that look alike."""

_CODE_LENGTH = 8

_PAGE_ATTEMPTS, _ADDRESS_ATTEMPTS = Rate(0.2, 10.0), Rate(2.0, 100.0)
"""Wrong codes that a page, and all pages of an address, may try."""

_ALL_ATTEMPTS = Rate(20.0, 1000.0)
"""Wrong codes that all pages together may try: ten addresses do not use them up."""

_MAX_NAME = 40
"""Characters of an owner's name."""


@dataclass(frozen=True, slots=True)
class Owner:
    """The page session that owns a robot, and the name that other pages see."""

    session: str
    name: str


@dataclass(frozen=True, slots=True)
class _Robot:
    address: str
    nearby: page.Nearby | None = None


class RobotRegistry:
    """
    All robots by the names that pages see.

    Args:
        addresses: the robots' addresses by name.
        executable: ``rosy-robot``; ``None`` while it is not built.
        now: a clock in s that only goes forward.
        on_change: called when a robot gets an owner or loses it.
        recorder: records the runs on the robots; ``None`` if they are not to be recorded.
        discovers: whether robots nearby will be set.
    """

    def __init__(
        self,
        addresses: dict[str, str],
        executable: Path | None,
        now: Callable[[], float],
        on_change: Callable[[], None],
        recorder: RunRecorder | None = None,
        discovers: bool = False,
    ) -> None:
        self.recorder = recorder
        self.discovers = discovers
        self._configured = addresses
        self._nearby: Sequence[NearbyRobot] = ()
        # The names of robots that were discovered, by address; one that comes again has its name again.
        self._names: dict[str, str] = {}
        self.executable = executable
        self._now = now
        self._on_change = on_change
        self._owners: dict[str, Owner] = {}
        self._attempts = Attempts([_PAGE_ATTEMPTS, _ADDRESS_ATTEMPTS], _ALL_ATTEMPTS, now())
        # The code that unlocks the robots.
        self.code = "".join(secrets.choice(_LETTERS) for _ in range(_CODE_LENGTH))

    def __bool__(self) -> bool:
        return bool(self._configured) or self.discovers

    def accepts_code(self, code: str, session: str, address: str) -> bool | None:
        """
        Whether this is the code; capitals, spaces and dashes do not matter. ``None`` if the page or its address has
        tried too many wrong ones.

        Args:
            code: as it was typed.
            session: the page session that tries it.
            address: the client address of the page.
        """
        keys, now = [session, address], self._now()
        if not self._attempts.begin(keys, now):
            return None
        tried = "".join(c for c in code.lower() if c.isalnum())
        if not secrets.compare_digest(tried.encode(), self.code.encode()):
            return False
        self._attempts.succeeded(keys, now)
        return True

    def robots_for(self, session: str) -> list[page.RobotName]:
        """The robots as a session sees them; one that was discovered and is gone stays as long as it has an owner."""
        known = self._robots()
        names: list[page.RobotName] = []
        for name in dict.fromkeys([*known, *self._owners]):
            owner = self._owners.get(name)
            nearby = known[name].nearby if name in known else None
            is_own = owner is not None and owner.session == session
            names.append(page.RobotName(name, owner.name if owner is not None else None, is_own, nearby))
        return names

    def set_nearby(self, robots: Sequence[NearbyRobot]) -> None:
        """The robots that are discovered at the moment."""
        self._nearby = robots
        self._on_change()

    def _robots(self) -> dict[str, _Robot]:
        """Those that can be taken, by name; one that is configured is not listed again when it is discovered."""
        robots = {name: _Robot(address) for name, address in self._configured.items()}
        configured = {canonical_address(address): name for name, address in self._configured.items()}
        for found in self._nearby:
            battery = found.battery
            nearby = page.Nearby(found.title, found.domain, battery.charge, battery.volts, found.zenoh, found.several)
            place = canonical_address(found.bare)
            if place in configured:
                name = configured[place]
                robots[name] = _Robot(self._configured[name], nearby)
            else:
                robots[self._name(found, place)] = _Robot(found.address, nearby)
        return robots

    def _name(self, robot: NearbyRobot, place: str) -> str:
        """What pages call a robot that was discovered: two that would have one name are told apart by their address."""
        if place not in self._names:
            name = robot.name or robot.title
            taken = {*self._configured, *self._names.values()}
            self._names[place] = f"{name} ({place})" if name in taken else name
        return self._names[place]

    def acquire(self, name: str, session: str, owner_name: str) -> str:
        """
        Make a session the owner of a robot; returns the robot's address.

        Raises:
            BadInput: there is no such robot, or it has an owner.
        """
        robots = self._robots()
        if name not in robots and name not in self._owners:
            raise BadInput(tr("There is no robot called {name}.", name=name))
        owner = self._owners.get(name)
        if owner is not None:
            if owner.session == session:
                raise BadInput(
                    tr("This page has {name} at the moment; it is free again when they leave it.", name=name)
                )
            raise BadInput(
                tr("{who} has {name} at the moment; it is free again when they leave it.", who=owner.name, name=name)
            )
        address = robots[name].address
        if any(canonical_address(d.address) == canonical_address(address) for d in active_drivers()):
            raise BadInput(tr("{name} is being driven from a terminal at the moment.", name=name))
        self._owners[name] = Owner(session, owner_name.strip()[:_MAX_NAME] or "Another person")
        self._on_change()
        return address

    def release(self, name: str, session: str) -> None:
        """End the session's ownership of a robot."""
        owner = self._owners.get(name)
        if owner is not None and owner.session == session:
            del self._owners[name]
            self._on_change()
