"""Reports of tests in many rooms as text for a terminal, and as values for JSON."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import msgspec

from ..sentences.sentence import Sentence, tr
from ..sentences.terminal_text import neutralize_line
from ..sentences.wording import in_terminal, machine_wording
from ..wire.page.room_tests import FindingShown
from ..wire.problem import Problem, to_wire, worded
from .room_test import Report, worst_first
from .trial import Finding, Outcome

__all__ = ["describe_failure", "format_report", "report_values", "worst_status"]

_Finding = Finding | FindingShown


def format_report(name: str, report: Report) -> str:
    """The failed rooms, worst first, and a line that counts."""
    failed = [outcome for outcome in worst_first(report.outcomes) if not outcome.has_passed]
    head = [in_terminal(title) for title in (tr("room"), tr("went"), tr("time"))]
    went = [in_terminal(tr("crashed") if outcome.has_crashed else tr("failed")) for outcome in failed]
    # Words of other languages are longer.
    width = max((len(word) for word in (head[1], *went)), default=0)
    rows = [f"{head[0]:>6}  {head[1]:<{width}}  {head[2]:>8}"] if failed else []
    rows += [_row(outcome, f"{word:<{width}}") for outcome, word in zip(failed, went, strict=True)]
    passed = tr("{passed} of {all} rooms passed.", passed=report.passed, all=len(report.outcomes))
    rows.append(f"{neutralize_line(name)}: {in_terminal(passed)}")
    return "\n".join(rows)


def _row(outcome: Outcome, went: str) -> str:
    what = describe_failure(outcome.problems, outcome.failed)
    return neutralize_line(f"{outcome.room:>6}  {went}  {outcome.time:>6.2f} s  {what}")


def describe_failure(problems: Sequence[Problem], failed: Sequence[_Finding]) -> str:
    """What went wrong in a room: the problems of the program, and the properties that do not hold."""
    said = [worded(problem, machine_wording()).message for problem in problems]
    return "; ".join([*said, *(in_terminal(_failure(finding)) for finding in failed)])


def _failure(finding: _Finding) -> Sentence:
    amount, time = finding.amount, f"{finding.time or 0.0:.2f}"
    match finding.property.split()[0]:
        case "reaches-goal":
            return tr("did not reach the goal, {share} % of the way", share=f"{100 * amount:.0f}")
        case "room-goals":
            return tr("missed goals of the room, {share} % done", share=f"{100 * amount:.0f}")
        case "never-falls":
            return tr("fell at {time} s", time=time)
        case "never-pushes":
            return tr("pushed for {pushed} s until {time} s", pushed=f"{amount:.2f}", time=time)
        case "returns-to-start":
            if not amount:
                return tr("never left its start")
            return tr("came back to {distance} m from its start", distance=f"{amount:.2f}")
        case _:
            return tr("covered {share} % of the floor", share=f"{amount:.0f}")


def report_values(name: str, report: Report, file: str | None) -> dict[str, Any]:
    """The report as JSON; ``file`` holds the smallest failing room."""
    found: dict[str, Any] = {
        "program": name,
        "passed": report.passed,
        "problems": msgspec.to_builtins(report.refused),
        "rooms": [_values(outcome) for outcome in worst_first(report.outcomes)],
    }
    if report.lost is not None:
        found["lost"] = msgspec.to_builtins(to_wire(report.lost))
    if report.smallest is not None:
        shrunk, outcome = report.smallest.shrunk, report.smallest.outcome
        found["smallest"] = {
            "room": outcome.room, "seed": outcome.seed, "file": file, "things": shrunk.things, "of": shrunk.of,
            "minimal": shrunk.is_minimal, "tried": shrunk.trials, "world": shrunk.world,
            "outcome": _values(outcome),
        }  # fmt: skip
    return found


def _values(outcome: Outcome) -> dict[str, Any]:
    x, y, theta = outcome.pose
    return {
        "room": outcome.room,
        "seed": outcome.seed,
        "passed": outcome.has_passed,
        "ended": outcome.ended,
        "time": outcome.time,
        "pose": {"x": x, "y": y, "theta": theta},
        "properties": msgspec.to_builtins(outcome.findings),
        "problems": msgspec.to_builtins(outcome.problems),
    }


def worst_status(reports: Sequence[Report]) -> int:
    """The exit status: 1 when a program does not compile, 2 when one crashed or was lost, 3 when a property failed."""
    return max((_status(report) for report in reports), default=0)


def _status(report: Report) -> int:
    if report.refused:
        return 1
    if report.lost is not None:
        return 2
    if any(outcome.failed for outcome in report.outcomes if not outcome.has_crashed):
        return 3
    return 2 if any(outcome.has_crashed for outcome in report.outcomes) else 0
