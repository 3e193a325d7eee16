"""
Where things are and how long anything may take: every path and limit that a machine may want to change.

Paths come from the project's root: ``ROSY_ROOT`` if set, else the folder above this package. Each can
be overridden by an environment variable, named below.
"""

from __future__ import annotations

import os
from dataclasses import dataclass, field, replace
from pathlib import Path

__all__ = ["Config", "Limits", "discover"]


@dataclass(frozen=True, slots=True)
class Limits:
    """Wall-clock limits in s, sizes in bytes or counts."""

    # A step that takes longer than this ends the run as `stuck`.
    settle: float = 2.0
    # From `started` to the program's `ready`.
    ready: float = 10.0
    # From `stop` to the program's `ended`, before it is killed.
    stop: float = 1.0
    # For the worker to say what became of a killed or dead run.
    gone: float = 1.0
    # A check or a compilation.
    compile: float = 30.0
    # For a fresh worker to become `ready`.
    worker_ready: float = 30.0
    # Memory of a run: what a learner's program needs ten times over, and a class of thirty fits into 2 GB.
    memory: int = 64 * 1024 * 1024
    # Pages at once.
    sessions: int = 400
    # Programs that run at once; others wait their turn. `./rosy start --runs`.
    runs: int = 100
    # A message from a page.
    page_message: int = 1_000_000
    # Characters of a program. protocol/README.md, section 3.
    source: int = 200_000
    # Messages waiting for a slow page before it is let go.
    page_queue: int = 2_000
    # Frames per second to a page. protocol/README.md, section 4.
    frame_rate: float = 60.0


@dataclass(frozen=True, slots=True)
class Config:
    """What the service was told or found."""

    root: Path
    # The built page. ROSY_PAGE.
    page: Path
    # Folders with program.rosy. ROSY_EXAMPLES.
    examples: Path
    # The command that starts a worker; empty when none is built. ROSY_WORKER names the executable.
    worker: tuple[str, ...]
    # Whether the worker is wrapped in bubblewrap. ROSY_SANDBOX=off turns it off (tests, odd kernels).
    sandbox: bool = True
    # Folders, read-only for the worker, beside the system's own.
    visible: tuple[Path, ...] = ()
    # What speaks to real robots; None while it is not built. ROSY_ROBOT.
    speaker: Path | None = None
    # The robots that pages may drive: their names, and their addresses.
    robots: dict[str, str] = field(default_factory=dict)
    limits: Limits = field(default_factory=Limits)

    @property
    def api_docs(self) -> Path:
        """The built pages that explain every name of the language."""
        return self.root / ".rosy" / "api-docs"

    def with_limits(self, limits: Limits) -> Config:
        """The same with other limits."""
        return replace(self, limits=limits)


def discover() -> Config:
    """Find everything from the environment and the project's root."""
    root = Path(os.environ.get("ROSY_ROOT") or Path(__file__).resolve().parents[2]).resolve()
    named = os.environ.get("ROSY_WORKER")
    executable = Path(named).resolve() if named else _built(root, "rosy-worker")
    speaker = os.environ.get("ROSY_ROBOT")
    return Config(
        root=root,
        page=Path(os.environ.get("ROSY_PAGE") or root / "editor" / "dist"),
        examples=Path(os.environ.get("ROSY_EXAMPLES") or root / "examples"),
        worker=(str(executable), *_compiler()) if executable is not None else (),
        sandbox=os.environ.get("ROSY_SANDBOX", "on") != "off",
        visible=_visible(executable),
        speaker=Path(speaker).resolve() if speaker else _built(root, "rosy-robot"),
    )


def _built(root: Path, name: str) -> Path | None:
    """The newest executable of this name that cabal built here."""
    pattern = f"dist-newstyle/build/*/ghc-*/rosy-*/x/{name}/**/{name}"
    built = [path for path in root.glob(pattern) if path.is_file()]
    return max(built, key=lambda path: path.stat().st_mtime, default=None)


def _compiler() -> tuple[str, ...]:
    """Where Debian keeps GHC's libraries; elsewhere the worker asks ``ghc``, which takes a little longer."""
    return ("--libdir", "/usr/lib/ghc") if Path("/usr/lib/ghc/settings").exists() else ()


def _visible(executable: Path | None) -> tuple[Path, ...]:
    """The build folder the worker lies in, with the library beside it (rosy-hs/worker/README.md)."""
    if executable is None:
        return ()
    built = [folder for folder in executable.parents if folder.name == "dist-newstyle"]
    return (built[0] if built else executable.parent,)
