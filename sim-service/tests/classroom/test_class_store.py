"""The store of a class: pupils, versions, conflicts, limits, migrations."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from rosy_sim.classroom.store import class_store as stores
from rosy_sim.classroom.store import roster_store, schema
from rosy_sim.classroom.store.class_store import (
    Admission,
    ClassStore,
    Conflict,
    NicknameTaken,
    Pupil,
    Saved,
    StoreFull,
)
from rosy_sim.classroom.store.database import SqliteDatabase, StoreError
from rosy_sim.classroom.word_list import draw_words, read_words, word_list
from rosy_sim.errors import BadInput
from rosy_sim.sentences.wording import LANGUAGES

from .conftest import ADMISSION, Opens


def join(store: ClassStore, nickname: str = "Ada", token: str = "token", words: str = "") -> Pupil:
    joined = store.join(nickname, lambda: words or f"{nickname} b c", token, 1.0)
    assert isinstance(joined, Pupil)
    return joined


def save(store: ClassStore, pupil: Pupil, text: str, **given: Any) -> Saved | Conflict | StoreFull:
    request = {"program": "p", "name": "walk", "reason": "change", "base": 0, "mark": text, "unacknowledged": []}
    return store.save(pupil.id, text=text, now=2.0, **{**request, **given})


def number(saved: Saved | Conflict | StoreFull) -> int:
    assert isinstance(saved, Saved)
    return saved.number


def test_a_class_keeps_its_code_and_key_when_it_is_opened_again(opens: Opens) -> None:
    ClassStore(opens("c"), ADMISSION, 0.0).close()
    again = ClassStore(opens("c"), Admission("other", "other"), 0.0)
    assert again.admission() == ADMISSION
    again.close()


def test_the_database_is_journalled_and_flushed_at_each_commit(tmp_path: Path) -> None:
    store = ClassStore(SqliteDatabase(tmp_path / "c"), ADMISSION, 0.0)
    database = store._database
    assert database.execute("PRAGMA journal_mode").fetchone() == ("wal",)
    assert database.execute("PRAGMA synchronous").fetchone() == (2,)
    assert database.execute("PRAGMA user_version").fetchone() == (len(schema.MIGRATIONS),)
    store.close()


def test_a_class_of_a_newer_rosy_is_left_alone(opens: Opens) -> None:
    ClassStore(opens("c"), ADMISSION, 0.0).close()
    newer = opens("c")
    newer.migrate(["CREATE TABLE more (a INTEGER)"], len(schema.MIGRATIONS) + 1)
    newer.close()
    with pytest.raises(BadInput, match="newer Rosy"):
        ClassStore(opens("c"), ADMISSION, 0.0)


def test_a_migration_that_fails_changes_nothing(opens: Opens, monkeypatch: pytest.MonkeyPatch) -> None:
    store = ClassStore(opens("c"), ADMISSION, 0.0)
    join(store)
    store.close()
    broken = (*schema.MIGRATIONS, ("CREATE TABLE more (a INTEGER)", "nonsense"))
    monkeypatch.setattr(schema, "MIGRATIONS", broken)
    with pytest.raises(StoreError):
        ClassStore(opens("c"), ADMISSION, 0.0)
    monkeypatch.setattr(schema, "MIGRATIONS", (*schema.MIGRATIONS[:-1], ("CREATE TABLE more (a INTEGER)",)))
    again = ClassStore(opens("c"), ADMISSION, 0.0)
    assert [pupil.nickname for pupil in again.pupils()] == ["Ada"]
    assert again._database.execute("SELECT count(*) FROM more").fetchone() == (0,)
    again.close()


def test_a_nickname_belongs_to_one_pupil_whatever_its_case(store: ClassStore) -> None:
    join(store, "Straße")
    assert store.join("STRASSE", lambda: "x y z", "t", 1.0) == NicknameTaken()


def test_words_that_another_pupil_has_are_drawn_again(store: ClassStore) -> None:
    join(store, "Ada", "t1", "a b c")
    drawn = iter(["a b c", "a b c", "d e f"])
    second = store.join("Ben", lambda: next(drawn), "t2", 1.0)
    assert isinstance(second, Pupil)
    assert second.words == "d e f"


def test_words_and_devices_lead_to_their_pupil_and_to_no_other(store: ClassStore) -> None:
    ada, ben = join(store, "Ada", "t1"), join(store, "Ben", "t2")
    assert store.pupil_of("t1") == ada
    assert store.resume(ben.words, "t3", 2.0) == ben
    assert store.pupil_of("t3") == ben
    assert store.resume("no such words", "t4", 2.0) is None
    assert store.pupil_of("t4") is None
    store.forget_device("t3")
    assert store.pupil_of("t3") is None
    assert store.pupil_of("t2") == ben


def test_tokens_are_not_in_the_database(tmp_path: Path) -> None:
    store = ClassStore(SqliteDatabase(tmp_path / "c"), ADMISSION, 0.0)
    join(store, token="the-secret-of-a-device")
    assert all(b"the-secret-of-a-device" not in file.read_bytes() for file in tmp_path.iterdir())
    store.close()


def test_only_so_many_devices_of_a_pupil_are_remembered(store: ClassStore) -> None:
    ada = join(store, token="first")
    for device in range(stores.MAX_DEVICES):
        store.resume(ada.words, f"t{device}", 3.0 + device)
    assert store.pupil_of("first") is None
    assert store.pupil_of("t0") == ada


def test_versions_follow_each_other(store: ClassStore) -> None:
    ada = join(store)
    first = number(save(store, ada, "1"))
    second = number(save(store, ada, "2", base=first))
    assert second > first
    assert [version.text for version in store.history(ada.id)] == ["1", "2"]
    assert [version.text for version in store.programs(ada.id)] == ["2"]


def test_the_same_text_is_no_new_version(store: ClassStore) -> None:
    ada = join(store)
    first = number(save(store, ada, "1"))
    assert number(save(store, ada, "1", base=0)) == first
    assert len(store.history(ada.id)) == 1


def test_a_change_of_an_older_version_is_a_conflict_and_loses_nothing(store: ClassStore) -> None:
    ada = join(store)
    first = number(save(store, ada, "1"))
    second = number(save(store, ada, "2", base=first))
    found = save(store, ada, "other", base=first)
    assert isinstance(found, Conflict)
    assert (found.latest.number, found.latest.text) == (second, "2")
    assert isinstance(save(store, ada, "other", base=0), Conflict)


def test_a_version_whose_answer_was_lost_is_no_conflict(store: ClassStore) -> None:
    ada = join(store)
    first = number(save(store, ada, "1"))
    save(store, ada, "2", base=first, mark="lost")
    assert isinstance(save(store, ada, "3", base=first), Conflict)
    assert isinstance(save(store, ada, "3", base=first, unacknowledged=["lost"]), Saved)


def test_pupils_have_programs_of_their_own_under_the_same_identifier(store: ClassStore) -> None:
    ada, ben = join(store, "Ada", "t1"), join(store, "Ben", "t2")
    save(store, ada, "of Ada")
    save(store, ben, "of Ben")
    assert [v.text for v in store.programs(ada.id)] == ["of Ada"]
    assert [v.text for v in store.programs(ben.id)] == ["of Ben"]


def test_old_versions_give_way(store: ClassStore, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(stores, "MAX_VERSIONS", 3)
    ada, base = join(store), 0
    for n in range(5):
        base = number(save(store, ada, str(n), base=base))
    assert [v.text for v in store.history(ada.id)] == ["2", "3", "4"]


def test_a_full_share_takes_superseded_versions_and_never_the_newest(
    store: ClassStore, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(stores, "MAX_BYTES", 30)
    ada = join(store)
    first = number(save(store, ada, "a" * 10))
    save(store, ada, "b" * 10, base=first)
    save(store, ada, "c" * 15, program="q")
    assert [v.text[0] for v in store.history(ada.id)] == ["b", "c"]
    assert save(store, ada, "d" * 10, program="r") == StoreFull()
    assert [v.text[0] for v in store.history(ada.id)] == ["b", "c"]


def test_a_class_has_an_end(store: ClassStore, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(roster_store, "MAX_PUPILS", 1)
    join(store)
    assert store.join("Ben", lambda: "x y z", "t", 1.0) == StoreFull()


@pytest.mark.parametrize("language", [file.parent.name for file in sorted(LANGUAGES.glob("*/pupil_words.txt"))])
def test_words_are_short_distinct_and_typed_on_any_keyboard(language: str) -> None:
    words = word_list(language)
    assert len(set(words)) == len(words) >= 250
    assert all(word.isascii() and word.isalpha() and word.islower() and 2 <= len(word) <= 10 for word in words)
    assert set(draw_words(f"{language}-CH").split()) <= set(words)


def test_words_are_read_as_people_type_them() -> None:
    assert read_words("  Apfel, BAUM-see. ") == "apfel baum see"
