"""
Test in many rooms beside an event loop: a thread waits for the trial processes, which have the lowest priority.

The processes are apart from the service and from the worker of the runs, so live pages keep their pace.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable

from ..config import Config
from ..errors import RosyError
from ..sentences.sentence import tr
from ..worker.background_process import LOWEST_PRIORITY, WorkerSetup
from .room_test import Report, RoomTest, shrunk_report, try_rooms
from .trial import Outcome
from .trial_pool import PoolClosed, TrialPool, Trials

__all__ = ["BUDGET", "try_in_background"]

BUDGET = 900.0
"""Longest test of one program for a page or a board, s. On an idle machine the largest takes a minute or two."""

_PATIENCE = 5.0
"""How many times longer trials may take than runs: at the lowest priority they wait for everything else."""


async def try_in_background(
    config: Config,
    source: str,
    test: RoomTest,
    on_outcome: Callable[[Outcome], None],
    on_shrink: Callable[[int], None] | None,
) -> Report:
    """
    Test a program with one trial process; cancellation ends it. ``on_outcome`` and ``on_shrink`` (``room_test.py``) are
    called in the event loop; without ``on_shrink`` no smallest room is searched.

    Raises:
        RosyError: the trial process or its worker died, or could not start.
    """
    loop = asyncio.get_running_loop()
    patient = config.with_limits(config.limits.stretched(_PATIENCE))
    pool = TrialPool(WorkerSetup.of(patient, LOWEST_PRIORITY), 1)

    def outcome_in_loop(outcome: Outcome) -> None:
        loop.call_soon_threadsafe(on_outcome, outcome)

    def shrink_in_loop(tried: int) -> None:
        if on_shrink is not None:
            loop.call_soon_threadsafe(on_shrink, tried)

    shrinks = shrink_in_loop if on_shrink is not None else None
    work = loop.run_in_executor(None, _in_pool, pool, pool.program(test.task(source)), test, outcome_in_loop, shrinks)
    try:
        return await asyncio.shield(work)
    except asyncio.CancelledError:
        pool.close()
        await asyncio.gather(work, return_exceptions=True)
        raise


def _in_pool(
    pool: TrialPool,
    trials: Trials,
    test: RoomTest,
    on_outcome: Callable[[Outcome], None],
    on_shrink: Callable[[int], None] | None,
) -> Report:
    with pool:
        try:
            report = try_rooms(test, trials, on_outcome)
            report = report if on_shrink is None else shrunk_report(test, trials, report, on_shrink)
        except PoolClosed as error:
            raise RosyError(tr("The test was cancelled.")) from error
    if report.lost is not None:
        raise RosyError(report.lost)
    return report
