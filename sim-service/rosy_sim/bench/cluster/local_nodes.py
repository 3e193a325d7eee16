"""
Nodes of a Ray cluster for benchmarks and tests: all on this machine, each started by the command.
"""

from __future__ import annotations

import contextlib
import os
import random
import shutil
import signal
import socket
import subprocess
from collections.abc import Mapping
from pathlib import Path
from types import TracebackType

import psutil

__all__ = ["CLUSTER_PYTHON", "Node", "cluster_command"]

CLUSTER_PYTHON = Path(__file__).resolve().parents[4] / ".rosy" / "venv-cluster" / "bin" / "python"

_PORTS = range(20_000, 32_000)
"""Of heads: Ray keeps 10002 to 19999 for the processes of its tasks, and outgoing connections are given higher ones."""


def cluster_command(*arguments: object) -> list[str]:
    """A command of the project in the environment that has Ray."""
    return [str(CLUSTER_PYTHON), "-m", "rosy_sim", *map(str, arguments)]


_PATIENCE = 240.0
"""For a node that is to end, s."""


class Node:
    """A node: the head of a new cluster, or one that joins."""

    def __init__(self, environment: Mapping[str, str], head: Node | None = None, processes: int = 1) -> None:
        place = ["--cluster", head.address] if head is not None else ["--cluster", "--port", str(_free_port())]
        command = cluster_command("node", "--host", "127.0.0.1", "--processes", processes, *place)
        self._process = subprocess.Popen(command, env=dict(environment), stdout=subprocess.PIPE, text=True)
        assert self._process.stdout is not None
        self._was_killed = False
        said = self._process.stdout.readline()
        if not said:
            raise RuntimeError(f"the node ended with status {self._process.wait(_PATIENCE)}")
        self.address: str = head.address if head is not None else said.split()[4].rstrip(".")

    def __enter__(self) -> Node:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None
    ) -> None:
        processes = self.processes()
        self._process.send_signal(signal.SIGINT)
        self._process.wait(_PATIENCE)
        while left := {pid for pid in processes if psutil.pid_exists(pid)}:
            for pid in left:
                # Ray ends the rest of a node that was killed by and by.
                _kill(pid)
            os.sched_yield()
        if self._was_killed:
            # It keeps Ray's logs after a fault.
            for folder in Path("/tmp").glob(f"rosy-ray-{self.pid}-*"):
                shutil.rmtree(folder, ignore_errors=True)
        assert self._process.stdout is not None
        self._process.stdout.close()

    @property
    def pid(self) -> int:
        """The command, above everything of the node."""
        return self._process.pid

    def processes(self) -> set[int]:
        """Everything of the node."""
        with contextlib.suppress(psutil.NoSuchProcess):
            return {process.pid for process in psutil.Process(self._process.pid).children(recursive=True)}
        return set()

    def running(self, *words: str) -> set[int]:
        """Those of its processes whose command has these words after the name of the interpreter."""
        return {pid for pid in self.processes() if _command(pid)[1 : 1 + len(words)] == list(words)}

    def trial_processes(self) -> set[int]:
        """Those that run programs for a test in many rooms."""
        return self.running("-m", "rosy_sim.rooms")

    def class_services(self, name: str) -> set[int]:
        """Those that serve a class."""
        return self.running("-m", "rosy_sim.cluster.class_service", name)

    def kill(self) -> None:
        """Lose the node: all of its processes end in this moment."""
        self._was_killed = True
        for pid in self.processes():
            _kill(pid)


def _command(pid: int) -> list[str]:
    with contextlib.suppress(psutil.NoSuchProcess, psutil.ZombieProcess):
        return list(psutil.Process(pid).cmdline())
    return []


def _free_port() -> int:
    while True:
        port = random.choice(_PORTS)
        with contextlib.suppress(OSError), socket.create_server(("127.0.0.1", port)):
            return port


def _kill(pid: int) -> None:
    with contextlib.suppress(ProcessLookupError):
        os.kill(pid, signal.SIGKILL)
