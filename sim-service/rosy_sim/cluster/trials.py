"""
Trials on the nodes of a Ray cluster: the pool of ``./rosy run … --rooms N --cluster ADDRESS``.

The trials of a program are cut into batches, and each batch is a Ray task that takes one processor. Ray places the
tasks, also on nodes that join later, and repeats those of a node that is lost. A task runs in a process that Ray keeps
for further tasks; this process keeps a trial process with a warm, sandboxed worker of its node's own installation, and
both end with it. Outcomes are pure functions of program, room and seed, so a batch that is repeated elsewhere gives the
same.
"""

from __future__ import annotations

import io
import sys
import threading
from collections.abc import Callable, Sequence
from contextlib import ExitStack, redirect_stderr, redirect_stdout
from dataclasses import dataclass
from types import TracebackType
from typing import TextIO

import msgspec
import ray
from ray.exceptions import RayError, TaskCancelledError

from ..config import discover
from ..errors import RosyError
from ..rooms.trial_pool import PoolClosed, ProgramLost, TrialPool, Trials
from ..rooms.trial_process import Answer, Task, Trial
from ..sentences.sentence import Sentence, tr
from ..worker.background_process import WorkerSetup
from .connection import ClusterError, connect
from .version import version_resource

__all__ = ["ClusterPool"]

_BATCHES_PER_PROCESS = 4
"""Batches of a program for each processor, so that the last ones end at about the same time."""

_LARGEST_BATCH = 16
"""Trials of a batch: a few seconds, which is what a lost node costs."""

_SHARE = 0.001
"""What a task takes of the version of a node, which has 1: enough for all of its processors."""

_POLL = 0.2
"""How often a wait for outcomes looks whether the pool was closed, s."""


class _Batch(msgspec.Struct, frozen=True):
    """The answers to some trials, or why there are none."""

    answers: list[Answer]
    lost: Sentence | None = None
    failure: Sentence | None = None


class _WithoutRay(io.TextIOBase):
    """A stream of this process without what Ray's own threads write: news of lost nodes, with their logs."""

    def __init__(self, stream: TextIO) -> None:
        self._stream = stream

    def write(self, text: str) -> int:
        if threading.current_thread().name.startswith("ray_"):
            return len(text)
        return self._stream.write(text)

    def flush(self) -> None:
        self._stream.flush()


class ClusterPool:
    """A connection to a cluster; one per process, as Ray has it."""

    def __init__(self, address: str) -> None:
        """
        ``address`` is HOST:PORT of the cluster's head node.

        Raises:
            ClusterError: it is not there, no node of it runs on this machine, or none has the version of this one.
        """
        self._closed = threading.Event()
        self._streams = ExitStack()
        connect(address)
        self._version = version_resource(discover().root)
        if not self._nodes():
            ray.shutdown()
            raise ClusterError(
                tr(
                    "No node of the cluster at {address} has the Rosy of this machine. Install the same version on "
                    "all, and start their nodes again.",
                    address=address,
                )
            )
        options = {"num_cpus": 1, "max_retries": -1, "resources": {self._version: _SHARE}}
        self._try_batch = ray.remote(scheduling_strategy="SPREAD", **options)(_try_batch)

    @property
    def processes(self) -> int:
        """The processors of all nodes that are there now and have our version."""
        return max(1, int(sum(resources.get("CPU", 0) for resources in self._nodes())))

    def _nodes(self) -> list[dict[str, float]]:
        """What the nodes of our version have."""
        there = [node["Resources"] for node in ray.nodes() if node["Alive"]]
        return [resources for resources in there if self._version in resources]

    def program(self, task: Task) -> Trials:
        """The trials of one program; the program is sent to each node once."""
        # As JSON: classes of compiled modules cannot be pickled where they are frozen.
        return _ProgramTrials(self, ray.put(msgspec.json.encode(task)))

    def close(self) -> None:
        """End all trials at once, from any thread; those that wait raise ``PoolClosed``."""
        self._closed.set()

    def __enter__(self) -> ClusterPool:
        self._streams.enter_context(redirect_stdout(_WithoutRay(sys.stdout)))
        self._streams.enter_context(redirect_stderr(_WithoutRay(sys.stderr)))
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None
    ) -> None:
        self.close()
        # Ray ends the processes of what is not done, and writes news that it has held back, from this thread.
        with redirect_stdout(io.StringIO()), redirect_stderr(io.StringIO()):
            ray.shutdown()
        self._streams.close()

    def run(self, task: ray.ObjectRef, trials: Sequence[Trial], on_answer: Callable[[Answer], None]) -> list[Answer]:
        """``Trials.run`` of a task."""
        size = min(_LARGEST_BATCH, max(1, len(trials) // (_BATCHES_PER_PROCESS * self.processes)))
        batches = [list(trials[first : first + size]) for first in range(0, len(trials), size)]
        places = {self._try_batch.remote(task, batch): index for index, batch in enumerate(batches)}
        answers: list[list[Answer]] = [[] for _ in batches]
        waiting = list(places)
        try:
            while waiting:
                if self._closed.is_set():
                    raise PoolClosed
                ready, waiting = ray.wait(waiting, timeout=_POLL)
                for reference in ready:
                    answers[places[reference]] = _answers(ray.get(reference))
                    for answer in answers[places[reference]]:
                        on_answer(answer)
        except (RayError, TaskCancelledError) as error:
            raise ClusterError(tr("The cluster cannot be reached any more: {why}", why=type(error).__name__)) from error
        finally:
            for reference in waiting:
                ray.cancel(reference)
        return [answer for batch in answers for answer in batch]


@dataclass(frozen=True, slots=True)
class _ProgramTrials:
    pool: ClusterPool
    task: ray.ObjectRef

    @property
    def processes(self) -> int:
        return self.pool.processes

    def run(self, trials: Sequence[Trial], on_answer: Callable[[Answer], None] = lambda _: None) -> list[Answer]:
        return self.pool.run(self.task, trials, on_answer)


def _answers(batch: _Batch) -> list[Answer]:
    if batch.lost is not None:
        raise ProgramLost(batch.lost)
    if batch.failure is not None:
        raise RosyError(batch.failure)
    return batch.answers


_of_process: TrialPool | None = None
"""The warm trial process of a process that Ray keeps for tasks."""


def _try_batch(task: bytes, trials: list[Trial]) -> _Batch:
    """The task: trials of a program, one after another, with the worker of this node."""
    global _of_process
    if _of_process is None:
        _of_process = TrialPool(WorkerSetup.of(discover()), 1)
    try:
        return _Batch(_of_process.program(msgspec.json.decode(task, type=Task)).run(trials))
    except ProgramLost as error:
        return _Batch([], lost=error.why)
    except RosyError as error:
        return _Batch([], failure=error.sentence)
