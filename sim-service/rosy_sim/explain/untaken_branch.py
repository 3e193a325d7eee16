"""
Why a branch of the program was not taken: which other branch of its choice was, or why no function came to the choice.

In: a recorded run, and all branches between which the functions of the program choose. A choice is not recorded; it is
found from the places of its branches.
"""

from __future__ import annotations

from collections.abc import Sequence

from ..wire.explanation import Sentence
from ..wire.firing import Branch, Firing, Place
from .branches import branch_link
from .recorded_run import RecordedRun
from .why import Link, shown_inputs
from .why_not import FunctionType, Window, outside, why_not_run

__all__ = ["branch_at", "choice_of", "why_not_taken"]


def branch_at(branches: Sequence[Branch], start: Place, end: Place) -> Branch | None:
    """The branch with this place."""
    return next((branch for branch in branches if (branch.start, branch.end) == (start, end)), None)


def choice_of(branches: Sequence[Branch], asked: Branch) -> list[Branch]:
    """The branches of one choice, in the order of the text: the asked one and those that can be taken in its place."""
    around = _parent(branches, asked)
    alike = [
        one
        for one in branches
        if one.definitions == asked.definitions and _form(one) == _form(asked) and _parent(branches, one) == around
    ]
    choice: list[Branch] = []
    for one in sorted(alike, key=_begin):
        # The branches of a choice are numbered from 1; sides of one equation have its number.
        if choice and one.number < choice[-1].number:
            if asked in choice:
                break
            choice = []
        choice.append(one)
    return choice


def why_not_taken(
    run: RecordedRun, functions: Sequence[FunctionType], branches: Sequence[Branch], asked: Branch, window: Window
) -> list[Link]:
    """Why a branch was not taken in a window of time; the last sentence of a firing tells which branch was."""
    ran = [firing for time, firing in run.firings() if window.holds(time)]
    for firing in reversed(ran):
        if asked in firing.branches:
            time = run.time_of(firing)
            sentence = Sentence("did-take", function=firing.function, time=time, values=shown_inputs(firing))
            return [Link(sentence, time, firing.n)]
    around: Branch | None = asked
    while around is not None:
        choice = choice_of(branches, around)
        for firing in reversed(ran):
            taken = next((one for one in firing.branches if one in choice and one != around), None)
            if taken is not None:
                return _other_taken(run, firing, taken)
        around = _parent(branches, around)
    name = asked.definitions[0]
    of_program = [one for one in functions if one.name == name]
    if of_program and not any(firing.function == name for firing in ran):
        return [why_not_run(run, functions, name, window)]
    sentence = Sentence("not-reached", function=asked.definitions[-1], since=window.start, until=window.end)
    return [outside(run, window) or Link(sentence, window.end)]


def _other_taken(run: RecordedRun, firing: Firing, taken: Branch) -> list[Link]:
    time = run.time_of(firing)
    sentence = Sentence("gave", function=firing.function, time=time, values=shown_inputs(firing), gave=firing.gave)
    return [Link(sentence, time, firing.n), branch_link(taken, firing, time)]


def _parent(branches: Sequence[Branch], inner: Branch) -> Branch | None:
    """The innermost branch around another one."""
    around = [one for one in branches if one != inner and _begin(one) <= _begin(inner) and _end(one) >= _end(inner)]
    return max(around, key=lambda one: (_begin(one), (-one.end.line, -one.end.column)), default=None)


def _form(branch: Branch) -> str:
    return "if" if branch.kind in ("then", "else") else branch.kind


def _begin(branch: Branch) -> tuple[int, int]:
    return branch.start.line, branch.start.column


def _end(branch: Branch) -> tuple[int, int]:
    return branch.end.line, branch.end.column
