"""The machine's bare round trip: two processes that pass a message back and forth over a socket and do nothing else."""

from __future__ import annotations

import os
import socket
import statistics
import time

__all__ = ["measure", "report"]

_TRIPS = 2000
_ROUNDS = 5

_BATCH = b"x" * 260
"""As long as the batch of a step in which only the odometry is new, bytes."""


def report() -> float:
    """Print a row; answers the time, s."""
    found = measure()
    print(f"  {'bare round trip of two processes over a socket':<56} {1e6 * found:>9,.1f} µs")
    return found


def measure() -> float:
    """The time of a round trip, s: the median of several rounds."""
    ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_STREAM)
    child = os.fork()
    if child == 0:
        ours.close()
        while data := theirs.recv(65536):
            theirs.send(data[:60])
        os._exit(0)
    theirs.close()
    with ours:
        times = [_round(ours) for _ in range(_ROUNDS)]
    os.waitpid(child, 0)
    return statistics.median(times)


def _round(link: socket.socket) -> float:
    began = time.perf_counter()
    for _ in range(_TRIPS):
        link.send(_BATCH)
        link.recv(65536)
    return (time.perf_counter() - began) / _TRIPS
