"""
Scheduler that runs suites side by side on a fixed number of processor cores.

In: suites in the order in which they should start, each with the number of cores it keeps busy. Out: one result per suite, in the
order in which they end, handed to `on_end`. A suite starts as soon as the cores it needs are free; one that needs more than
there are runs alone. A suite in the background has a low priority and takes no place of the others; one of them runs at a time. Each suite
writes to its own log file. A suite that takes longer than its limit is ended and has failed. When the caller is interrupted or told
to terminate, every process that was started is ended.
"""

from __future__ import annotations

import math
import os
import queue
import signal
import subprocess
import threading
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from .counts import Count, Reader

__all__ = ["BACKGROUND_NICE", "Result", "Suite", "run_all"]

BACKGROUND_NICE = 10
"""Nice value of the background: a tenth of the share of others where they want all of a processor, so that no test in it waits for its limit of time."""


@dataclass(frozen=True)
class Suite:
    """A command and a way to read its counts."""

    name: str
    command: Sequence[str]
    read: Reader
    cores: float = 1
    """Processor time that it takes while it runs, s per s."""
    background: bool = False
    """Whether it only computes: nothing in it depends on how soon something is answered."""
    report: Path | None = None
    """Removed before the suite starts, so that an old report is never read."""
    after: frozenset[str] = frozenset()
    """Suites that must end first, if they take part at all."""
    prints: bool = True
    """Whether the output is worth reading when nothing failed."""
    limit: float = math.inf
    """Wall-clock time after which it is ended, s. A test that waits for ever would otherwise hide the results of all others."""


@dataclass(frozen=True)
class Result:
    suite: Suite
    count: Count
    seconds: float
    """Wall-clock time, s."""
    computing: float
    """Processor time of the suite and of what it has waited for, user and system, s."""
    output: str


@dataclass
class _Running:
    suite: Suite
    process: subprocess.Popen[bytes]
    log: Path
    began: float = field(default_factory=time.monotonic)
    late: bool = False
    """Whether it was ended since it has taken longer than its limit."""

    def result(self, status: int, computing: float) -> Result:
        output = self.log.read_text(errors="replace")
        count = self.suite.read(output, status)
        if self.late:
            output += f"\nEnded because it took longer than {self.suite.limit / 60:g} minutes.\n"
            count = Count(count.passed, max(count.failed, 1), count.skipped, count.reasons)
        return Result(self.suite, count, time.monotonic() - self.began, computing, output)


def run_all(
    suites: Sequence[Suite],
    cores: float,
    folder: Path,
    logs: Path,
    environment: Mapping[str, str],
    on_change: Callable[[Sequence[str]], None],
    on_end: Callable[[Result], None],
) -> None:
    """
    Runs all suites; in the main thread. `on_change` gets the names of the running suites once per second and after every start or end.
    SIGTERM raises KeyboardInterrupt, as SIGINT does.
    """
    waiting = list(suites)
    running: dict[str, _Running] = {}
    ended: queue.SimpleQueue[tuple[str, int, float]] = queue.SimpleQueue()
    terminate = signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        while waiting or running:
            for suite in list(waiting):
                if _may_start(suite, waiting, running, cores):
                    waiting.remove(suite)
                    running[suite.name] = _start(suite, folder, logs, environment, ended)
            on_change(list(running))
            for started in running.values():
                if not started.late and time.monotonic() - started.began > started.suite.limit:
                    started.late = True
                    threading.Thread(target=_end, args=(started.process,), daemon=True).start()
            try:
                name, status, computing = ended.get(timeout=1)
            except queue.Empty:
                continue
            on_end(running.pop(name).result(status, computing))
    finally:
        for left in running.values():
            _end(left.process)
        signal.signal(signal.SIGTERM, terminate)


def _may_start(suite: Suite, waiting: Sequence[Suite], running: Mapping[str, _Running], cores: float) -> bool:
    if suite.after & ({s.name for s in waiting} | set(running)):
        return False
    beside = [r.suite for r in running.values() if r.suite.background == suite.background]
    if suite.background:
        return not beside
    return sum(min(other.cores, cores) for other in beside) + min(suite.cores, cores) <= cores


def _start(suite: Suite, folder: Path, logs: Path, environment: Mapping[str, str], ended: queue.SimpleQueue[tuple[str, int, float]]) -> _Running:
    if suite.report is not None:
        suite.report.parent.mkdir(parents=True, exist_ok=True)
        suite.report.unlink(missing_ok=True)
    log = logs / f"test-{suite.name}.log"
    with log.open("wb") as output:
        process = subprocess.Popen(
            [*(["nice", "-n", str(BACKGROUND_NICE)] if suite.background else []), *suite.command],
            cwd=folder,
            env=environment,
            stdin=subprocess.DEVNULL,
            stdout=output,
            stderr=subprocess.STDOUT,
            # A group of its own, so that an interruption also reaches what the suite has started.
            start_new_session=True,
        )
    threading.Thread(target=lambda: ended.put((suite.name, *_wait(process))), daemon=True).start()
    return _Running(suite, process, log)


def _wait(process: subprocess.Popen[bytes]) -> tuple[int, float]:
    """Waits like `process.wait()`, and reads the processor time that the kernel has counted."""
    try:
        _, status, usage = os.wait4(process.pid, 0)
    except ChildProcessError:
        # An interruption has ended it.
        return process.wait(), 0.0
    process.returncode = os.waitstatus_to_exitcode(status)
    return process.returncode, usage.ru_utime + usage.ru_stime


def _end(process: subprocess.Popen[bytes]) -> None:
    try:
        os.killpg(process.pid, signal.SIGTERM)
    except ProcessLookupError:
        return
    try:
        process.wait(10)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
