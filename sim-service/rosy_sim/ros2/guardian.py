"""
Guardian of a bridge: a process that stops the robot when the bridge ends or stands still.

In, on standard input: heartbeats, lines that are empty, and lines ``TOPIC TYPE``, each naming a velocity topic of DDS
and its type as ROS has it. Out: ``ready`` on standard output after each of these; zero on all these topics after 0.6 s
without a heartbeat, again every 0.1 s until one comes, and for a second when the input ends. It enters the
domain itself, because a bridge that stands still says nothing.
Arguments: domain and address, which may be empty.
"""

from __future__ import annotations

import os
import select
import signal
import sys
import time

from ..boot_clock import boot_seconds
from .transports.dds_messages import from_json
from .transports.graph import Quality
from .transports.open_transport import open_transport
from .transports.transport import Writer
from .velocity_watch import MAX_REPEATS, REPEAT, STOPPED, VelocityWatch, as_type

__all__: list[str] = []

_IGNORED = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT, signal.SIGTSTP)
"""By which a terminal or a shell ends or suspends programs; it ends with the bridge."""


def _stop(writers: dict[tuple[str, str], Writer]) -> None:
    seconds, nanoseconds = divmod(time.time_ns(), 10**9)
    for (_, kind), writer in writers.items():
        writer.write(from_json(kind, as_type(STOPPED, kind), lambda: (seconds, nanoseconds)))


def _main(domain: int, address: str | None) -> None:
    for number in _IGNORED:
        signal.signal(number, signal.SIG_IGN)
    transport = open_transport(domain, address)
    writers: dict[tuple[str, str], Writer] = {}
    watch = VelocityWatch(boot_seconds())
    rest = b""
    while True:
        ready, _, _ = select.select([0], [], [], watch.wait(boot_seconds()))
        if not ready:
            if watch.due(boot_seconds()):
                _stop(writers)
            continue
        text = os.read(0, 65536)
        if not text:
            break
        *lines, rest = (rest + text).split(b"\n")
        if watch.heard(boot_seconds()):
            _stop(writers)
        for line in filter(None, lines):
            topic, kind = line.decode().split()
            if (topic, kind) not in writers:
                writers[topic, kind] = transport.writer(topic, kind, Quality(True, False))
            print("ready", flush=True)
    for _ in range(MAX_REPEATS):
        # A robot that reads with best effort may miss one.
        _stop(writers)
        time.sleep(REPEAT)
    for writer in writers.values():
        writer.flush()
    transport.close()


if __name__ == "__main__":
    _main(int(sys.argv[1]), sys.argv[2] or None)
