"""
Tree of an installed Rosy: everything that its commands need at run time, in one folder that can lie anywhere.

The tree has the same layout as the repository, so that the service finds its parts in the same places, and a file `.installed`,
by which `./rosy` sees that nothing has to be set up. Paths of the machine that built it are replaced: package descriptions of GHC
name folders by ``${pkgroot}``, and executables find their libraries by ``$ORIGIN``.
"""

from __future__ import annotations

import compileall
import importlib.metadata
import os
import py_compile
import re
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path

from rosy_sim.sentences.sentence import SentenceError, tr

__all__ = ["System", "TreeError", "copy_tree", "haskell_build", "is_elf", "package_versions", "source_date", "this_system"]

_COPIED = ("rosy", "rosy.cabal", "LICENSE", "scripts/lib", "languages", "protocol", "examples", "editor/dist", "codegen/dist", ".rosy/api-docs")
"""Copied as they are."""

_EXECUTABLES = ("rosy-worker", "rosy-robot", "rosy-build")

_IGNORED = shutil.ignore_patterns("__pycache__", "tests", "bench", ".keep")

_COMPILED_WORDS = ("blocks", "page")
"""Folders of a language that `editor/dist` and `codegen/dist` hold already."""


class TreeError(SentenceError):
    """The tree cannot be made."""


@dataclass(frozen=True)
class System:
    """The system that packages are made on and for."""

    # For the reader: "Debian GNU/Linux 12 (bookworm)".
    name: str
    # For names of files: "debian12", "ubuntu24.04"; a release without a version by its code name, "debianforky".
    tag: str
    # Debian's name of the processor architecture: "amd64", "arm64".
    architecture: str


def this_system(release: str | None = None, machine: str | None = None) -> System:
    """From the text of /etc/os-release (os-release(5)) and the machine that uname(2) reports, those of this system by default."""
    text = Path("/etc/os-release").read_text() if release is None else release
    fields = {name: value.strip("\"'") for name, value in re.findall(r"^([A-Z_]+)=(.*)$", text, re.MULTILINE)}
    kind = os.uname().machine if machine is None else machine
    tag = fields.get("ID", "linux") + fields.get("VERSION_ID", fields.get("VERSION_CODENAME", ""))
    return System(fields.get("PRETTY_NAME", "Linux"), tag, {"x86_64": "amd64", "aarch64": "arm64"}.get(kind, kind))


def source_date(root: Path) -> int:
    """
    The time that packages give to what they hold, in seconds since 1970.

    It is ``SOURCE_DATE_EPOCH`` (reproducible-builds.org), else that of the last change.
    """
    named = os.environ.get("SOURCE_DATE_EPOCH", "")
    if named.isdecimal():
        return int(named)
    done = subprocess.run(["git", "-C", str(root), "log", "-1", "--format=%ct"], capture_output=True, text=True, check=False)
    return int(done.stdout) if done.returncode == 0 and done.stdout.strip() else int((root / "CHANGELOG.md").stat().st_mtime)


def copy_tree(root: Path, target: Path) -> None:
    """
    Copy the installed parts of the repository at ``root`` into ``target``, which must not exist.

    Raises:
        TreeError: a part has not been built or installed.
    """
    for name in _COPIED:
        source = root / name
        if not source.exists():
            raise TreeError(tr("{name} has not been built.", name=name))
        (target / name).parent.mkdir(parents=True, exist_ok=True)
        if source.is_dir():
            ignored = shutil.ignore_patterns(*_COMPILED_WORDS) if name == "languages" else _IGNORED
            shutil.copytree(source, target / name, ignore=ignored)
        else:
            shutil.copy2(source, target / name)
    shutil.copytree(root / "sim-service/rosy_sim", target / "sim-service/rosy_sim", ignore=_IGNORED)
    # Where it could not be compiled the sources are interpreted.
    if (root / ".rosy/compiled").is_dir():
        shutil.copytree(root / ".rosy/compiled", target / ".rosy/compiled")
    _copy_python_packages(root / "sim-service/requirements.lock", target / "python")
    _copy_haskell(root, target)
    # Compiled files never look at the times of their sources, and so are never written again.
    for folder in ("python", "sim-service"):
        compileall.compile_dir(target / folder, quiet=2, stripdir=str(target), invalidation_mode=py_compile.PycInvalidationMode.UNCHECKED_HASH)
    (target / ".installed").write_text("Made by ./rosy package.\n")


def package_versions(lock: Path) -> dict[str, str]:
    """Names and versions of the distributions in a lock file of pip."""
    return dict(re.findall(r"^([A-Za-z0-9._-]+)==([^\s\\]+)", lock.read_text(), re.MULTILINE))


def _copy_python_packages(lock: Path, target: Path) -> None:
    """Files of the locked distributions, from the environment that this script runs in."""
    for name, version in package_versions(lock).items():
        try:
            found = importlib.metadata.distribution(name)
        except importlib.metadata.PackageNotFoundError as error:
            raise TreeError(tr("the Python package {name} is not installed.", name=name)) from error
        if found.version != version:
            raise TreeError(tr("the Python package {name} has version {found} instead of {wanted}.", name=name, found=found.version, wanted=version))
        for file in found.files or ():
            # Scripts lie outside of the packages' folder; compiled files are made again.
            if ".." in file.parts or "__pycache__" in file.parts:
                continue
            copy = target / file
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(Path(str(found.locate_file(file))), copy)


def haskell_build(root: Path) -> Path:
    """
    Cabal's folder for this package and compiler: ``dist-newstyle/build/SYSTEM/ghc-VERSION/rosy-VERSION``.

    Raises:
        TreeError: the worker has not been built, or for several compilers.
    """
    found = [path.parents[3] for path in root.glob("dist-newstyle/build/*/ghc-*/rosy-*/x/rosy-worker/build/rosy-worker")]
    if len(found) != 1:
        raise TreeError(tr("{count} builds of the worker are in {folder}; there must be one.", count=len(found), folder="dist-newstyle"))
    return found[0]


def _copy_haskell(root: Path, target: Path) -> None:
    """Executables, the libraries that programs are compiled against, and GHC's descriptions of them."""
    build = haskell_build(root)
    place = build.relative_to(root)
    for name in _EXECUTABLES:
        executable = build / "x" / name / "build" / name / name
        if not executable.is_file():
            raise TreeError(tr("{name} has not been built.", name=name))
        copy = target / executable.relative_to(root)
        copy.parent.mkdir(parents=True)
        shutil.copy2(executable, copy)
    database = root / "dist-newstyle/packagedb" / build.parent.name
    copied = target / database.relative_to(root)
    copied.mkdir(parents=True)
    for description in sorted(database.glob("rosy-*.conf")):
        text = description.read_text()
        # The folder may have been moved since it was built.
        built_at, _, inside = _field(text, "import-dirs").partition("/dist-newstyle/")
        shutil.copytree(root / "dist-newstyle" / inside, target / "dist-newstyle" / inside, ignore=shutil.ignore_patterns("*.o", "*.dyn_o", "autogen", "*-tmp"))
        text = re.sub(r"^haddock-(interfaces|html):\s*\S+\n", "", text, flags=re.MULTILINE)
        text = re.sub(r"^data-dir:.*\n", "", text, flags=re.MULTILINE)
        # Headers of our C code are needed by nothing that is compiled against the library.
        text = re.sub(r"^include-dirs:.*\n(?: .*\n)*", "", text, flags=re.MULTILINE)
        (copied / description.name).write_text(text.replace(f"{built_at}/dist-newstyle", "${pkgroot}/.."))
        for file in sorted((target / place).rglob("*")):
            if is_elf(file):
                _replace_library_paths(file, f"{built_at}/{place}", target / place)
    _run("ghc-pkg", "--no-user-package-db", "--package-db", str(copied), "recache")


def _field(description: str, name: str) -> str:
    """The first value of a field of a package description."""
    found = re.search(rf"^{name}:\s*(\S+)", description, re.MULTILINE)
    if found is None:
        raise TreeError(tr("a package description has no {name}.", name=name))
    return found.group(1)


def is_elf(file: Path) -> bool:
    """Whether it is an executable or a shared library."""
    if not file.is_file() or file.is_symlink():
        return False
    with file.open("rb") as opened:
        return opened.read(4) == b"\x7fELF"


def _replace_library_paths(file: Path, old: str, build: Path) -> None:
    """
    Replace the absolute prefix ``old`` in the run path of a file by one that starts at the file's own folder.

    The new text must not be longer: the string table of the file is changed in place, and the rest filled with zeros.
    """
    data = file.read_bytes()
    for found in set(re.findall(rb"\0([^\0]*" + re.escape(old.encode()) + rb"/[^\0]*)\0", data)):
        new = found.replace(old.encode(), b"$ORIGIN/" + os.path.relpath(build, file.parent).encode())
        if len(new) > len(found):
            raise TreeError(tr("the library path of {name} cannot be changed: build Rosy in a folder with a longer name.", name=file.name))
        # A run path lists several folders; other text of the program is left as it is.
        if b":" in found:
            data = data.replace(b"\0" + found + b"\0", b"\0" + new + b"\0" * (len(found) - len(new) + 1))
    file.write_bytes(data)


def _run(*command: str) -> None:
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise TreeError(tr("{command} failed: {why}", command=command[0], why=done.stderr.strip()))
