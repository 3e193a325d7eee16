"""
Control group in which a worker and all its programs live, with a limit of memory that the kernel keeps. cgroups(7).

The worker keeps a ceiling itself and ends the largest program with a sentence; the limit here lies above it, and holds
between two looks of the worker as well. Without a control group that may be written the worker's ceiling is alone.
"""

from __future__ import annotations

import contextlib
import itertools
import os
from dataclasses import dataclass
from pathlib import Path

import psutil

from ..text_lines import text_lines

__all__ = ["MemoryGroup", "create_memory_group"]

_PREFIX = "rosy-programs-"

_numbers = itertools.count(1)


@dataclass(frozen=True, slots=True)
class MemoryGroup:
    """A control group without processes; one that writes its id to ``members`` belongs to it, as do its children."""

    folder: Path

    @property
    def members(self) -> Path:
        """The file that takes the ids of processes."""
        return self.folder / "cgroup.procs"

    def remove(self) -> None:
        """Remove it when its last process has ended; one that has not is removed by the next to be created."""
        _remove(self.folder)


def create_memory_group(
    limit: int, groups: Path = Path("/sys/fs/cgroup"), own: Path = Path("/proc/self/cgroup")
) -> MemoryGroup | None:
    """A new group below a limit in bytes, or ``None`` where this process may not make one."""
    try:
        memberships = [line.split(":", 2) for line in text_lines(own.read_text())]
    except OSError:
        return None
    for _, controllers, name in memberships:
        folder = Path(name.lstrip("/"))
        if "memory" in controllers.split(","):
            group = _create(groups / "memory" / folder, "memory.limit_in_bytes", limit)
        elif controllers == "":
            group = next(
                (made for above in _parents(groups, folder) if (made := _create(above, "memory.max", limit))), None
            )
        else:
            continue
        if group is not None:
            return group
    return None


def _parents(groups: Path, folder: Path) -> list[Path]:
    """
    The groups of version 2 below which processes may get a limit of memory: those that give it to their children.

    A group with processes cannot. Its parent can, but is left out where that would free the programs from a limit.
    """
    found: list[Path] = []
    for above in (folder, *folder.parents):
        path = groups / above
        if "memory" in _words(path / "cgroup.subtree_control"):
            found.append(path)
        if _words(path / "memory.max") not in ([], ["max"]):
            break
    return found


def _create(parent: Path, limit_file: str, limit: int) -> MemoryGroup | None:
    if not parent.is_dir():
        return None
    for old in parent.glob(f"{_PREFIX}*"):
        # Of a service that was killed. One with processes stays, and one that its service has just made.
        if not psutil.pid_exists(_owner(old)):
            _remove(old)
    folder = parent / f"{_PREFIX}{os.getpid()}-{next(_numbers)}"
    try:
        folder.mkdir()
    except OSError:
        return None
    group = MemoryGroup(folder)
    try:
        (folder / limit_file).write_text(str(limit))
        may_join = os.access(parent / "cgroup.procs", os.W_OK)
    except OSError:
        may_join = False
    if not may_join:
        group.remove()
        return None
    return group


def _owner(group: Path) -> int:
    """The process that has made a group: its name says it."""
    owner = group.name.removeprefix(_PREFIX).partition("-")[0]
    return int(owner) if owner.isdecimal() else -1


def _words(file: Path) -> list[str]:
    try:
        return file.read_text().split()
    except OSError:
        return []


def _remove(folder: Path) -> None:
    with contextlib.suppress(OSError):
        folder.rmdir()
