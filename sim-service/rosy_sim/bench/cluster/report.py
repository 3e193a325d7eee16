"""
Cluster beside one machine: programs in rooms, and a class. Skipped by name where Ray or PostgreSQL is not installed.

Two busy cores (load 12 to 22), 2,000 runs: 233 s on one machine (46 ms of processor time each), 257 s on the cluster
(64 ms), 274 s with a node killed and another joining (69 ms), with the same answers. A class on a node costs -3.0 to
+0.6 % more.
"""

from __future__ import annotations

import argparse
import os

from . import classes, rooms
from .local_nodes import CLUSTER_PYTHON
from .postgresql_server import SERVERS

__all__ = ["report"]


def report(options: argparse.Namespace) -> int:
    """Print the tables; returns the exit status, 1 when a cluster's answer is not that of one machine."""
    if not CLUSTER_PYTHON.exists():
        print("  skipped: Ray is not installed; ./rosy start --cluster installs it", flush=True)
        return 0
    # What the commands say is read.
    environment = {**os.environ, "LC_ALL": "C.UTF-8"}
    agree = rooms.report(environment, options.programs, options.rooms, 1.0)
    if SERVERS:
        classes.report(environment, options.pupils, options.seconds, options.rounds)
    else:
        print("  the class is skipped: Debian's package postgresql is not installed", flush=True)
    return 0 if agree else 1
