"""
Slots for connections, of which one client address may take a share only.
"""

from __future__ import annotations

from collections import Counter

__all__ = ["AddressSlots"]


class AddressSlots:
    """
    Each take() that returns ``taken`` is followed by one free().

    Args:
        total: slots for all addresses.
        each: slots for one address.
    """

    def __init__(self, total: int, each: int) -> None:
        self.total = total
        self.each = each
        self._used: Counter[str] = Counter()

    @property
    def is_full(self) -> bool:
        """Whether no address gets a slot."""
        return self._used.total() >= self.total

    def take(self, address: str) -> bool:
        """Take a slot; returns whether there was one for this address."""
        if self.is_full or self._used[address] >= self.each:
            return False
        self._used[address] += 1
        return True

    def free(self, address: str) -> None:
        """Free a slot of an address."""
        self._used[address] -= 1
        if not self._used[address]:
            del self._used[address]
