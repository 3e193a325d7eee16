"""Language server on standard input and output: ``./rosy lsp``."""

from __future__ import annotations

import os
import shutil
import sys

from ..config import Config
from ..errors import WorkerMissing
from .handlers import register
from .session import EditorSession

__all__ = ["serve_editor"]


def serve_editor(config: Config) -> int:
    """Serve one editor until it says ``exit`` or closes standard input; returns the exit status."""
    if not config.worker or shutil.which(config.worker[0]) is None:
        raise WorkerMissing
    # Standard output belongs to the protocol; what anything else prints goes to standard error.
    protocol = os.fdopen(os.dup(sys.stdout.fileno()), "wb")
    os.dup2(sys.stderr.fileno(), sys.stdout.fileno())
    session = EditorSession(config)
    register(session)
    session.start_io(sys.stdin.buffer, protocol)
    return 0
