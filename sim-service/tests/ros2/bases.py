"""
Bases on ROS 2 that are not there, by their transport: another vendor's DDS (``fast_dds.py``), or Zenoh with a router of
its own (``rosy-hs/test-robots/peers/zenoh_base.py``).
"""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path

import pytest

from ..ports import kept_port
from .fast_dds import compiled_base, free_domain

__all__ = ["TRANSPORTS", "Place", "base", "place"]

ZENOH_BASE = Path(__file__).resolve().parents[3] / "rosy-hs" / "test-robots" / "peers" / "zenoh_base.py"

TRANSPORTS = pytest.mark.parametrize("transport", ["DDS", "Zenoh"])


@dataclass(frozen=True)
class Place:
    """Where bases of one transport are. ``command`` starts one, with namespace, kind and words behind it."""

    command: tuple[str, ...]
    domain: int
    host: str

    @property
    def address(self) -> str:
        """Of Rosy."""
        return f"ros2:{self.domain}{self.host and f'@{self.host}'}"


@contextmanager
def place(transport: str) -> Iterator[Place]:
    """One that no other test on this machine has."""
    if transport == "DDS":
        executable = compiled_base()
        with free_domain() as domain:
            yield Place((executable, str(domain)), domain, "")
        return
    if find_spec("zenoh") is None or find_spec("cyclonedds") is None:
        pytest.skip("Zenoh or Cyclone DDS is not installed")
    port = kept_port()
    yield Place((sys.executable, str(ZENOH_BASE), str(port), "7"), 7, f"127.0.0.1:{port}")


@contextmanager
def base(where: Place, *words: str) -> Iterator[list[str]]:
    """What it has said, once it has ended."""
    said: list[str] = []
    with subprocess.Popen(
        [*where.command, *words], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as process:
        try:
            yield said
        finally:
            said += process.communicate("quit\n")[0].splitlines()
