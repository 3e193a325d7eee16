"""
Whether this machine can build the workers' sandbox.

Standard library only: ``./rosy doctor`` asks it before anything is installed.
"""

from __future__ import annotations

import functools
import shutil
import subprocess

from ..sentences.sentence import Sentence, tr, verbatim
from ..text_lines import text_lines

__all__ = ["sandbox_fault"]


@functools.cache
def sandbox_fault() -> Sentence | None:
    """Why this machine cannot build the sandbox, or ``None`` when it can."""
    if shutil.which("bwrap") is None:
        return tr("bubblewrap is not installed")
    probe = [
        "bwrap",
        "--unshare-all",
        "--cap-drop",
        "ALL",
        "--ro-bind",
        "/",
        "/",
        "--proc",
        "/proc",
        "--dev",
        "/dev",
        "/bin/true",
    ]
    try:
        # A busy machine takes seconds for it, and programs would run without their sandbox.
        done = subprocess.run(probe, capture_output=True, timeout=60, check=False)
    except (OSError, subprocess.TimeoutExpired) as error:
        return verbatim(str(error))
    if done.returncode == 0:
        return None
    said = text_lines(done.stderr.decode(errors="replace").strip())
    return verbatim(said[-1]) if said else tr("the kernel does not allow new namespaces")
