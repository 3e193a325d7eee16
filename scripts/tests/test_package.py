"""
Packages of `./rosy package`: an installed Rosy checks and runs a program where neither the repository nor its tools can be seen.

The machine of the test is the sandbox of bubblewrap, with the repository hidden; for the stick GHC's libraries are hidden as well.
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

from installation.debian import after_removal, make_deb
from installation.installed_tree import System, TreeError, is_elf, this_system
from installation.portable_folder import copy_packages, make_folder
from package import main as package_command

ROOT = Path(__file__).resolve().parents[2]

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


@pytest.mark.parametrize(
    ("release", "machine", "expected"),
    [
        (
            'PRETTY_NAME="Debian GNU/Linux 12 (bookworm)"\nVERSION_ID="12"\nVERSION_CODENAME=bookworm\nID=debian\n',
            "x86_64",
            System("Debian GNU/Linux 12 (bookworm)", "debian12", "amd64"),
        ),
        (
            'PRETTY_NAME="Debian GNU/Linux forky/sid"\nVERSION_CODENAME=forky\nID=debian\n',
            "aarch64",
            System("Debian GNU/Linux forky/sid", "debianforky", "arm64"),
        ),
        ('PRETTY_NAME="Ubuntu 24.04.1 LTS"\nVERSION_ID="24.04"\nID=ubuntu\nID_LIKE=debian\n', "x86_64", System("Ubuntu 24.04.1 LTS", "ubuntu24.04", "amd64")),
        ("", "riscv64", System("Linux", "linux", "riscv64")),
    ],
)
def test_a_system_is_named_for_readers_and_for_files(release: str, machine: str, expected: System) -> None:
    assert this_system(release, machine) == expected


def removed(how: str, machine: Path, language: str = "C.UTF-8") -> str:
    """What the package's script says on a machine, whose root folder that is, after it was removed."""
    script = machine.parent / "postrm"
    script.write_text(after_removal(ROOT))
    environment = {"PATH": "/usr/bin:/bin", "DPKG_ROOT": str(machine), "LANG": language}
    return subprocess.run(["sh", str(script), how], env=environment, capture_output=True, text=True, check=True).stdout


def test_purging_says_what_it_deletes_and_what_stays(tmp_path: Path) -> None:
    machine = tmp_path / "machine"
    of_service = machine / "var/lib/private/rosy/.local/share/rosy/classes/7b"
    of_people = machine / "home/ada/.local/share/rosy/classes/club"
    others = machine / "var/lib/private/other"
    for folder in (of_service, of_people, others):
        folder.mkdir(parents=True)
    (machine / "var/lib/rosy").symlink_to("private/rosy")
    # Without a purge everything stays.
    assert removed("remove", machine) == ""
    assert of_service.is_dir()
    deleted, kept = removed("purge", machine).splitlines()
    assert deleted.startswith("Rosy deletes /var/lib/rosy: the classes and recordings of the service")
    assert "~/.local/share/rosy" in kept
    assert sorted(path.name for path in (machine / "var/lib").rglob("*")) == ["other", "private"]
    assert of_people.is_dir()
    # It says nothing of a folder that is not there.
    assert removed("purge", machine).splitlines() == [kept]


@pytest.mark.parametrize("language", sorted(path.parent.name for path in ROOT.glob("languages/*/sentences.json")))
def test_purging_speaks_the_language_of_the_machine(language: str, tmp_path: Path) -> None:
    machine = tmp_path / "machine"
    (machine / "var/lib/rosy").mkdir(parents=True)
    said = removed("purge", machine, f"{language}_XX.UTF-8").splitlines()
    assert len(said) == 2
    assert not set(said) & set(removed("purge", tmp_path / "none").splitlines())
    assert "/var/lib/rosy" in said[0]


def test_the_file_names_the_system_that_it_is_for(package: Path) -> None:
    system = this_system()
    assert package.name.endswith(f"+{system.tag}_{system.architecture}.deb")


def test_the_folder_for_packages_is_made_and_a_file_in_its_place_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def make(_root: Path, folder: Path) -> None:
        folder.mkdir()

    monkeypatch.setattr("package.make_folder", make)
    assert package_command(["stick", "-o", str(tmp_path / "a/b")]) == 0
    system = this_system()
    assert [made.name for made in (tmp_path / "a/b").iterdir()] == [f"rosy-stick-{system.tag}-{system.architecture}"]
    said = capsys.readouterr()
    assert f"for {system.name} and newer" in said.out
    assert "this takes a few minutes" in said.err
    (tmp_path / "file").touch()
    assert package_command(["stick", "-o", str(tmp_path / "file")]) == 1
    assert "is not a folder" in capsys.readouterr().err


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


def described(folder: Path, file: str, unit: str, fields: str = "") -> None:
    """GHC's description of a package, in a file of any name."""
    folder.mkdir(parents=True, exist_ok=True)
    name, version = re.fullmatch(r"(.+?)-([0-9.]+)(?:-[\w-]+)?", unit).groups()  # type: ignore[union-attr]
    (folder / f"{file}.conf").write_text(f"name: {name}\nversion: {version}\nid: {unit}\nkey: {unit}\n{fields}")


# GHC 9.0 names the compiler's folder plainly, GHC 9.6 by a detour.
@pytest.mark.parametrize("way", ["", "/../lib"])
@pytest.mark.parametrize("hashed", [True, False])
def test_a_stick_has_every_package_that_another_one_depends_on_whatever_its_file_is_called(tmp_path: Path, hashed: bool, way: str) -> None:
    libdir, built, ghc = tmp_path / "lib", tmp_path / "dist-newstyle", tmp_path / "stick/ghc"
    ids = {name: f"{name}-1.0-{'H8BOQwtT8HYFvWPR1b6zv' + name[0] if hashed else name}" for name in ("aeson", "vector", "unused", "linked")}
    packages = libdir / "package.conf.d"
    described(packages, "base-4.15.1.0", "base-4.15.1.0", f"library-dirs: {libdir}{way}/base-4.15.1.0\nextra-libraries:\n    gmp m\nld-options: -u main\n")
    for name, depends in {
        "aeson": f"base-4.15.1.0\n    {ids['vector']}",
        "vector": "base-4.15.1.0",
        "unused": "base-4.15.1.0",
        "linked": "base-4.15.1.0",
    }.items():
        # Beside the compiler's own folder, whose name is the beginning of theirs.
        described(packages, f"{name}-1.0", ids[name], f"haddock-interfaces: {libdir}-doc/{name}.haddock\ndepends:\n    {depends}\n")
    described(built / "packagedb/ghc-9", "rosy-0.1.0-inplace", "rosy-0.1.0-inplace", f"depends: {ids['aeson']}\n")
    described(built / "packagedb/ghc-9", "rosy-0.1.0-inplace-robots", "rosy-0.1.0-inplace-robots", "depends: rosy-0.1.0-inplace\n")
    worker = built / "build/x/ghc-9/rosy/x/rosy-worker/build/rosy-worker/rosy-worker"
    worker.parent.mkdir(parents=True)
    worker.write_text(f"libHS{ids['linked']}-ghc9.so")
    ghc.mkdir(parents=True)
    copy_packages(libdir, built, ghc)
    texts = [file.read_text() for file in (ghc / "package.conf.d").glob("*.conf")]
    assert {unit for text in texts for unit in re.findall(r"^id: (\S+)", text, re.MULTILINE)} == {
        "base-4.15.1.0", ids["aeson"], ids["vector"], ids["linked"]
    }  # fmt: skip
    assert not [text for text in texts if str(tmp_path) in text]
    assert [text for text in texts if "library-dirs: ${pkgroot}/base-4.15.1.0\nld-options: -u main\n" in text]
    (packages / "vector-1.0.conf").unlink()
    shutil.rmtree(ghc)
    ghc.mkdir()
    with pytest.raises(TreeError, match=re.escape(ids["vector"])):
        copy_packages(libdir, built, ghc)


def test_a_stick_runs_a_program_without_ghc(tmp_path: Path) -> None:
    folder = tmp_path / "rosy-stick"
    make_folder(ROOT, folder)
    assert not [file for file in folder.rglob("*") if file.is_symlink()]
    (tmp_path / "move.hs").write_text(PROGRAM)
    hidden = [name for name in ("/usr/lib/ghc", "/usr/lib/haskell-packages", "/var/lib/ghc") if Path(name).exists()]
    # Neither a C compiler: GHC would ask it where the C libraries of packages are.
    compilers = {str(Path(found).resolve()) for name in ("gcc", "cc", f"{os.uname().machine}-linux-gnu-gcc") if (found := shutil.which(name))}
    binds = [word for name in sorted(compilers) for word in ("--ro-bind", "/dev/null", name)]
    done = on_another_machine(
        ["--ro-bind", str(folder), str(folder), *binds], hidden, [str(folder / "rosy"), "run", "move.hs", "--seconds", "2", "--speed", "max"], tmp_path
    )
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout.splitlines()[-1])["ended"] == "time"
