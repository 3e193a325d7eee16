"""
How much memory all programs of a worker may take together: half of what the machine, or the control group of the
service, has. The worker keeps the ceiling (rosy-hs/worker/Rosy/Worker/MemoryCeiling.hs); in its sandbox it cannot see
the control group. cgroups(7).
"""

from __future__ import annotations

import os
from pathlib import Path

from .text_lines import text_lines

__all__ = ["memory_ceiling"]

_SHARE = 0.5
"""The rest is the service's, the browser's and the system's."""


def memory_ceiling(groups: Path = Path("/sys/fs/cgroup"), own: Path = Path("/proc/self/cgroup")) -> int:
    """Bytes."""
    machine = os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
    return int(min([machine, *_limits(groups, own)]) * _SHARE)


def _limits(groups: Path, own: Path) -> list[int]:
    """The limits of the control groups of this process and of those above, bytes."""
    try:
        memberships = [line.split(":", 2) for line in text_lines(own.read_text())]
    except OSError:
        return []
    files: list[Path] = []
    for _, controllers, name in memberships:
        if controllers == "":
            files += _upwards(groups, name, "memory.max")
        elif "memory" in controllers.split(","):
            files += _upwards(groups / "memory", name, "memory.limit_in_bytes")
    return [limit for file in files if (limit := _number(file)) is not None]


def _upwards(root: Path, name: str, file: str) -> list[Path]:
    folder = Path(name.lstrip("/"))
    return [root / above / file for above in (folder, *folder.parents)]


def _number(file: Path) -> int | None:
    """A number, or ``None`` for a missing file and for the word ``max``."""
    try:
        return int(file.read_text())
    except (OSError, ValueError):
        return None
