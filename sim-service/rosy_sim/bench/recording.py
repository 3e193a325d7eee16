"""
What it costs to record the firings of a run with their provenance: processor time of service and program for a step.

The same programs drive in the same pages without being observed, observed, and observed with their firings sent to the
page, in short turns one after the other. Each round has a share of its own, of turns that follow each other at once;
the median of the shares and their quartiles are printed.

The goal is 15 % for observing. Two cores, 30 rounds: 10.6 % for 8 pages and 11.3 % for 32; 16 to 18 % with firings
sent.
"""

from __future__ import annotations

import os
import statistics
from dataclasses import replace
from typing import Any

from ..config import Config
from ..run.observed_runs import MOST_OBSERVED
from .pages import Drivers, Turn, take_turns

__all__ = ["report"]

_ROUNDS = int(os.environ.get("ROSY_BENCH_ROUNDS", "30"))

_TURN = 0.5
"""Length of a turn, s: 25 steps of each page."""

GOAL = 0.15
"""The share of an observed step that recording may take."""

_PLAIN = "not observed"

_KINDS: dict[str, dict[str, Any]] = {
    _PLAIN: {"op": "observe", "on": False},
    "observed": {"op": "observe", "on": True},
    "observed, firings sent to the page": {"op": "observe", "on": True, "frames": True},
}

_FORWARD_BACKWARD = """type Hit = Bool

bump :: Bumper -> Memory Hit
bump _ = Memory True

forwardBackward :: Memory Hit -> Velocity -> Velocity
forwardBackward (Memory hit) (Velocity vl va)
  | hit = Velocity (vl - 0.5) va
  | otherwise = Velocity (vl + 0.5) va

main = simulate (bump, forwardBackward)
"""


def report(config: Config, counts: list[int], seconds: float) -> None:
    """Print a row for each kind of observation, for so many pages at once; rounds of ``seconds`` at most."""
    for count in [min(count, MOST_OBSERVED) for count in counts]:
        limits = replace(config.limits, runs=count, sessions=max(count, config.limits.sessions))
        drivers = Drivers(count, min(seconds, _TURN), _FORWARD_BACKWARD)
        measured = take_turns(config.with_limits(limits), drivers, _KINDS, _ROUNDS)
        for kind in _KINDS:
            turns = [turn[kind] for turn in measured]
            share = "" if kind == _PLAIN else "; " + _shares([(one[_PLAIN], one[kind]) for one in measured])
            received = _median(turns, "received") / 1e3
            print(
                f"  {count} pages, a step, {kind + ':':<37} {1e6 * _median(turns, 'service'):4.0f} µs of service and"
                f" {1e6 * _median(turns, 'programs'):4.0f} of program, {received:5.1f} kB/s to a page{share}",
                flush=True,
            )
    print(
        f"  (goal: recording takes less than {100 * GOAL:.0f} % of an observed step, and nothing without observation)"
    )


def _median(turns: list[Turn], what: str) -> float:
    return float(statistics.median(getattr(turn, what) for turn in turns))


def _shares(pairs: list[tuple[Turn, Turn]]) -> str:
    """The median share of the observation in an observed step, and between what half of the shares lie."""
    shares = [100 * (1 - plain.step / observed.step) for plain, observed in pairs]
    low, middle, high = statistics.quantiles(shares, n=4) if len(shares) > 1 else (shares[0],) * 3
    return f"{middle:.1f} % of it for the observation (half of {len(shares)} rounds from {low:.1f} to {high:.1f} %)"
