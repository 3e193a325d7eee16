"""Sizes of an installation, and what `./rosy test systems` says of a system that it cannot make."""

from __future__ import annotations

import hashlib
import os
import subprocess
from pathlib import Path

import pytest

from sizes import measure, table
from systems import RELEASES, WITH_FILTER, WITHOUT_FILTER, all_megabytes, minutes_to_start, name_of, suites_for
from testing.bare_system import System, first_error, keyring

from .sandbox import COMPLETE, machine


def write(path: Path, megabytes: float) -> Path:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(os.urandom(int(megabytes * 1e6)))
    return path


def test_sizes_are_told_by_part_from_the_logs_of_set_up(tmp_path: Path) -> None:
    write(tmp_path / "node_modules/a/file", 2)
    write(tmp_path / "dist-newstyle/library.so", 3)
    os.link(tmp_path / "dist-newstyle/library.so", tmp_path / "dist-newstyle/the-same.so")
    for name, text in {
        "apt-runtime": "Need to get 134 MB of archives.\nAfter this operation, 1,093 MB of additional disk space will be used.\n",
        "apt-tools": "  Download size: 2,500 kB / 3,000 kB\n  Space needed: 7,000 kB / 70.1 GB available\n",
        "venv": "Downloading a-1.whl (1.5 MB)\n   ━━━ 1.5/1.5 MB 9.1 MB/s eta 0:00:00\n  Downloading https://index.example/b-2.whl (500 kB)\n",
        "npm": "added 20 packages in 3s\nnpm downloaded 62 MB\n",
    }.items():
        write(tmp_path / f".rosy/log/{name}.log", 0).write_text(text)
    found = {name: (round(disk, 1), round(download, 1)) for name, disk, download in measure(tmp_path)}
    assert found["Debian packages"] == (1100.0, 136.5)
    assert found["Python packages"] == (0.0, 2.0)
    assert found["Node's packages"] == (2.0, 62.0)
    assert found["Haskell builds"] == (3.0, 0.0)
    printed = table(measure(tmp_path))
    assert all_megabytes(printed) == ("1105", "200")


def test_set_up_writes_down_what_npm_downloads_and_keeps_no_cache(tmp_path: Path) -> None:
    complete = machine(tmp_path)
    complete.tool(
        "npm",
        'case "$*" in *install*) while [ "$1" != --cache ]; do shift; done; mkdir -p "$2"; head -c 3000000 /dev/urandom >"$2/tarball" ;; esac\n'
        + COMPLETE["npm"].replace("*install*)", "*npm-cache*)"),
    )
    done = complete.rosy("start")
    assert done.returncode == 0, done.stderr
    assert ("Node's packages", 3.0) in [(name, download) for name, _, download in measure(complete.root)]
    assert not (complete.root / ".rosy/npm-cache").exists()


@pytest.mark.parametrize("has_strip", [True, False])
def test_the_debug_symbols_of_python_packages_are_removed_where_the_system_can(tmp_path: Path, has_strip: bool) -> None:
    complete = machine(tmp_path)
    complete.tool("python3", 'case "$*" in *"-m venv "*) mkdir -p "$3/lib"; touch "$3/lib/fast.so" "$3/lib/slow.py" ;; esac\n' + COMPLETE["python3"])
    if has_strip:
        complete.tool("strip", "")
    done = complete.rosy("check", "Main.hs")
    assert done.returncode == 0, done.stderr
    assert complete.called("--strip-debug") == complete.called("venv/lib/fast.so") == (1 if has_strip else 0)
    assert complete.called("slow.py") == 0


def test_a_system_whose_keys_are_not_here_is_not_made_and_the_reason_is_told(tmp_path: Path) -> None:
    system = System({"name": "Nowhere 1", "suite": "first", "distribution": "nowhere", "components": "main"}, tmp_path / "root", tmp_path / "log")
    assert "nowhere-archive-keyring.gpg" in system.make(keyring("nowhere", tmp_path, None))
    assert not system.folder.exists()


def test_keys_come_out_of_a_package_only_where_it_is_the_one_that_is_known(tmp_path: Path) -> None:
    name = "usr/share/keyrings/nowhere-archive-keyring.gpg"
    write(tmp_path / "tree" / name, 0).write_text("keys")
    write(tmp_path / "tree/DEBIAN/control", 0).write_text("Package: keys\nVersion: 1\nArchitecture: all\nMaintainer: a <a@example.org>\nDescription: keys\n")
    package = tmp_path / "keys.deb"
    subprocess.run(["dpkg-deb", "--root-owner-group", "-b", tmp_path / "tree", package], check=True, capture_output=True)
    for known, sha256 in ((True, hashlib.sha256(package.read_bytes()).hexdigest()), (False, "0" * 64)):
        folder = tmp_path / str(known)
        folder.mkdir()
        found = keyring("nowhere", folder, {"package": package.as_uri(), "sha256": sha256})
        assert found == folder / "keyrings" / name
        assert found.exists() == known
    gone = {"package": (tmp_path / "gone.deb").as_uri(), "sha256": "0" * 64}
    assert not keyring("nowhere", tmp_path, gone).exists()


def test_the_reason_is_the_first_error_of_apt() -> None:
    log = "I: running apt-get update...\nW: GPG error\nE: The repository 'x' is not signed.\nE: mmdebstrap failed to run\n"
    assert first_error(log) == "The repository 'x' is not signed."
    assert first_error("I: success\n") == ""


def test_releases_are_told_apart_by_name_also_for_another_processor() -> None:
    names = [name_of(release) for release in RELEASES]
    assert len(set(names)) == len(names)
    assert {"trixie", "trixie-arm64"} <= set(names)


def test_an_emulated_system_has_more_time_and_runs_only_named_suites() -> None:
    usual, emulated = ({"suite": "trixie"}, {"suite": "trixie", "architecture": "arm64"})
    assert minutes_to_start(emulated) > minutes_to_start(usual)
    assert [suites_for(release, named) for release in (usual, emulated) for named in (None, "scripts")] == [None, "scripts", "", "scripts"]


@pytest.mark.parametrize(("release", "expected"), [({}, []), ({"architecture": "arm64"}, ["--arch=arm64"])])
def test_a_system_is_made_for_the_processor_of_its_release(
    release: dict[str, str], expected: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    called: list[list[str]] = []

    def fails(command: list[str], **_: object) -> subprocess.CompletedProcess[bytes]:
        called.append(command)
        return subprocess.CompletedProcess(command, 1)

    monkeypatch.setattr("testing.bare_system.subprocess.run", fails)
    keys = write(tmp_path / "keys.gpg", 0)
    system = System({"name": "Some 1", "suite": "some", "distribution": "debian", "components": "main", **release}, tmp_path / "root", tmp_path / "log")
    assert "mmdebstrap failed" in system.make(keys)
    assert [part for part in called[0] if part.startswith("--arch")] == expected


def test_a_worker_does_without_its_filter_and_has_it_again(tmp_path: Path) -> None:
    worker = write(tmp_path / "dist-newstyle/build/aarch64-linux/ghc-9.6.6/rosy-1/x/rosy-worker/build/rosy-worker/rosy-worker", 0)
    worker.write_text('#!/bin/sh\necho "$@"\n')
    worker.chmod(0o755)
    said = []
    for change in ("true", WITHOUT_FILTER, WITH_FILTER):
        subprocess.run(["sh", "-c", change], cwd=tmp_path, check=True)
        said.append(subprocess.run([worker, "--fd", "4"], capture_output=True, text=True, check=True).stdout.strip())
    assert said == ["--fd 4", "--without system-calls --fd 4", "--fd 4"]
