"""
Portable folder of an installed Rosy (a memory stick): it starts on machines of the same kind without internet, without GHC and
without the right to install anything.

Beside the tree (see `installed_tree`) it holds GHC's library folder with the packages that programs may import, the shared
libraries of C that they need, Python, and bubblewrap. Nothing in it is a symbolic link, because a stick's file system may have none.
The machine needs neither a C compiler nor bubblewrap, but the same kind of processor, a C library at least as new, and a
browser. `rosy build` needs GHC and stays away.
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

from .installed_tree import TreeError, copy_tree, is_elf, this_system

__all__ = ["copy_packages", "make_folder"]

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
    copy_packages(libdir, target / "dist-newstyle", ghc)
    _copy_python(target / "python-home")
    (target / "bin").mkdir()
    bubblewrap = shutil.which("bwrap")
    if bubblewrap is not None:
        shutil.copy2(bubblewrap, target / "bin" / "bwrap")
    _copy_system_libraries(target)
    (target / "README.txt").write_text(_readme(), "utf-8")


def _readme() -> str:
    """What the folder says about itself, in the language of this machine."""
    system = this_system()
    start = in_terminal(tr("Open a terminal in this folder and type"))
    then = in_terminal(tr("Then open the address that it prints. Nothing is installed and no internet is needed."))
    kind = in_terminal(tr("The machine needs to be of the kind that this folder was made on: {system}.", system=f"{system.name}, {system.architecture}"))
    otherwise = in_terminal(tr("If the stick does not allow programs to start, copy the folder to the machine first."))
    return f"{in_terminal(tr('Rosy on a stick'))}\n\n{start}\n\n    ./rosy start\n\n{then}\n{kind}\n{otherwise}\n"


def copy_packages(libdir: Path, built: Path, ghc: Path) -> None:
    """
    Descriptions and libraries of all packages that Rosy's libraries and GHC's own depend on, with relative paths.

    Raises:
        TreeError: a package has no description.
    """
    rosy = [file.read_text() for file in built.glob("packagedb/*/rosy-*.conf")]
    descriptions = _by_id([_read(file) for file in sorted((libdir / "package.conf.d").resolve().glob("*.conf"))])
    # Rosy's libraries have descriptions of their own in the tree.
    own = _by_id(rosy).keys()
    wanted = [unit for text in rosy for unit in _depends(text)]
    # Packages in the compiler's own folder are all taken: the compiler is linked with them.
    wanted += [unit for unit, text in descriptions.items() if f"{libdir}/" in text]
    # The worker is linked with packages that no learner's program sees.
    wanted += [unit for unit in descriptions if _is_linked(unit, built)]
    database = ghc / "package.conf.d"
    database.mkdir()
    done: set[str] = set(own)
    while wanted:
        unit = wanted.pop()
        if unit in done:
            continue
        done.add(unit)
        if unit not in descriptions:
            raise TreeError(tr("GHC has no description of the package {name}.", name=unit))
        text = descriptions[unit]
        wanted += _depends(text)
        text = re.sub(r"^haddock-(interfaces|html):[^\n]*\n(\s+\S+\n)*", "", text, flags=re.MULTILINE)
        # For these GHC asks a C compiler where they are. The packages' own shared libraries name them.
        text = re.sub(r"^extra-(?:ghci-)?libraries(?:-static)?:[^\n]*\n([ \t]+[^\n]*\n)*", "", text, flags=re.MULTILINE)
        for folder in sorted(set(re.findall(r"(/\S*/haskell-packages/\S+)", text))):
            _copy_library_folder(Path(folder), unit, ghc / "packages")
        text = re.sub(rf"{re.escape(str(libdir))}(?=[/\s])", "${pkgroot}", text)
        text = re.sub(r"/\S*/haskell-packages/ghc/lib", "${pkgroot}/packages", text)
        (database / f"{unit}.conf").write_text(text)
    _output("ghc-pkg", "--no-user-package-db", "--package-db", str(database), "recache")


def _read(file: Path) -> str:
    """A description with every path in its shortest form: newer GHCs write ``/usr/lib/ghc/lib/../lib/base``."""
    return re.sub(r"(?<=\s)/\S+", lambda path: os.path.normpath(path.group()), file.read_text())


def _by_id(descriptions: list[str]) -> dict[str, str]:
    """
    Package descriptions by the id that other descriptions depend on, such as ``aeson-2.1.2.1-H8BOQwtT8HYFvWPR1b6zvB``.

    A description's file need not be named like it: Debian leaves out the hash.
    """
    return {found.group(1): text for text in descriptions if (found := re.search(r"^id:\s*(\S+)", text, re.MULTILINE))}


def _depends(text: str) -> list[str]:
    """Ids of the packages that a description depends on."""
    found = re.search(r"^depends:((?:.*\n)(?:[ \t]+.*\n)*)", text, re.MULTILINE)
    return found.group(1).split() if found else []


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


def _output(*command: str) -> str:
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise TreeError(tr("{command} failed: {why}", command=command[0], why=done.stderr.strip()))
    return done.stdout
