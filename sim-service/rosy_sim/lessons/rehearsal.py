"""Rehearsal: a program run headless as an attempt at a lesson's step, as fast as possible."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from ..config import Limits
from ..robots import robot_in
from ..run.headless_run import RunOutput, RunResult, RunSettings, run_program
from ..run.steps.lockstep import Lockstep
from ..wire.user_input import TimedInput, user_actions
from ..wire.verdict import Verdict
from ..worker.blocking_worker import BlockingWorker
from ..world.arena import Arena
from ..world.world import World
from .lesson_watch import CheckedStep, LessonWatch
from .program_graph import read_graph

__all__ = ["Attempt", "attempt"]


@dataclass(frozen=True, slots=True)
class Attempt:
    """How a program did: the run, the verdicts about its checks, and whether all are done."""

    run: RunResult
    verdicts: list[Verdict]
    is_passed: bool


def attempt(
    worker: BlockingWorker,
    source: str,
    step: CheckedStep,
    hands: Sequence[TimedInput],
    arena: Arena,
    seed: int,
    limits: Limits,
) -> Attempt:
    """Check a program, run it in a room for the time of a step while hands do what they do, and judge it."""
    actions = tuple((movement.t, action) for movement in hands for action in user_actions(movement))
    watch = LessonWatch(step, arena)
    watch.set_graph(read_graph(worker.check(source).graph))
    settings = RunSettings(step.seconds, seed, None, actions, limits)

    def observe(lockstep: Lockstep) -> None:
        # Whether a check changed does not end the run.
        watch.on_step(lockstep)

    run = run_program(worker, source, World(arena, robot_in(arena), seed), settings, RunOutput(observe=observe))
    watch.finish()
    return Attempt(run, watch.verdicts, watch.is_passed)
