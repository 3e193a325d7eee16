"""Files that are replaced as a whole, on disks that are full."""

from __future__ import annotations

import os
import resource
import subprocess
import sys
from pathlib import Path

import pytest

from rosy_sim.atomic_file import AtomicFile
from rosy_sim.errors import BadInput

from .test_cli import WARNING, environment, last, rosy

__all__ = ["environment"]

DISK = 100_000
"""Largest file that a limited process may write, bytes."""


def limited(variables: dict[str, str], *arguments: object) -> subprocess.CompletedProcess[str]:
    """The command in a process that cannot write files of more than ``DISK`` bytes: it behaves as on a full disk."""

    def limit() -> None:
        resource.setrlimit(resource.RLIMIT_FSIZE, (DISK, DISK))

    return subprocess.run(
        [sys.executable, "-m", "rosy_sim", *map(str, arguments)],
        # A compiled module that is cut short would break later processes.
        env={**variables, "PYTHONDONTWRITEBYTECODE": "1"},
        capture_output=True, text=True, check=False, cwd=variables["ROSY_ROOT"], preexec_fn=limit,
    )  # fmt: skip


def test_a_trace_on_a_full_disk_gives_one_sentence_and_keeps_the_old_file(
    environment: dict[str, str], tmp_path: Path
) -> None:
    (tmp_path / "p.hs").write_text("drive:0.5")
    trace = tmp_path / "t.jsonl"
    trace.write_text("old\n")
    before = set(tmp_path.iterdir())
    done = limited(environment, "run", tmp_path / "p.hs", "--seconds", 60, "--trace", trace)
    assert done.stderr == f"{WARNING}rosy: {trace} cannot be written: File too large.\n"
    assert done.returncode == 1
    assert trace.read_text() == "old\n"
    assert set(tmp_path.iterdir()) == before


@pytest.mark.parametrize("seconds", [0.02, 60])
def test_a_trace_to_a_full_device_gives_one_sentence(
    seconds: float, environment: dict[str, str], tmp_path: Path
) -> None:
    (tmp_path / "p.hs").write_text("drive:0.5")
    done = rosy(environment, "run", tmp_path / "p.hs", "--seconds", seconds, "--trace", "/dev/full")
    assert done.stderr == "rosy: /dev/full cannot be written: No space left on device.\n"


@pytest.mark.parametrize("script", ["say:hi@3", "refuse"])
def test_output_to_a_full_device_gives_one_sentence(script: str, environment: dict[str, str], tmp_path: Path) -> None:
    (tmp_path / "p.hs").write_text(script)
    with open("/dev/full", "wb") as full:
        done = subprocess.run(
            [sys.executable, "-m", "rosy_sim", "check" if script == "refuse" else "run", str(tmp_path / "p.hs")],
            env=environment, stdout=full, stderr=subprocess.PIPE, text=True, check=False,
        )  # fmt: skip
    assert done.returncode == 1
    assert done.stderr == f"{WARNING}rosy: The output cannot be written: No space left on device.\n"


def test_a_reader_that_leaves_ends_the_run_without_a_word(environment: dict[str, str], tmp_path: Path) -> None:
    (tmp_path / "p.hs").write_text("say:hi@3")
    reading, writing = os.pipe()
    os.close(reading)
    done = subprocess.run(
        [sys.executable, "-m", "rosy_sim", "run", str(tmp_path / "p.hs")],
        env=environment, stdout=writing, stderr=subprocess.PIPE, text=True, check=False,
    )  # fmt: skip
    os.close(writing)
    assert (done.returncode, done.stderr) == (1, WARNING)


def test_a_trace_goes_to_standard_output(environment: dict[str, str], tmp_path: Path) -> None:
    (tmp_path / "p.hs").write_text("drive:0.5")
    done = rosy(environment, "run", tmp_path / "p.hs", "--seconds", 1, "--trace", "/dev/stdout")
    assert len(done.stdout.splitlines()) == 51
    assert last(done)["ended"] == "time"


def test_the_old_file_is_there_until_the_new_one_is_complete(tmp_path: Path) -> None:
    path = tmp_path / "f"
    path.write_bytes(b"old")
    path.chmod(0o640)
    with AtomicFile(path) as file:
        file.write(b"new")
        assert path.read_bytes() == b"old"
    assert path.read_bytes() == b"new"
    assert path.stat().st_mode & 0o777 == 0o640


def test_a_link_stays_a_link(tmp_path: Path) -> None:
    (tmp_path / "target").write_bytes(b"old")
    (tmp_path / "link").symlink_to("target")
    with AtomicFile(tmp_path / "link") as file:
        file.write(b"new")
    assert (tmp_path / "link").is_symlink()
    assert (tmp_path / "target").read_bytes() == b"new"


@pytest.mark.parametrize("keep", [True, False])
def test_an_interrupt_keeps_what_was_written_where_that_is_asked_for(keep: bool, tmp_path: Path) -> None:
    path = tmp_path / "f"
    path.write_bytes(b"old")
    with pytest.raises(KeyboardInterrupt), AtomicFile(path, keep_interrupted=keep) as file:  # noqa: PT012
        file.write(b"half")
        raise KeyboardInterrupt
    assert path.read_bytes() == (b"half" if keep else b"old")
    assert [p.name for p in tmp_path.iterdir()] == ["f"]


@pytest.mark.parametrize("name", ["no/such/folder", ".", "x" * 300])
def test_a_file_that_cannot_be_written_is_said_at_once(name: str, tmp_path: Path) -> None:
    with pytest.raises(BadInput, match="cannot be written"):
        AtomicFile(tmp_path / name)
    assert list(tmp_path.iterdir()) == []
