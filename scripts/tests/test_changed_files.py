"""Checks of changed files: what passed is not checked again until the file, the tool or its configuration changes."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from testing.changed_files import DAYS, LEFT_OUT, Day, check, main

# Prints the names of the files that it is given, and finds fault with the word `bad`.
TOOL = """#!/bin/sh
[ "$1" = --version ] && { echo %s; exit; }
echo "$@" >>"$SEEN"
! grep -q bad "$@"
"""


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("SEEN", str(tmp_path / "seen"))
    install(tmp_path, "1")
    for name in ("a", "b"):
        (tmp_path / name).write_text(name)
    (tmp_path / "settings").write_text("")
    return tmp_path


def install(folder: Path, version: str) -> None:
    (folder / "tool").write_text(TOOL % version)
    os.chmod(folder / "tool", 0o755)


ALL = Day(None)


def checked(folder: Path, whole: bool = False, day: Day = ALL) -> tuple[int, list[str]]:
    """The status, and the names of the files that the tool was given."""
    (folder / "seen").write_text("")
    files = [folder / "a", folder / "b"]
    status = check(folder / "record", [str(folder / "tool")], [folder / "settings"], files, day, whole)
    return status, [Path(path).name for path in (folder / "seen").read_text().split()]


def test_what_passed_is_not_checked_again(folder: Path) -> None:
    assert checked(folder) == (0, ["a", "b"])
    assert checked(folder) == (0, [])
    (folder / "b").write_text("changed")
    assert checked(folder) == (0, ["b"])
    assert checked(folder, whole=True) == (0, ["a", "b"])


@pytest.mark.parametrize("first", [0, 20783, 20784])
def test_in_a_new_clone_each_file_is_judged_once_in_seven_days(folder: Path, first: int) -> None:
    judged = [checked(folder, day=Day(first + day))[1] for day in range(DAYS)]
    assert sorted(name for names in judged for name in names) == ["a", "b"]
    assert all(len(names) < 2 for names in judged)
    assert checked(folder, day=Day(first)) == (0, [])


def test_a_changed_file_does_not_wait_for_its_day(folder: Path) -> None:
    assert checked(folder, day=Day(1, {(folder / "a").as_posix()})) == (0, ["a"])
    (folder / "a").write_text("changed")
    assert checked(folder, day=Day(1)) == (0, ["a"])
    assert checked(folder, day=Day(1), whole=True) == (0, ["a", "b"])


def test_what_failed_is_checked_until_it_passes(folder: Path) -> None:
    assert checked(folder) == (0, ["a", "b"])
    (folder / "a").write_text("bad")
    assert checked(folder) == (1, ["a"])
    assert checked(folder) == (1, ["a"])
    (folder / "a").write_text("good")
    assert checked(folder) == (0, ["a"])


def test_another_version_or_configuration_checks_everything(folder: Path) -> None:
    checked(folder)
    install(folder, "2")
    assert checked(folder) == (0, ["a", "b"])
    (folder / "settings").write_text("stricter")
    assert checked(folder) == (0, ["a", "b"])


@pytest.mark.parametrize("damage", ["{", "[]", '["a digest"]'])
def test_a_damaged_record_counts_as_empty(folder: Path, damage: str) -> None:
    checked(folder)
    (folder / "record").write_text(damage)
    assert checked(folder) == (0, ["a", "b"])


@pytest.mark.parametrize(
    ("said", "status"), [("v3.3.6, (C) Somebody 2006-2021", 0), ("3.3", 0), ("3.30.1", LEFT_OUT), ("v3.6.1", LEFT_OUT), ("unknown", LEFT_OUT)]
)
def test_a_tool_of_another_version_is_left_out_and_named(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str], said: str, status: int
) -> None:
    install(folder, f"'{said}'")
    (folder / "seen").write_text("")
    monkeypatch.chdir(folder)
    monkeypatch.delenv("ROSY_TEST_SEED", raising=False)
    assert main(["record", "only", "3.3", str(folder / "tool"), "--", "a"]) == status
    assert ((folder / "seen").read_text() == "") == (status == LEFT_OUT)
    assert ("Left out" in capfd.readouterr().out) == (status == LEFT_OUT)
