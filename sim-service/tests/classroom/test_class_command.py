"""``./rosy class``: list, export, delete."""

from __future__ import annotations

import json
import zipfile
from pathlib import Path

import pytest

from rosy_sim import cli
from rosy_sim.classroom.store.class_folder import open_class
from rosy_sim.classroom.store.class_store import Pupil


@pytest.fixture
def classes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("ROSY_CLASSES", str(tmp_path / "classes"))
    return tmp_path / "classes"


def begin(classes: Path, name: str = "7b") -> None:
    """A class with a pupil and three programs, two of the same name."""
    with open_class(classes, name) as store:
        pupil = store.join("Ada / <b>", lambda: "apple boat star", "token", 0.0)
        assert isinstance(pupil, Pupil)
        store.save(pupil.id, "p", "walk", "old", "change", 0, "1", [], 1.0)
        store.save(pupil.id, "p", "walk", "new", "run", 0, "2", ["1"], 2.0)
        store.save(pupil.id, "q", "Walk", "other", "change", 0, "3", [], 3.0)
        store.save(pupil.id, "r", "../../up", "outside", "change", 0, "4", [], 4.0)


def test_an_export_has_every_program_and_its_history(
    classes: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    begin(classes)
    target = tmp_path / "out.zip"
    assert cli.main(["class", "export", "7b", "-o", str(target)]) == 0
    assert "1 pupils, 3 programs" in capsys.readouterr().out
    with zipfile.ZipFile(target) as archive:
        assert archive.testzip() is None
        programs = {name: archive.read(name).decode() for name in archive.namelist() if name != "class.json"}
        everything = json.loads(archive.read("class.json"))
    assert programs == {
        "001 Ada _ _b_/_.._up.rosy": "outside",
        "001 Ada _ _b_/Walk.rosy": "other",
        "001 Ada _ _b_/walk 2.rosy": "new",
    }
    (pupil,) = everything["pupils"]
    assert pupil["nickname"] == "Ada / <b>"
    assert [version["text"] for version in pupil["history"]] == ["old", "new", "other", "outside"]


def test_a_class_is_exported_while_it_is_open(classes: Path, tmp_path: Path) -> None:
    begin(classes)
    with open_class(classes, "7b"):
        assert cli.main(["class", "export", "-o", str(tmp_path / "out.zip")]) == 0


def test_deleting_leaves_nothing_behind(classes: Path, capsys: pytest.CaptureFixture[str]) -> None:
    begin(classes)
    assert (classes / "7b").is_dir()
    assert cli.main(["class", "delete", "7b"]) == 0
    assert list(classes.iterdir()) == []
    assert cli.main(["class", "list"]) == 0
    assert capsys.readouterr().out == "The class 7b is deleted.\n"


def test_a_class_in_use_is_not_deleted_and_not_opened_twice(classes: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with open_class(classes, "7b"):
        assert cli.main(["class", "delete", "7b"]) == 1
        assert "is open in another Rosy" in capsys.readouterr().err
    assert cli.main(["class", "list"]) == 0
    assert capsys.readouterr().out == "7b\n"


def test_only_the_owner_can_read_a_class(classes: Path) -> None:
    begin(classes)
    with open_class(classes, "7b"):
        assert (classes / "7b").stat().st_mode & 0o777 == 0o700
        assert all(file.stat().st_mode & 0o077 == 0 for file in (classes / "7b").iterdir())


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (["delete"], "There is no class yet"),
        (["delete", "7c"], "There is no class called 7c"),
        (["export", "7c"], "There is no class called 7c"),
        (["delete", "../../home"], "The name of a class has at most 40 letters"),
        (["list", "-o", "x"], "-o is for export"),
    ],
)
def test_what_cannot_be_done_is_a_sentence(
    classes: Path, capsys: pytest.CaptureFixture[str], arguments: list[str], sentence: str
) -> None:
    assert cli.main(["class", *arguments]) == 1
    assert sentence in capsys.readouterr().err
    assert not classes.exists() or list(classes.iterdir()) == []


def test_of_several_classes_one_must_be_named(classes: Path, capsys: pytest.CaptureFixture[str]) -> None:
    begin(classes, "7a")
    begin(classes, "7b")
    assert cli.main(["class", "delete"]) == 1
    assert "Which class? There are 7a, 7b." in capsys.readouterr().err
