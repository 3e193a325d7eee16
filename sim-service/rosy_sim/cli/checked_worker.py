"""Worker of a command. A missing sandbox is reported."""

from __future__ import annotations

import sys

from ..config import Config
from ..sentences.wording import in_terminal
from ..worker.blocking_worker import BlockingWorker
from ..worker.launcher import missing_sandbox, sandbox_warning

__all__ = ["started_worker", "warn_without_sandbox"]


def started_worker(config: Config) -> BlockingWorker:
    """A worker; a missing sandbox is reported."""
    worker = BlockingWorker(config)
    warn_without_sandbox(config)
    return worker


def warn_without_sandbox(config: Config) -> None:
    fault = missing_sandbox(config)
    if fault is not None:
        print(f"rosy: {in_terminal(sandbox_warning(fault))}", file=sys.stderr)
