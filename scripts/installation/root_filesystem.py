"""
Root file system with an installed Rosy: a small Debian or Ubuntu of this machine's release, and the folder for a stick in ``/opt/rosy``.

A container image and a distribution for WSL are made of it. It is written as one tar archive: what a user owns and may execute comes
from the rules here and not from the machine that packs, and no time is later than ``epoch``, so that the same input gives the same bytes.
"""

from __future__ import annotations

import gzip
import io
import os
import re
import shutil
import subprocess
import tarfile
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from rosy_sim.sentences.sentence import tr

from .installed_tree import TreeError, is_elf

__all__ = ["HOME", "PLACE", "USER", "USER_ID", "ExtraFile", "make_base", "write_archive", "write_folder"]

PLACE = "opt/rosy"
"""Where the tree lies, without the leading slash."""

USER, USER_ID = "rosy", 1000
"""Who starts Rosy: the first ordinary user of Debian (adduser.conf(5), FIRST_UID)."""

HOME = "home/rosy"

_PACKAGES = ("passwd", "mount", "kmod")
"""Beside Debian's essential packages: adding the user; disks, and modprobe for the driver of a robot's cable, in WSL."""

_LEFT_OUT = ("/usr/share/doc/*", "/usr/share/man/*", "/usr/share/info/*", "/usr/share/locale/*")

_LICENCES = "/usr/share/doc/*/copyright"


@dataclass(frozen=True, slots=True)
class ExtraFile:
    """A file that only one kind of package has. ``data`` is ``None`` for a folder."""

    name: str
    data: bytes | None
    mode: int = 0o644
    owner: int = 0


def make_base(target: Path, epoch: int) -> None:
    """
    Write the system without Rosy as the tar archive ``target``. Needs no rights of root: mmdebstrap then uses a user namespace.

    Raises:
        TreeError: mmdebstrap is missing or failed.
    """
    if shutil.which("mmdebstrap") is None:
        raise TreeError(tr("this system has no {name}: install it with {command}.", name="mmdebstrap", command="sudo apt install mmdebstrap uidmap"))
    text = Path("/etc/os-release").read_text()
    suite = re.search(r'^VERSION_CODENAME="?([a-z]+)"?$', text, re.MULTILINE)
    if suite is None:
        raise TreeError(tr("{name} does not say which release this system is.", name="/etc/os-release"))
    command = ["mmdebstrap", "--variant=essential", f"--include={','.join(_PACKAGES)}", '--aptopt=Acquire::Check-Valid-Until "false"']
    command += [f"--dpkgopt=path-exclude={pattern}" for pattern in _LEFT_OUT]
    command += [f"--dpkgopt=path-include={_LICENCES}"]
    command += [f'--customize-hook=chroot "$1" useradd --create-home --uid {USER_ID} --shell /bin/bash {USER}']
    # What a machine has of its own; a container engine and WSL write theirs.
    command += ['--customize-hook=rm -f "$1/etc/resolv.conf" "$1/etc/hostname" "$1/etc/hosts" "$1/etc/machine-id"']
    command += [suite.group(1), str(target)]
    done = subprocess.run(command, capture_output=True, text=True, env={**os.environ, "SOURCE_DATE_EPOCH": str(epoch)}, check=False)
    if done.returncode != 0:
        errors = [line.removeprefix("E: ") for line in done.stderr.splitlines() if line.startswith("E: ")]
        raise TreeError(tr("{command} failed: {why}", command="mmdebstrap", why=errors[0] if errors else done.stderr.strip()))


def write_archive(base: Path, tree: Path, extra: Iterable[ExtraFile], target: io.BufferedIOBase, epoch: int) -> None:
    """
    Write the system ``base``, the folder ``tree`` at its place and the files of this kind of package into ``target``, as a tar archive.

    Times later than ``epoch``, in seconds since 1970, become ``epoch``.
    """
    files = list(extra)
    replaced = {file.name for file in files}
    with tarfile.open(base) as system, tarfile.open(fileobj=target, mode="w|", format=tarfile.GNU_FORMAT) as archive:
        for member in system:
            name = member.name.removeprefix("./")
            # Devices are made by who starts the system; without root they could not even be unpacked.
            if name in replaced or member.ischr() or member.isblk():
                continue
            member.name = name
            member.mtime = min(int(member.mtime), epoch)
            member.pax_headers = {}
            archive.addfile(member, system.extractfile(member) if member.isreg() else None)
        _add_all(archive, PLACE, tree, epoch)
        for file in files:
            found = tarfile.TarInfo(file.name)
            found.mode, found.mtime, found.uid, found.gid = file.mode, epoch, file.owner, file.owner
            if file.data is None:
                found.type = tarfile.DIRTYPE
                archive.addfile(found)
            else:
                found.size = len(file.data)
                archive.addfile(found, io.BytesIO(file.data))


def write_folder(tree: Path, target: Path, epoch: int) -> None:
    """Write the folder ``tree`` under its own name as the archive ``target``, a tar.gz, with the same rules."""
    with (
        target.open("wb") as opened,
        gzip.GzipFile("", "wb", 6, opened, mtime=epoch) as packed,
        tarfile.open(fileobj=packed, mode="w|", format=tarfile.GNU_FORMAT) as archive,
    ):
        _add_all(archive, tree.name, tree, epoch)


def _add_all(archive: tarfile.TarFile, name: str, tree: Path, epoch: int) -> None:
    for path in [tree, *sorted(tree.rglob("*"))]:
        inside = path.relative_to(tree).as_posix()
        _add(archive, name if inside == "." else f"{name}/{inside}", path, epoch)


def _add(archive: tarfile.TarFile, name: str, path: Path, epoch: int) -> None:
    """One file or folder of the tree: root's, readable by all, and executable where it was or where a linker loads it."""
    found = tarfile.TarInfo(name)
    status = path.lstat()
    found.mtime = min(int(status.st_mtime), epoch)
    if path.is_symlink():
        found.type, found.linkname, found.mode = tarfile.SYMTYPE, os.readlink(path), 0o777
        archive.addfile(found)
    elif path.is_dir():
        found.type, found.mode, found.mtime = tarfile.DIRTYPE, 0o755, epoch
        archive.addfile(found)
    else:
        found.size = status.st_size
        found.mode = 0o755 if status.st_mode & 0o100 or is_elf(path) else 0o644
        with path.open("rb") as opened:
            archive.addfile(found, opened)
