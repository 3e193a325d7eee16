"""
Native build: ``rosy-build`` (rosy-hs/builder) compiles a program with GHC to an executable that drives a robot.

The program must have passed the worker's check. Intermediate files go into a folder that is removed afterwards.
"""

from __future__ import annotations

import platform
import re
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

from ..atomic_file import AtomicFile
from ..errors import BadInput, WorkerMissing
from ..sentences.sentence import tr
from ..sentences.wording import in_terminal

__all__ = ["PROCESSORS", "build_program", "is_native", "refuse_other_processor"]

PROCESSORS = {"x86_64": "amd64", "aarch64": "arm64"}
"""Debian's names of the kinds of processor that Rosy is for, by those that uname(2) reports."""

_ARCHIVES = ("libgmp.a", "libffi.a", "libz.a")
"""Libraries that a robot's computer need not have, also where the C library cannot become a part of the file."""

_LINKER_ADVICE = re.compile(
    r": warning: Using '\w+' in statically linked applications requires|: in function `\w+':$"
    r"|: note: the message above does not take linker garbage collection into account$"
)
"""
Warnings of the linker about functions that load a library of the machine. Of host lookups, which ``Ros.Net.HostLookup``
heeds; the others are of functions of GHC's libraries that no built program calls (users, groups, loading code). The
note follows each of them in newer versions of the linker.
"""


def refuse_other_processor(wanted: str, source: Path, output: Path) -> None:
    """
    GHC, as Debian and Ubuntu package it, makes code only for the kind of processor that it runs on.

    Raises:
        BadInput: ``wanted``, one of the values of ``PROCESSORS``, is another kind.
    """
    here = platform.machine()
    here = PROCESSORS.get(here, here)
    if wanted != here:
        command = shlex.join(["./rosy", "build", str(source), "-o", str(output)])
        raise BadInput(
            tr(
                "Here GHC makes programs for {here} only. On a computer with {wanted} that has Rosy, type: {command}",
                here=here,
                wanted=wanted,
                command=command,
            )
        )


def build_program(root: Path, source: str, output: Path) -> int:
    """
    Compile and link a checked program; returns the exit status. GHC speaks for itself, on standard error.

    Raises:
        BadInput: nothing can be written there.
        WorkerMissing: the compiler part has not been built.
    """
    builder = _newest(root, "dist-newstyle/build/*/ghc-*/rosy-*/x/rosy-build/**/rosy-build")
    robots = _newest(root, "dist-newstyle/packagedb/ghc-*/rosy-*-robots.conf")
    if builder is None or robots is None:
        raise WorkerMissing
    if output.is_dir() or not output.absolute().parent.is_dir():
        raise BadInput(tr("{output} cannot be written: name a file in a folder that exists.", output=output))
    with tempfile.TemporaryDirectory(prefix="rosy-build-") as folder:
        scratch = Path(folder)
        program, binary = scratch / "Main.hs", scratch / "program"
        program.write_text(source, encoding="utf-8")
        static = _archive("libc.a") is not None
        if not static:
            note = tr(
                "This computer has no static C library,"
                " so the program needs a C library that is no older than the one here."
            )
            print(in_terminal(note), file=sys.stderr)
            _link_static_archives(scratch)
        units = f"{robots.stem.removesuffix('-robots')},{robots.stem}"
        request = [_libdir(), robots.parent, units, scratch, program, root, binary, "static" if static else "dynamic"]
        finished = subprocess.run([builder, *map(str, request)], stderr=subprocess.PIPE, text=True, check=False)
        said = finished.stderr.splitlines(keepends=True)
        if finished.returncode == 0:
            said = [line for line in said if not _LINKER_ADVICE.search(line)]
            _install(binary, output)
        # Of a build that failed all is told: such a line may say where the fault is.
        sys.stderr.writelines(said)
    return finished.returncode


def is_native(path: Path) -> bool:
    """Whether a file is an executable program (ELF's first four bytes), as ``build_program`` makes them."""
    try:
        with path.open("rb") as file:
            return file.read(4) == b"\x7fELF"
    except OSError:
        return False


def _install(binary: Path, output: Path) -> None:
    """Replaces the output as a whole; an old version that is running keeps its own file."""
    with AtomicFile(output, mode=0o755) as file:
        file.write(binary.read_bytes())


def _link_static_archives(folder: Path) -> None:
    """What the linker finds there as an archive and not as a shared library becomes a part of the file."""
    for name in _ARCHIVES:
        archive = _archive(name)
        if archive is not None:
            (folder / name).symlink_to(archive)


def _archive(name: str) -> Path | None:
    """Where the C compiler has this static library; a bare name comes back from it where there is none."""
    archive = Path(_output_of("gcc", f"-print-file-name={name}"))
    return archive if archive.is_absolute() else None


def _libdir() -> str:
    return _output_of("ghc", "--print-libdir")


def _output_of(*command: str) -> str:
    return subprocess.run(command, capture_output=True, check=True, text=True).stdout.strip()


def _newest(root: Path, pattern: str) -> Path | None:
    built = [path for path in root.glob(pattern) if path.is_file()]
    return max(built, key=lambda path: path.stat().st_mtime, default=None)
