"""
Packages of `./rosy package`: an installed Rosy checks and runs a program where neither the repository nor its tools can be seen.

The machine of the test is the sandbox of bubblewrap, with the repository hidden; for the stick GHC's libraries are hidden as well.
The stick is a copy of all of GHC and is made in `nightly` only. The others take turns (`conftest.py`).
"""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from installation.debian import make_deb
from installation.installed_tree import is_elf
from installation.portable_folder import make_folder

ROOT = Path(__file__).resolve().parents[2]
WHOLE = os.environ.get("ROSY_TEST_SHARE") == "1"

PROGRAM = "move :: Velocity\nmove = Velocity 0.3 0\n\nmain = simulate move\n"


@pytest.fixture(scope="module")
def package(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The Debian package, hardly compressed."""
    work = tmp_path_factory.mktemp("package")
    return make_deb(ROOT, work, work, compression="-Zgzip", level="-z1")


@pytest.fixture(scope="module")
def contents(package: Path) -> Path:
    """What the package puts into the root folder."""
    target = package.parent / "root"
    subprocess.run(["dpkg-deb", "--extract", str(package), str(target)], check=True)
    return target


def on_another_machine(binds: list[str], hidden: list[str], command: list[str], cwd: Path) -> subprocess.CompletedProcess[str]:
    """Runs a command where the repository is not there."""
    if shutil.which("bwrap") is None or subprocess.run(["bwrap", "--dev-bind", "/", "/", "true"], check=False, capture_output=True).returncode != 0:
        pytest.skip("this kernel allows no other machine to be played (bubblewrap)")
    sandbox = ["bwrap", "--dev-bind", "/", "/", "--tmpfs", str(ROOT)]
    for folder in hidden:
        sandbox += ["--tmpfs", folder]
    environment = {"PATH": "/usr/bin:/bin", "HOME": str(cwd), "LANG": "C.UTF-8"}
    return subprocess.run([*sandbox, *binds, *command], cwd=cwd, env=environment, capture_output=True, text=True, check=False)


def test_the_package_says_what_it_needs(package: Path) -> None:
    fields = subprocess.run(["dpkg-deb", "--field", str(package)], capture_output=True, text=True, check=True).stdout
    needed = re.search(r"^Depends: (.*)$", fields, re.MULTILINE)
    assert needed is not None
    names = needed.group(1).split(", ")
    assert {"ghc", "bubblewrap", f"python3 (>= 3.{sys.version_info.minor})"} <= set(names)
    assert [name for name in names if re.fullmatch(r"libghc-aeson-dev-[0-9.]+-[0-9a-f]{5}", name)]
    # Each can be had on this system, from the packages that are installed.
    for name in names:
        assert subprocess.run(["dpkg-query", "--status", name.split(" ")[0]], capture_output=True, check=False).returncode == 0 or "-dev-" in name, name


def test_nothing_in_it_looks_for_the_folder_that_it_was_built_in(contents: Path) -> None:
    for file in contents.rglob("*.conf"):
        assert str(ROOT) not in file.read_text(), file
    executables = [file for file in contents.rglob("*") if is_elf(file)]
    assert len(executables) > 5
    for file in executables:
        read = subprocess.run(["readelf", "-d", str(file)], capture_output=True, text=True, check=True).stdout
        assert "dist-newstyle" not in read, file


def test_what_was_compiled_here_is_in_it(contents: Path) -> None:
    (service,) = contents.rglob("sim-service")
    here, there = ROOT / ".rosy/compiled", service.parent / ".rosy/compiled"
    assert {file.relative_to(here) for file in here.rglob("*")} == {file.relative_to(there) for file in there.rglob("*")}
    # The sources that it was made of, so that it is taken.
    for module in ("world/world.py", "run/steps/lockstep.py"):
        assert (service / "rosy_sim" / module).read_bytes() == (ROOT / "sim-service/rosy_sim" / module).read_bytes()


def test_an_installed_rosy_runs_a_program(contents: Path, tmp_path: Path) -> None:
    (tmp_path / "move.hs").write_text(PROGRAM)
    installed = contents / "usr/lib/rosy"
    done = on_another_machine(
        ["--ro-bind", str(installed), str(installed)], [], [str(installed / "rosy"), "run", "move.hs", "--seconds", "2", "--speed", "max"], tmp_path
    )
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout.splitlines()[-1])["ended"] == "time"
    for command in (["test"], ["start", "--cluster"]):
        refused = on_another_machine(["--ro-bind", str(installed), str(installed)], [], [str(installed / "rosy"), *command], tmp_path)
        assert (refused.returncode, refused.stderr.count("\n")) == (1, 1)
        assert "needs its source" in refused.stderr or "need its source" in refused.stderr


@pytest.mark.skipif(not WHOLE, reason="the stick is made in nightly")
def test_a_stick_runs_a_program_without_ghc(tmp_path: Path) -> None:
    folder = tmp_path / "rosy-stick"
    make_folder(ROOT, folder)
    assert not [file for file in folder.rglob("*") if file.is_symlink()]
    (tmp_path / "move.hs").write_text(PROGRAM)
    hidden = [name for name in ("/usr/lib/ghc", "/usr/lib/haskell-packages", "/var/lib/ghc") if Path(name).exists()]
    done = on_another_machine(
        ["--ro-bind", str(folder), str(folder)], hidden, [str(folder / "rosy"), "run", "move.hs", "--seconds", "2", "--speed", "max"], tmp_path
    )
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout.splitlines()[-1])["ended"] == "time"
