"""
Configuration: every path and limit that may differ between machines.

Paths come from the project's root: ``ROSY_ROOT`` if set, else the folder above this package. Each can
be overridden by an environment variable, named below.
"""

from __future__ import annotations

import os
from dataclasses import dataclass, field, replace
from pathlib import Path

from .memory_ceiling import memory_ceiling

__all__ = ["Config", "Limits", "discover"]


@dataclass(frozen=True, slots=True)
class Limits:
    """Wall-clock limits in s, sizes in bytes or counts."""

    # A step that takes longer than this ends the run as `stuck`. Programs have a low priority: on a busy machine one
    # may get no processor for two seconds.
    settle: float = 5.0
    # From `started` to the program's `ready`.
    ready: float = 10.0
    # Without a sign of the person at the page, until a run on a real robot is ended; its wheels stand long before.
    unattended: float = 3.0
    # From `stop` to the program's `ended`, before it is killed.
    stop: float = 1.0
    # For the worker to say what became of a killed or dead run; it says so at once when it has the processor.
    gone: float = 10.0
    # A check or a compilation: longer than the worker lets one wait that gets no processor (`--check-seconds`).
    compile: float = 60.0
    # Processor time of one preview after its compilation; then the path ends early.
    preview: float = 3.0
    # For a fresh worker to become `ready`: 1.5 s of a processor, which a busy machine may take a minute to give.
    worker_ready: float = 120.0
    # Memory of a run: what a learner's program needs ten times over, and a class of thirty fits into 2 GB.
    memory: int = 64 * 1024 * 1024
    # Pages at once.
    sessions: int = 400
    # Pages at once from one client address: a school behind one address, and never all of them.
    address_sessions: int = 200
    # Programs that are compiled before Run is pressed, of all pages: some 8 MB each. protocol/README.md, section 3.
    prepared: int = 40
    # Programs that run at once; further runs wait in the run queue. `./rosy start --runs`.
    runs: int = 100
    # A message from a page.
    page_message: int = 1_000_000
    # Characters of a program. protocol/README.md, section 3.
    source: int = 200_000
    # Messages waiting for a slow page before it is disconnected.
    page_queue: int = 2_000
    # Frames per second to a page. protocol/README.md, section 4.
    frame_rate: float = 60.0

    def stretched(self, factor: float) -> Limits:
        """The same with longer times for programs and workers, which get less of the processor than others."""
        return replace(
            self,
            settle=factor * self.settle,
            ready=factor * self.ready,
            stop=factor * self.stop,
            gone=factor * self.gone,
            compile=factor * self.compile,
            worker_ready=factor * self.worker_ready,
        )


@dataclass(frozen=True, slots=True)
class Config:
    """Configuration of the service, as given or found."""

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
    # The rosy-robot executable; None while it is not built. ROSY_ROBOT.
    robot_executable: Path | None = None
    # Addresses of the robots that pages may drive, by name.
    robots: dict[str, str] = field(default_factory=dict)
    # Addresses of ROS 2 at which robots are discovered that pages may drive too.
    nearby: tuple[str, ...] = ()
    # The folder of classes, one folder each. ROSY_CLASSES; else in the person's data folder (XDG base directories).
    classes: Path = field(default_factory=lambda: _classes())
    # The folder of recordings of runs on real robots. ROSY_RECORDINGS; else in the person's data folder.
    recordings: Path = field(default_factory=lambda: _recordings())
    # Whether runs of pages on real robots are recorded.
    records: bool = True
    # URL of the PostgreSQL database of all classes, or sqlite:/PATH; None for the folder. ROSY_CLASS_DATABASE.
    class_database: str | None = None
    # The class that is served; None without class mode.
    class_name: str | None = None
    # Where the robot of the oldest page is on ROS 2 too.
    simulator_address: str | None = None
    # HOST or HOST:PORT of other services whose pages may connect to this one: those of a cluster.
    origins: frozenset[str] = frozenset()
    # Addresses of proxies whose `X-Forwarded-For` says who the client is. ROSY_PROXIES, with commas.
    proxies: tuple[str, ...] = ()
    # What pupils open, where it is not the address of this service.
    class_address: str | None = None
    # Where the internet reaches this service, through a proxy on the way: https://HOST, without a slash at its end.
    public: str | None = None
    limits: Limits = field(default_factory=Limits)

    @property
    def text_service(self) -> Path:
        """Codegen's command line, as Node runs it."""
        return self.root / "codegen" / "dist" / "cli.js"

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
    robot_executable = os.environ.get("ROSY_ROBOT")
    return Config(
        root=root,
        page=Path(os.environ.get("ROSY_PAGE") or root / "editor" / "dist"),
        examples=Path(os.environ.get("ROSY_EXAMPLES") or root / "examples"),
        worker=(str(executable), *_compiler(), "--total-memory", str(memory_ceiling()))
        if executable is not None
        else (),
        sandbox=os.environ.get("ROSY_SANDBOX", "on") != "off",
        class_database=os.environ.get("ROSY_CLASS_DATABASE") or None,
        proxies=tuple(name.strip() for name in os.environ.get("ROSY_PROXIES", "").split(",") if name.strip()),
        visible=_visible(executable),
        robot_executable=Path(robot_executable).resolve() if robot_executable else _built(root, "rosy-robot"),
    )


def _classes() -> Path:
    return Path(os.environ.get("ROSY_CLASSES") or _data_folder() / "classes")


def _recordings() -> Path:
    return Path(os.environ.get("ROSY_RECORDINGS") or _data_folder() / "recordings")


def _data_folder() -> Path:
    data = os.environ.get("XDG_DATA_HOME", "")
    home = Path(data) if data.startswith("/") else Path.home() / ".local" / "share"
    return home / "rosy"


def _built(root: Path, name: str) -> Path | None:
    """The newest executable of this name that cabal built here."""
    pattern = f"dist-newstyle/build/*/ghc-*/rosy-*/x/{name}/**/{name}"
    built = [path for path in root.glob(pattern) if path.is_file()]
    return max(built, key=lambda path: path.stat().st_mtime, default=None)


def _compiler() -> tuple[str, ...]:
    """
    Where GHC's libraries are: ROSY_LIBDIR, or Debian's place. Elsewhere the worker asks ``ghc``, which takes longer.
    """
    named = os.environ.get("ROSY_LIBDIR")
    if named:
        return ("--libdir", named)
    return ("--libdir", "/usr/lib/ghc") if Path("/usr/lib/ghc/settings").exists() else ()


def _visible(executable: Path | None) -> tuple[Path, ...]:
    """
    The build folder the worker lies in, with the library beside it (rosy-hs/worker/README.md).

    Also GHC's folder and those of shared libraries where they are not the system's: ROSY_LIBDIR and ROSY_LIBRARIES.
    """
    if executable is None:
        return ()
    built = [folder for folder in executable.parents if folder.name == "dist-newstyle"]
    named = [os.environ.get("ROSY_LIBDIR", ""), *os.environ.get("ROSY_LIBRARIES", "").split(":")]
    return (built[0] if built else executable.parent, *(Path(name) for name in named if name and Path(name).is_dir()))
