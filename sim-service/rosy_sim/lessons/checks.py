"""
Checks of a lesson's step, as values: a goal of the room, a law of the run, or a fact about the program's typed graph.

Never the text of the program. ``protocol/lesson.schema.json`` is generated from these types. Units are SI.
"""

from __future__ import annotations

from typing import Annotated

import msgspec
from msgspec import Meta

__all__ = [
    "Answers",
    "At",
    "Back",
    "Check",
    "Counts",
    "Ends",
    "Faces",
    "Farthest",
    "Function",
    "Functions",
    "Gap",
    "Goals",
    "Holds",
    "Measures",
    "Moves",
    "Never",
    "Raises",
    "Reaches",
    "Returns",
    "Says",
    "Sends",
    "Silent",
    "Still",
    "Varies",
]

Identifier = Annotated[str, Meta(pattern="^[a-z][a-z0-9-]{0,39}$", description="Lower-case letters, digits, hyphens.")]
Time = Annotated[float, Meta(ge=0, le=600, description="Seconds of the run.")]
Span = Annotated[float, Meta(gt=0, le=600, description="Seconds.")]
Place = Annotated[int, Meta(ge=0, le=9, description="Number of a goal of the room that has a place, from 0.")]
Tolerance = Annotated[float, Meta(gt=0, le=10, description="Largest difference, m.")]
Pattern = Annotated[
    str,
    Meta(
        min_length=1,
        max_length=80,
        description="A channel and its values as Haskell shows them: `Bumper _ Pressed`. "
        "`_` is any value, `!Black` any other one, `<0` and `>0` compare.",
    ),
]


class _Check(msgspec.Struct, tag_field="kind", forbid_unknown_fields=True, kw_only=True):
    """What all checks have: the name that texts, hints and wrong attempts refer to."""

    id: Identifier


class Goals(_Check, tag="goals"):
    """All goals of the room are done, at the latest at ``within`` when that is there."""

    within: Span | None = None


class Holds(_Check, tag="holds"):
    """A property of the run in words, as ``./rosy run --hold`` takes it: ``never-pushes 1 s``, ``covers 60 %``."""

    property: Annotated[str, Meta(min_length=1, max_length=60)]


class At(_Check, tag="at"):
    """The robot is at the place of a goal at a time."""

    time: Time
    goal: Place = 0


class Faces(_Check, tag="faces"):
    """The robot looks towards the place of a goal at a time."""

    time: Time
    goal: Place = 0
    degrees: Annotated[float, Meta(gt=0, le=180, description="Largest angle beside it.")] = 10.0


class Still(_Check, tag="still"):
    """The robot stands from ``after`` until the end of the step."""

    after: Time


class Moves(_Check, tag="moves"):
    """The robot drives at least so far in all, m."""

    metres: Annotated[float, Meta(gt=0, le=1000)]


class Farthest(_Check, tag="farthest"):
    """The robot comes so far from its start, and not farther: at most ``tolerance`` beside it, m."""

    metres: Annotated[float, Meta(gt=0, le=1000)]
    tolerance: Tolerance


class Back(_Check, tag="back"):
    """At the end the robot is at its start, at most ``tolerance`` beside it, m."""

    tolerance: Tolerance


class Gap(_Check, tag="gap"):
    """At the end the robot is so far from where it was at the first such event, at most ``tolerance`` beside it, m."""

    event: Pattern
    metres: Annotated[float, Meta(gt=0, le=1000)]
    tolerance: Tolerance


class Reaches(_Check, tag="reaches"):
    """The speed reaches a value, m/s (backwards when it is negative), at the latest at ``within``."""

    speed: Annotated[float, Meta(ge=-2, le=2)]
    within: Span


class Sends(_Check, tag="sends"):
    """The program sends a command at least once, at the latest at ``within`` when that is there."""

    command: Pattern
    within: Span | None = None


class Answers(_Check, tag="answers"):
    """Each time that an event happens, at least ``least`` times, a command follows within so many seconds."""

    event: Pattern
    command: Pattern
    within: Span = 0.3
    least: Annotated[int, Meta(ge=1, le=100)] = 1


class Silent(_Check, tag="silent"):
    """
    A command does not follow an event from ``after`` to ``within`` seconds later, or until the event happens again; it
    happens at least once.
    """

    event: Pattern
    command: Pattern
    within: Span = 0.1
    after: Annotated[float, Meta(ge=0, le=600, description="Seconds.")] = 0.0


class Never(_Check, tag="never"):
    """An event does not happen."""

    event: Pattern


class Raises(_Check, tag="raises"):
    """Each time that an event happens, the robot gets faster by at least ``speed``, m/s, within so many seconds."""

    event: Pattern
    speed: Annotated[float, Meta(gt=0, le=2)]
    within: Span


class Returns(_Check, tag="returns"):
    """What a command was before the first event comes again at a later one, after others in between."""

    event: Pattern
    command: Pattern


class Varies(_Check, tag="varies"):
    """The commands have at least so many different values."""

    command: Pattern
    least: Annotated[int, Meta(ge=2, le=1000)]


class Counts(_Check, tag="counts"):
    """After the n-th event the program says the number n, and no other number; the event happens ``least`` times."""

    event: Pattern
    least: Annotated[int, Meta(ge=1, le=100)]


class Measures(_Check, tag="measures"):
    """The program says how far the robot has driven, cm, so far or until a bump, at most ``tolerance`` beside it."""

    tolerance: Annotated[float, Meta(gt=0, le=1000, description="Largest difference, cm.")]


class Says(_Check, tag="says"):
    """The program says these texts, in this order; others may come between."""

    texts: Annotated[list[str], Meta(min_length=1, max_length=50)]


class Ends(_Check, tag="ends"):
    """The program ends by itself, at the latest at ``by``."""

    by: Span


class Function(_Check, tag="function"):
    """Some function takes all of ``takes`` and sends all of ``gives``: names of types, at any place in the type."""

    takes: list[str] = []
    gives: list[str] = []


class Functions(_Check, tag="functions"):
    """The program runs at least so many functions and values."""

    least: Annotated[int, Meta(ge=1, le=50)]


Check = (
    Goals
    | Holds
    | At
    | Faces
    | Still
    | Moves
    | Farthest
    | Back
    | Gap
    | Reaches
    | Raises
    | Sends
    | Varies
    | Returns
    | Answers
    | Silent
    | Never
    | Says
    | Counts
    | Measures
    | Ends
    | Function
    | Functions
)
