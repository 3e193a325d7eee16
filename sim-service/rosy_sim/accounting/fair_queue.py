"""
Fair queue: places for work that takes a while, shared between clients by start-time fair queueing.

A free place goes to the waiting client with the fewest places, and among those to the one whose work took long least
lately, then to the one that has used least (Goyal, Vin and Cheng 1997: virtual start times; a client saves up nothing
while it asks for nothing). The pages of a client take turns. Clients whose work took long lately have a debt; with much
of it they are heavy: together they leave one place free for the others. When a client without a place finds all of them
taken, work that may be preempted gives one up; a callback tells its owner. Long work does after a while, and work that
can begin again at once when its client has a debt and the other one has none; one of several such pieces of work is
left to go on to its end.

What it does not do: know what the work is, or end it.
"""

from __future__ import annotations

import asyncio
import math
import time
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from dataclasses import dataclass, field

from .client import Client

__all__ = ["FairQueue", "Lease", "Policy"]

_REVIEW = 0.25
"""Between two looks whether work may be preempted, while a client without a place waits, s."""

_PREEMPTION = 2.0
"""For preempted work to give its place up, before another one is preempted, s."""


@dataclass(frozen=True, slots=True)
class Policy:
    """What a queue grants. Times in s."""

    places: int
    # Places of one page at once.
    page_places: int = 1_000_000
    # Work that takes longer is long: it counts for the allowance, and may be preempted.
    long: float = math.inf
    # Long work of a client, at once, without being heavy.
    allowance: float = math.inf
    # Part of the allowance that comes back in a second.
    recovery: float = 0.1
    # Work that is preempted begins again later; nothing but time is lost.
    restarts: bool = False
    # Work that has shown no activity for so long may be preempted, as may the surplus of a client with several places.
    idle: float = math.inf


@dataclass(slots=True)
class _Account:
    """What one client uses."""

    # Virtual time at which its next work starts, s of use.
    start: float = 0.0
    # Long work at ``at``, s; it is forgotten at the rate of recovery.
    debt: float = 0.0
    at: float = 0.0
    leases: int = 0
    waiting: int = 0
    # The numbers of the latest grants of its pages.
    pages: dict[str, int] = field(default_factory=dict)


class Lease:
    """A place. ``release`` may be called more than once."""

    __slots__ = ("_queue", "account", "active", "begun", "client_page", "on_preempt", "preempted")

    def __init__(
        self, queue: FairQueue, account: _Account, page: str, now: float, on_preempt: Callable[[], None] | None
    ) -> None:
        self._queue: FairQueue | None = queue
        self.account = account
        self.client_page = page
        # When the work began, and when it last did something, on the queue's clock.
        self.begun = self.active = now
        # Asks the owner to release it soon; None for work that is not preempted.
        self.on_preempt = on_preempt
        # When the owner was asked to.
        self.preempted: float | None = None

    def touch(self) -> None:
        """The work has done something."""
        if self._queue is not None:
            self.active = self._queue.now()

    def release(self) -> None:
        """Give the place back."""
        queue, self._queue = self._queue, None
        if queue is not None:
            queue.end(self)


@dataclass(slots=True, eq=False)
class _Waiter:
    account: _Account
    page: str
    turn: asyncio.Future[Lease]
    on_position: Callable[[int], None]
    on_preempt: Callable[[], None] | None
    # The position that was reported last; 0 before that.
    position: int = 0


class FairQueue:
    """
    The places of one resource.

    Args:
        policy: what is granted.
        now: a clock in s that only goes forward.
    """

    def __init__(self, policy: Policy, now: Callable[[], float] = time.monotonic) -> None:
        self.policy = policy
        self.now = now
        # Work that has had to wait since the service started.
        self.queued = 0
        self._leases: list[Lease] = []
        # In the order of their arrival.
        self._waiters: list[_Waiter] = []
        self._accounts: dict[str, _Account] = {}
        # The debts of pages that are gone, with their times, by network.
        self._inherited: dict[str, tuple[float, float]] = {}
        # The virtual start time of the work that began last, and its number.
        self._virtual = 0.0
        self._grants = 0
        self._timer: asyncio.TimerHandle | None = None

    @property
    def running(self) -> int:
        """Places in use."""
        return len(self._leases)

    async def acquire(
        self,
        client: Client,
        on_position: Callable[[int], None] = lambda _: None,
        on_preempt: Callable[[], None] | None = None,
    ) -> Lease:
        """Take a place; while there is none, wait and report the position in the queue, 1 for the next."""
        account = self._account(client)
        turn: asyncio.Future[Lease] = asyncio.get_running_loop().create_future()
        waiter = _Waiter(account, client.page, turn, on_position, on_preempt)
        if not account.waiting:
            account.start = max(account.start, self._virtual)
        account.waiting += 1
        self._waiters.append(waiter)
        self._dispatch()
        if not turn.done():
            self.queued += 1
        try:
            return await turn
        except asyncio.CancelledError:
            if turn.cancelled():
                self._forget(waiter)
            else:
                # The place had been handed over already.
                turn.result().release()
            raise

    @asynccontextmanager
    async def place(self, client: Client, on_preempt: Callable[[], None] | None = None) -> AsyncIterator[Lease]:
        """Wait for a place, and have it until the end of the block."""
        lease = await self.acquire(client, on_preempt=on_preempt)
        try:
            yield lease
        finally:
            lease.release()

    def leave(self, client: Client) -> None:
        """A page has gone; a page that opens from its network does not begin without its debt."""
        account = self._accounts.get(client.name)
        if account is None:
            return
        now = self.now()
        account.pages.pop(client.page, None)
        self._inherited = {key: old for key, old in self._inherited.items() if self._decayed(*old, now) > 0}
        debt, before = self._debt(account, now), self._decayed(*self._inherited.get(client.network, (0.0, now)), now)
        if debt > before:
            self._inherited[client.network] = debt, now

    def end(self, lease: Lease) -> None:
        """A place is free; ``Lease.release`` calls it."""
        now = self.now()
        used = now - lease.begun
        account = lease.account
        account.debt, account.at = self._decayed(account.debt, account.at, now), now
        if used > self.policy.long:
            account.debt += used
        if lease.preempted is not None and math.isfinite(self.policy.allowance):
            account.debt = max(account.debt, self.policy.allowance + used)
        account.start += used
        account.leases -= 1
        self._leases.remove(lease)
        self._dispatch()

    # Accounts

    def _account(self, client: Client) -> _Account:
        found = self._accounts.get(client.name)
        if found is None:
            now = self.now()
            # Those that use nothing and owe nothing are as good as unknown.
            self._accounts = {
                name: account
                for name, account in self._accounts.items()
                if account.leases or account.waiting or account.start > self._virtual or self._debt(account, now) > 0
            }
            debt, at = self._inherited.get(client.network, (0.0, now))
            found = self._accounts[client.name] = _Account(start=self._virtual, debt=debt, at=at)
        return found

    def _decayed(self, debt: float, at: float, now: float) -> float:
        return max(0.0, debt - self.policy.recovery * (now - at)) if debt else 0.0

    def _debt(self, account: _Account, now: float) -> float:
        return self._decayed(account.debt, account.at, now)

    def _is_heavy(self, account: _Account, now: float) -> bool:
        return self._debt(account, now) > self.policy.allowance

    # Places

    def _forget(self, waiter: _Waiter) -> None:
        if waiter in self._waiters:
            self._waiters.remove(waiter)
            waiter.account.waiting -= 1
            self._report_positions()

    def _in_order(self, now: float) -> list[_Waiter]:
        """Those that wait, the next one first. Each counts with those of its client before it as served."""
        ahead: dict[int, int] = {}
        pages: dict[tuple[int, str], int] = {}
        keyed = []
        for arrival, waiter in enumerate(self._waiters):
            account = waiter.account
            key = id(account), waiter.page
            pages[key] = pages.get(key, -1) + 1
            keyed.append(((pages[key], account.pages.get(waiter.page, 0), arrival), waiter))
        keyed.sort(key=lambda one: one[0])
        placed = []
        for (_, _, arrival), waiter in keyed:
            account = waiter.account
            number = ahead[id(account)] = ahead.get(id(account), -1) + 1
            rank = (
                self._is_heavy(account, now),
                account.leases + number,
                self._debt(account, now),
                account.start,
                arrival,
            )
            placed.append((rank, waiter))
        placed.sort(key=lambda one: one[0])
        return [waiter for _, waiter in placed]

    def _dispatch(self) -> None:
        now = self.now()
        for waiter in [waiter for waiter in self._waiters if waiter.turn.done()]:
            self._forget(waiter)
        while len(self._leases) < self.policy.places and (chosen := self._next(now)) is not None:
            self._grant(chosen, now)
        self._preempt(now)
        self._report_positions()
        if self._timer is None and self._has_needy():
            self._timer = asyncio.get_running_loop().call_later(_REVIEW, self._review)

    def _review(self) -> None:
        self._timer = None
        self._dispatch()

    def _next(self, now: float) -> _Waiter | None:
        """Whose turn it is; ``None`` when those that wait have to wait on."""
        heavy = sum(self._is_heavy(lease.account, now) for lease in self._leases)
        for waiter in self._in_order(now):
            if self._is_heavy(waiter.account, now) and self.policy.places > 1 and heavy >= self.policy.places - 1:
                continue
            used = sum(lease.account is waiter.account and lease.client_page == waiter.page for lease in self._leases)
            if used < self.policy.page_places:
                return waiter
        return None

    def _grant(self, waiter: _Waiter, now: float) -> None:
        account = waiter.account
        self._waiters.remove(waiter)
        account.waiting -= 1
        account.leases += 1
        self._virtual = max(self._virtual, account.start)
        self._grants += 1
        account.pages[waiter.page] = self._grants
        lease = Lease(self, account, waiter.page, now, waiter.on_preempt)
        self._leases.append(lease)
        waiter.turn.set_result(lease)

    def _report_positions(self) -> None:
        for position, waiter in enumerate(self._in_order(self.now()), 1):
            if position != waiter.position and not waiter.turn.done():
                waiter.position = position
                waiter.on_position(position)

    # Preemption

    def _needy(self, now: float) -> list[_Account]:
        """Clients that wait without a place and are not heavy."""
        waiting = {id(w.account): w.account for w in self._waiters if not w.turn.done()}
        return [one for one in waiting.values() if not one.leases and not self._is_heavy(one, now)]

    def _has_needy(self) -> bool:
        return math.isfinite(min(self.policy.idle, self.policy.long)) and bool(self._needy(self.now()))

    def _preempt(self, now: float) -> None:
        """Ask for a place for each client that waits without one."""
        if not self._has_needy():
            return
        asked = sum(one.preempted is not None and now - one.preempted < _PREEMPTION for one in self._leases)
        needy = sorted(self._debt(account, now) > 0 for account in self._needy(now))
        for is_indebted in needy[asked:]:
            lease = self._victim(now, is_indebted)
            if lease is None:
                return
            assert lease.on_preempt is not None
            lease.preempted = now
            lease.on_preempt()

    def _victim(self, now: float, is_indebted: bool) -> Lease | None:
        """
        The work to preempt for a client that has a debt or none: of the client with most places or the largest debt,
        the one that has been idle or at work for longest. A client's only place only when its work is idle, or when
        several places have long work or that of clients with a debt; one of them is left to go on.
        """
        left: dict[int, int] = {}
        for lease in self._leases:
            if lease.preempted is None:
                left[id(lease.account)] = left.get(id(lease.account), 0) + 1
        policy = self.policy
        lengthy = sum(one.preempted is None and self._is_lengthy(one, now) for one in self._leases)
        gives_way = math.isfinite(policy.long) and lengthy >= min(2, policy.places)
        best: Lease | None = None
        rank: tuple[int, float, float] | None = None
        for lease in self._leases:
            if lease.on_preempt is None or lease.preempted is not None:
                continue
            places = left[id(lease.account)]
            is_surplus = math.isfinite(policy.idle) and places > 1
            at_once = policy.restarts and not is_indebted
            is_slow = self._is_lengthy(lease, now) and (at_once or now - lease.begun >= policy.long)
            if not (is_surplus or now - lease.active >= policy.idle or (gives_way and is_slow)):
                continue
            own = (places, self._debt(lease.account, now), now - lease.active)
            if rank is None or own > rank:
                best, rank = lease, own
        return best

    def _is_lengthy(self, lease: Lease, now: float) -> bool:
        """Whether the work takes long, or is that of a client whose work took long lately."""
        return now - lease.begun >= self.policy.long or self._debt(lease.account, now) > 0
