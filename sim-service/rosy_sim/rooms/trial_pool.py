"""
Pool of trial processes: tries programs in many rooms at once.

The outcomes come back in the order of the trials, whichever process was faster, so they do not depend on the number of
processes. A trial in which the worker is lost is repeated once, in another process. ``close`` may be called from any
thread; it ends all processes at once, and trials that wait raise ``PoolClosed``.
"""

from __future__ import annotations

import queue
import subprocess
import sys
import threading
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import dataclass
from types import TracebackType
from typing import Protocol

import msgspec

from ..errors import RosyError, WorkerLost
from ..sentences.sentence import Sentence, verbatim
from ..wire.problem import to_wire
from ..worker.background_process import WorkerSetup
from .trial_process import Answer, Request, Task, Trial

__all__ = ["PoolClosed", "ProgramLost", "TrialPool", "Trials"]

OnAnswer = Callable[[Answer], None]


class PoolClosed(Exception):
    """The pool was closed while trials were waiting for their outcomes."""


class ProgramLost(Exception):
    """A program ended the worker in a trial, and again when the trial was repeated."""

    def __init__(self, why: Sentence) -> None:
        super().__init__(why)
        self.why = why


class Trials(Protocol):
    """The trials of one program, on this machine or on others."""

    @property
    def processes(self) -> int:
        """How many rooms are tried at once."""

    def run(self, trials: Sequence[Trial], on_answer: OnAnswer = ...) -> list[Answer]:
        """
        The answers to some trials, in their order; ``on_answer`` is called as they come.

        Raises:
            PoolClosed: the pool was closed.
            ProgramLost: the program ended the worker twice.
            RosyError: a worker could not start.
        """


class _Process:
    """A trial process and the task that it has."""

    def __init__(self, setup: WorkerSetup) -> None:
        # In a session of its own: Ctrl-C in a terminal reaches only this process, which ends the others.
        self.popen = subprocess.Popen(
            [sys.executable, "-m", "rosy_sim.rooms"],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            start_new_session=True,
        )
        self._task: Task | None = None
        assert self.popen.stdin is not None
        assert self.popen.stdout is not None
        self._input, self._output = self.popen.stdin, self.popen.stdout
        self._input.write(msgspec.json.encode(setup) + b"\n")

    def ask(self, task: Task, trial: Trial) -> Answer:
        """Raises OSError when the process has ended."""
        request = Request(trial, None if task is self._task else task)
        self._task = task
        self._input.write(msgspec.json.encode(request) + b"\n")
        self._input.flush()
        said = self._output.readline()
        if not said:
            raise ConnectionResetError("a trial process ended")
        return msgspec.json.decode(said, type=Answer)

    def wait(self) -> None:
        """Wait for its end, and close its pipes."""
        self.popen.wait()
        for pipe in (self._input, self._output):
            try:
                pipe.close()
            except BrokenPipeError:
                # What was not read any more.
                continue


class TrialPool:
    """Starts a process when all others are busy, up to ``processes``; each serves the trials of any program."""

    def __init__(self, setup: WorkerSetup, processes: int) -> None:
        self._setup = setup
        self.processes = processes
        self._threads = ThreadPoolExecutor(max_workers=processes)
        self._idle: queue.LifoQueue[_Process] = queue.LifoQueue()
        self._lock = threading.Lock()
        self._all: list[_Process] = []
        self._closed = False

    def __enter__(self) -> TrialPool:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None
    ) -> None:
        self.close()
        self._threads.shutdown(cancel_futures=True)
        for process in self._all:
            process.wait()

    def close(self) -> None:
        """End all processes at once."""
        with self._lock:
            self._closed = True
            for process in self._all:
                process.popen.kill()

    def program(self, task: Task) -> Trials:
        """The trials of one program."""
        return _ProgramTrials(self, task)

    def run(self, task: Task, trials: Sequence[Trial], on_answer: OnAnswer) -> list[Answer]:
        """``Trials.run`` of a task."""
        futures = [self._threads.submit(self._one, task, trial) for trial in trials]
        try:
            for future in as_completed(futures):
                on_answer(future.result())
        finally:
            for future in futures:
                future.cancel()
        return [future.result() for future in futures]

    def _one(self, task: Task, trial: Trial) -> Answer:
        answer = self._try(task, trial)
        if answer.failure and answer.was_ready:
            answer = self._try(task, trial)
            if answer.failure and answer.was_ready:
                raise ProgramLost(_sentence(answer))
        if answer.failure:
            raise RosyError(_sentence(answer))
        return answer

    def _try(self, task: Task, trial: Trial) -> Answer:
        process = self._process()
        try:
            answer = process.ask(task, trial)
        except OSError as error:
            if self._closed:
                raise PoolClosed from error
            lost = WorkerLost(str(error))
            return Answer(was_ready=True, failure=str(lost), failure_sentence=to_wire(lost.sentence))
        if not answer.failure:
            self._idle.put(process)
        return answer

    def _process(self) -> _Process:
        try:
            return self._idle.get_nowait()
        except queue.Empty:
            pass
        with self._lock:
            if self._closed:
                raise PoolClosed
            process = _Process(self._setup)
            self._all.append(process)
        return process


@dataclass(frozen=True, slots=True)
class _ProgramTrials:
    pool: TrialPool
    task: Task

    @property
    def processes(self) -> int:
        return self.pool.processes

    def run(self, trials: Sequence[Trial], on_answer: OnAnswer = lambda _: None) -> list[Answer]:
        return self.pool.run(self.task, trials, on_answer)


def _sentence(answer: Answer) -> Sentence:
    said = answer.failure_sentence
    return Sentence(said.id, said.arguments) if said is not None else verbatim(answer.failure)
