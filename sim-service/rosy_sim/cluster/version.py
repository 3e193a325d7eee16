"""
Version of the Rosy on a machine, by what decides how a program is run: a fingerprint of the sources.

Programs are tested only on nodes of the version of the machine that asks, so that the answer is the one that it would
have found itself. During an upgrade nodes of two versions are in one cluster.
"""

from __future__ import annotations

import hashlib
from pathlib import Path

__all__ = ["version_resource"]

_DECISIVE = ("rosy.cabal", "protocol", "rosy-hs/src", "rosy-hs/worker", "rosy-hs/app", "sim-service/rosy_sim")
"""Files and folders of the project."""

_SUFFIXES = frozenset({".cabal", ".hs", ".json", ".py"})


def version_resource(root: Path) -> str:
    """The name of the Ray resource that nodes of this version have."""
    found = hashlib.sha256()
    for part in _DECISIVE:
        path = root / part
        for file in [path] if path.is_file() else sorted(path.rglob("*")):
            if file.suffix in _SUFFIXES and file.is_file():
                found.update(f"{file.relative_to(root)}\0".encode() + hashlib.sha256(file.read_bytes()).digest())
    return f"rosy-{found.hexdigest()[:16]}"
