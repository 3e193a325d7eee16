"""
Portable folder of an installed Rosy (a memory stick): it starts on machines of the same kind without internet, without GHC and
without the right to install anything.

Beside the tree (see `installed_tree`) it holds GHC's library folder with the packages that programs may import, the shared
libraries of C that they need, Python, and bubblewrap. Nothing in it is a symbolic link, because a stick's file system may have none.
The machine needs the same kind of processor, a C library at least as new, and a browser. `rosy build` needs GHC and stays away.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import sysconfig
from pathlib import Path

from rosy_sim.sentences.sentence import tr
from rosy_sim.sentences.wording import in_terminal

from .installed_tree import TreeError, copy_tree, is_elf

__all__ = ["make_folder"]

_SKIPPED = shutil.ignore_patterns("*.a", "*.p_*", "*_p.a", "package.conf.d", "html", "doc", "bin")

_SYSTEM_LIBRARIES = ("libc.so", "libm.so", "libpthread.so", "libdl.so", "librt.so", "ld-linux")
"""Parts of the C library; those of the machine itself are used."""


def make_folder(root: Path, target: Path) -> None:
    """
    Make the folder ``target``, which must not exist.

    Raises:
        TreeError: a part is missing.
    """
    copy_tree(root, target)
    libdir = Path(_output("ghc", "--print-libdir").strip()).resolve()
    ghc = target / "ghc"
    shutil.copytree(libdir, ghc, ignore=_SKIPPED, symlinks=False)
    _copy_packages(libdir, target / "dist-newstyle", ghc)
    _copy_python(target / "python-home")
    (target / "bin").mkdir()
    bubblewrap = shutil.which("bwrap")
    if bubblewrap is not None:
        shutil.copy2(bubblewrap, target / "bin" / "bwrap")
    _copy_system_libraries(target)
    (target / "README.txt").write_text(_readme(), "utf-8")


def _readme() -> str:
    """What the folder says about itself, in the language of this machine."""
    start = in_terminal(tr("Open a terminal in this folder and type"))
    then = in_terminal(tr("Then open the address that it prints. Nothing is installed and no internet is needed."))
    kind = in_terminal(tr("The machine needs to be of the kind that this folder was made on: {system}.", system=_system()))
    otherwise = in_terminal(tr("If the stick does not allow programs to start, copy the folder to the machine first."))
    return f"{in_terminal(tr('Rosy on a stick'))}\n\n{start}\n\n    ./rosy start\n\n{then}\n{kind}\n{otherwise}\n"


def _copy_packages(libdir: Path, built: Path, ghc: Path) -> None:
    """Descriptions and libraries of all packages that Rosy's libraries and GHC's own depend on, with relative paths."""
    descriptions = {file.stem: file.read_text() for file in (libdir / "package.conf.d").resolve().glob("*.conf")}
    wanted = [unit for file in built.glob("packagedb/*/rosy-*.conf") for unit in _units(file.read_text(), descriptions)]
    # Packages in the compiler's own folder are all taken: the compiler is linked with them.
    wanted += [unit for unit, text in descriptions.items() if str(libdir) in text]
    # The worker is linked with packages that no learner's program sees.
    wanted += [unit for unit in descriptions if _is_linked(unit, built)]
    database = ghc / "package.conf.d"
    database.mkdir()
    done: set[str] = set()
    while wanted:
        unit = wanted.pop()
        if unit in done:
            continue
        done.add(unit)
        text = descriptions[unit]
        wanted += _units(text, descriptions)
        for folder in sorted(set(re.findall(r"(/\S*/haskell-packages/\S+)", text))):
            if "/share/doc/" in folder or "haddock" in folder:
                continue
            _copy_library_folder(Path(folder), unit, ghc / "packages")
        text = text.replace(str(libdir), "${pkgroot}")
        text = re.sub(r"/\S*/haskell-packages/ghc/lib", "${pkgroot}/packages", text)
        text = re.sub(r"^haddock-(interfaces|html):\n?(\s+\S+\n)*", "", text, flags=re.MULTILINE)
        (database / f"{unit}.conf").write_text(text)
    _output("ghc-pkg", "--no-user-package-db", "--package-db", str(database), "recache")


def _units(text: str, known: dict[str, str]) -> list[str]:
    """Units that a description depends on, without those that have none of their own (Rosy's)."""
    found = re.search(r"^depends:((?:.*\n)(?:\s+.*\n)*)", text, re.MULTILINE)
    return [unit for unit in (found.group(1).split() if found else []) if unit in known]


def _is_linked(unit: str, built: Path) -> bool:
    executable = next(built.glob("build/*/*/*/x/rosy-worker/build/rosy-worker/rosy-worker"))
    return f"libHS{unit}-ghc".encode() in executable.read_bytes()


def _copy_library_folder(folder: Path, unit: str, target: Path) -> None:
    """A package's interfaces (in a folder of its own), or its shared library (in a folder of all packages)."""
    place = target / Path(*folder.parts[folder.parts.index("lib", folder.parts.index("haskell-packages")) + 1 :])
    if folder.name.startswith(("x86_64", "aarch64")):
        place.mkdir(parents=True, exist_ok=True)
        for file in folder.glob(f"libHS{unit}*.so"):
            shutil.copy2(file, place / file.name)
    elif folder.is_dir() and not place.exists():
        shutil.copytree(folder, place, ignore=_SKIPPED)


def _copy_python(home: Path) -> None:
    """The interpreter that runs this script and its standard library, without tests and compilers."""
    version = f"python{sys.version_info.major}.{sys.version_info.minor}"
    (home / "bin").mkdir(parents=True)
    shutil.copy2(Path(sys.executable).resolve(), home / "bin" / "python3")
    shutil.copytree(
        sysconfig.get_path("stdlib"),
        home / "lib" / version,
        ignore=shutil.ignore_patterns(
            "__pycache__", "test", "tests", "idlelib", "tkinter", "turtledemo", "ensurepip", "site-packages", "dist-packages", "config-*", "lib2to3"
        ),
    )
    library = sysconfig.get_config_var("INSTSONAME")
    shared = Path(str(sysconfig.get_config_var("LIBDIR"))) / str(library)
    if sysconfig.get_config_var("Py_ENABLE_SHARED") and shared.exists():
        shutil.copy2(shared, home / "lib" / shared.name)


def _copy_system_libraries(target: Path) -> None:
    """Shared libraries of the system that any file in the folder is linked with, except the C library."""
    (target / "lib").mkdir()
    inside = {file.name for file in target.rglob("*.so*")}
    for file in sorted(target.rglob("*")):
        if not is_elf(file):
            continue
        done = subprocess.run(["ldd", str(file)], capture_output=True, text=True, check=False)
        for name, path in re.findall(r"(\S+) => (/\S+)", done.stdout):
            copy = target / "lib" / name
            if name not in inside and not name.startswith(_SYSTEM_LIBRARIES) and not copy.exists():
                shutil.copy2(Path(path).resolve(), copy)


def _system() -> str:
    """Name of this system, for the reader."""
    found = re.search(r'^PRETTY_NAME="?([^"\n]+)', Path("/etc/os-release").read_text(), re.MULTILINE)
    return f"{found.group(1) if found else 'Linux'}, {os.uname().machine}"


def _output(*command: str) -> str:
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise TreeError(tr("{command} failed: {why}", command=command[0], why=done.stderr.strip()))
    return done.stdout
