"""
Driver locks: which process on this machine drives which robot, and the emergency stop for all of them.

Every program that drives a robot keeps a locked file in a folder of its user's, named by its process, with the robot's
address in it (rosy-hs/robots, Rosy.Robots.DriverLock). SIGUSR1 is the emergency stop.
"""

from __future__ import annotations

import contextlib
import fcntl
import os
import signal
from dataclasses import dataclass
from pathlib import Path
from urllib.parse import urlsplit

from ..errors import BadInput
from ..ros2.transports.address import parse_ros2_address
from ..sentences.sentence import tr

__all__ = ["PORTS", "Driver", "active_drivers", "canonical_address", "emergency_stop"]

PORTS = {"ws": 9090, "ros": 11311}
"""Where rosbridge servers and ROS masters listen when an address does not say (rosbridge_server, ROS_MASTER_URI)."""


@dataclass(frozen=True, slots=True)
class Driver:
    """A process that drives a robot."""

    process: int
    address: str


def _folder() -> Path:
    runtime = os.environ.get("XDG_RUNTIME_DIR")
    return Path(runtime) / "rosy" if runtime else Path(f"/tmp/rosy-{os.geteuid()}")


def active_drivers(folder: Path | None = None) -> list[Driver]:
    """The processes that drive now; files of processes that have ended are removed."""
    found: list[Driver] = []
    place = folder if folder is not None else _folder()
    if not place.is_dir() or place.stat().st_uid != os.geteuid():
        return []
    for path in sorted(place.iterdir()):
        if not path.name.isdecimal():
            continue
        with contextlib.suppress(FileNotFoundError), path.open("r+") as file:
            try:
                fcntl.lockf(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except OSError:
                found.append(Driver(int(path.name), file.read()))
            else:
                path.unlink()
    return found


def emergency_stop(address: str | None) -> list[Driver]:
    """
    Stop every robot that is driven from this machine, or one.

    Raises:
        BadInput: no process on this machine drives it.
    """
    found = [
        d for d in active_drivers() if address is None or canonical_address(d.address) == canonical_address(address)
    ]
    for driver in found:
        with contextlib.suppress(ProcessLookupError):
            os.kill(driver.process, signal.SIGUSR1)
    if not found:
        raise BadInput(
            tr(
                "Nothing that you started on this machine drives a robot; "
                "if it moves, press its power button or lift it."
            )
            if address is None
            else tr(
                "Nothing that you started on this machine drives the robot at {address}; "
                "if it moves, press its power button or lift it.",
                address=address,
            )
        )
    return found


def canonical_address(address: str) -> str:
    """
    An address without options, in one spelling: two addresses with the same result are one robot. Default ports are
    added, links to devices are resolved, and host names are in lower case.
    """
    bare = address.partition("?")[0]
    if bare.startswith("serial:"):
        return "serial:" + os.path.realpath(bare.removeprefix("serial:"))
    on_ros2 = parse_ros2_address(bare)
    if on_ros2 is not None:
        return on_ros2.bare()
    try:
        parts = urlsplit(bare)
        port = parts.port or PORTS.get(parts.scheme)
    except ValueError:
        # Not an address, so equal to no other.
        return bare
    return f"{parts.scheme}://{parts.hostname}:{port}{parts.path.rstrip('/')}"
