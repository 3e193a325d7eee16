"""A real program in lockstep at ``max``: times real time, the Haskell process included."""

from __future__ import annotations

import statistics

from ..config import Config
from ..robots import DEFAULT_ROBOT
from ..run.headless_run import RunOutput, RunSettings, run_program
from ..worker.blocking_worker import BlockingWorker
from ..world.world import World
from ..worlds.gallery import DEFAULT_WORLD, named_world, usable_arena

__all__ = ["report"]

_SECONDS = 120.0
_ROUNDS = 5

_PROGRAMS = {
    "move": "move :: Velocity\nmove = Velocity 0.5 0\n\nmain = simulate move\n",
    "accelerate, at 50 Hz": (
        "accelerate :: Velocity -> Velocity\naccelerate (Velocity v w) = Velocity (v + 0.5) w\n\n"
        "main = simulate accelerate\n"
    ),
}


def report(config: Config) -> None:
    """Print a row per program."""
    arena = usable_arena(named_world(DEFAULT_WORLD), DEFAULT_WORLD)
    for name, source in _PROGRAMS.items():
        factors = []
        for _ in range(_ROUNDS):
            with BlockingWorker(config) as worker:
                worker.ready()
                settings = RunSettings(_SECONDS, 1, limits=config.limits)
                world = World(arena, DEFAULT_ROBOT)
                outcome = run_program(worker, source, world, settings, RunOutput())
            factors.append(_SECONDS / outcome.wall)
        factor = statistics.median(factors)
        label = f"program in lockstep, {name}"
        print(f"  {label:<56} {factor * 50:>9,.0f} steps/s   {factor:>7,.0f} x real time")
