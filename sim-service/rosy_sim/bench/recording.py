"""
What it costs to record the firings of a run with their provenance: processor time of service and program for a step.

The same program drives in the same pages without being observed, observed, and observed with its firings sent to the
page. The three take turns; a row has the medians. Processor time hardly depends on what else the machine does.
"""

from __future__ import annotations

import os
import statistics
from dataclasses import replace
from typing import Any

from ..config import Config
from ..run.observed_runs import MOST_OBSERVED
from .pages import Cost, Drivers, drive

__all__ = ["report"]

_ROUNDS = int(os.environ.get("ROSY_BENCH_ROUNDS", "5"))

GOAL = 0.15
"""The share of an observed step that recording may take."""

_KINDS: dict[str, tuple[dict[str, Any], ...]] = {
    "not observed": (),
    "observed": ({"op": "observe", "on": True},),
    "observed, firings sent to the page": ({"op": "observe", "on": True, "frames": True},),
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


def report(config: Config, count: int, seconds: float) -> None:
    """Print a row for each kind of observation, for so many pages at once."""
    count = min(count, MOST_OBSERVED)
    limits = replace(config.limits, runs=count, sessions=max(count, config.limits.sessions))
    costs: dict[str, list[Cost]] = {kind: [] for kind in _KINDS}
    for _ in range(_ROUNDS):
        for kind, requests in _KINDS.items():
            drivers = Drivers(count, seconds, _FORWARD_BACKWARD, requests)
            costs[kind].append(drive(config.with_limits(limits), drivers))
    plain = statistics.median(map(_step, costs["not observed"]))
    for kind, measured in costs.items():
        step = statistics.median(map(_step, measured))
        service = statistics.median(cost.service / cost.steps for cost in measured)
        programs = statistics.median(cost.programs / cost.steps for cost in measured)
        received = statistics.median(cost.received / cost.took / count for cost in measured)
        share = "" if kind == "not observed" else f"; {100 * (1 - plain / step):.0f} % of it for the observation"
        print(
            f"  a step, {kind + ':':<37} {1e6 * service:4.0f} µs of service and {1e6 * programs:4.0f} of program,"
            f" {received / 1e3:5.1f} kB/s to a page{share}",
            flush=True,
        )
    print(
        f"  (goal: recording takes less than {100 * GOAL:.0f} % of an observed step, and nothing without observation)"
    )


def _step(cost: Cost) -> float:
    """Processor time of a step, s."""
    return (cost.service + cost.programs) / cost.steps
