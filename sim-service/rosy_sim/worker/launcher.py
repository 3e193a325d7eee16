"""
Launcher of worker processes: one end of a socket pair as descriptor 3, a session of its own, bubblewrap around it.

The sandbox has no network, a read-only view of the system's libraries and of the Rosy library, private
/tmp and /proc, and no capabilities; it dies with its parent. What it does not do: limit the programs
themselves (the worker does, with seccomp and resource limits).
"""

from __future__ import annotations

import asyncio
import contextlib
import os
import shutil
import signal
import socket
from dataclasses import dataclass
from pathlib import Path

from ..config import Config
from ..errors import WorkerMissing
from ..memory_ceiling import memory_ceiling
from ..sentences.sentence import Sentence, tr
from .error_output import ErrorOutput
from .memory_group import MemoryGroup, create_memory_group
from .sandbox_probe import sandbox_fault

__all__ = [
    "ENDED",
    "NOT_IN_TIME",
    "ForkedWorker",
    "WorkerProcess",
    "launch",
    "missing_sandbox",
    "sandbox_fault",
    "sandbox_warning",
]

_DESCRIPTOR = 3
"""Where the worker finds its socket. protocol/README.md, section 3."""

_SYSTEM = ("/usr", "/var/lib/ghc", "/etc/alternatives", "/etc/ld.so.cache")
"""What GHC and the libraries need of a Debian system; missing ones are skipped."""

_LINKS = ("/bin", "/sbin", "/lib", "/lib64")
"""Links into /usr on a merged system, folders elsewhere."""

ENDED, NOT_IN_TIME = tr("it ended before it was ready"), tr("it was not ready in time")
"""Causes of a failed start of which the worker itself says nothing."""

_SESSION_MEMORY = 512 * 1024 * 1024
"""What a worker takes itself, several times over, bytes; its control group may take so much beyond the ceiling."""

_JOIN = ("/bin/sh", "-c", '{ echo $$ > "$0"; } 2>/dev/null; exec "$@"')
"""
Starts a command in the control group whose file comes first: before the command can start a process. Where it may not
join, the worker's own ceiling is alone; nothing is said, for the output belongs to the user.
"""


def sandbox_warning(fault: Sentence) -> Sentence:
    """The line on standard error that every command prints where the sandbox is missing."""
    return tr("programs run without their sandbox: {fault}.", fault=fault)


@dataclass(frozen=True, slots=True)
class WorkerProcess:
    """A running worker. ``pid`` leads its own process group."""

    pid: int
    socket: socket.socket
    # Where the kernel keeps the limit of its memory.
    group: MemoryGroup | None
    # What it and its sandbox write to standard error.
    errors: ErrorOutput

    def kill(self) -> None:
        """End the worker and everything in its sandbox, at once. Reaping is the owner's."""
        try:
            os.killpg(self.pid, signal.SIGKILL)
        except (ProcessLookupError, PermissionError):
            # Not a group leader yet, or already gone.
            try:
                os.kill(self.pid, signal.SIGKILL)
            except ProcessLookupError:
                return

    async def reap(self) -> None:
        """Wait for the killed process without stopping the loop."""
        try:
            handle = os.pidfd_open(self.pid)
        except ProcessLookupError:
            return
        try:
            await _ended(handle)
        finally:
            # It has been killed, so this returns at once even when the wait was cancelled.
            os.waitpid(self.pid, 0)  # noqa: ASYNC222
            os.close(handle)
            self.leave_nothing()

    def leave_nothing(self) -> None:
        """To be called when it has been reaped."""
        self.errors.close()
        if self.group is not None:
            self.group.remove()


@dataclass(frozen=True, slots=True)
class ForkedWorker:
    """A worker that another one has forked, which reaps it. ``handle`` is its pidfd."""

    pid: int
    handle: int
    socket: socket.socket

    def kill(self) -> None:
        """End the worker and its children, at once."""
        with contextlib.suppress(ProcessLookupError):
            signal.pidfd_send_signal(self.handle, signal.SIGKILL)

    async def reap(self) -> None:
        """Wait until it has ended; once."""
        try:
            await _ended(self.handle)
        finally:
            os.close(self.handle)


async def _ended(handle: int) -> None:
    """Wait until a pidfd says that its process has ended."""
    loop = asyncio.get_running_loop()
    ended = asyncio.Event()
    loop.add_reader(handle, ended.set)
    try:
        await ended.wait()
    finally:
        loop.remove_reader(handle)


def launch(config: Config) -> WorkerProcess:
    """
    Start a worker.

    Raises:
        WorkerMissing: none has been built.
        OSError: the system cannot start it.
    """
    if not config.worker or shutil.which(config.worker[0]) is None:
        raise WorkerMissing
    command = [*(_sandbox(config) if uses_sandbox(config) else []), *config.worker]
    group = create_memory_group(memory_ceiling() + _SESSION_MEMORY)
    if group is not None:
        command = [*_JOIN, str(group.members), *command]
    ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_STREAM)
    errors = ErrorOutput()
    try:
        pid = os.posix_spawn(
            shutil.which(command[0]) or command[0],
            command,
            _environment(),
            file_actions=[
                (os.POSIX_SPAWN_OPEN, 0, "/dev/null", os.O_RDONLY, 0),
                (os.POSIX_SPAWN_DUP2, errors.descriptor, 2),
                (os.POSIX_SPAWN_DUP2, theirs.fileno(), _DESCRIPTOR),
            ],
            setsid=True,
        )
    except OSError:
        ours.close()
        errors.close()
        if group is not None:
            group.remove()
        raise
    finally:
        theirs.close()
    return WorkerProcess(pid, ours, group, errors)


def _environment() -> dict[str, str]:
    """
    As little as a worker needs; nothing of the person's own.

    ROSY_LIBRARIES: folders of shared libraries, where they are not the system's (on a stick).
    """
    passed_on = {"ROSY_PACKAGE_DB": "ROSY_PACKAGE_DB", "ROSY_LIBRARIES": "LD_LIBRARY_PATH"}
    kept = {inside: os.environ[outside] for outside, inside in passed_on.items() if outside in os.environ}
    return {"PATH": "/usr/bin:/bin", "LANG": "C.UTF-8", "HOME": "/tmp", **kept}


def _sandbox(config: Config) -> list[str]:
    command = ["bwrap", "--unshare-all", "--die-with-parent", "--cap-drop", "ALL", "--clearenv"]
    for name, value in _environment().items():
        command += ["--setenv", name, value]
    for name in _SYSTEM:
        if Path(name).exists():
            command += ["--ro-bind", name, name]
    for name in _LINKS:
        if Path(name).is_symlink():
            command += ["--symlink", os.readlink(name), name]
        elif Path(name).is_dir():
            command += ["--ro-bind", name, name]
    command += ["--proc", "/proc", "--dev", "/dev", "--tmpfs", "/tmp"]
    for folder in config.visible:
        command += ["--ro-bind", str(folder), str(folder)]
    return [*command, "--chdir", "/tmp", "--"]


def missing_sandbox(config: Config) -> Sentence | None:
    """Why workers of this configuration run without their sandbox, or ``None`` when they have it."""
    return sandbox_fault() if config.sandbox else tr("the sandbox is turned off")


def uses_sandbox(config: Config) -> bool:
    """Whether workers of this configuration are wrapped."""
    return missing_sandbox(config) is None
