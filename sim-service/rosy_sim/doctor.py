"""
``./rosy doctor``: what of Rosy works on this computer, and what to do about the rest, on one screen for a bug report.

Neither it nor what it imports needs more than the standard library: it answers before anything is installed or built.
Names of people and folders, and addresses, are not printed.
"""

from __future__ import annotations

import os
import platform
import re
import shutil
import socket
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from .sentences.sentence import Sentence, tr
from .sentences.terminal_text import neutralize_line
from .sentences.wording import in_terminal
from .text_lines import text_lines
from .version import VERSION
from .worker.sandbox_probe import sandbox_fault

__all__ = ["Finding", "Machine", "findings", "main"]

_OLDEST = {"debian": (12,), "ubuntu": (24, 4)}
"""The oldest supported releases, by the ID of os-release(5)."""

_DISK = 200
"""Free space to work with a Rosy that is built, MB: a judgement, for what a class stores in an afternoon."""

_PROGRAM = "main = simulate (Velocity 0.2 0)\n"

_PATIENCE = 120
"""For a program to be compiled and to run, s. A start of the compiler takes 2 s; a busy machine may need a minute."""

_MARKS = {"good": "✓", "bad": "✗", "note": "·"}


@dataclass(frozen=True, slots=True)
class Finding:
    """One line: something works, does not work, or is worth knowing. ``advice`` says what to do."""

    state: Literal["good", "bad", "note"]
    sentence: Sentence
    advice: Sentence | None = None


@dataclass(frozen=True, slots=True)
class Machine:
    """What the findings are made of. ``None``: not there, or not known."""

    version: str
    kind: Literal["clone", "package", "stick"]
    release: Mapping[str, str]
    """Fields of os-release(5)."""
    system: str
    architecture: str
    processors: int
    memory: int | None
    """MB."""
    free_disk: int
    """MB, at the folder of Rosy."""
    disk_to_build: int
    """MB that the first start of a clone takes."""
    python: str
    ghc: str | None
    supported_ghc: tuple[str, ...]
    sandbox_fault: Sentence | None
    is_built: bool
    run_fault: str | None
    """Why a small program did not compile or run; ``None`` when it did, or when nothing is built."""
    run_seconds: float
    has_page: bool
    is_port_in_use: bool
    cables: tuple[tuple[str, bool], ...]
    """Serial devices, and whether this user may open them."""


def findings(machine: Machine) -> Iterator[Finding]:
    """What a person should know of this machine, the most general first."""
    yield Finding("good", tr("Rosy {version}", version=machine.version))
    yield from _about_system(machine)
    yield from _about_tools(machine)
    yield from _about_programs(machine)
    if machine.is_port_in_use:
        yield Finding(
            "note",
            tr("Port {port} is in use, perhaps by a Rosy that runs already.", port="8080"),
            tr("Another port for a second one: {command}", command="./rosy start --port 8081"),
        )
    for device, may_open in machine.cables:
        if may_open:
            yield Finding("good", tr("A cable of a robot is at {device}.", device=device))
        else:
            yield Finding(
                "bad",
                tr("A cable is at {device}, which you may not use.", device=device),
                tr("{command}, then log in again", command='sudo usermod -aG dialout "$USER"'),
            )


def _about_system(machine: Machine) -> Iterator[Finding]:
    name = machine.release.get("PRETTY_NAME", machine.system)
    hardware = tr(
        "{system}, {architecture}, {processors} processors, {memory} MB of memory",
        system=name,
        architecture=machine.architecture,
        processors=str(machine.processors),
        memory="?" if machine.memory is None else str(machine.memory),
    )
    if machine.kind != "stick" and not _is_supported(machine):
        advice = tr("Use Debian 12, Ubuntu 24.04 or a newer one, also in WSL 2 on Windows or in Linux on a Chromebook.")
        yield Finding("bad", hardware, advice)
    else:
        yield Finding("good", hardware)
    needed = _DISK if machine.is_built else machine.disk_to_build
    free = tr("{free} MB of disk space are free.", free=str(machine.free_disk))
    if machine.free_disk < needed:
        yield Finding(
            "bad", free, tr("Rosy needs {needed} MB: delete something, or use a larger disk.", needed=str(needed))
        )
    else:
        yield Finding("good", free)


def _is_supported(machine: Machine) -> bool:
    oldest = _OLDEST.get(machine.release.get("ID", ""))
    # Debian testing has no version.
    version = tuple(int(part) for part in re.findall(r"\d+", machine.release.get("VERSION_ID", "9999")))
    return machine.system == "Linux" and oldest is not None and version >= oldest


def _about_tools(machine: Machine) -> Iterator[Finding]:
    if machine.kind != "clone":
        return
    if machine.ghc is None:
        yield Finding(
            "note", tr("GHC, the compiler, is not installed yet."), tr("{command} installs it.", command="./rosy start")
        )
    elif not machine.ghc.startswith(tuple(f"{known}." for known in machine.supported_ghc)):
        known = " ".join(machine.supported_ghc)
        yield Finding(
            "bad",
            tr("This system has GHC {version}; Rosy knows GHC {versions}.", version=machine.ghc, versions=known),
            tr("Use Debian 12 or Ubuntu 24.04, or a newer Rosy."),
        )
    else:
        yield Finding("good", tr("Python {python}, GHC {ghc}", python=machine.python, ghc=machine.ghc))


def _about_programs(machine: Machine) -> Iterator[Finding]:
    if not machine.is_built:
        yield Finding("note", tr("Nothing is built yet."), tr("{command} does it, once.", command="./rosy start"))
    elif machine.run_fault is not None:
        advice = tr(
            "Try it in a terminal: {command}", command="./rosy run examples/forwardBackward/Main.hs --seconds 1"
        )
        yield Finding("bad", tr("A small program does not run: {why}", why=machine.run_fault), advice)
    else:
        yield Finding(
            "good", tr("A small program was compiled and drove: {seconds} s", seconds=round(machine.run_seconds, 1))
        )
    if machine.is_built and not machine.has_page:
        yield Finding("note", tr("The page is not built yet."), tr("{command} does it, once.", command="./rosy start"))
    if machine.sandbox_fault is None:
        yield Finding("good", tr("Programs are kept in their sandbox."))
    else:
        advice = tr("Let only people you trust use this Rosy: a program could read your files.")
        if machine.sandbox_fault == tr("bubblewrap is not installed"):
            advice = tr("{command} installs it.", command="sudo apt install bubblewrap")
        yield Finding("bad", tr("programs run without their sandbox: {fault}.", fault=machine.sandbox_fault), advice)


def this_machine(root: Path, disk_to_build: int, supported_ghc: Sequence[str]) -> Machine:
    """Look at this machine; nothing is changed on it."""
    installed = (root / ".installed").exists()
    workers = root.glob("dist-newstyle/build/*/ghc-*/rosy-*/x/rosy-worker/build/rosy-worker/rosy-worker")
    is_built = installed or ((root / ".rosy/venv/bin/python").exists() and any(workers))
    began = time.monotonic()
    run_fault = _try_program(root) if is_built else None
    return Machine(
        version=VERSION,
        kind="stick" if (root / "python-home").exists() else "package" if installed else "clone",
        release=_release(),
        system=platform.system(),
        architecture=platform.machine(),
        processors=len(os.sched_getaffinity(0)),
        memory=_memory(),
        free_disk=shutil.disk_usage(root).free // 1_000_000,
        disk_to_build=disk_to_build,
        python=platform.python_version(),
        ghc=_output_of("ghc", "--numeric-version"),
        supported_ghc=tuple(supported_ghc),
        sandbox_fault=sandbox_fault(),
        is_built=is_built,
        run_fault=run_fault,
        run_seconds=time.monotonic() - began,
        has_page=(root / "editor/dist/index.html").exists(),
        is_port_in_use=_is_in_use(8080),
        cables=tuple(
            (str(device), os.access(device, os.R_OK | os.W_OK)) for device in sorted(Path("/dev").glob("ttyUSB*"))
        ),
    )


def _release() -> Mapping[str, str]:
    try:
        return platform.freedesktop_os_release()
    except OSError:
        return {}


def _memory() -> int | None:
    try:
        return os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE") // 1_000_000
    except (OSError, ValueError):
        return None


def _output_of(*command: str) -> str | None:
    try:
        return subprocess.run(command, capture_output=True, text=True, timeout=20, check=True).stdout.strip()
    except (OSError, subprocess.SubprocessError):
        return None


def _is_in_use(port: int) -> bool:
    with socket.socket() as client:
        client.settimeout(1)
        return client.connect_ex(("127.0.0.1", port)) == 0


def _try_program(root: Path) -> str | None:
    """Compile a small program and drive for a second; returns the last line that was printed when this fails."""
    python = os.environ.get("ROSY_PYTHON", sys.executable)
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder, "small.hs")
        program.write_text(_PROGRAM)
        command = [python, "-m", "rosy_sim", "run", str(program), "--seconds", "1", "--speed", "max"]
        try:
            done = subprocess.run(
                command, capture_output=True, text=True, errors="replace", timeout=_PATIENCE, check=False, cwd=root
            )
        except OSError as error:
            return error.strerror
        except subprocess.TimeoutExpired:
            return in_terminal(tr("it did not end within {seconds} s", seconds=str(_PATIENCE)))
    lines = [line for line in text_lines(done.stderr.replace(str(root), "…")) if line.strip()]
    return None if done.returncode == 0 else (lines[-1] if lines else f"{done.returncode}")


def main(arguments: Sequence[str]) -> int:
    """
    Print the findings; returns the exit status: 1 when something does not work.

    Args:
        arguments: of scripts/lib/doctor.sh: the MB that a first start takes, and the supported versions of GHC.
    """
    disk, *supported_ghc = arguments
    found = list(findings(this_machine(Path(os.environ["ROSY_ROOT"]), int(disk), supported_ghc)))
    for finding in found:
        print(f"{_MARKS[finding.state]} {neutralize_line(in_terminal(finding.sentence))}")
        if finding.advice is not None:
            print(f"    {neutralize_line(in_terminal(finding.advice))}")
    return 1 if any(finding.state == "bad" for finding in found) else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
