"""What the system says about processes: who is below whom, what they have open, what they take. proc(5)."""

from __future__ import annotations

import contextlib
from pathlib import Path

__all__ = ["alive", "below", "called", "descriptors", "named", "resident"]


def below(pid: int) -> set[int]:
    """The processes that a process has started, and theirs."""
    found: set[int] = set()
    for task in _inside(Path(f"/proc/{pid}/task")):
        # A thread that ends meanwhile has no children; those of the others count.
        with contextlib.suppress(FileNotFoundError, ProcessLookupError):
            for child in (task / "children").read_text().split():
                found |= {int(child), *below(int(child))}
    return found


def alive(pids: set[int]) -> set[int]:
    """Those that have not ended."""
    return {pid for pid in pids if Path(f"/proc/{pid}").exists()}


def descriptors(pid: int) -> int:
    """How many files and sockets a process has open."""
    return len(_inside(Path(f"/proc/{pid}/fd")))


def _inside(folder: Path) -> list[Path]:
    """What there is of a process; nothing when it is gone."""
    with contextlib.suppress(FileNotFoundError, ProcessLookupError):
        return list(folder.iterdir())
    return []


def resident(pid: int) -> int:
    """Memory of a process, kB; 0 when it is gone."""
    with contextlib.suppress(FileNotFoundError, ProcessLookupError, StopIteration):
        lines = Path(f"/proc/{pid}/status").read_text().splitlines()
        return int(next(line for line in lines if line.startswith("VmRSS:")).split()[1])
    return 0


def called(pid: int) -> str:
    """The name of a process; empty when it is gone."""
    with contextlib.suppress(FileNotFoundError, ProcessLookupError):
        return Path(f"/proc/{pid}/comm").read_text().strip()
    return ""


def named(pids: set[int], name: str) -> set[int]:
    """Those whose command begins with this program."""
    found = set()
    for pid in pids:
        with contextlib.suppress(FileNotFoundError, ProcessLookupError):
            if Path(f"/proc/{pid}/cmdline").read_bytes().split(b"\0")[0].endswith(name.encode()):
                found.add(pid)
    return found
