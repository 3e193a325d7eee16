"""Figures of processes (descendants, descriptors, memory, names), their begin and end. An ended process has none."""

from __future__ import annotations

import os
import select
import subprocess
import time
from collections.abc import Callable, Iterable

import psutil

__all__ = ["await_begin", "await_end", "below", "called", "children", "command_of", "descriptors", "named", "resident"]


def below(pid: int) -> set[int]:
    """The descendants of a process."""
    try:
        return {process.pid for process in psutil.Process(pid).children(recursive=True)}
    except psutil.NoSuchProcess:
        return set()


def children(pid: int) -> set[int]:
    """The processes that a process has started."""
    try:
        return {process.pid for process in psutil.Process(pid).children()}
    except psutil.NoSuchProcess:
        return set()


def await_end(pids: Iterable[int], seconds: float) -> None:
    """Returns when all have ended; the kernel tells it, also of processes of others."""
    deadline = time.monotonic() + seconds
    for pid in pids:
        try:
            process = os.pidfd_open(pid)
        except ProcessLookupError:
            continue
        try:
            readable, _, _ = select.select([process], [], [], max(0.0, deadline - time.monotonic()))
            if not readable:
                raise TimeoutError(f"the process {pid} ({called(pid)}) has not ended after {seconds:g} s")
        finally:
            os.close(process)


def await_begin(find: Callable[[], set[int]], client: subprocess.Popen[str]) -> set[int]:
    """
    What ``find`` finds, as soon as it finds some, or none when the client has ended first.

    No event tells of a process that begins elsewhere, so it looks 20 times a second, without work in between.
    """
    process = os.pidfd_open(client.pid)
    try:
        while not (found := find()) and not select.select([process], [], [], 0.05)[0]:
            pass
    finally:
        os.close(process)
    return found


def descriptors(pid: int) -> int:
    """Number of open files and sockets."""
    try:
        return int(psutil.Process(pid).num_fds())
    except psutil.NoSuchProcess:
        return 0


def resident(pid: int) -> int:
    """Resident memory, kB."""
    try:
        return int(psutil.Process(pid).memory_info().rss) // 1024
    except psutil.NoSuchProcess:
        return 0


def called(pid: int) -> str:
    """The name of a process."""
    try:
        return str(psutil.Process(pid).name())
    except psutil.NoSuchProcess:
        return ""


def command_of(pid: int) -> list[str]:
    """The words of its command."""
    try:
        return list(psutil.Process(pid).cmdline())
    except (psutil.NoSuchProcess, psutil.ZombieProcess):
        return []


def named(pids: set[int], name: str) -> set[int]:
    """Those whose command begins with this program."""
    found = set()
    for pid in pids:
        try:
            command = psutil.Process(pid).cmdline()
        except (psutil.NoSuchProcess, psutil.ZombieProcess):
            continue
        if command and command[0].endswith(name):
            found.add(pid)
    return found
