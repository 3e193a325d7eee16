"""What tests share: a configuration with the fake worker, small worlds, and a place to play scripts."""

from __future__ import annotations

import socket
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from itertools import islice
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, settings

from rosy_sim.config import Config, Limits
from rosy_sim.robots.kobuki import KOBUKI
from rosy_sim.wire.channels import simulated_channels
from rosy_sim.world.arena import read_arena
from rosy_sim.world.events import Reading
from rosy_sim.world.world import World

from .extent import NIGHTLY
from .fake_program import play

PATIENCE = 240.0
"""For what hangs, s: a machine that is slow or stands still for a while is waited for."""

UNHURRIED: dict[str, Any] = {"open_timeout": PATIENCE, "ping_interval": None}
"""Of a WebSocket to a service of this machine; by itself it gives up after ten seconds."""

FAKE_WORKER = Path(__file__).with_name("fake_worker.py")

# How long a busy machine takes for an example says nothing about it. The same commit tries the same examples.
settings.register_profile(
    "rosy",
    settings(),
    deadline=None,
    suppress_health_check=[HealthCheck.too_slow],
    derandomize=not NIGHTLY,
    database=None,
)
settings.load_profile("rosy")

Play = Callable[[str], Any]


@contextmanager
def playing(script: str) -> Iterator[socket.socket]:
    """A link with a script at its other end."""
    ours, theirs = socket.socketpair()
    player = threading.Thread(target=play, args=(theirs, script), daemon=True)
    player.start()
    with ours:
        yield ours


def events_of(world: World) -> list[Reading]:
    """The events among what the robot senses now."""
    channels = simulated_channels()
    return [reading for reading in world.sense() if channels[reading.channel].kind == "event"]


def hall(**more: object) -> World:
    """A world of 20 by 20 m with the robot in the middle."""
    return World(read_arena({"size": [20, 20], "start": {"x": 10, "y": 10, "theta": 0}, **more}), KOBUKI)


@pytest.fixture
def limits() -> Limits:
    """Long enough for a busy machine, but for `stop`, which ends well either way."""
    return Limits(
        settle=60.0, ready=60.0, unattended=PATIENCE, stop=0.3, gone=60.0,
        compile=PATIENCE, preview=PATIENCE, worker_ready=PATIENCE,
    )  # fmt: skip


@pytest.fixture
def impatient(limits: Limits) -> Limits:
    """Short, for programs that are stuck whatever the machine does; a program that waits for its turn is not."""
    return replace(limits, settle=4.0)


@pytest.fixture
def config(tmp_path: Path, limits: Limits) -> Config:
    """A service with the fake worker and nothing else."""
    return Config(
        root=tmp_path,
        page=tmp_path / "page",
        examples=tmp_path / "examples",
        worker=(sys.executable, str(FAKE_WORKER)),
        sandbox=False,
        classes=tmp_path / "classes",
        recordings=tmp_path / "recordings",
        limits=limits,
    )


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Long tests start first in each process: a process that gets one last keeps the others waiting."""
    items[:] = long_first(items, getattr(config, "workerinput", {}).get("workercount", 1))


def long_first(items: list[pytest.Item], processes: int) -> list[pytest.Item]:
    """The tests as equal shares, as pytest-xdist deals them out; each share begins with its part of the long tests."""
    long = [item for item in items if item.get_closest_marker("long") is not None]
    others = iter([item for item in items if item.get_closest_marker("long") is None])
    ordered: list[pytest.Item] = []
    for process in range(processes):
        # The first shares are the smaller ones where the number cannot be divided.
        share = (len(items) - len(ordered)) // (processes - process)
        mine = long[process::processes]
        ordered += [*mine, *islice(others, max(0, share - len(mine)))]
    return [*ordered, *others]
