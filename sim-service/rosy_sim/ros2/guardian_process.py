"""Starts the guardian of a bridge and keeps in touch with it (``guardian.py``)."""

from __future__ import annotations

import asyncio
import os
import subprocess
import sys

__all__ = ["GuardianProcess"]


class GuardianProcess:
    """Started at once, so that it is ready when a client comes; a new one after one has ended."""

    def __init__(self, domain: int, address: str | None) -> None:
        self._arguments = [str(domain), address or ""]
        self._guarded: set[tuple[str, str]] = set()
        self._process = self._start()

    async def guard(self, topic: str, kind: str) -> None:
        """Returns when the guardian would stop this topic of DDS, of this type."""
        if (topic, kind) not in self._guarded:
            self._guarded.add((topic, kind))
            self._write(f"{topic} {kind}\n".encode())
            assert self._process.stdout is not None
            await asyncio.to_thread(self._process.stdout.readline)

    def beat(self) -> None:
        """A sign of life. One that a guardian does not take because it stands still is lost."""
        self._write(b"\n")

    def has_ended(self) -> bool:
        """By itself; tells it once, and starts another."""
        if self._process.poll() is None:
            return False
        self._guarded = set()
        self._process = self._start()
        return True

    def _start(self) -> subprocess.Popen[bytes]:
        process = subprocess.Popen(
            [sys.executable, "-m", "rosy_sim.ros2.guardian", *self._arguments],
            bufsize=0,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            start_new_session=True,
        )
        assert process.stdin is not None
        os.set_blocking(process.stdin.fileno(), False)
        return process

    def _write(self, line: bytes) -> None:
        assert self._process.stdin is not None
        try:
            self._process.stdin.write(line)
        except OSError:
            # It has ended, which has_ended() tells, or its pipe is full.
            return
