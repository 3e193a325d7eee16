"""``./rosy class``: list, export, delete, restore."""

from __future__ import annotations

import argparse
import json
import os
import sqlite3
import zipfile
from contextlib import closing
from pathlib import Path

import pytest

from rosy_sim import cli
from rosy_sim.classroom.command import add_class_options, run_class_command
from rosy_sim.classroom.store.class_folder import open_class, read_class
from rosy_sim.classroom.store.class_places import class_place
from rosy_sim.classroom.store.class_store import Pupil
from rosy_sim.errors import BadInput


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
        programs = {name: archive.read(name).decode() for name in archive.namelist() if name.endswith(".rosy")}
        everything = json.loads(archive.read("class.json"))
    assert programs == {
        "001 Ada _ _b_/_.._up.rosy": "outside",
        "001 Ada _ _b_/Walk.rosy": "other",
        "001 Ada _ _b_/walk 2.rosy": "new",
    }
    (pupil,) = everything["pupils"]
    assert pupil["nickname"] == "Ada / <b>"
    assert [version["text"] for version in pupil["history"]] == ["old", "new", "other", "outside"]


def test_a_study_is_exported_with_a_key_that_is_made(
    classes: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    begin(classes)
    command = ["class", "study", "7b", "-o", str(tmp_path / "out.zip"), "--key", str(tmp_path / "key")]
    assert cli.main(command) == 1
    assert "takes part in no study" in capsys.readouterr().err
    assert not (tmp_path / "out.zip").exists()
    with open_class(classes, "7b") as store:
        store.study.begin("Prof. Eve", 0.0)
        store.study.answer(1, 2.5)
        assert cli.main(command) == 0
    assert "1 pupils" in capsys.readouterr().out
    with zipfile.ZipFile(tmp_path / "out.zip") as archive:
        assert len(archive.read("MainTable.csv").splitlines()) == 3
    assert (tmp_path / "key").stat().st_mode & 0o777 == 0o600
    assert cli.main(["class", "export", "7b", "--key", "key"]) == 1
    assert "--key is for study" in capsys.readouterr().err


def test_a_class_is_exported_while_it_is_open(classes: Path, tmp_path: Path) -> None:
    begin(classes)
    with open_class(classes, "7b"):
        assert cli.main(["class", "export", "-o", str(tmp_path / "out.zip")]) == 0


DAY = 86_400.0

EXAMPLES = Path(__file__).resolve().parents[3] / "examples"


def told(classes: Path, command: str, now: float, typed: str | None = None) -> str:
    """What the command prints at a time, with what a person types at its question."""
    parser = argparse.ArgumentParser()
    add_class_options(parser)
    lines: list[str] = []
    options = parser.parse_args(command.split())
    place = class_place(classes, None)
    assert run_class_command(place, options, now, lines.append, lambda: typed, EXAMPLES) == 0
    return "\n".join(lines)


def test_a_deleted_class_is_restored_as_it_was(classes: Path) -> None:
    begin(classes)
    with read_class(classes, "7b") as store:
        admission, programs = store.admission(), store.programs(1)
    said = told(classes, "delete 7b", 0.0, "7b\n")
    assert "The class 7b has 1 pupils, 3 programs and 0 programs that were handed in." in said
    assert "It can be restored until 1970-01-31." in said
    assert told(classes, "list", 30 * DAY) == "7b (deleted; can be restored until 1970-01-31)"
    assert told(classes, "restore", 30 * DAY) == "The class 7b is back."
    assert told(classes, "list", 30 * DAY) == "7b"
    with open_class(classes, "7b") as store:
        assert (store.admission(), store.programs(1)) == (admission, programs)


def test_a_deleted_class_is_removed_after_thirty_days(classes: Path) -> None:
    begin(classes)
    told(classes, "delete 7b --yes", 0.0)
    assert told(classes, "list", 30 * DAY + 1) == "7b (deleted; a start after 1970-02-01 removes it for good)"
    # The clock was wrong.
    assert told(classes, "list", DAY) == "7b (deleted; can be restored until 1970-01-31)"
    assert told(classes, "list", 31 * DAY) == "7b (deleted; a start after 1970-02-02 removes it for good)"
    assert told(classes, "list", 32 * DAY) == ""
    assert list(classes.iterdir()) == []


def test_a_class_that_is_deleted_for_good_leaves_nothing_behind(classes: Path) -> None:
    begin(classes)
    told(classes, "delete 7b --yes", 0.0)
    begin(classes)
    assert "Nothing of it can be restored" in told(classes, "delete 7b --forever", 1.0, "7b\n")
    assert list(classes.iterdir()) == []


def test_a_class_of_the_same_name_is_not_replaced(classes: Path) -> None:
    begin(classes)
    told(classes, "delete 7b --yes", 0.0)
    begin(classes)
    told(classes, "delete 7b --yes", 0.0)
    begin(classes)
    with pytest.raises(BadInput, match="choose another name with --as"):
        told(classes, "restore 7b", 1.0)
    told(classes, "restore 7b --as 7b-old", 1.0)
    told(classes, "restore 7b --as 7b-older", 1.0)
    assert told(classes, "list", 1.0) == "7b\n7b-old\n7b-older"


@pytest.mark.parametrize(
    ("command", "typed", "sentence"),
    [
        ("delete", "7b\n", "Which class is to be deleted?"),
        ("delete 7b", "yes\n", "That is not 7b: nothing was deleted."),
        ("delete 7b", "", "That is not 7b: nothing was deleted."),
        ("delete 7b", None, "No person is at this terminal"),
        ("delete 7b --forever", None, "No person is at this terminal"),
    ],
)
def test_nothing_is_deleted_without_a_name_and_a_confirmation(
    classes: Path, command: str, typed: str | None, sentence: str
) -> None:
    begin(classes)
    with pytest.raises(BadInput, match=sentence.replace("?", r"\?")):
        told(classes, command, 0.0, typed)
    assert told(classes, "list", 0.0) == "7b"


def test_a_class_in_use_is_not_deleted_and_not_opened_twice(classes: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with open_class(classes, "7b"):
        assert cli.main(["class", "delete", "7b", "--yes"]) == 1
        assert "is open in another Rosy" in capsys.readouterr().err
    assert cli.main(["class", "list"]) == 0
    assert capsys.readouterr().out == "7b\n"


def modes(path: Path) -> set[int]:
    """Permissions of a folder and of everything in it."""
    return {one.stat().st_mode & 0o777 & ~(0o100 if one.is_dir() else 0) for one in (path, *path.rglob("*"))}


@pytest.mark.parametrize("mode", [0o755, 0o777])
def test_only_the_owner_can_read_a_class_and_the_names_of_classes(classes: Path, tmp_path: Path, mode: int) -> None:
    target = tmp_path / "out.zip"
    old = os.umask(0)
    try:
        begin(classes)
        begin(classes, "8c")
        assert cli.main(["class", "export", "7b", "-o", str(target)]) == 0
    finally:
        os.umask(old)
    assert modes(classes) == {0o600}
    assert target.stat().st_mode & 0o777 == 0o600
    told(classes, "delete 8c --yes", 0.0)
    for path in (classes, *classes.rglob("*")):
        path.chmod(mode if path.is_dir() else mode & 0o666)
    with open_class(classes, "7b"):
        assert modes(classes / "7b") == {0o600}
    # Other users cannot open anything below a folder that they cannot enter.
    assert classes.stat().st_mode & 0o777 == 0o700


def test_the_rights_to_a_folder_that_is_not_for_classes_alone_stay(classes: Path) -> None:
    begin(classes)
    (classes / "other").write_text("")
    classes.chmod(0o755)
    with open_class(classes, "7b"):
        assert classes.stat().st_mode & 0o777 == 0o755
        assert modes(classes / "7b") == {0o600}


def without_tables() -> bytes:
    """A database in which nothing was ever made."""
    with closing(sqlite3.connect(":memory:")) as connection:
        connection.execute("VACUUM")
        return connection.serialize()


def damages(whole: bytes) -> dict[str, bytes | None]:
    """What may have become of a database."""
    return {
        "removed": None,
        "empty": b"",
        "one byte": whole[:1],
        "zeros": bytes(len(whole)),
        "half": whole[: len(whole) // 2],
        "no header": b"x" * 100 + whole[100:],
        "another file": b"PK\3\4" + whole,
        "garbage in the tables": whole[:4096] + b"\xff" * (len(whole) - 4096),
        "no tables": without_tables(),
    }


@pytest.mark.parametrize("damage", damages(bytes(10)))
def test_a_damaged_class_is_refused_and_its_copy_brings_it_back(classes: Path, damage: str) -> None:
    begin(classes)
    with open_class(classes, "7b"):
        pass
    database, copy = classes / "7b" / "class.sqlite3", classes / "7b" / "backup.sqlite3"
    found = damages(database.read_bytes())[damage]
    if found is None:
        database.rename(database.with_name("class.sqlite3-wal"))
    else:
        database.write_bytes(found)

    def contents() -> dict[Path, bytes]:
        # What stands before is SQLite's header, which says how the file is written.
        return {path: path.read_bytes()[100:] for path in (classes / "7b").iterdir()}

    before = contents()
    for _ in range(2):
        with pytest.raises(BadInput, match=f"A copy from .* is {copy}"), open_class(classes, "7b"):
            pass
    assert contents() == before
    # As the sentence says.
    for path in (classes / "7b").glob("class.sqlite3*"):
        path.unlink()
    copy.rename(database)
    with open_class(classes, "7b") as store:
        assert [pupil.nickname for pupil in store.pupils()] == ["Ada / <b>"]


def test_a_pupil_who_was_removed_long_ago_is_in_neither_the_class_nor_its_copy(classes: Path) -> None:
    begin(classes)
    with open_class(classes, "7b") as store:
        (pupil,) = store.pupils()
        store.roster.remove([pupil.id], 1.0)
        store.roster.purge(40 * DAY)
        assert len(store.roster.removed()) == 1
    with open_class(classes, "7b") as store:
        assert store.roster.removed() == []
    for name in ("class.sqlite3", "backup.sqlite3"):
        with closing(sqlite3.connect(classes / "7b" / name)) as database:
            assert database.execute("SELECT count(*) FROM pupil").fetchone() == (0,)
            assert database.execute("SELECT count(*) FROM version").fetchone() == (0,)


def test_a_damaged_class_without_a_copy_is_refused(classes: Path) -> None:
    (classes / "7b").mkdir(parents=True)
    (classes / "7b" / "class.sqlite3").write_bytes(b"")
    for opens in (open_class, read_class):
        with pytest.raises(BadInput, match="There is no copy of it here"), opens(classes, "7b"):
            pass


def test_a_class_whose_creation_was_interrupted_is_created(classes: Path) -> None:
    (classes / "7b").mkdir(parents=True)
    for name in ("class.sqlite3.new", "class.sqlite3.new-wal", "lock"):
        (classes / "7b" / name).write_bytes(b"x")
    begin(classes)


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (["export"], "There is no class yet"),
        (["restore"], "There is no deleted class"),
        (["delete", "7c", "--yes"], "There is no class called 7c"),
        (["export", "7c"], "There is no class called 7c"),
        (["delete", "../../home", "--yes"], "The name of a class has at most 40 letters"),
        (["list", "-o", "x"], "-o is for export"),
        (["export", "7b", "--yes"], "--yes and --forever are for delete"),
        (["list", "--as", "7c"], "--as is for restore"),
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
    assert cli.main(["class", "export"]) == 1
    assert "Which class? There are 7a, 7b." in capsys.readouterr().err
