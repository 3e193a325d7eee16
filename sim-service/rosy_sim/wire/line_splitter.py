"""
Splitter of a byte stream into lines: takes pieces of any size, returns the lines they complete.

A line beyond the limit is an error, so a peer that never sends a line end costs bounded memory.
"""

from __future__ import annotations

__all__ = ["LineSplitter", "LineTooLong"]


class LineTooLong(Exception):
    """A line passed the limit of ``limit`` bytes."""

    def __init__(self, limit: int) -> None:
        super().__init__(f"a line is longer than {limit} bytes")
        self.limit = limit


class LineSplitter:
    """Cuts a stream at line ends."""

    __slots__ = ("_limit", "_rest")

    def __init__(self, limit: int) -> None:
        self._limit = limit
        # The bytes of a line that has not ended yet.
        self._rest = b""

    def feed(self, data: bytes) -> list[bytes]:
        """
        Take bytes; return the lines they complete, without their ends.

        Raises:
            LineTooLong: the line that is under way, or one of the completed ones, passes the limit.
        """
        if self._rest:
            data = self._rest + data
        lines = data.split(b"\n")
        self._rest = rest = lines.pop()
        limit = self._limit
        if len(rest) > limit or (len(data) > limit and any(len(line) > limit for line in lines)):
            raise LineTooLong(limit)
        return lines
