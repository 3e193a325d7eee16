"""Rehearsals beside an event loop, in a process of the lowest priority: live pages keep their pace."""

from __future__ import annotations

import asyncio
import sys
from collections.abc import Callable
from typing import Any

import msgspec

from ..config import Config
from ..errors import RosyError, WorkerLost
from ..sentence import Sentence
from .rehearsal_process import Rehearsals, Rehearsed, RehearsedAttempt

__all__ = ["rehearse_in_background"]

_LOWEST_PRIORITY = 19
"""Of a process; ``nice``(2)."""

_PATIENCE = 5.0
"""How many times longer rehearsals may take than runs: at the lowest priority they wait for everything else."""

_MAX_LINE = 16 * 1024 * 1024
"""Of an answer, bytes: the problems of a program quote it."""


async def rehearse_in_background(
    config: Config, world: dict[str, Any], attempts: list[RehearsedAttempt], on_answer: Callable[[Rehearsed], None]
) -> None:
    """
    Run all attempts; ``on_answer`` is called after each, in their order. Cancellation ends the process.

    Raises:
        RosyError: the process or its worker died, or could not start.
    """
    patient = config.limits.stretched(_PATIENCE)
    visible = [str(folder) for folder in config.visible]
    task = Rehearsals(world, attempts, config.worker, config.sandbox, visible, patient, _LOWEST_PRIORITY)
    process = await asyncio.create_subprocess_exec(
        sys.executable,
        "-m",
        "rosy_sim.lessons",
        stdin=asyncio.subprocess.PIPE,
        stdout=asyncio.subprocess.PIPE,
        # In a session of its own: Ctrl-C in a terminal reaches only the service, which ends it.
        start_new_session=True,
        limit=_MAX_LINE,
    )
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
        await process.wait()
