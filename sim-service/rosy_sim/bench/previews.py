"""
Previews: the time from an edited text to its path, for five programs, through a process as the service uses it.

Two cores: 25 to 48 ms for small programs, 60 to 70 for the random walk; in the page (``e2e-tests/bench/preview.ts``) 56
to 144 ms from the key to the path.
"""

from __future__ import annotations

import asyncio
import statistics
import time

from ..accounting.client import SERVICE
from ..accounting.resources import Budgets
from ..config import Config
from ..previews.preview import PreviewTask
from ..previews.preview_pool import PreviewPool
from ..programs.program_file import read_program
from ..run.steps.velocity_guard import OFF
from ..worlds.gallery import DEFAULT_WORLD, named_world

__all__ = ["report"]

_EXAMPLES = ("move", "accelerate", "accelerateAndPlay", "randomWalk", "wander")

_SECONDS = 10.0
"""Simulated: the shortest run that a page has previewed."""

_GOAL = 0.1
"""From edit to path, s."""


def report(config: Config, rounds: int = 10) -> None:
    """Print a row per program."""
    asyncio.run(_report(config, rounds))


async def _report(config: Config, rounds: int) -> None:
    pool = PreviewPool(config, Budgets(config.limits).previews)
    try:
        for name in _EXAMPLES:
            program = read_program(config.examples / name / "program.rosy")
            world = named_world(DEFAULT_WORLD)
            times = []
            for edit in range(rounds + 1):
                # Each text is new to the worker.
                source = program.source + "\n" * edit
                began = time.perf_counter()
                await pool.run(PreviewTask(edit, source, world, 1, _SECONDS, OFF, []), SERVICE, lambda _: None)
                times.append(time.perf_counter() - began)
            # The first one has started the process.
            label = f"preview of {_SECONDS:g} s, {name}"
            median = statistics.median(times[1:])
            print(f"  {label:<56} {1000 * median:>9,.0f} ms        goal {1000 * _GOAL:.0f} ms")
    finally:
        await pool.close()
