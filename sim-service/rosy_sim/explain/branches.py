"""
Branches of a firing as sentences: which equation, guard or alternative of the function it took.
"""

from __future__ import annotations

from ..wire.explanation import Sentence, SentenceId
from ..wire.firing import Branch, Firing
from .recorded_run import RecordedRun
from .why import Link

__all__ = ["MAX_BRANCHES", "branch_link", "taken_branches"]

MAX_BRANCHES = 2
"""Branches in an answer about one firing: as many as a learner reads beside the rest. A choice of ours."""

_IDS: dict[str, SentenceId] = {
    "equation": "matched-equation",
    "case": "matched-case",
    "guard": "guard-held",
    "then": "was-true",
    "else": "was-false",
}


def taken_branches(run: RecordedRun, firing: Firing) -> list[Link]:
    """The first branches that a firing took: those of its function, or all when the function has no name."""
    own = [branch for branch in firing.branches if firing.function in branch.definitions]
    return [branch_link(branch, firing, run.time_of(firing)) for branch in (own or firing.branches)[:MAX_BRANCHES]]


def branch_link(branch: Branch, firing: Firing, time: float) -> Link:
    """That a firing took a branch."""
    # A local definition has its own name.
    name = branch.definitions[-1]
    number = branch.number if branch.kind in ("equation", "case") else None
    return Link(Sentence(_IDS[branch.kind], function=name, value=branch.text, number=number), time, firing.n)
