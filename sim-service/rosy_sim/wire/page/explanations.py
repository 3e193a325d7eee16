"""Messages of a page about firings and why they happened, or did not."""

from __future__ import annotations

import msgspec

from ..explanation import Sentence
from ..firing import Firing, Place

__all__ = ["Because", "BranchPlace", "FiringShown", "Observe", "SentenceShown", "Why", "WhyNot", "firing_shown"]


class Observe(msgspec.Struct, tag="observe", tag_field="op"):
    """Whether the firings are recorded with their provenance, from the next step on, and whether frames carry them."""

    on: bool
    frames: bool = False


class Why(msgspec.Struct, tag="why", tag_field="op"):
    """
    Why is something as it is at a time, s (without one the latest)? About one of: a firing by its number, the latest
    firing of a function by its name, a memory by its type, an event as Haskell shows it or by its constructor, the
    position of the robot, a command by its type (`Velocity`, which is also meant when none is given). ``run``: another
    run than the latest.
    """

    id: int
    time: float | None = None
    firing: int | None = None
    function: str = ""
    position: bool = False
    memory: str = ""
    event: str = ""
    command: str = ""
    run: int | None = None


class BranchPlace(msgspec.Struct):
    """Where a branch of the program that runs starts and ends."""

    start: Place
    end: Place


class WhyNot(msgspec.Struct, tag="whyNot", tag_field="op"):
    """
    Why did something not happen between two times, s? A function that did not run, or did not send a command of a type;
    a branch that was not taken; a command that shows no effect, or an event of the program that was not received.
    """

    id: int
    since: float
    until: float
    function: str = ""
    command: str = ""
    event: str = ""
    branch: BranchPlace | None = None
    run: int | None = None


class FiringShown(Firing, omit_defaults=True, frozen=True, kw_only=True):
    """A firing, and when it was, s since the start of the program."""

    time: float


def firing_shown(firing: Firing, time: float) -> FiringShown:
    """A firing at a time, s."""
    f = firing
    return FiringShown(f.n, f.function, f.task, f.cause, f.took, f.gave, f.branches, time=time)


class SentenceShown(msgspec.Struct, omit_defaults=True):
    """A sentence of an explanation, the time that it is about, s, and the firing, if it is about one."""

    said: Sentence
    time: float
    firing: int | None = None


class Because(msgspec.Struct, tag="because", tag_field="op"):
    """
    The answer to `why` or `whyNot` with this ``id``: sentences, the time of what was asked about, s, and the firings
    that led to it, in the order of time.
    """

    id: int
    time: float
    sentences: list[SentenceShown]
    path: list[FiringShown]
