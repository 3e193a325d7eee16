"""
Real programs in lockstep at ``max``: times real time, the Haskell process included, beside the machine's bare round
trip, which a step costs at least in which the program is asked and both share a core.

Two quiet cores, bare round trip 20 to 30 µs, times real time: a task with pauses 2,000 to 2,650, events 1,180 to 1,920,
the default rate 945 to 1,270, 50 Hz 376 to 591 (goal 500).
"""

from __future__ import annotations

import os
import statistics
import time
from typing import NamedTuple

from ..config import Config
from ..run.headless_run import RunOutput, RunSettings, run_program
from ..run.steps.lockstep import Lockstep
from ..worker.blocking_worker import BlockingWorker
from ..worlds.gallery import named_world, usable_world
from . import round_trip
from .programs import BACK_OFF, EACH_STEP, MOVE, PATROL

__all__ = ["report"]

_SECONDS = float(os.environ.get("ROSY_BENCH_SECONDS", "120"))
_ROUNDS = int(os.environ.get("ROSY_BENCH_ROUNDS", "5"))


class _Row(NamedTuple):
    """A program, its room, and the goal, in times real time."""

    name: str
    source: str
    world: str
    goal: int


_ROWS = [
    _Row("a task with pauses", PATROL, "room", 1000),
    _Row("events, backOff", BACK_OFF, "room", 1000),
    _Row("default rate, move", MOVE, "room", 1000),
    _Row("50 Hz, accelerate", EACH_STEP, "room", 500),
]


def report(config: Config) -> None:
    """Print a row per program."""
    trip = round_trip.report()
    for row in _ROWS:
        asked, factors, costs = 0.0, [], []
        for _ in range(_ROUNDS):
            asked, wall, cost = _run(config, row)
            factors.append(_SECONDS / wall)
            costs.append(cost)
        factor = statistics.median(factors)
        label = f"program in lockstep, {row.name}"
        print(
            f"  {label:<56} {factor * 50:>9,.0f} steps/s   {factor:>7,.0f} x real time   goal {row.goal:,}; asked in"
            f" {100 * asked:.0f} % of the steps; {1e6 / factor / 50:.0f} µs a step,"
            f" {1e6 * statistics.median(costs):.0f} of them computing here; bare round trip {1e6 * trip:.0f} µs"
        )


def _run(config: Config, row: _Row) -> tuple[float, float, float]:
    """The share of steps in which the program was asked, the duration in s, our processor time per step in s."""
    asked = 0

    def observe(lockstep: Lockstep) -> None:
        nonlocal asked
        asked += not lockstep.was_quiet

    with BlockingWorker(config) as worker:
        worker.ready()
        settings = RunSettings(_SECONDS, 1, limits=config.limits, busy_waits=True)
        world = usable_world(named_world(row.world), row.world)
        began = time.process_time()
        outcome = run_program(worker, row.source, world, settings, RunOutput(observe=observe))
    if outcome.problems or not outcome.steps:
        raise RuntimeError(f"{row.name}: {outcome.problems}")
    return asked / outcome.steps, outcome.wall, (time.process_time() - began) / outcome.steps
