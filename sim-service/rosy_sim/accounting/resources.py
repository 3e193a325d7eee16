"""
What one client may use of each resource, and the queues and slots of a service that grant it.

The document of protections shows these numbers as a table (``scripts/protection_table.py``).
"""

from __future__ import annotations

import os

from ..config import Limits
from .fair_queue import FairQueue, Policy
from .slots import Evictions, Slots

__all__ = [
    "BACKGROUND_ALLOWANCE",
    "BACKGROUND_LONG",
    "CLASS_PAGES",
    "CLASS_PAGES_EACH",
    "CLIENT_UPLOADS",
    "COMPILING",
    "IDLE",
    "JOINS_EACH",
    "LOCKED",
    "LOCKED_EACH",
    "LOCKED_SECONDS",
    "PREVIEW_ALLOWANCE",
    "PREVIEW_LONG",
    "QUESTIONS",
    "UPLOADS",
    "UPLOAD_SECONDS",
    "Budgets",
]

IDLE = 60.0
"""A program that has sensed, fired and commanded nothing for so long may be stopped for a client without a place, s."""

QUESTIONS = Policy(places=2, page_places=1, long=2.0, allowance=5.0, restarts=True)
"""Checks and completions; as many compile at once in the worker (``Options.hs``, ``checkLimit``). A program of a
learner takes some 50 ms, and the worker ends one after 10 s of processor time."""

COMPILING = Policy(places=2, page_places=1, long=2.0, allowance=5.0, restarts=True)
"""Programs that are compiled for Run; as many compile at once in the worker."""

BACKGROUND_LONG, BACKGROUND_ALLOWANCE = 60.0, 60.0
"""Of a test in many rooms, a rehearsal and the check of a hand-in, s: most take some seconds."""

PREVIEW_LONG, PREVIEW_ALLOWANCE = 1.0, 5.0
"""Of a preview, s: most take some tenths of a second."""

UPLOADS, CLIENT_UPLOADS = 500_000_000, 100_000_000
"""Bytes of uploaded recordings that are kept at once, of all clients and of one: the largest file twice."""

UPLOAD_SECONDS = 120.0
"""For an upload to arrive, s: 50 MB at 3.5 Mbit/s."""

CLASS_PAGES, CLASS_PAGES_EACH = 500, 250
"""Connections of pupils' pages: several classes behind one router."""

LOCKED, LOCKED_EACH = 100, 10
"""Connections of boards and projectors that have not given the key yet. With the key there is no limit."""

LOCKED_SECONDS = 20.0
"""For a board or a projector to give the key, s. A page gives it with its first message."""

JOINS_EACH = 150
"""New pupils of a class from one network while the service runs: several classes behind one router, of 400 places."""


def _background_places() -> int:
    # Half of the cores; never fewer than two, one of which is left to clients that have used little.
    return max(2, len(os.sched_getaffinity(0)) // 2)


class Budgets:
    """The queues and slots of one service."""

    def __init__(self, limits: Limits) -> None:
        background = _background_places()
        self.runs = FairQueue(Policy(places=limits.runs, idle=IDLE))
        self.questions = FairQueue(QUESTIONS)
        self.compiling = FairQueue(COMPILING)
        self.previews = FairQueue(Policy(background, long=PREVIEW_LONG, allowance=PREVIEW_ALLOWANCE))
        self.background = FairQueue(Policy(background, long=BACKGROUND_LONG, allowance=BACKGROUND_ALLOWANCE))
        self.pages = Slots(limits.sessions, limits.address_sessions)
        self.class_pages = Slots(CLASS_PAGES, CLASS_PAGES_EACH)
        self.locked = Evictions(LOCKED, LOCKED_EACH)
        self.uploads = Slots(UPLOADS, CLIENT_UPLOADS)

    @property
    def queues(self) -> tuple[FairQueue, ...]:
        """All queues that remember what a client used."""
        return self.runs, self.questions, self.compiling, self.previews, self.background
