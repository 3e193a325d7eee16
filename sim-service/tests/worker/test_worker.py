"""Keeping a worker: restarts, a fork server, a missing executable, requests in flight when it dies."""

from __future__ import annotations

import asyncio
import os
import signal
import socket
from collections.abc import Awaitable, Callable
from dataclasses import replace
from pathlib import Path

import psutil
import pytest

from rosy_sim.config import Config
from rosy_sim.errors import WorkerFailed, WorkerLost, WorkerMissing
from rosy_sim.wire.worker import Gone, Refused, Started
from rosy_sim.worker.blocking_worker import BlockingWorker
from rosy_sim.worker.launcher import launch
from rosy_sim.worker.supervisor import WorkerStatus, WorkerSupervisor

from ..conftest import PATIENCE


class States(list[WorkerStatus]):
    """What the supervisor has told, in order."""

    def __init__(self) -> None:
        super().__init__()
        self._told = asyncio.Event()

    def tell(self, status: WorkerStatus) -> None:
        self.append(status)
        self._told.set()

    async def reach(self, *states: WorkerStatus) -> None:
        """Until it has told these, first of all."""
        while self[: len(states)] != list(states):
            self._told.clear()
            await self._told.wait()


def keeping(play: Callable[[WorkerSupervisor, States], Awaitable[None]], config: Config) -> None:
    """Keep a worker while a story is told; afterwards nothing of it is left."""
    states = States()

    async def tell() -> None:
        worker = WorkerSupervisor(config, states.tell)
        keeper = asyncio.create_task(worker.run())
        try:
            async with asyncio.timeout(PATIENCE):
                await play(worker, states)
        finally:
            keeper.cancel()
            await asyncio.gather(keeper, return_exceptions=True)

    before = children()
    asyncio.run(tell())
    assert children() <= before


def children() -> set[str]:
    return set(Path(f"/proc/self/task/{os.getpid()}/children").read_text().split())


def test_checks_come_home_by_id(config: Config) -> None:
    async def play(worker: WorkerSupervisor, _: list[WorkerStatus]) -> None:
        answers = await asyncio.gather(*[worker.check("refuse" if i % 2 else "") for i in range(20)])
        assert [len(answer.problems) for answer in answers] == [i % 2 for i in range(20)]

    keeping(play, config)


def test_a_run_is_started_or_refused_and_its_end_is_known(config: Config) -> None:
    async def play(worker: WorkerSupervisor, _: list[WorkerStatus]) -> None:
        ours, theirs = socket.socketpair()
        with ours:
            program = await worker.start("drive:0.5", theirs)
            assert isinstance(await program.started, Started)
            worker.kill(program)
            assert (await program.gone).signal == signal.SIGKILL
        ours, theirs = socket.socketpair()
        with ours:
            program = await worker.start("refuse", theirs)
            assert isinstance(await program.started, Refused)
            assert isinstance(await program.gone, Gone)

    keeping(play, config)


def test_what_is_under_way_ends_with_the_worker_and_the_next_one_serves(config: Config) -> None:
    async def play(worker: WorkerSupervisor, states: States) -> None:
        for _ in range(5):
            await worker.check("")
            waiting = asyncio.create_task(worker.check("slow"))
            ours, theirs = socket.socketpair()
            program = await worker.start("slow", theirs)
            assert worker.pid is not None
            os.kill(worker.pid, signal.SIGKILL)
            for future in (waiting, program.started, program.gone):
                with pytest.raises(WorkerLost):
                    await future
            ours.close()
        await worker.check("")
        assert states == ["ready"] + ["restarting", "ready"] * 5

    keeping(play, config)


def test_a_worker_that_dies_is_replaced_by_one_that_shares_the_memory_of_the_same_fork_server(config: Config) -> None:
    async def play(worker: WorkerSupervisor, _: list[WorkerStatus]) -> None:
        await worker.check("")
        first, server = worker.pid, worker.fork_server_pid
        assert first is not None
        assert server is not None
        waiting = asyncio.create_task(worker.check("slow"))
        os.kill(first, signal.SIGKILL)
        with pytest.raises(WorkerLost):
            await waiting
        await worker.check("")
        assert worker.fork_server_pid == server
        assert worker.pid is not None
        assert psutil.Process(worker.pid).ppid() == server

    keeping(play, config)


@pytest.mark.parametrize("how", [signal.SIGKILL, signal.SIGSTOP])
def test_a_fork_server_that_is_lost_is_replaced_when_it_is_needed(how: signal.Signals, config: Config) -> None:
    async def play(worker: WorkerSupervisor, states: States) -> None:
        await worker.check("")
        first, server = worker.pid, worker.fork_server_pid
        assert first is not None
        assert server is not None
        os.kill(server, how)
        if how == signal.SIGSTOP:
            # Nothing is asked of it while its worker lives.
            await worker.check("")
            assert states == ["ready"]
            os.kill(first, signal.SIGKILL)
        await states.reach("ready", "restarting", "ready")
        assert worker.pid not in (None, first)
        await worker.check("")
        assert worker.fork_server_pid not in (None, server)
        assert states == ["ready", "restarting", "ready"]

    keeping(play, config)


def test_a_worker_that_is_stopped_before_it_is_warm_is_replaced(config: Config) -> None:
    async def play(worker: WorkerSupervisor, _: list[WorkerStatus]) -> None:
        while (first := worker.fork_server_pid) is None:
            await asyncio.sleep(0)
        os.kill(first, signal.SIGSTOP)
        await worker.check("")
        assert worker.fork_server_pid != first

    keeping(play, config)


@pytest.mark.parametrize("how", ["stopped", "running in circles"])
def test_a_wedged_worker_is_replaced(config: Config, how: str) -> None:
    async def play(worker: WorkerSupervisor, states: States) -> None:
        await worker.check("")
        ours, theirs = socket.socketpair()
        program = await worker.start("slow", theirs)
        wedged = worker.pid
        assert wedged is not None
        if how == "stopped":
            os.kill(wedged, signal.SIGSTOP)
            waiting = asyncio.create_task(worker.check(""))
        else:
            waiting = asyncio.create_task(worker.check("hang"))
        for future in (waiting, program.gone):
            with pytest.raises(WorkerLost):
                await future
        ours.close()
        await worker.check("")
        assert worker.pid != wedged
        assert states == ["ready", "restarting", "ready"]

    keeping(play, config)


def test_a_worker_that_has_little_to_do_is_left_alone(config: Config) -> None:
    async def play(worker: WorkerSupervisor, states: States) -> None:
        await worker.check("")
        first, looks = worker.pid, 0
        loop, looked = asyncio.get_running_loop(), asyncio.Event()
        assert worker._connection is not None
        liveness = worker._connection.liveness
        probe = liveness.probe

        def counted() -> bool:
            nonlocal looks
            looks += 1
            if looks == 10:
                loop.call_soon_threadsafe(looked.set)
            return probe()

        liveness.probe = counted  # type: ignore[method-assign]
        await looked.wait()
        assert (worker.pid, states) == (first, ["ready"])

    keeping(play, config)


def test_a_worker_that_vanishes_is_waited_for(config: Config, tmp_path: Path) -> None:
    executable = tmp_path / "worker"

    async def play(worker: WorkerSupervisor, states: States) -> None:
        await states.reach("failed")
        executable.write_text(f'#!/bin/sh\nexec "{config.worker[0]}" "{config.worker[1]}"\n')
        executable.chmod(0o755)
        await states.reach("failed", "ready")
        await worker.check("")

    keeping(play, replace(config, worker=(str(executable),)))
    executable.unlink()
    with pytest.raises(WorkerMissing):
        launch(replace(config, worker=(str(executable),)))


@pytest.mark.parametrize(
    ("script", "cause"),
    [
        ("echo 'rosy-worker: missing\n    dependencies: aeson' >&2; exit 1", "missing dependencies: aeson"),
        ("yes a library is missing >&2; exit 1", "a library is missing a library is missing"),
        ("exit 1", "it ended before it was ready"),
    ],
)
def test_a_worker_that_cannot_start_is_reported_once_with_its_cause_and_requests_are_refused_with_it(
    config: Config, tmp_path: Path, script: str, cause: str, caplog: pytest.LogCaptureFixture
) -> None:
    executable = tmp_path / "worker"
    executable.write_text(f"#!/bin/sh\necho >>'{tmp_path}/starts'\n{script}\n")
    executable.chmod(0o755)
    broken = replace(config, worker=(str(executable),))

    async def play(worker: WorkerSupervisor, states: States) -> None:
        ours, theirs = socket.socketpair()
        with ours:
            for request in (worker.check(""), worker.start("", theirs), worker.wait_ready()):
                with pytest.raises(WorkerFailed) as refused:
                    await request
                assert cause in str(refused.value)
                assert len(str(refused.value)) < 500
        while (tmp_path / "starts").read_text().count("\n") < 5:
            await asyncio.sleep(0)
        assert states == ["failed"]

    keeping(play, broken)
    assert [cause in line for line in caplog.messages] == [True]
    with BlockingWorker(broken) as worker, pytest.raises(WorkerFailed) as refused:
        worker.ready()
    assert cause in str(refused.value)


def test_a_cancelled_check_is_taken_back(config: Config) -> None:
    async def play(worker: WorkerSupervisor, _: list[WorkerStatus]) -> None:
        await worker.check("")
        waiting = asyncio.create_task(worker.check("slow"))
        await asyncio.sleep(0)
        await asyncio.sleep(0)
        waiting.cancel()
        await asyncio.gather(waiting, return_exceptions=True)
        assert not worker._questions
        await worker.check("")

    keeping(play, config)


def test_descriptors_do_not_leak(config: Config) -> None:
    def count() -> int:
        return len(os.listdir("/proc/self/fd"))

    with BlockingWorker(config) as worker:
        worker.ready()
        before = count()
        for _ in range(30):
            ours, theirs = socket.socketpair()
            with ours:
                worker.run("refuse", theirs)
        assert count() == before
