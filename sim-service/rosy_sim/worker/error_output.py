"""
Standard error of a worker: the beginning of what it and its sandbox write, kept in memory of a fixed size.

A worker that cannot start says why on standard error. Writes beyond the size fail, so nothing waits for a reader.
"""

from __future__ import annotations

import fcntl
import os

from ..sentences.sentence import Sentence, verbatim

__all__ = ["ErrorOutput"]

_SIZE = 4096
"""Bytes that are kept."""

_LONGEST = 300
"""Characters of a cause in a sentence."""


class ErrorOutput:
    """Owns a descriptor for a child process to write to. Call close() in any case."""

    def __init__(self) -> None:
        self.descriptor = os.memfd_create("rosy-worker-errors", os.MFD_CLOEXEC | os.MFD_ALLOW_SEALING)
        os.ftruncate(self.descriptor, _SIZE)
        fcntl.fcntl(self.descriptor, fcntl.F_ADD_SEALS, fcntl.F_SEAL_GROW | fcntl.F_SEAL_SHRINK)

    def text(self) -> str:
        """What has been written so far, as one line."""
        written = os.pread(self.descriptor, _SIZE, 0).rstrip(b"\0").decode(errors="replace")
        words = " ".join(written.removeprefix("rosy-worker:").split())
        return words if len(words) <= _LONGEST else words[: _LONGEST - 1] + "…"

    def cause(self, otherwise: Sentence) -> Sentence:
        """What has been written, or ``otherwise`` when that is nothing."""
        text = self.text()
        return verbatim(text) if text else otherwise

    def close(self) -> None:
        """Forget what was written."""
        os.close(self.descriptor)
