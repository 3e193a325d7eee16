"""Programs give way: a busy one has a lower priority than the service, its worker, and the checks of others."""

from __future__ import annotations

import asyncio
import os
import socket

import pytest

from rosy_sim.config import discover
from rosy_sim.wire.worker import Started
from rosy_sim.worker.liveness import sandboxed_pid

from ..processes import below, called
from ..system.test_endurance import DRIVE, PATIENT, warm

pytestmark = [pytest.mark.real, pytest.mark.skipif(not discover().worker, reason="the worker is not built")]


def niceness(pid: int) -> int:
    """Higher gives way to lower. getpriority(2)."""
    return os.getpriority(os.PRIO_PROCESS, pid)


def test_a_program_gives_way_to_the_service_to_its_worker_and_to_checks() -> None:
    async def tell() -> None:
        async with warm(discover().with_limits(PATIENT)) as worker:
            await worker.check(DRIVE)
            assert worker.pid is not None
            parent = sandboxed_pid(worker.pid)
            checkers = below(parent)
            ours, theirs = socket.socketpair()
            with ours:
                program = await worker.start(DRIVE, theirs)
                assert isinstance(await program.started, Started)
                [running] = below(parent) - checkers
                assert {called(pid) for pid in checkers} == {"rosy-check"}
                for other in (os.getpid(), parent, *checkers):
                    assert niceness(running) > niceness(other)

    asyncio.run(tell())
