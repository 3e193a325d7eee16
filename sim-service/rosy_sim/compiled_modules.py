"""
Compiled modules: those that compute in each step of a run, as an extension that mypyc makes of the same sources.

In: a folder made by ``compile_service``. The import system takes the modules from there while they are those of exactly
these sources and of this interpreter; else it interprets the sources, with the same results in twice the time.
``ROSY_COMPILED=off`` does so in any case.
"""

from __future__ import annotations

import importlib
import importlib.util
import os
import sys
import zlib
from collections.abc import Mapping, Sequence
from importlib.machinery import EXTENSION_SUFFIXES, ModuleSpec
from pathlib import Path
from types import ModuleType

__all__ = ["MODULES", "SOURCES", "fingerprint", "install"]

_MODULES = (
    "previews.path_recorder",
    "run.frame_rate",
    "run.headless_run",
    "run.lateness",
    "run.loop_link",
    "run.program_link",
    "run.realtime_runner",
    "run.step_display",
    "run.step_phases",
    "run.steps.blocked_drive",
    "run.steps.command_conflicts",
    "run.steps.lockstep",
    "run.steps.quiet_steps",
    "run.steps.replay",
    "run.steps.velocity_guard",
    "token_bucket",
    "web.sessions.page_view",
    "web.sessions.simulator.hands_recorder",
    "web.sessions.simulator.ros_bridge",
    "web.sessions.simulator.simulated_robot",
    "wire.channels",
    "wire.line_splitter",
    "wire.robot_link",
    "worker.mailbox",
    "world.motor_controller",
    "world.obstacles",
    "world.realism",
    "world.shared_world",
    "world.world",
)
"""Without the name of the package. A module whose classes a library looks into (msgspec) or a test replaces cannot be
compiled."""

_NOT_OF_A_ROBOT = ("__init__", "connector", "dimensions", "facts")
"""Modules of a robot that read files or say what it is made of. The others compute what its parts do in each step."""

_PACKAGE = Path(__file__).parent

MODULES = (
    *_MODULES,
    *sorted(
        f"robots.{path.parent.name}.{path.stem}"
        for path in (_PACKAGE / "robots").glob("*/*.py")
        if path.stem not in _NOT_OF_A_ROBOT
    ),
)
"""All of them."""

SOURCES = "sources"
"""The file that says of which sources the extension was made: a ``fingerprint``."""


def source_of(name: str) -> Path:
    """The source file of one of the modules."""
    return _PACKAGE / (name.replace(".", "/") + ".py")


def fingerprint() -> str:
    """Of the sources and of this interpreter: its name for extensions, and a checksum and the size of each source."""
    # A checksum of zlib, because loading a library for a better one would take longer than all else here.
    sources = [source_of(name).read_bytes() for name in MODULES]
    return " ".join([EXTENSION_SUFFIXES[0], *(f"{zlib.crc32(source):08x}.{len(source)}" for source in sources)])


class _CompiledFinder:
    """Finds these modules by their full names in these files. A finder of the import system."""

    def __init__(self, files: Mapping[str, Path]) -> None:
        self._files = files

    def find_spec(
        self,
        fullname: str,
        _path: Sequence[str] | None,
        _target: ModuleType | None = None,
    ) -> ModuleSpec | None:
        """Where a module is, if it is one of these."""
        file = self._files.get(fullname)
        return importlib.util.spec_from_file_location(fullname, file) if file is not None else None


def install(folder: Path) -> bool:
    """Whether the modules come from this folder from now on. Call before one of them is imported."""
    if os.environ.get("ROSY_COMPILED") == "off":
        return False
    try:
        if (folder / SOURCES).read_text() != fingerprint():
            return False
    except OSError:
        return False
    suffix = EXTENSION_SUFFIXES[0]
    files = {f"rosy_sim.{name}": folder / "rosy_sim" / (name.replace(".", "/") + suffix) for name in MODULES}
    # All modules are in one library; the other files only lead to it.
    shared = next(folder.glob(f"*__mypyc{suffix}"), None)
    if shared is None:
        return False
    name = shared.name.removesuffix(suffix)
    finder = _CompiledFinder(files | {name: shared})
    sys.meta_path.insert(0, finder)
    try:
        importlib.import_module(name)
    except ImportError:
        # It was made on a machine with other libraries.
        sys.meta_path.remove(finder)
        return False
    return True
