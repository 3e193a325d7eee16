"""
Scheduler that runs suites side by side on a fixed number of processor cores.

In: suites in the order of their importance, each with the number of cores it keeps busy. Out: one result per suite, in the
order in which they end, handed to `on_end`. A suite starts as soon as the cores it needs are free; a later one that needs
fewer cores may start first. A suite that needs more cores than there are runs alone. Half a core is for a suite that waits
for half of its time. A suite in the background has a low priority: it takes the processor time that the others leave, so one
of them per core runs at any time beside any others. Each suite writes to its own log file; nothing is printed here.
A suite that takes longer than its limit is ended and has failed: what it has said until then is in its result. When the caller is
interrupted or told to terminate, every process that was started is ended.
"""

from __future__ import annotations

import math
import os
import queue
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from .adoption import BACKGROUND
from .counts import Count, Reader

__all__ = ["Result", "Suite", "run_all"]

ADOPTION = Path(__file__).with_name("adoption.py")


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
    """Processor time of the suite and of all that it started, detached processes as well, user and system, s."""
    output: str


@dataclass
class _Running:
    suite: Suite
    process: subprocess.Popen[bytes]
    log: Path
    began: float = field(default_factory=time.monotonic)
    ending: threading.Thread | None = None
    """Ends the suite, since it has taken longer than its limit."""

    def enforce_limit(self) -> None:
        if self.ending is None and time.monotonic() - self.began > self.suite.limit:
            self.ending = threading.Thread(target=_end, args=(self.process,), daemon=True)
            self.ending.start()

    def result(self, end: _Ended) -> Result:
        output = self.log.read_text(errors="replace")
        count = self.suite.read(output, end.status)
        if self.ending is not None:
            output += f"\nEnded because it took longer than {self.suite.limit / 60:g} minutes.\n"
            count = Count(count.passed, max(count.failed, 1), count.skipped)
        return Result(self.suite, count, time.monotonic() - self.began, end.computing, output)


@dataclass(frozen=True)
class _Ended:
    status: int
    computing: float


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
    ended: queue.SimpleQueue[tuple[str, _Ended]] = queue.SimpleQueue()
    terminate = signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        while waiting or running:
            for suite in [s for s in waiting if _may_start(s, waiting, running, cores)]:
                # Checked again: the one before may have taken the cores.
                if not _may_start(suite, waiting, running, cores):
                    continue
                waiting.remove(suite)
                running[suite.name] = _start(suite, folder, logs, environment, ended)
            on_change(list(running))
            for started in running.values():
                started.enforce_limit()
            try:
                name, end = ended.get(timeout=1)
            except queue.Empty:
                continue
            on_end(running.pop(name).result(end))
    finally:
        for left in running.values():
            _end(left.process)
        signal.signal(signal.SIGTERM, terminate)


def _may_start(suite: Suite, waiting: Sequence[Suite], running: Mapping[str, _Running], cores: float) -> bool:
    pending = {s.name for s in waiting} | set(running)
    if suite.after & pending:
        return False
    beside = [r.suite for r in running.values()]
    behind = sum(other.cores for other in beside if other.background)
    if suite.background and (behind == 0 or behind + suite.cores <= cores):
        return True
    # A suite in the background gives way to one that is not.
    busy = sum(min(other.cores, cores) for other in beside if suite.background or not other.background)
    return busy + min(suite.cores, cores) <= cores


def _start(suite: Suite, folder: Path, logs: Path, environment: Mapping[str, str], ended: queue.SimpleQueue[tuple[str, _Ended]]) -> _Running:
    if suite.report is not None:
        suite.report.parent.mkdir(parents=True, exist_ok=True)
        suite.report.unlink(missing_ok=True)
    log = logs / f"test-{suite.name}.log"
    with log.open("wb") as output:
        process = subprocess.Popen(
            [sys.executable, str(ADOPTION), *([BACKGROUND] if suite.background else []), *suite.command],
            cwd=folder,
            env=environment,
            stdin=subprocess.DEVNULL,
            stdout=output,
            stderr=subprocess.STDOUT,
            # A group of its own, so that an interruption also reaches what the suite has started.
            start_new_session=True,
        )
    threading.Thread(target=lambda: ended.put((suite.name, _wait(process))), daemon=True).start()
    return _Running(suite, process, log)


def _wait(process: subprocess.Popen[bytes]) -> _Ended:
    """Waits like `process.wait()`, and reads what the kernel has counted."""
    try:
        _, status, usage = os.wait4(process.pid, 0)
    except ChildProcessError:
        # An interruption has ended it.
        return _Ended(process.wait(), 0.0)
    process.returncode = os.waitstatus_to_exitcode(status)
    return _Ended(process.returncode, usage.ru_utime + usage.ru_stime)


def _end(process: subprocess.Popen[bytes]) -> None:
    try:
        os.killpg(process.pid, signal.SIGTERM)
    except ProcessLookupError:
        return
    try:
        process.wait(10)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
