"""Frames that wait for a client of the bridge, in their order; so many at most."""

from __future__ import annotations

import asyncio
import json
from collections import deque
from typing import Any

__all__ = ["OutgoingFrames"]

_MOST = 1000

_LOST = json.dumps({"op": "status", "level": "error", "msg": "read too slowly: messages were dropped"})


class OutgoingFrames:
    """A client that reads slowly loses the oldest frames; it is told so once until it has caught up."""

    def __init__(self) -> None:
        self._frames: deque[str] = deque(maxlen=_MOST)
        self._added = asyncio.Event()
        self._has_lost = self._is_told = False

    def put(self, message: dict[str, Any]) -> None:
        """Append a frame."""
        self._has_lost = self._has_lost or len(self._frames) == _MOST
        self._frames.append(json.dumps(message))
        self._added.set()

    async def take(self) -> str:
        """The next frame, as soon as there is one."""
        if self._has_lost and not self._is_told:
            self._is_told = True
            return _LOST
        while not self._frames:
            self._has_lost = self._is_told = False
            self._added.clear()
            await self._added.wait()
        return self._frames.popleft()
