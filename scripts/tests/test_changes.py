"""Files that have changed since the last run that passed, in a repository of their own."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from testing.changes import changed_since, packages_are_waiting, record_commit, recorded_commit


def git(root: Path, *arguments: str) -> None:
    who = ["-c", "user.name=a", "-c", "user.email=a@example.org"]
    subprocess.run(["git", *who, *arguments], cwd=root, check=True, capture_output=True)


@pytest.fixture
def root(tmp_path: Path) -> Path:
    """A repository with two commits: `old.txt`, then `newer.txt`."""
    git(tmp_path, "init", "-q")
    for name in ("old.txt", "newer.txt"):
        (tmp_path / name).write_text("1")
        git(tmp_path, "add", name)
        git(tmp_path, "commit", "-q", "-m", name)
    return tmp_path


def test_without_a_record_only_what_is_not_committed_has_changed(root: Path) -> None:
    assert changed_since(root, None) == []
    (root / "old.txt").write_text("2")
    (root / "new.txt").write_text("")
    assert changed_since(root, None) == ["new.txt", "old.txt"]
    assert changed_since(root, "0" * 40) == ["new.txt", "old.txt"]


def test_commits_after_the_base_count(root: Path) -> None:
    assert changed_since(root, "HEAD~1") == ["newer.txt"]


def test_a_recorded_commit_is_the_next_base(root: Path, tmp_path_factory: pytest.TempPathFactory) -> None:
    record = tmp_path_factory.mktemp("state") / "checked" / "commit"
    assert recorded_commit(record) is None
    record_commit(root, record)
    (root / "old.txt").write_text("2")
    git(root, "commit", "-q", "-a", "-m", "changed")
    assert changed_since(root, recorded_commit(record)) == ["old.txt"]


def test_without_git_nothing_has_changed(tmp_path: Path) -> None:
    assert changed_since(tmp_path, None) == []
    record_commit(tmp_path, tmp_path / "commit")
    assert recorded_commit(tmp_path / "commit") is None


def test_packages_are_tested_on_their_day_nightly_by_hand_and_after_a_change() -> None:
    day = {"ROSY_TEST_SEED": "1", "ROSY_TEST_SHARE": "0.1", "ROSY_TEST_CHANGED": "rosy-hs/src/Rosy.hs\nrosy.cabal"}
    assert packages_are_waiting(day)
    assert not packages_are_waiting(day | {"ROSY_TEST_SEED": "7"})
    assert not packages_are_waiting(day | {"ROSY_TEST_SHARE": "1"})
    assert not packages_are_waiting({})
    for name in ("rosy", "scripts/installation/debian.py"):
        assert not packages_are_waiting(day | {"ROSY_TEST_CHANGED": f"README.md\n{name}"})
