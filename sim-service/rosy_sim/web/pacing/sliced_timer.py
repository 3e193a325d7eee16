"""
Timer that tolerates pauses of this process: it counts slices of time, and a pause of any length, of a busy machine or
one that sleeps, uses up one of them. What arrived during the pause is handled before the timer ends.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable

__all__ = ["SlicedTimer"]

_SLICES = 10


class SlicedTimer:
    """Calls back once after ``seconds``, unless it is cancelled before."""

    def __init__(self, loop: asyncio.AbstractEventLoop, seconds: float, callback: Callable[[], None]) -> None:
        self._loop = loop
        self._slice = seconds / _SLICES
        self._callback = callback
        self._left = _SLICES
        self._handle = loop.call_later(self._slice, self._end_slice)

    def cancel(self) -> None:
        """Do not call back."""
        self._handle.cancel()

    def _end_slice(self) -> None:
        self._left -= 1
        if self._left:
            self._handle = self._loop.call_later(self._slice, self._end_slice)
        else:
            self._callback()
