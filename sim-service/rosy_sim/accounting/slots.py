"""
Slots for connections, of which one client may take a share only, and slots that the newest connection takes.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable

__all__ = ["Evictions", "Slots"]


class Slots:
    """
    Each take() that returns true is followed by one free() of the same amount.

    Args:
        total: slots, or bytes, for all clients.
        each: for one client.
    """

    def __init__(self, total: int, each: int) -> None:
        self.total = total
        self.each = each
        self._used: Counter[str] = Counter()

    @property
    def is_full(self) -> bool:
        """Whether no client gets a slot."""
        return self.used >= self.total

    @property
    def used(self) -> int:
        """What all clients have."""
        return self._used.total()

    def take(self, name: str, amount: int = 1) -> bool:
        """Take slots; returns whether there were enough for this client."""
        if self.used + amount > self.total or self._used[name] + amount > self.each:
            return False
        self._used[name] += amount
        return True

    def free(self, name: str, amount: int = 1) -> None:
        """Free slots of a client."""
        self._used[name] -= amount
        if self._used[name] <= 0:
            del self._used[name]


class Evictions:
    """
    Slots that a newcomer always gets: of the client with most, the oldest connection loses its own.

    Args:
        total: slots for all clients.
        each: for one client.
    """

    def __init__(self, total: int, each: int) -> None:
        self.total = total
        self.each = each
        # By the function that closes a connection, the oldest first.
        self._used: dict[Callable[[], None], str] = {}

    def __len__(self) -> int:
        return len(self._used)

    def take(self, name: str, evict: Callable[[], None]) -> None:
        """Take a slot until free() or until ``evict`` is called."""
        counts = Counter(self._used.values())
        if counts[name] >= self.each:
            self._evict(name)
        elif len(self._used) >= self.total:
            self._evict(counts.most_common(1)[0][0])
        self._used[evict] = name

    def free(self, evict: Callable[[], None]) -> None:
        """Free the slot, if it is still taken."""
        self._used.pop(evict, None)

    def _evict(self, name: str) -> None:
        oldest = next(evict for evict, owner in self._used.items() if owner == name)
        del self._used[oldest]
        oldest()
