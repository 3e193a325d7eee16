"""
Debian package of an installed Rosy, for the system that it is built on.

It holds /usr/lib/rosy (see `installed_tree`), the command /usr/bin/rosy and a systemd unit for a school's server, which is not
started by itself. It depends on the exact interfaces of the Haskell libraries that it was compiled against (Debian's virtual
packages with a hash of the interface), so a system with other ones refuses it instead of failing later.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
import time
from collections.abc import Iterable
from pathlib import Path
from shlex import quote

from rosy_sim.sentences.sentence import tr
from rosy_sim.sentences.wording import ENGLISH, wording
from rosy_sim.version import VERSION

from .installed_tree import TreeError, copy_tree, haskell_build, is_elf, source_date, this_system

__all__ = ["after_removal", "make_deb"]

_TEMPLATE = """\
Package: rosy
Version: {version}
Architecture: {architecture}
Maintainer: The Rosy developers <rosy@localhost>
Installed-Size: {size}
Depends: {depends}
Recommends: nodejs
Section: education
Priority: optional
Description: Learn to program robots with nothing but functions
 A page with blocks and Haskell, a compiler service and a simulated Kobuki robot. The same programs drive real robots.
 .
 `rosy start` serves the page. `systemctl enable --now rosy` serves it to a school's network after every start.
"""

_UNIT = """\
[Unit]
Description=Rosy, robot programming for a class
After=network.target

[Service]
ExecStart=/usr/bin/rosy start --host 0.0.0.0 --no-browser
DynamicUser=yes
StateDirectory=rosy
WorkingDirectory=/var/lib/rosy
Environment=HOME=/var/lib/rosy
Restart=on-failure

[Install]
WantedBy=multi-user.target
"""

# Maintainer scripts: what a unit needs before and after its file comes and goes (Debian Policy 9.3 and 6.5).
_BEFORE_REMOVAL = """\
#!/bin/sh
set -e
if [ -d /run/systemd/system ] && [ "$1" = remove ]; then systemctl --no-reload disable --now rosy.service || true; fi
"""

_AFTER_INSTALLATION = """\
#!/bin/sh
set -e
if [ -d /run/systemd/system ]; then
  systemctl daemon-reload || true
  systemctl try-restart rosy.service || true
fi
"""

# DPKG_ROOT is the root folder in front of all paths, empty as a rule (dpkg(1)). With DynamicUser=, /var/lib/rosy is a link to
# /var/lib/private/rosy (systemd.exec(5)).
_AFTER_REMOVAL = """\
#!/bin/sh
set -e
if [ -z "${DPKG_ROOT:-}" ] && [ -d /run/systemd/system ]; then systemctl daemon-reload || true; fi
if [ "$1" = purge ]; then
  case "${LC_ALL:-${LC_MESSAGES:-${LANG:-}}}" in
    SENTENCES
  esac
  link="${DPKG_ROOT:-}/var/lib/rosy"
  folder="${DPKG_ROOT:-}/var/lib/private/rosy"
  if [ -e "$link" ] || [ -L "$link" ] || [ -e "$folder" ]; then
    printf '%s\\n' "$deleted"
    rm -rf "$link" "$folder"
  fi
  printf '%s\\n' "$kept"
fi
"""


def make_deb(root: Path, work: Path, output: Path, compression: str = "-Zxz", level: str = "-z6") -> Path:
    """
    Build the package in the folder ``work`` and write it into the folder ``output``; returns its path.

    ``compression`` and ``level`` are options of dpkg-deb.

    Raises:
        TreeError: a part is missing, this system has no dpkg, or Rosy runs with another Python than the system's.
    """
    if shutil.which("dpkg-deb") is None:
        raise TreeError(tr("this system has no {name}: install it with {command}.", name="dpkg-deb", command="apt-get install dpkg"))
    python = _output("/usr/bin/python3", "-c", "import sys; print(*sys.version_info[:2], sep='.')").strip()
    if python != f"{sys.version_info.major}.{sys.version_info.minor}":
        raise TreeError(tr("an installed Rosy runs with this system's Python {version}, and this one has another version.", version=python))
    tree = work / "deb"
    copy_tree(root, tree / "usr/lib/rosy")
    (tree / "usr/bin").mkdir()
    (tree / "usr/bin/rosy").symlink_to("../lib/rosy/rosy")
    _write(tree / "lib/systemd/system/rosy.service", _UNIT)
    _write(tree / "usr/share/doc/rosy/copyright", (root / "LICENSE").read_text())
    _write(tree / "DEBIAN/prerm", _BEFORE_REMOVAL, mode=0o755)
    _write(tree / "DEBIAN/postinst", _AFTER_INSTALLATION, mode=0o755)
    _write(tree / "DEBIAN/postrm", after_removal(root), mode=0o755)
    architecture = _output("dpkg", "--print-architecture").strip()
    version = _version(root)
    size = sum(file.stat().st_size for file in tree.rglob("*") if file.is_file() and not file.is_symlink()) // 1024
    _write(
        tree / "DEBIAN/control",
        _TEMPLATE.format(version=version, architecture=architecture, size=size, depends=", ".join(_dependencies(root, tree))),
    )
    subprocess.run(["chmod", "-R", "go=rX", str(tree)], check=True)
    package = output / f"rosy_{version}_{architecture}.deb"
    _output("dpkg-deb", "--root-owner-group", compression, level, "--build", str(tree), str(package))
    return package


def after_removal(root: Path) -> str:
    """
    The script that dpkg runs after a removal, with what it says in each language of the tables in ``root``: these tables
    are gone when it runs.
    """
    deleted = tr("Rosy deletes /var/lib/rosy: the classes and recordings of the service that this system started, with the programs in them.")
    kept = tr("What people have made themselves stays: programs where they saved them, classes and recordings in ~/.local/share/rosy.")
    tables = sorted(file.parent.name for file in (root / "languages").glob("*/sentences.json"))
    cases = [(f"{language}*", wording(language)) for language in tables]
    lines = [f"{pattern}) deleted={quote(one.put(deleted))} kept={quote(one.put(kept))} ;;" for pattern, one in [*cases, ("*", ENGLISH)]]
    return _AFTER_REMOVAL.replace("SENTENCES", "\n    ".join(lines))


def _write(file: Path, text: str, mode: int = 0o644) -> None:
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text)
    file.chmod(mode)


def _output(*command: str) -> str:
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise TreeError(tr("{command} failed: {why}", command=command[0], why=done.stderr.strip()))
    return done.stdout


def _version(root: Path) -> str:
    """
    The version of Rosy, the time of the last change, so that a newer build replaces an older one, and the system, which
    the name of the package's file then shows.
    """
    return f"{VERSION}+{time.strftime('%Y%m%d.%H%M', time.gmtime(source_date(root)))}+{this_system().tag}"


def _dependencies(root: Path, tree: Path) -> list[str]:
    """Packages that the tree needs: of its executables' libraries, of GHC's package descriptions, and tools."""
    owners = _owners({library for file in tree.rglob("*") if is_elf(file) for library in _libraries(file)})
    units = set(re.findall(r"[A-Za-z][A-Za-z0-9-]*-[0-9.]+-[A-Za-z0-9]{20,22}", _descriptions(root)))
    python = f"{sys.version_info.major}.{sys.version_info.minor}"
    following = f"{sys.version_info.major}.{sys.version_info.minor + 1}"
    tools = ["bubblewrap", "gcc", "libc6-dev", "libgmp-dev", f"python3 (>= {python})", f"python3 (<< {following})"]
    exact: set[str] = set()
    for owner in sorted(owners | _description_owners(units)):
        exact |= set(_interfaces(owner))
    return sorted(exact) + tools


def _libraries(file: Path) -> list[str]:
    """Shared libraries of the system that a file is linked with, by the path that the linker finds."""
    done = subprocess.run(["ldd", str(file)], capture_output=True, text=True, check=False)
    return re.findall(r"=> (/(?:usr/)?lib\S+)", done.stdout)


def _descriptions(root: Path) -> str:
    """GHC's descriptions of Rosy's libraries."""
    database = root / "dist-newstyle/packagedb" / haskell_build(root).parent.name
    return "\n".join(file.read_text() for file in sorted(database.glob("rosy-*.conf")))


def _description_owners(units: set[str]) -> set[str]:
    """Debian packages of GHC packages, by the file that describes each."""
    found = Path(_output("ghc", "--print-libdir").strip()).resolve() / "package.conf.d"
    return _owners([str(file) for unit in sorted(units) if (file := found.resolve() / f"{unit}.conf").exists()])


def _owners(files: Iterable[str]) -> set[str]:
    """Debian packages that the files belong to. Some packages know them by their place before /lib moved into /usr."""
    names = {name for file in files for name in (file, file.removeprefix("/usr"), f"/usr{file}", str(Path(file).resolve()))}
    # Names that no package knows are reported on standard error.
    done = subprocess.run(["dpkg-query", "--search", *sorted(names)], capture_output=True, text=True, check=False)
    return {line.split(":")[0] for line in done.stdout.splitlines() if not line.startswith("diversion ")}


def _interfaces(package: str) -> list[str]:
    """
    What to depend on for a package: the interfaces with a hash that a Haskell library provides, else its name and version.

    GHC itself provides all that come with it; base and the compiler's own library stand for them.
    """
    provided = re.findall(r"\blibghc-[a-z0-9-]+-dev-[0-9.]+-[0-9a-f]{5}\b", _output("dpkg-query", "--show", "-f", "${Provides}", package))
    if package == "ghc":
        return ["ghc", *(name for name in provided if name.startswith(("libghc-base-dev-", "libghc-ghc-dev-")))]
    if provided:
        return provided
    # A library of C may be newer: its name changes when its interface does.
    version = _output("dpkg-query", "--show", "-f", "${source:Upstream-Version}", package)
    return [f"{package} (>= {version})"]
