"""Places of classes: one service opens a class; others read it, list it and delete it, in a folder or on a server."""

from __future__ import annotations

from pathlib import Path

import pytest

from rosy_sim.classroom.store.class_places import ClassPlace, class_place
from rosy_sim.classroom.store.class_store import Pupil
from rosy_sim.errors import BadInput

from ..postgresql_server import needs_postgresql


@pytest.fixture(params=["folder", "sqlite", pytest.param("postgresql", marks=needs_postgresql)])
def place(request: pytest.FixtureRequest, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> ClassPlace:
    if request.param == "folder":
        return class_place(tmp_path, None)
    if request.param == "sqlite":
        return class_place(tmp_path / "elsewhere", f"sqlite:{tmp_path}")
    from rosy_sim.classroom.store import postgresql_database

    monkeypatch.setattr(postgresql_database.PostgresqlDatabase.__init__, "__kwdefaults__", {"patience": 0.0})
    return class_place(tmp_path, request.getfixturevalue("server"))


def test_a_class_is_kept_until_it_is_deleted(place: ClassPlace) -> None:
    with place.open("7b") as store:
        admission = store.admission()
        assert isinstance(store.join("Ada", lambda: "a b c", "token", 1.0), Pupil)
        # While a service has it open it can be read, and neither opened nor deleted.
        with place.read("7b") as read:
            assert [pupil.nickname for pupil in read.pupils()] == ["Ada"]
        with pytest.raises(BadInput, match="open in another Rosy"), place.open("7b"):
            pass
        with pytest.raises(BadInput, match="open in another Rosy"):
            place.delete("7b", 5.0)
    with place.open("7b") as store:
        assert store.admission() == admission
    assert "7b" in place.names()
    place.delete("7b", 5.0)
    assert "7b" not in place.names()
    with place.open("7b") as store:
        assert store.pupils() == []
    (deleted,) = [one for one in place.deleted() if one.name == "7b"]
    with pytest.raises(BadInput, match="There is a class called 7b"):
        place.restore(deleted, "7b")
    for announced in (7.0, None, 8.0):
        place.announce_removal(deleted, announced)
        assert [one.announced for one in place.deleted() if one.name == "7b"] == [announced]
    place.restore(deleted, "7c")
    with place.open("7c") as store:
        assert [pupil.nickname for pupil in store.pupils()] == ["Ada"]
    place.delete("7c", 6.0)
    place.delete("7b", 6.0)
    for one in place.deleted():
        assert one.announced is None
        place.remove(one)
    assert place.deleted() == []


def test_what_is_no_class_is_refused(place: ClassPlace) -> None:
    with pytest.raises(BadInput, match="no class called 8c"), place.read("8c"):
        pass
    with pytest.raises(BadInput, match="no class called 8c"):
        place.delete("8c", 5.0)
    with pytest.raises(BadInput, match="at most 40 letters"), place.open("../8c"):
        pass


@needs_postgresql
def test_a_server_that_is_not_there_is_named(tmp_path: Path) -> None:
    with pytest.raises(BadInput, match=r"database of the classes cannot be reached \(.*\). Start its server"):
        class_place(tmp_path, f"postgresql://rosy@/none?host={tmp_path}").names()


@needs_postgresql
def test_a_server_that_does_not_admit_this_machine_is_named(server: str, tmp_path: Path) -> None:
    place = class_place(tmp_path, server.replace("/postgres?", "/none?"))
    with pytest.raises(BadInput, match=r'does not admit this machine \(.*"none" does not exist'), place.open("7b"):
        pass


@needs_postgresql
def test_a_server_that_cannot_be_reached_is_named_without_its_password(tmp_path: Path) -> None:
    url = f"postgresql://rosy:secret@/none?host={tmp_path}"
    with pytest.raises(BadInput) as refused:
        class_place(tmp_path, url).names()
    causes = [refused.value, refused.value.__cause__, getattr(refused.value.__cause__, "__cause__", None)]
    assert not any("secret" in str(cause) for cause in causes)


@needs_postgresql
@pytest.mark.parametrize("url", ["postgresql://rosy:secret@[1", "postgresql://rosy:secret@host:port/rosy"])
def test_an_address_that_cannot_be_read_is_named_without_its_password(url: str, tmp_path: Path) -> None:
    with pytest.raises(BadInput) as refused:
        class_place(tmp_path, url).names()
    assert "ROSY_CLASS_DATABASE" in str(refused.value)
    assert "secret" not in str(refused.value)
