"""Nodes of a Ray cluster, all on this machine, started by the command."""

from __future__ import annotations

import os
import signal
import subprocess
from pathlib import Path
from types import TracebackType

import pytest

from ..conftest import PATIENCE
from ..ports import kept_port
from ..processes import alive, below, command_of

__all__ = ["CLUSTER_PYTHON", "Node", "needs_ray"]

CLUSTER_PYTHON = Path(__file__).resolve().parents[3] / ".rosy" / "venv-cluster" / "bin" / "python"

needs_ray = pytest.mark.skipif(
    not CLUSTER_PYTHON.exists(), reason="cluster: Ray is not installed; ./rosy start --cluster installs it"
)


class Node:
    """A node with one processor: the head of a new cluster, or one that joins."""

    def __init__(self, environment: dict[str, str], head: Node | None = None, processes: int = 1) -> None:
        command = [str(CLUSTER_PYTHON), "-m", "rosy_sim", "node", "--host", "127.0.0.1", "--processes", str(processes)]
        command += ["--cluster", head.address] if head is not None else ["--cluster", "--port", str(_head_port())]
        self._process = subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, text=True)
        assert self._process.stdout is not None
        said = self._process.stdout.readline()
        assert said, f"the node ended with status {self._process.wait(PATIENCE)}"
        self.address: str = head.address if head is not None else said.split()[4].rstrip(".")

    def __enter__(self) -> Node:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None
    ) -> None:
        processes = self.processes()
        self._process.send_signal(signal.SIGINT)
        self._process.wait(PATIENCE)
        while left := alive(processes):
            for pid in left:
                # Ray ends the rest of a node that was killed by and by.
                _kill(pid)
            os.sched_yield()
        assert self._process.stdout is not None
        self._process.stdout.close()

    def processes(self) -> set[int]:
        """Everything of the node."""
        return below(self._process.pid)

    def trial_processes(self) -> set[int]:
        """Those that run programs for a test in many rooms."""
        return {pid for pid in self.processes() if command_of(pid)[-2:] == ["-m", "rosy_sim.rooms"]}

    def kill(self) -> None:
        """Lose the node: all of its processes end in this moment."""
        for pid in self.processes():
            _kill(pid)


def _head_port() -> int:
    """Ray keeps 10002 to 19999 for the processes of its tasks."""
    while (port := kept_port()) < 20_000:
        continue
    return port


def _kill(pid: int) -> None:
    try:
        os.kill(pid, signal.SIGKILL)
    except ProcessLookupError:
        return
