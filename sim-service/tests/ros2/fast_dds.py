"""
Processes of ROS 2 with another vendor's DDS, compiled once: a base that is not there
(``rosy-hs/test-robots/peers/fast_dds_base.cpp``), and a program that drives one (``fast_dds_driver.cpp``).

Skips with a reason where a compiler, Fast DDS or Cyclone DDS is not installed.
"""

from __future__ import annotations

import fcntl
import hashlib
import shutil
import subprocess
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from importlib.util import find_spec
from pathlib import Path

import pytest

__all__ = ["compiled_base", "compiled_driver", "free_domain"]

_PEERS = Path(__file__).resolve().parents[3] / "rosy-hs" / "test-robots" / "peers"

_LIBRARIES = ("-lfastrtps", "-lfastcdr", "-lpthread")

_DOMAINS = range(50, 100)
"""Not those that people use, and whose ports are below the ones of outgoing connections (DDSI-RTPS 2.5, 9.6.2.3)."""


def compiled_base() -> str:
    """The executable of the base."""
    return _compiled(_PEERS / "fast_dds_base.cpp")


def compiled_driver() -> str:
    """The executable of the driver."""
    return _compiled(_PEERS / "fast_dds_driver.cpp")


def _compiled(source: Path) -> str:
    """Tests that run at once share it."""
    if find_spec("cyclonedds") is None:
        pytest.skip("Cyclone DDS is not installed")
    if shutil.which("g++") is None or not Path("/usr/include/fastdds/dds").is_dir():
        pytest.skip("g++ and libfastrtps-dev are not installed")
    text = source.read_bytes() + source.with_name("fast_dds.hpp").read_bytes()
    name = f"rosy-{source.stem}-{hashlib.sha256(text).hexdigest()[:16]}"
    made = Path(tempfile.gettempdir()) / name
    with made.with_suffix(".lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not made.exists():
            part = made.with_suffix(".part")
            subprocess.run(["g++", "-std=c++17", "-O0", str(source), "-o", str(part), *_LIBRARIES], check=True)
            part.rename(made)
    return str(made)


@contextmanager
def free_domain() -> Iterator[int]:
    """A domain that no other test on this machine has."""
    for domain in _DOMAINS:
        with (Path(tempfile.gettempdir()) / f"rosy-dds-domain-{domain}").open("w") as lock:
            try:
                fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError:
                continue
            yield domain
            return
    pytest.skip("all domains are taken")
