"""
Buffer for the fragments of a rosbridge client's messages (rosbridge v2.0 Protocol Specification, section 3.1.1).

In: `fragment` messages in any order. Out: the text of a message when its last fragment has come. Bounded.
"""

from __future__ import annotations

from typing import Any

__all__ = ["FragmentBuffer"]

_MAX_FRAGMENTS = 1_000
"""Of one message."""

_MAX_CHARACTERS = 1_000_000
"""Of all fragments whose messages are not complete."""


class FragmentBuffer:
    """Of one client."""

    def __init__(self) -> None:
        # By the identifier of the message and the place in it.
        self._parts: dict[str, dict[int, str]] = {}

    def add(self, message: dict[str, Any]) -> tuple[str | None, str | None]:
        """The message that this fragment completes, if it does, and what is wrong with the fragment, if anything is."""
        ident, data = message.get("id"), message.get("data")
        num, total = _count(message.get("num")), _count(message.get("total"))
        if not isinstance(ident, str) or not isinstance(data, str) or not 0 <= num < total <= _MAX_FRAGMENTS:
            return None, "a fragment needs id, data, num and total"
        parts = self._parts.setdefault(ident, {})
        parts[num] = data
        if sum(len(part) for some in self._parts.values() for part in some.values()) > _MAX_CHARACTERS:
            self._parts.clear()
            return None, "too many fragments of messages that are not complete"
        if len(parts) < total:
            return None, None
        del self._parts[ident]
        return "".join(parts[n] for n in sorted(parts)), None


def _count(value: Any) -> int:
    """A whole number; -1 for anything else."""
    return value if isinstance(value, int) and not isinstance(value, bool) else -1
