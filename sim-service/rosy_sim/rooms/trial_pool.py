"""
Pool of trial processes: tries a program in many rooms at once.

The outcomes come back in the order of the trials, whichever process was faster, so they do not depend on the number of
processes. ``close`` may be called from any thread; it ends all processes at once, and trials that wait raise
``PoolClosed``.
"""

from __future__ import annotations

import queue
import subprocess
import sys
import threading
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from types import TracebackType

import msgspec

from ..errors import RosyError, WorkerLost
from ..sentence import Sentence, verbatim
from .trial_process import Answer, Task, Trial

__all__ = ["PoolClosed", "TrialPool"]


class PoolClosed(Exception):
    """The pool was closed while trials were waiting for their outcomes."""


class TrialPool:
    """Starts a process when all others are busy, up to ``processes``."""

    def __init__(self, task: Task, processes: int) -> None:
        self._task = task
        self.processes = processes
        self._threads = ThreadPoolExecutor(max_workers=processes)
        self._idle: queue.LifoQueue[subprocess.Popen[bytes]] = queue.LifoQueue()
        self._lock = threading.Lock()
        self._all: list[subprocess.Popen[bytes]] = []
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
            for pipe in (process.stdin, process.stdout):
                assert pipe is not None
                try:
                    pipe.close()
                except BrokenPipeError:
                    # What was not read any more.
                    continue

    def close(self) -> None:
        """End all processes at once."""
        with self._lock:
            self._closed = True
            for process in self._all:
                process.kill()

    def run(self, trials: Sequence[Trial], on_answer: Callable[[Answer], None] = lambda _: None) -> list[Answer]:
        """
        The answers to some trials, in their order; ``on_answer`` is called as they come.

        Raises:
            PoolClosed: the pool was closed.
            RosyError: a process or its worker died, or could not start.
        """
        futures = [self._threads.submit(self._one, trial) for trial in trials]
        try:
            for future in as_completed(futures):
                on_answer(future.result())
        finally:
            for future in futures:
                future.cancel()
        return [future.result() for future in futures]

    def _one(self, trial: Trial) -> Answer:
        process = self._process()
        try:
            answer = self._ask(process, msgspec.json.encode(trial))
        except OSError as error:
            if self._closed:
                raise PoolClosed from error
            raise WorkerLost(str(error)) from error
        self._idle.put(process)
        if answer.failure:
            raise RosyError(_sentence(answer))
        return answer

    def _ask(self, process: subprocess.Popen[bytes], line: bytes) -> Answer:
        assert process.stdin is not None
        assert process.stdout is not None
        process.stdin.write(line + b"\n")
        process.stdin.flush()
        said = process.stdout.readline()
        if not said:
            raise ConnectionResetError("a trial process ended")
        return msgspec.json.decode(said, type=Answer)

    def _process(self) -> subprocess.Popen[bytes]:
        try:
            return self._idle.get_nowait()
        except queue.Empty:
            pass
        with self._lock:
            if self._closed:
                raise PoolClosed
            # In a session of its own: Ctrl-C in a terminal reaches only this process, which ends the others.
            process = subprocess.Popen(
                [sys.executable, "-m", "rosy_sim.rooms"],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                start_new_session=True,
            )
            self._all.append(process)
        assert process.stdin is not None
        process.stdin.write(msgspec.json.encode(self._task) + b"\n")
        return process


def _sentence(answer: Answer) -> Sentence:
    said = answer.failure_sentence
    return Sentence(said.id, said.arguments) if said is not None else verbatim(answer.failure)
