"""Pace at which a page's messages are read, so that one page delays no other."""

from __future__ import annotations

from ...token_bucket import TokenBucket

_MESSAGE_RATE = 100.0
"""Messages that a page may send, a second; twice as many at once."""

_WORK_RATE, _WORK_BURST = 0.1, 0.25
"""Computing time that a page's messages may take on the event loop: a share of it, and s at once."""

_CHARACTERS_PER_MESSAGE = 2000
"""Characters that count as one more message: programs and rooms are long, and cost more to serve."""


def message_cost(characters: int) -> float:
    """What a message of this length counts against a rate of messages."""
    return 1 + characters / _CHARACTERS_PER_MESSAGE


class ReadingPace:
    """Limits of one page: a rate of messages, and a share of the event loop."""

    def __init__(self, now: float) -> None:
        self._messages = TokenBucket(_MESSAGE_RATE, 2 * _MESSAGE_RATE, now)
        self._work = TokenBucket(_WORK_RATE, _WORK_BURST, now)

    def wait(self, characters: int, work: float, now: float) -> float:
        """Return the s to wait after a message of this length whose answer took ``work`` s of computing time."""
        return max(self._work.overdraw(work, now), self._messages.overdraw(message_cost(characters), now))
