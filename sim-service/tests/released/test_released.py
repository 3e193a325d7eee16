"""
What each released version has stored is read by this one, and what a newer one stores is refused and stays as it is.

A folder named like a version has ``class.sql`` (a dump of the database of a class), ``recording.mcap`` and
``program.rosy``, and for ``editor/test/browser/released.test.ts`` ``lesson.json`` and ``browser-storage.json``, as that
version writes them. They are never changed. All versions tell the same story.
"""

from __future__ import annotations

import json
import shutil
import sqlite3
from contextlib import closing
from pathlib import Path

import pytest

from rosy_sim.classroom.store.class_folder import open_class, read_class
from rosy_sim.classroom.store.class_store import Admission
from rosy_sim.classroom.store.schema import MIGRATIONS
from rosy_sim.errors import BadInput
from rosy_sim.programs.program_file import VERSION, read_program
from rosy_sim.recordings import mcap_file
from rosy_sim.recordings.mcap_file import RunDetails, open_recording

RELEASED = sorted(path for path in Path(__file__).parent.iterdir() if path.name[0].isdigit())

PROGRAM = "main = simulate (Velocity 0.2 0)\n"


@pytest.fixture(params=RELEASED, ids=lambda path: path.name)
def released(request: pytest.FixtureRequest) -> Path:
    """What a released version has stored."""
    assert isinstance(request.param, Path)
    return request.param


def stored_class(released: Path, classes: Path) -> Path:
    """The database of a class of that version, in a folder of classes."""
    path = classes / "robots" / "class.sqlite3"
    path.parent.mkdir(parents=True)
    with closing(sqlite3.connect(path)) as database:
        # A dump does not have it; databases of classes do.
        database.execute("PRAGMA journal_mode = WAL")
        database.executescript((released / "class.sql").read_text())
    return path


def test_there_is_a_released_version() -> None:
    assert RELEASED


def test_a_class_keeps_everything(released: Path, tmp_path: Path) -> None:
    stored_class(released, tmp_path)
    for _ in range(2):
        with open_class(tmp_path, "robots") as store:
            ada, ben = store.pupils()
            assert store.admission() == Admission("bcdfgh", "bcdfghjkmnpqrstv")
            assert (ada.nickname, ben.nickname) == ("Ada", "Ben")
            assert store.pupil_of("token-of-ada") == ada
            assert [version.text for version in store.history(ada.id)] == [PROGRAM.replace("0.2", "0.1"), PROGRAM]
            (task,) = store.tasks.tasks()
            (hand_in,) = store.tasks.kept(task.id)
            assert (task.title, hand_in.text, hand_in.comment) == ("Drive a square", PROGRAM, "Well done")
            assert [comment.text for comment in store.comments.comments()] == ["Why 0.2?"]
            assert [(done.pupil, done.lesson, list(done.done)) for done in store.progress.all()] == [
                (ben.id, "first-drive", ["one", "two"])
            ]


def test_a_recording_is_read(released: Path) -> None:
    with open_recording(released / "recording.mcap") as recording:
        program = PROGRAM.replace("0.2", "0.1")
        assert recording.details == RunDetails(program, "serial:/dev/kobuki", "walk.hs", "stopped")
        assert (recording.is_complete, recording.left_out, len(list(recording.lines()))) == (True, 2, 3)


def test_a_project_is_read(released: Path) -> None:
    assert "main = simulate" in read_program(released / "program.rosy").source


def test_a_class_of_a_newer_version_is_refused_and_stays_as_it_is(released: Path, tmp_path: Path) -> None:
    path = stored_class(released, tmp_path)
    with closing(sqlite3.connect(path)) as database:
        database.execute(f"PRAGMA user_version = {len(MIGRATIONS) + 1}")
    before = path.read_bytes()
    for opened in (open_class, read_class):
        with (
            pytest.raises(BadInput, match=rf"its version is {len(MIGRATIONS) + 1}, .*up to {len(MIGRATIONS)}"),
            opened(tmp_path, "robots"),
        ):
            pass
    assert path.read_bytes() == before
    assert not (path.parent / "backup.sqlite3").exists()


def test_a_recording_of_a_newer_version_is_refused(
    released: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "recording.mcap"
    shutil.copy(released / "recording.mcap", path)
    monkeypatch.setattr(mcap_file, "VERSION", 0)
    with pytest.raises(BadInput, match=r"saved by a newer Rosy: its version is 1, .* up to 0"), open_recording(path):
        pass


def test_a_project_of_a_newer_version_is_refused(released: Path, tmp_path: Path) -> None:
    path = tmp_path / "program.rosy"
    project = json.loads((released / "program.rosy").read_text())
    path.write_text(json.dumps(project | {"rosy": VERSION + 1}))
    with pytest.raises(BadInput, match=r"newer Rosy: its version is 2, .* up to 1"):
        read_program(path)
