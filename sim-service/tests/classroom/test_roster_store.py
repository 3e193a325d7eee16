"""The roster of a class in its store: names beforehand, other names, removed and restored pupils, merged entries."""

from __future__ import annotations

import itertools

import pytest

from rosy_sim.classroom.store import roster_store
from rosy_sim.classroom.store.class_store import ClassStore, NicknameTaken, Pupil, PupilRemoved, Saved, StoreFull
from rosy_sim.classroom.store.comment_store import CommentKept
from rosy_sim.classroom.store.retention import DELETED_KEPT, NOTICE, kept_until
from rosy_sim.classroom.store.roster_store import RemovedPupil

from .conftest import ADMISSION, Opens


def join(store: ClassStore, nickname: str) -> Pupil:
    joined = store.join(nickname, lambda: f"{nickname} b c", f"token {nickname}", 1.0)
    assert isinstance(joined, Pupil)
    return joined


def save(store: ClassStore, pupil: Pupil, text: str, program: str = "p", base: int = 0) -> int:
    saved = store.save(pupil.id, program, f"name of {text}", text, "change", base, text, [], 2.0)
    assert isinstance(saved, Saved)
    return saved.number


def open_task(store: ClassStore, title: str) -> int:
    task = store.tasks.open(title, None, 3.0)
    assert task is not None
    return task.id


def contents(store: ClassStore) -> list[object]:
    """Everything that lists show."""
    return [
        store.pupils(),
        store.tasks.hand_ins(),
        store.comments.comments(),
        store.progress.all(),
        [store.programs(pupil.id) for pupil in store.pupils()],
    ]


def test_a_list_of_names_adds_pupils_who_come_in_with_their_words(store: ClassStore) -> None:
    join(store, "Ada")
    words = (f"{n} b c" for n in itertools.count())
    ben, again, cleo = store.roster.add(["Ben", "ADA", "Cleo"], lambda: next(words), 2.0)
    assert isinstance(ben, Pupil)
    assert isinstance(cleo, Pupil)
    assert isinstance(again, NicknameTaken)
    assert store.resume(ben.words, "tablet", 3.0) == ben
    assert [pupil.nickname for pupil in store.pupils()] == ["Ada", "Ben", "Cleo"]


def test_a_pupil_gets_another_name_that_no_one_else_has(store: ClassStore) -> None:
    ada, ben = join(store, "Ada"), join(store, "Ben")
    assert isinstance(store.roster.rename(ada.id, "BEN"), NicknameTaken)
    renamed = store.roster.rename(ada.id, "ADA")
    assert renamed == Pupil(ada.id, "ADA", ada.words, ada.joined)
    assert store.roster.rename(99, "Cleo") is None
    assert store.pupils() == [renamed, ben]
    assert store.pupil_of("token Ada") == renamed


def test_a_removed_pupil_is_in_no_list_and_comes_back_with_everything(store: ClassStore) -> None:
    ada, ben = join(store, "Ada"), join(store, "Ben")
    task = open_task(store, "Maze")
    for pupil in (ada, ben):
        save(store, pupil, f"text {pupil.nickname}")
        store.tasks.hand_in(task, pupil.id, "walk", "text", 4.0)
        store.comments.add(pupil.id, "p", "Good.", b"{}", 5.0)
        store.progress.add(pupil.id, "bump", "Bump!", 5, ["run"], 6.0)
    before = contents(store)
    store.roster.remove([ada.id], 7.0)
    assert store.pupils() == [ben]
    assert {one.pupil for one in store.tasks.hand_ins()} == {ben.id}
    assert {one.pupil for one in store.tasks.kept(task)} == {ben.id}
    assert {one.pupil for one in store.comments.comments()} == {ben.id}
    assert {one.pupil for one in store.progress.all()} == {ben.id}
    assert store.roster.removed() == [RemovedPupil(ada.id, "Ada", 7.0)]
    # Neither the device nor the words let the pupil in.
    assert store.pupil_of("token Ada") == PupilRemoved()
    assert store.resume(ada.words, "other", 8.0) == PupilRemoved()
    restored = store.roster.restore(ada.id)
    assert restored == ada
    assert contents(store) == before
    assert store.pupil_of("token Ada") == ada
    assert store.roster.removed() == []
    assert store.roster.restore(ada.id) is None


def test_the_name_of_a_removed_pupil_is_free_and_gets_a_number_when_it_was_taken(store: ClassStore) -> None:
    first = join(store, "Ada")
    store.roster.remove([first.id], 2.0)
    second = store.join("ada", lambda: "other words", "t", 3.0)
    assert isinstance(second, Pupil)
    restored = store.roster.restore(first.id)
    assert isinstance(restored, Pupil)
    assert (restored.id, restored.nickname) == (first.id, "Ada 2")


def test_removed_pupils_take_no_place_and_go_for_good_after_their_time(
    store: ClassStore, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(roster_store, "MAX_PUPILS", 1)
    ada = join(store, "Ada")
    save(store, ada, "text")
    store.roster.remove([ada.id], 10.0)
    ben = join(store, "Ben")
    assert isinstance(store.roster.restore(ada.id), StoreFull)
    for now in (10.0 + DELETED_KEPT, 10.5 + DELETED_KEPT, 10.5 + DELETED_KEPT + NOTICE / 2):
        store.roster.purge(now)
        (removed,) = store.roster.removed()
        # What the board says of the end is never in the past.
        assert kept_until(removed.at, removed.announced) >= now
    # Put right, the clock begins anew.
    store.roster.purge(10.0)
    store.roster.purge(10.5 + DELETED_KEPT + NOTICE)
    assert len(store.roster.removed()) == 1
    store.roster.purge(10.5 + DELETED_KEPT + 2 * NOTICE)
    assert store.roster.removed() == []
    assert store.history(ada.id) == []
    assert store.pupil_of("token Ada") is None
    assert store.pupils() == [ben]


def test_two_entries_of_a_pupil_become_one_and_nothing_of_either_is_lost(store: ClassStore) -> None:
    ada, twin, ben = join(store, "Ada"), join(store, "Ada 2"), join(store, "Ben")
    save(store, ada, "ada 1")
    save(store, twin, "twin 1")
    save(store, twin, "twin 2", base=save(store, twin, "twin 1"))
    save(store, twin, "own", program="q")
    save(store, ben, "ben 1")
    both_a, both_b, single = open_task(store, "A"), open_task(store, "B"), open_task(store, "C")
    store.tasks.hand_in(both_a, ada.id, "early", "only handed in", 10.0)
    store.tasks.hand_in(both_a, twin.id, "late", "late a", 11.0)
    store.tasks.comment(both_a, ada.id, "Nearly.")
    store.tasks.comment(both_a, twin.id, "Well done.")
    store.tasks.hand_in(both_b, twin.id, "early", "twin 1", 12.0)
    store.tasks.hand_in(both_b, ada.id, "late", "late b", 13.0)
    store.tasks.hand_in(single, twin.id, "single", "single", 14.0)
    store.comments.add(twin.id, "p", "Good.", b"{}", 15.0)
    store.progress.add(ada.id, "bump", "Bump!", 5, ["guess", "run"], 16.0)
    store.progress.add(twin.id, "bump", "Bump!", 5, ["run", "make"], 17.0)
    store.progress.add(twin.id, "walk", "Walk", 3, ["see"], 18.0)

    store.roster.merge(twin.id, ada.id, 20.0)
    assert store.pupils() == [ada, ben]
    assert store.roster.removed() == []
    texts = [version.text for version in store.history(ada.id)]
    assert texts == ["only handed in", "ada 1", "twin 1", "twin 2", "own"]
    newest = {version.text: version.program for version in store.programs(ada.id)}
    assert list(newest) == ["own", "twin 2", "ada 1", "only handed in"]
    assert newest["ada 1"] == "p"
    hand_ins = {(one.task, one.pupil): (one.name, one.comment) for one in store.tasks.hand_ins()}
    assert hand_ins == {
        (both_a, ada.id): ("late", "Nearly. Well done."),
        (both_b, ada.id): ("late", ""),
        (single, ada.id): ("single", ""),
    }
    assert store.comments.comments() == [CommentKept(1, ada.id, newest["twin 2"], 15.0, "Good.", b"{}")]
    assert {one.lesson: one.done for one in store.progress.all()} == {"bump": ["guess", "run", "make"], "walk": ["see"]}
    for device in ("token Ada", "token Ada 2"):
        assert store.pupil_of(device) == ada
    assert store.resume(twin.words, "new", 21.0) == ada
    # A version that came from a hand-in is changed as any other.
    old = store.latest(ada.id, newest["only handed in"])
    assert old is not None
    save(store, ada, "changed", newest["only handed in"], old.number)


def test_the_words_of_a_merged_entry_go_where_the_entry_goes(store: ClassStore) -> None:
    one, two, three = join(store, "One"), join(store, "Two"), join(store, "Three")
    store.roster.merge(one.id, two.id, 2.0)
    store.roster.merge(two.id, three.id, 3.0)
    assert store.resume(one.words, "a", 4.0) == three
    store.roster.remove([three.id], 5.0)
    assert store.resume(one.words, "b", 6.0) == PupilRemoved()
    assert [removed.id for removed in store.roster.removed()] == [three.id]
    assert store.roster.restore(one.id) is None
    store.roster.purge(6.0 + DELETED_KEPT)
    store.roster.purge(6.0 + DELETED_KEPT + NOTICE)
    assert store.resume(one.words, "c", 7.0) is None


def test_a_locked_class_stays_locked_when_it_is_opened_again(opens: Opens) -> None:
    store = ClassStore(opens("c"), ADMISSION, 0.0)
    assert not store.roster.is_locked()
    store.roster.set_locked(True)
    store.close()
    again = ClassStore(opens("c"), ADMISSION, 0.0)
    assert again.roster.is_locked()
    again.roster.set_locked(False)
    assert not again.roster.is_locked()
    again.close()
