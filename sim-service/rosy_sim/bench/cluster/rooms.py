"""
Programs in rooms on a cluster beside one machine: how many a second, what they cost, and that the answers are the same
byte for byte, also when a node is killed and another one joins meanwhile.

All nodes are on this machine, so the cluster cannot be faster here: the comparison shows what Ray costs.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from ..processor_time import ProcessTimes, TimeMeter
from .local_nodes import Node, cluster_command

__all__ = ["Graded", "Grading", "programs", "report"]

_PROGRAM = """cruise :: Velocity -> Velocity
cruise _ = Velocity {speed:.2f} {turn:.2f}

backOff :: Bumper -> Velocity
backOff (Bumper _ Pressed) = Velocity (-0.1) 0.5
backOff (Bumper _ Released) = Velocity 0.1 0.0

main = simulate (cruise, backOff)
"""

_LOST_AFTER = 0.1
"""The share of the work which a node has done when it is lost."""


Loss = Literal["too late", "none came in time", "one joined"]
"""Of a node that is to be lost and of another one: all was tested before, or before the other one tried rooms."""


@dataclass(frozen=True, slots=True)
class Graded:
    """Standard output and status of the command; clock and processor time in s."""

    answer: str
    status: int
    took: float
    spent: float
    # Of a cluster that was to lose a node.
    loss: Loss | None = None


@dataclass(frozen=True, slots=True)
class Grading:
    """The programs of a folder in so many rooms each, ``seconds`` of the robot in each."""

    folder: Path
    rooms: int
    seconds: float
    environment: Mapping[str, str]

    def alone(self, processes: int) -> Graded:
        """On this machine without a cluster."""
        command = [sys.executable, "-m", "rosy_sim", *self._words, "--processes", str(processes)]
        return self._graded(command, [], lambda _: None)

    def on_cluster(self, nodes: Sequence[Node]) -> Graded:
        """On a cluster, whose head comes first."""
        return self._graded(self._on(nodes[0]), nodes, lambda _: None)

    def with_loss(self, nodes: Sequence[Node], least: float) -> Graded:
        """
        On a cluster whose last node is killed when it has tried rooms and worked for ``least`` s of processor time;
        then another one joins.
        """
        head, lost = nodes[0], nodes[-1]
        there = list(nodes)
        with ExitStack() as stack:

            def disturb(running: subprocess.Popen[bytes]) -> Loss:
                times = ProcessTimes()
                times.look([lost.pid])
                before = times.total
                while not (lost.trial_processes() and times.total - before >= least):
                    if running.poll() is not None:
                        return "too late"
                    times.look([lost.pid])
                lost.kill()
                node = stack.enter_context(Node(self.environment, head))
                there.append(node)
                while running.poll() is None:
                    if node.trial_processes():
                        return "one joined"
                    time.sleep(_LOOK)
                return "none came in time"

            return self._graded(self._on(head), there, disturb)

    @property
    def _words(self) -> list[str]:
        test = ["--rooms", str(self.rooms), "--seconds", f"{self.seconds:g}"]
        return ["run", str(self.folder), *test, "--hold", "never-pushes", "1", "s", "--json"]

    def _on(self, head: Node) -> list[str]:
        return cluster_command(*self._words, "--cluster", head.address)

    def _graded(
        self, command: list[str], nodes: Sequence[Node], meanwhile: Callable[[subprocess.Popen[bytes]], Loss | None]
    ) -> Graded:
        # A pipe that is not read would stop it.
        with tempfile.TemporaryFile() as said:
            began = time.monotonic()
            running = subprocess.Popen(command, env=dict(self.environment), cwd=self.folder.parent, stdout=said)
            try:
                with TimeMeter(lambda: [running.pid, *(node.pid for node in nodes)]) as meter:
                    loss = meanwhile(running)
                    status = running.wait()
                took = time.monotonic() - began
            finally:
                running.kill()
                running.wait()
            said.seek(0)
            return Graded(said.read().decode(), status, took, meter.spent, loss)


_LOOK = 0.2
"""Between two looks at a node, s."""


def programs(folder: Path, count: int) -> None:
    """Write so many programs, each of which drives in a way of its own."""
    for number in range(count):
        program = folder / f"pupil-{number:02}" / "Main.hs"
        program.parent.mkdir(parents=True)
        program.write_text(_PROGRAM.format(speed=0.1 + number / 100, turn=number / 20))


def report(environment: Mapping[str, str], count: int, rooms: int, seconds: float) -> bool:
    """Print a row for one machine, for a cluster, and for one that loses a node; returns whether all answers agree."""
    with tempfile.TemporaryDirectory(prefix="rosy-bench-") as folder, ExitStack() as stack:
        secret = {**environment, "ROSY_CLUSTER_TOKEN": f"{folder}/token"}
        grading = Grading(Path(folder) / "homework", rooms, seconds, secret)
        programs(grading.folder, count)
        runs = count * rooms
        alone = grading.alone(2)
        _print_row("one machine, two processes", runs, alone, None)
        head = stack.enter_context(Node(secret))
        nodes = [head, *(stack.enter_context(Node(secret, head)) for _ in range(2))]
        cluster = grading.on_cluster(nodes)
        _print_row("a cluster of three nodes", runs, cluster, alone)
        lossy = grading.with_loss(nodes, _LOST_AFTER * alone.spent)
        _print_row(f"one of them is killed, another joins ({lossy.loss})", runs, lossy, alone)
    agree = alone.answer == cluster.answer == lossy.answer
    print(f"  all answers are the same, byte for byte: {agree}", flush=True)
    return agree


def _print_row(title: str, runs: int, graded: Graded, alone: Graded | None) -> None:
    beside = "" if alone is None else f" ({graded.spent / alone.spent:.2f} of one machine's)"
    print(
        f"  {title}: {runs} runs in {graded.took:.0f} s, {runs / graded.took:.1f} a second; "
        f"{graded.spent / runs * 1e3:.0f} ms of processor time each{beside}; load average {os.getloadavg()[0]:.1f}",
        flush=True,
    )
