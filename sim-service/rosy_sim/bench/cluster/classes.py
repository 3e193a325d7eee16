"""
Cost of a class on a node of a cluster beside one on a laptop: the same pupils, whose programs all drive.

Both classes run at the same time, so that what else the machine does disturbs both; the medians of several windows of
time are compared. Their services are those of the commands; the pupils are protocol clients in processes of their own.
"""

from __future__ import annotations

import multiprocessing
import os
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Mapping
from contextlib import ExitStack, suppress
from dataclasses import dataclass, field
from multiprocessing.connection import Connection

import psutil

from ...text_lines import text_lines
from ..class_pupils import PROGRAM, Counted, run_class
from ..processor_time import exact_time
from .local_nodes import Node, cluster_command
from .postgresql_server import postgresql_server

__all__ = ["MOST", "report"]

MOST = 1.05
"""What a class may cost on a node, of its cost on a laptop."""

_NAME = "bench"


@dataclass(slots=True)
class _Class:
    """A class that is served: its service and pupils, and the processor time of each window, s a step."""

    service: psutil.Process
    pupils: Connection
    services: list[float] = field(default_factory=list)
    programs: list[float] = field(default_factory=list)

    def times(self) -> tuple[float, float]:
        """Of the service, and of its worker with the programs, until now."""
        return exact_time([self.service]), exact_time(self.service.children(recursive=True))

    def add(self, before: tuple[float, float], after: tuple[float, float], counted: Counted) -> None:
        """Keep a window."""
        self.services.append((after[0] - before[0]) / counted.steps)
        self.programs.append((after[1] - before[1]) / counted.steps)

    def totals(self) -> list[float]:
        """Of each window, s a step."""
        return [one + other for one, other in zip(self.services, self.programs, strict=True)]


def report(environment: Mapping[str, str], pupils: int, seconds: float, windows: int) -> bool:
    """Print a row for the laptop and one for the node; returns whether the node costs at most ``MOST`` of it."""
    with tempfile.TemporaryDirectory(prefix="rosy-bench-") as folder, ExitStack() as stack:
        url = stack.enter_context(postgresql_server())
        secret = {**environment, "ROSY_CLUSTER_TOKEN": f"{folder}/token", "ROSY_CLASSES": f"{folder}/classes"}
        head = stack.enter_context(Node(secret))
        node = stack.enter_context(Node({**secret, "ROSY_CLASS_DATABASE": url}, head))
        laptop = _on_laptop(stack, secret, pupils)
        cluster = _on_node(stack, secret, head, node, pupils)
        apart = {cluster.service.pid, *(child.pid for child in cluster.service.children(recursive=True))}
        ray = [psutil.Process(pid) for pid in sorted(node.processes() - apart)]
        idle, began = _of_all(ray), time.monotonic()
        for _ in range(windows):
            _measure([laptop, cluster], seconds)
        share = (_of_all(ray) - idle) / (time.monotonic() - began)
        for one in (laptop, cluster):
            one.pupils.send("stop")
    ratios = sorted(there / here for here, there in zip(laptop.totals(), cluster.totals(), strict=True))
    ratio, quarter = statistics.median(ratios), len(ratios) // 4
    _print_row("a laptop alone", pupils, laptop)
    _print_row("a node of a cluster", pupils, cluster)
    print(
        f"  the class costs {_percent(ratio)} on the node (median of {windows} windows, half of them between "
        f"{_percent(ratios[quarter])} and {_percent(ratios[-1 - quarter])}); at most 5 %: {ratio <= MOST}",
        flush=True,
    )
    print(
        f"  Ray itself takes {share * 100:.1f} % of a core of the node, however many classes it has; "
        f"load average {os.getloadavg()[0]:.1f}",
        flush=True,
    )
    return ratio <= MOST


def _measure(classes: list[_Class], seconds: float) -> None:
    """A window of time, for all classes at once."""
    for one in classes:
        one.pupils.send("count")
    before = [one.times() for one in classes]
    time.sleep(seconds)
    after = [one.times() for one in classes]
    for one in classes:
        one.pupils.send("counted")
    for one, first, last in zip(classes, before, after, strict=True):
        one.add(first, last, one.pupils.recv())


def _of_all(processes: list[psutil.Process]) -> float:
    with suppress(psutil.NoSuchProcess):
        return exact_time(processes)
    return 0.0


def _percent(ratio: float) -> str:
    return f"{ratio * 100 - 100:+.1f} %"


def _print_row(title: str, pupils: int, measured: _Class) -> None:
    service, programs = (statistics.median(one) * 1e6 for one in (measured.services, measured.programs))
    print(
        f"  {pupils} pupils on {title}: {service:.0f} µs of the service and {programs:.0f} µs of worker and programs "
        f"a pupil's step, {service + programs:.0f} µs together",
        flush=True,
    )


def _on_laptop(stack: ExitStack, environment: Mapping[str, str], pupils: int) -> _Class:
    command = [sys.executable, "-m", "rosy_sim", "serve", "--class", _NAME, "--host", "127.0.0.1", "--port", "0"]
    # In a session of its own, as the services of the node are: the scheduler shares the processors among sessions.
    service = subprocess.Popen(
        [*command, "--no-browser"], env=dict(environment), stdout=subprocess.PIPE, text=True, start_new_session=True
    )
    stack.callback(service.wait)
    stack.callback(service.terminate)
    assert service.stdout is not None
    said = ""
    while "#key=" not in said:
        line = service.stdout.readline()
        if not line:
            raise RuntimeError("the service of the class ended")
        said += line
    address = said.partition("http://")[2].partition("/")[0]
    return _driving(stack, psutil.Process(service.pid), address, said, pupils)


def _on_node(stack: ExitStack, environment: Mapping[str, str], head: Node, node: Node, pupils: int) -> _Class:
    command = cluster_command("node", "--cluster", head.address, "--class", _NAME, "--origin", "http://127.0.0.1")
    said = subprocess.run(command, env=dict(environment), stdout=subprocess.PIPE, text=True, check=True).stdout
    (service,) = node.class_services(_NAME)
    address = text_lines(said)[-1].partition(" on ")[2].split()[0]
    return _driving(stack, psutil.Process(service), address, said, pupils)


def _driving(stack: ExitStack, service: psutil.Process, address: str, said: str, pupils: int) -> _Class:
    """Pupils join; ``said`` is what the command has printed, in English."""
    code = next(line for line in text_lines(said) if line.startswith("Class code")).split()[-1]
    key = said.partition("#key=")[2].split()[0]
    ours, theirs = multiprocessing.Pipe()
    clients = multiprocessing.get_context("spawn").Process(
        target=run_class, args=(address, pupils, code, key, PROGRAM, theirs), daemon=True
    )
    clients.start()
    # Its end is noticed.
    theirs.close()
    stack.callback(clients.kill)
    ours.recv()
    return _Class(service, ours)
