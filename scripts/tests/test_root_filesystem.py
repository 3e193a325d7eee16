"""
What `./rosy package all` gives away, with small trees: the same bytes from the same files, the settings that WSL reads, the image's
settings, checksums, and the list of parts.
"""

from __future__ import annotations

import configparser
import gzip
import io
import json
import os
import random
import struct
import subprocess
import tarfile
import zlib
from collections.abc import Callable
from pathlib import Path

import pytest

from installation import bill_of_materials, container_image, root_filesystem, wsl_distribution
from installation.bill_of_materials import Part, debian_parts, npm_parts, python_parts
from installation.installed_tree import TreeError
from package import main as package_command

EPOCH = 1_700_000_000

STATUS = "Package: dash\nStatus: install ok installed\nVersion: 0.5.12-2\n\nPackage: sed\nVersion: 4.9-1\n"

FILES = {"rosy": "#!/bin/bash\n", "bin/bwrap": "\x7fELF", "examples/move/Main.hs": "main = simulate move\n", "a b/ü.txt": "ü"}


def small_tree(folder: Path, seed: int) -> Path:
    """The same files in another order, with other times and with the rights of another umask."""
    chance = random.Random(seed)
    tree = folder / "rosy-stick"
    for name, text in chance.sample(sorted(FILES.items()), len(FILES)):
        file = tree / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, "latin-1" if text.startswith("\x7f") else "utf-8")
        file.chmod((0o700 if name == "rosy" else 0o600) | chance.choice([0, 0o040, 0o044]))
        os.utime(file, (EPOCH + chance.randrange(1, 10**6),) * 2)
    return tree


def small_base(folder: Path) -> Path:
    """A system as mmdebstrap writes it, with a device."""
    base = folder / "base.tar"
    with tarfile.open(base, "w") as archive:
        for name, text in {"./etc/passwd": "root:x:0:0::/root:/bin/bash\n", "./var/lib/dpkg/status": STATUS, "./etc/wsl.conf": "old"}.items():
            found = tarfile.TarInfo(name)
            found.size, found.mtime, found.uid = len(text), EPOCH + 10, 42
            archive.addfile(found, io.BytesIO(text.encode()))
        device = tarfile.TarInfo("./dev/console")
        device.type = tarfile.CHRTYPE
        archive.addfile(device)
    return base


@pytest.fixture
def fake_buildah(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A buildah that writes down what it is told; its archive is the layer."""
    tool = tmp_path / "tools/buildah"
    tool.parent.mkdir()
    calls = tmp_path / "calls"
    tool.write_text(
        f"""#!/bin/sh
shift 6
printf '%s\\n' "$@" >>{calls}
case "$1" in
from) echo working ;;
add) cp "$4" {tmp_path}/layer ;;
commit) for last; do :; done; last=${{last#docker-archive:}}; cp {tmp_path}/layer "${{last%%:*}}" ;;
esac
"""
    )
    tool.chmod(0o755)
    monkeypatch.setenv("PATH", f"{tool.parent}:{os.environ['PATH']}")
    return calls


def make_wsl(folder: Path, seed: int) -> Path:
    return wsl_distribution.make_wsl(small_base(folder), small_tree(folder, seed), folder, "amd64", EPOCH)


def make_stick(folder: Path, seed: int) -> Path:
    archive = folder / "stick.tar.gz"
    root_filesystem.write_folder(small_tree(folder, seed), archive, EPOCH)
    return archive


def make_image(folder: Path, seed: int) -> Path:
    return container_image.make_image(small_base(folder), small_tree(folder, seed), folder, "amd64", EPOCH)


@pytest.mark.parametrize("make", [make_wsl, make_stick, make_image])
@pytest.mark.usefixtures("fake_buildah")
def test_the_same_files_give_the_same_bytes(tmp_path: Path, make: Callable[[Path, int], Path]) -> None:
    found = []
    for seed in range(3):
        folder = tmp_path / f"folder{seed}"
        folder.mkdir()
        found.append(make(folder, seed).read_bytes())
    assert found[0] == found[1] == found[2]


def test_a_root_file_system_is_of_root_without_devices_and_readable_by_all(tmp_path: Path) -> None:
    with tarfile.open(make_wsl(tmp_path, 1)) as archive:
        members = {member.name: member for member in archive}
        read = {name: (archive.extractfile(member) or io.BytesIO()).read() for name, member in members.items() if member.isreg()}
    assert {f"opt/rosy/{name}" for name in FILES} <= members.keys()
    assert members["opt/rosy/rosy"].mode == members["opt/rosy/bin/bwrap"].mode == 0o755
    assert members["opt/rosy/examples/move/Main.hs"].mode == 0o644
    assert members["etc/passwd"].uid == 42
    assert {(member.uid, member.gid) for name, member in members.items() if name.startswith("opt/")} == {(0, 0)}
    assert all(member.mtime <= EPOCH for member in members.values())
    assert not [name for name, member in members.items() if member.isdev()]
    # The files of the distribution are in place of the system's, once.
    assert read["etc/wsl.conf"] != b"old"
    assert not [name for name in members if name.startswith("./")]


def test_the_settings_of_a_distribution_are_those_that_wsl_documents() -> None:
    """Keys: Microsoft, "Build a custom Linux distribution for WSL" and "Advanced settings configuration in WSL"."""
    files = {file.name: file for file in wsl_distribution.files()}

    def read(name: str) -> dict[str, dict[str, str]]:
        parser = configparser.ConfigParser()
        parser.optionxform = str  # type: ignore[assignment,method-assign]
        parser.read_string((files[name].data or b"").decode())
        return {section: dict(parser[section]) for section in parser.sections()}

    distribution, settings = read("etc/wsl-distribution.conf"), read("etc/wsl.conf")
    known = {
        "oobe": {"command", "defaultUid", "defaultName"},
        "shortcut": {"enabled", "icon"},
        "windowsterminal": {"enabled", "profileTemplate"},
    }
    assert {section: set(keys) for section, keys in distribution.items()} == known
    assert distribution["oobe"]["defaultUid"] == "1000"
    # A double click needs a name.
    assert distribution["oobe"]["defaultName"]
    assert settings["boot"] == {"systemd": "false"}
    assert settings["user"] == {"default": root_filesystem.USER}
    for named in (distribution["oobe"]["command"], distribution["shortcut"]["icon"], distribution["windowsterminal"]["profileTemplate"]):
        assert named.lstrip("/") in files
    assert files[distribution["oobe"]["command"].lstrip("/")].mode == 0o755
    template = json.loads(files[distribution["windowsterminal"]["profileTemplate"].lstrip("/")].data or b"")
    assert isinstance(template["profiles"], list)


def test_the_icon_is_one_that_windows_reads() -> None:
    icon = wsl_distribution.icon()
    reserved, kind, count, width, height, _, _, _, bits, size, offset = struct.unpack("<HHHBBBBHHII", icon[:22])
    assert (reserved, kind, count, width, height, bits, offset, size) == (0, 1, 1, 64, 64, 32, 22, len(icon) - 22)
    assert len(icon) < 10_000_000
    png = icon[22:]
    assert png.startswith(b"\x89PNG\r\n\x1a\n")
    length = struct.unpack(">I", png[33:37])[0]
    rows = zlib.decompress(png[41 : 41 + length])
    assert len(rows) == 64 * (1 + 4 * 64)
    # Nothing in its corner, the colour in the middle of its dot.
    assert rows[4] == 0
    assert rows[(1 + 4 * 64) * 37 + 1 + 4 * 32 :][:4] == bytes([0xD6, 0x17, 0x5A, 255])


def test_a_first_start_leaves_a_shell_whatever_happens(tmp_path: Path) -> None:
    """WSL opens no shell after a first-start command that failed."""
    (script,) = [file.data or b"" for file in wsl_distribution.files() if file.name.endswith("first-start")]
    file = tmp_path / "first-start"
    file.write_bytes(script)
    assert subprocess.run(["/bin/sh", str(file)], env={"PATH": str(tmp_path)}, check=False, capture_output=True).returncode == 0


def test_an_image_has_an_ordinary_user_one_volume_and_a_health_check(tmp_path: Path, fake_buildah: Path) -> None:
    image = make_image(tmp_path, 1)
    told = fake_buildah.read_text().splitlines()

    def option(name: str) -> str:
        return told[told.index(f"--{name}") + 1]

    assert (option("user"), option("volume"), option("port"), option("timestamp")) == ("1000:1000", "/data", "8080/tcp", str(EPOCH))
    assert told.count("--volume") == 1
    assert option("healthcheck") == "CMD /usr/bin/rosy-health"
    assert json.loads(option("entrypoint")) == ["/usr/bin/rosy"]
    with gzip.open(image) as packed, tarfile.open(fileobj=packed) as archive:
        members = {member.name: member for member in archive}
        health = archive.extractfile(members["usr/bin/rosy-health"])
        assert health is not None
        assert b"/api/health" in health.read()
    assert (members["data"].uid, members["data"].mode) == (1000, 0o700)
    # What it worked with is gone.
    assert sorted(file.name for file in tmp_path.iterdir() if file.name.startswith("rosy-image")) == []


def test_the_seccomp_profile_leaves_what_the_sandbox_needs_and_refuses_modules_and_keys() -> None:
    (rule,) = json.loads(container_image.seccomp_profile())["syscalls"]
    refused = set(rule["names"])
    # System calls of bubblewrap, seen with strace.
    assert not refused & {"clone", "clone3", "unshare", "mount", "umount2", "pivot_root", "prctl", "seccomp", "capset", "capget", "sethostname", "chdir"}
    assert {"init_module", "kexec_load", "bpf", "keyctl", "open_by_handle_at", "perf_event_open", "setns", "ptrace"} <= refused
    assert rule["action"] == "SCMP_ACT_ERRNO"


@pytest.mark.parametrize(("tool", "make"), [("mmdebstrap", lambda folder, _: root_filesystem.make_base(folder / "base.tar", EPOCH)), ("buildah", make_image)])
def test_a_tool_that_is_missing_is_named_with_the_command_that_installs_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, tool: str, make: Callable[[Path, int], object]
) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(TreeError, match=f"has no {tool}: install it with sudo apt install {tool}"):
        make(tmp_path, 1)


def test_the_list_of_parts_is_the_same_for_the_same_parts_and_names_each(tmp_path: Path) -> None:
    lock = tmp_path / "requirements.lock"
    lock.write_text("Some_Thing==1.0 \\\n    --hash=sha256:0\n")
    npm = tmp_path / "package-lock.json"
    places = {
        "": {"name": "rosy"},
        "codegen": {"version": "1.0.0"},
        "node_modules/@rosy/codegen": {"link": True},
        "node_modules/@codemirror/state": {"version": "6.5.2"},
        "node_modules/a/node_modules/b": {"version": "2.0.0"},
        "node_modules/vitest": {"version": "3.0.0", "dev": True},
    }
    npm.write_text(json.dumps({"packages": places}))
    parts = {*debian_parts(small_base(tmp_path), "debian"), *python_parts(lock), *npm_parts(npm)}
    assert parts == {
        Part("deb", "debian", "dash", "0.5.12-2"),
        Part("deb", "debian", "sed", "4.9-1"),
        Part("pypi", "", "some-thing", "1.0"),
        Part("npm", "@codemirror", "state", "6.5.2"),
        Part("npm", "", "b", "2.0.0"),
    }
    text = bill_of_materials.bill_of_materials(parts, EPOCH)
    assert text == bill_of_materials.bill_of_materials(frozenset(parts), EPOCH)
    found = json.loads(text)
    assert (found["bomFormat"], found["specVersion"]) == ("CycloneDX", "1.6")
    assert {part["purl"] for part in found["components"]} >= {"pkg:deb/debian/dash@0.5.12-2", "pkg:npm/%40codemirror/state@6.5.2"}


@pytest.mark.usefixtures("fake_buildah")
def test_all_of_them_come_with_checksums_that_hold(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    def deb(_root: Path, _work: Path, output: Path) -> Path:
        package = output / "rosy_1_amd64.deb"
        package.write_text("deb")
        return package

    def base(target: Path, _epoch: int) -> None:
        small_base(target.parent)

    def folder(_root: Path, target: Path) -> None:
        small_tree(target.parent, 1).rename(target)
        (target / "ghc/package.conf.d").mkdir(parents=True)
        (target / "ghc/package.conf.d/base.conf").write_text("name: base\nversion: 4.15\n")
        (target / "lib").mkdir()

    monkeypatch.setenv("SOURCE_DATE_EPOCH", str(EPOCH))
    for name, made in (("make_deb", deb), ("make_base", base), ("make_folder", folder)):
        monkeypatch.setattr(f"package.{name}", made)
    for again in ("one", "two"):
        assert package_command(["all", "-o", str(tmp_path / again)]) == 0
    one, two = tmp_path / "one", tmp_path / "two"
    assert (one / "SHA256SUMS").read_text() == (two / "SHA256SUMS").read_text()
    names = {line.split("  ")[1] for line in (one / "SHA256SUMS").read_text().splitlines()}
    assert names | {"SHA256SUMS"} == {file.name for file in one.iterdir()}
    assert {"".join(Path(name).suffixes[-2:]) for name in names} >= {".cdx.json", ".tar.gz"}
    assert subprocess.run(["sha256sum", "--quiet", "-c", "SHA256SUMS"], cwd=one, check=False).returncode == 0
    assert " MB)" in capsys.readouterr().out
    (one / "rosy_1_amd64.deb").write_text("another")
    assert subprocess.run(["sha256sum", "--quiet", "-c", "SHA256SUMS"], cwd=one, check=False, capture_output=True).returncode == 1
