"""
Live classes on a Ray cluster: a directory that maps classes to nodes, and an actor for each class on its node.

A class is the unit of placement: all of its pages talk to the service on its node. Ray places its actor by the pages
and the memory that nodes have free, and starts it on another node when its node is lost; the class comes up there from
the database. The directory holds nothing that is not known to Ray, so it may be started again anywhere, too.
"""

from __future__ import annotations

import os
import subprocess
import sys
import threading
import time
from contextlib import suppress
from typing import Any

import msgspec
import ray
from ray._private.state import available_resources_per_node
from ray.exceptions import RayError

from ..sentences.sentence import tr
from .class_service import Failed, Ready, Started
from .connection import NAMESPACE, connect, reached
from .node import PAGES

__all__ = ["PAGES_OF_CLASS", "ClassDirectory", "directory"]

PAGES_OF_CLASS = 40
"""Pages of a class: thirty pupils, some of them with two devices."""

_MEMORY_OF_CLASS = 1024**3
"""Of the service, its worker and the programs of PAGES_OF_CLASS pages, bytes; docs/district.md has the measurement."""

_ASK = 5.0
"""How long the directory waits for a class that is about to start, s; a page asks again."""

_END = 15.0
"""How long a class may take to end, s: longer than its service waits for open connections."""

_FOREVER: dict[str, Any] = {"namespace": NAMESPACE, "lifetime": "detached", "max_restarts": -1, "max_task_retries": 0}

_DIRECTORY = "directory"


_UNKNOWN = Failed(tr("The class could not start on a node; what its service says is in Ray's log there.").id, {})

_PAUSE = 2.0
"""Before an actor whose class could not start ends and is started again, s."""


class _ClassHost:
    """The actor of a class: its service as a process, which ends with this one and ends this one."""

    def __init__(self, name: str, origin: str) -> None:
        # As the node was started: Ray itself may know it by another address.
        host = os.environ["ROSY_NODE_HOST"]
        self._process = subprocess.Popen(
            [sys.executable, "-m", "rosy_sim.cluster.class_service", name, host, origin],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
        )
        assert self._process.stdout is not None
        line = self._process.stdout.readline()
        started: Started = msgspec.json.decode(line, type=Started) if line else _UNKNOWN
        if isinstance(started, Failed):
            _report(name, started)
            # The database cannot be used now, or no port is free: Ray starts the actor again.
            os._exit(1)
        self._ready = started
        self._is_ending = False
        threading.Thread(target=self._end_with_process, daemon=True).start()

    def _end_with_process(self) -> None:
        self._process.wait()
        if not self._is_ending:
            os._exit(1)

    def ready(self) -> Ready:
        """Where the class is."""
        return self._ready

    def end(self) -> None:
        """End the service, which then has the class locked no more."""
        self._is_ending = True
        self._process.terminate()
        self._process.wait()


class ClassDirectory:
    """The actor that maps classes to nodes."""

    def __init__(self) -> None:
        # Of classes that could not start.
        self._faults: dict[str, Failed] = {}

    def place(self, name: str, origin: str) -> None:
        """Have a class served by a node, for pages of an origin (a URL); nothing happens if it is."""
        self._faults.pop(name, None)
        resources = {PAGES: PAGES_OF_CLASS}
        options = {"num_cpus": 0, "resources": resources, "memory": _MEMORY_OF_CLASS, "scheduling_strategy": "SPREAD"}
        host = ray.remote(_ClassHost).options(name=_host(name), get_if_exists=True, **_FOREVER, **options)
        host.remote(name, origin)

    def report(self, name: str, why: Failed) -> None:
        """A class could not start on a node; it is tried again."""
        self._faults[name] = why

    def fault(self, name: str) -> Failed | None:
        """Why a class that was begun or lost could not start lately."""
        return self._faults.get(name)

    def has_room(self) -> bool:
        """Whether a node has room for one more class now."""
        free = available_resources_per_node().values()
        return any(one.get(PAGES, 0) >= PAGES_OF_CLASS and one.get("memory", 0) >= _MEMORY_OF_CLASS for one in free)

    def find(self, name: str) -> Ready | None:
        """Where a class is; ``None`` while it starts, and if no node serves it."""
        try:
            host = ray.get_actor(_host(name), namespace=NAMESPACE)
            found: Ready = ray.get(host.ready.remote(), timeout=_ASK)
        except (RayError, ValueError, TimeoutError):
            return None
        return found

    def services(self) -> dict[str, str]:
        """The classes that are served now, and where, as HOST:PORT."""
        asked = {}
        for name in self.names():
            with suppress(ValueError):
                asked[ray.get_actor(_host(name), namespace=NAMESPACE).ready.remote()] = name
        answers, _ = ray.wait(list(asked), num_returns=len(asked), timeout=_ASK) if asked else ([], [])
        found = {}
        for answer in answers:
            with suppress(RayError):
                found[asked[answer]] = ray.get(answer).address
        return dict(sorted(found.items()))

    def names(self) -> list[str]:
        """The classes that nodes serve."""
        actors = ray.util.list_named_actors(all_namespaces=True)
        names = [actor["name"] for actor in actors if actor["namespace"] == NAMESPACE]
        return sorted(name.removeprefix("class-") for name in names if name.startswith("class-"))

    def end(self, name: str) -> bool:
        """End a class, which stays in the database; whether a node served it."""
        try:
            host = ray.get_actor(_host(name), namespace=NAMESPACE)
        except ValueError:
            return False
        # A class that waits for a node has no service.
        with suppress(RayError, TimeoutError):
            ray.get(host.end.remote(), timeout=_END)
        ray.kill(host)
        return True


def _host(name: str) -> str:
    return f"class-{name}"


def _report(name: str, why: Failed) -> None:
    """Tell the directory why a class could not start, if that can be reached."""
    with suppress(RayError, ValueError, TimeoutError):
        directory = ray.get_actor(_DIRECTORY, namespace=NAMESPACE)
        ray.get(directory.report.remote(name, why), timeout=_ASK)
    time.sleep(_PAUSE)


def directory(address: str) -> Any:
    """
    The directory of a cluster; it is started if there is none. Connects this process to the cluster.

    Raises:
        ClusterError: the cluster cannot be used from this machine.
    """
    connect(address)
    # The caller may be asked while a class starts elsewhere.
    options = {**_FOREVER, "max_task_retries": -1, "num_cpus": 0, "max_concurrency": 64}
    with reached():
        return ray.remote(ClassDirectory).options(name=_DIRECTORY, get_if_exists=True, **options).remote()
