"""
Who on this machine drives which robot, and the emergency stop for all of them from any terminal.

Every program that drives a robot keeps a locked file in a folder of its user's, named by its process, with the robot's
address in it (rosy-hs/robots, Rosy.Robots.Announce). SIGUSR1 is the emergency stop.
"""

from __future__ import annotations

import contextlib
import fcntl
import os
import signal
from dataclasses import dataclass
from pathlib import Path
from urllib.parse import urlsplit

from .errors import BadInput

__all__ = ["PORTS", "Driver", "drivers", "emergency_stop", "way"]

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


def drivers(folder: Path | None = None) -> list[Driver]:
    """Those that live; the files of the dead are cleared away."""
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
        BadInput: nobody here drives it.
    """
    found = [d for d in drivers() if address is None or way(d.address) == way(address)]
    for driver in found:
        with contextlib.suppress(ProcessLookupError):
            os.kill(driver.process, signal.SIGUSR1)
    if not found:
        which = "a robot" if address is None else f"the robot at {address}"
        raise BadInput(
            f"Nothing that you started on this machine drives {which}; if it moves, press its power button or lift it."
        )
    return found


def way(address: str) -> str:
    """
    How a robot is reached, without options: two addresses of one way are one robot. Ports that are not said are said, a
    device is called by its own name, whatever links to it, and capitals of a computer's name do not matter.
    """
    bare = address.partition("?")[0]
    if bare.startswith("serial:"):
        return "serial:" + os.path.realpath(bare.removeprefix("serial:"))
    try:
        parts = urlsplit(bare)
        port = parts.port or PORTS.get(parts.scheme)
    except ValueError:
        # No address, so no other one's either.
        return bare
    return f"{parts.scheme}://{parts.hostname}:{port}{parts.path.rstrip('/')}"
