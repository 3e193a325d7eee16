"""Rehearsals beside an event loop, in a process of the lowest priority: live pages keep their pace."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import msgspec

from ..config import Config
from ..errors import RosyError, WorkerLost
from ..sentences.sentence import Sentence
from ..worker.background_process import LOWEST_PRIORITY, WorkerSetup, reap, start_process
from .rehearsal_process import Rehearsals, Rehearsed, RehearsedAttempt

__all__ = ["rehearse_in_background"]

_PATIENCE = 5.0
"""How many times longer rehearsals may take than runs: at the lowest priority they wait for everything else."""


async def rehearse_in_background(
    config: Config, world: dict[str, Any], attempts: list[RehearsedAttempt], on_answer: Callable[[Rehearsed], None]
) -> None:
    """
    Run all attempts; ``on_answer`` is called after each, in their order. Cancellation ends the process.

    Raises:
        RosyError: the process or its worker died, or could not start.
    """
    patient = config.with_limits(config.limits.stretched(_PATIENCE))
    task = Rehearsals(world, attempts, WorkerSetup.of(patient, LOWEST_PRIORITY))
    process = await start_process("rosy_sim.lessons")
    assert process.stdin is not None
    assert process.stdout is not None
    try:
        process.stdin.write(msgspec.json.encode(task) + b"\n")
        for _ in attempts:
            line = await process.stdout.readline()
            if not line:
                raise WorkerLost()
            answer = msgspec.json.decode(line, type=Rehearsed)
            if answer.failure is not None:
                raise RosyError(Sentence(answer.failure.id, answer.failure.arguments))
            on_answer(answer)
    finally:
        process.stdin.close()
        await reap(process)
