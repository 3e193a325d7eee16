"""
Liveness monitor of a worker process: tells one that is wedged from one that is merely waiting for the processor.

A worker answers a ping at once, whatever it compiles. On a busy machine the answer may be late; the state of the
process and the processor time it has used tell the two cases apart.
"""

from __future__ import annotations

import psutil

__all__ = ["PROBE_INTERVAL", "LivenessMonitor", "sandboxed_pid"]

PROBE_INTERVAL = 0.15
"""Between two probes, s."""

_MAX_SILENT = 4
"""Probes without an answer, after which a worker that does nothing is wedged: it is replaced within a second."""

_MAX_SILENT_WAITING = 200
"""The same for one that waits for the processor or the disk: half a minute. A machine that is busy or stands still for
seconds must not lose all runs."""

_MAX_COMPUTED = 1.5
"""Processor time without an answer, s, after which the worker is in an endless loop. Its longest garbage collection
takes 0.2 s of an idle fast processor, and several times that of a slow one whose caches are shared."""

_STOPPED = (psutil.STATUS_STOPPED, psutil.STATUS_TRACING_STOP)


class LivenessMonitor:
    """Of one worker process: call record_activity() for each answer, and probe() or probe_stopped() at intervals."""

    def __init__(self, pid: int) -> None:
        self._pid = pid
        # Whether _pid is already the process inside of the sandbox: finding it reads the whole process table.
        self._is_inside = False
        # Probes since the last answer, and the processor time at the first of them, s.
        self._silent = 0
        self._computed = 0.0
        # Successive probes that found the process stopped.
        self._stopped = 0

    def record_activity(self) -> None:
        """The worker has answered."""
        self._silent = 0

    def probe(self) -> bool:
        """Whether the worker is wedged."""
        status, computed = self._process_state()
        if self._silent == 0:
            self._computed = computed
        self._silent += 1
        if status == psutil.STATUS_RUNNING:
            loops = self._silent > _MAX_SILENT and computed - self._computed >= _MAX_COMPUTED
            return loops or self._silent > _MAX_SILENT_WAITING
        return self._silent > (_MAX_SILENT_WAITING if status == psutil.STATUS_DISK_SLEEP else _MAX_SILENT)

    def probe_stopped(self) -> bool:
        """Whether a worker that is not warm yet, and so cannot answer, has been stopped by a signal."""
        status, _ = self._process_state()
        self._stopped = self._stopped + 1 if status in _STOPPED else 0
        return self._stopped >= _MAX_SILENT

    def _process_state(self) -> tuple[str, float]:
        """The status of the process, and the processor time it has used, s."""
        if not self._is_inside:
            inside = sandboxed_pid(self._pid)
            self._is_inside = inside != self._pid
            self._pid = inside
        try:
            process = psutil.Process(self._pid)
            times = process.cpu_times()
            return process.status(), times.user + times.system
        except psutil.Error:
            return psutil.STATUS_DEAD, 0.0


def sandboxed_pid(pid: int) -> int:
    """The process inside of the sandbox that ``pid`` may be."""
    try:
        process = psutil.Process(pid)
        while process.name() == "bwrap":
            process = process.children()[0]
    except (psutil.Error, IndexError):
        return pid
    return int(process.pid)
