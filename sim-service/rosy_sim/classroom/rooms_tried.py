"""
Stored form of all rooms in which a hand-in was tried: JSON, compressed, because rooms of a family resemble each other.

Apart from the result (``check_messages.CheckResult``), which has the worst room only and is kept in memory.
"""

from __future__ import annotations

import zlib
from collections.abc import Sequence

import msgspec

from ..wire.page.room_tests import TestedRoom
from .messages.check_messages import CheckResult
from .store.task_store import HandInGraded

__all__ = ["pack_rooms", "rooms_of"]


def pack_rooms(rooms: Sequence[TestedRoom]) -> bytes:
    """The stored form of rooms; empty for none."""
    return zlib.compress(msgspec.json.encode(rooms)) if rooms else b""


def rooms_of(graded: HandInGraded) -> list[TestedRoom]:
    """All rooms of a hand-in, worst first; of a check by an older Rosy, which stored no others, the worst one."""
    if graded.rooms_tried:
        return msgspec.json.decode(zlib.decompress(graded.rooms_tried), type=list[TestedRoom])
    worst = msgspec.json.decode(graded.result, type=CheckResult).worst
    return [] if worst is None else [worst]
