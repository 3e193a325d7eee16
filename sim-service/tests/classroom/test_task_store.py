"""Tasks of a class in its store: one is open at a time, the newest hand-in counts, comments stay."""

from __future__ import annotations

import pytest

from rosy_sim.classroom.store import schema, task_store
from rosy_sim.classroom.store.class_store import ClassStore, Pupil
from rosy_sim.classroom.store.task_store import HandIn, HandInGraded, HandInKept, Task

from .conftest import ADMISSION, Opens


def joined(store: ClassStore, nickname: str) -> int:
    pupil = store.join(nickname, lambda: f"{nickname} b c", nickname, 1.0)
    assert isinstance(pupil, Pupil)
    return pupil.id


def opened(store: ClassStore, title: str, now: float, deadline: float | None = None) -> Task:
    task = store.tasks.open(title, deadline, now)
    assert task is not None
    return task


def test_a_class_of_the_first_schema_keeps_its_pupils_and_gets_tasks(
    opens: Opens, monkeypatch: pytest.MonkeyPatch
) -> None:
    with monkeypatch.context() as old:
        old.setattr(schema, "MIGRATIONS", schema.MIGRATIONS[:1])
        database = opens("c")
        before = ClassStore(database, ADMISSION, 0.0)
        # As Rosy of that time did.
        with database.transaction():
            (ada,) = database.execute(
                "INSERT INTO pupil (nickname, nickname_key, words, joined) VALUES (?, ?, ?, ?) RETURNING id",
                ("Ada", "ada", "a b c", 1.0),
            ).fetchone()
        before.close()
    store = ClassStore(opens("c"), ADMISSION, 0.0)
    store.tasks.hand_in(opened(store, "Maze", 1.0).id, ada, "walk", "text", 2.0)
    assert [pupil.nickname for pupil in store.pupils()] == ["Ada"]
    assert store.tasks.hand_ins() == [HandIn(1, ada, 2.0, "walk")]
    store.close()


def test_opening_a_task_ends_the_one_before(store: ClassStore) -> None:
    opened(store, "Maze", 1.0)
    second = opened(store, "Pits", 2.0, deadline=9.0)
    first = store.tasks.tasks()[0]
    assert first == Task(1, "Maze", 1.0, None, 2.0)
    assert not first.is_open(3.0)
    assert second.is_open(8.9)
    assert not second.is_open(9.0)
    store.tasks.close(second.id, 5.0)
    store.tasks.close(second.id, 6.0)
    assert store.tasks.tasks()[1].closed == 5.0


def test_the_newest_hand_in_of_each_pupil_counts_and_keeps_the_comment(store: ClassStore) -> None:
    ada, ben = joined(store, "Ada"), joined(store, "Ben")
    task = opened(store, "Maze", 1.0).id
    store.tasks.hand_in(task, ben, "b", "of Ben", 2.0)
    store.tasks.hand_in(task, ada, "a", "first", 3.0)
    store.tasks.comment(task, ada, "Look at the corner.")
    store.tasks.hand_in(task, ada, "a 2", "second", 4.0)
    assert store.tasks.kept(task) == [
        HandInKept(ada, 4.0, "a 2", "second", "Look at the corner."),
        HandInKept(ben, 2.0, "b", "of Ben", ""),
    ]


def test_the_rooms_of_a_check_go_with_the_next_hand_in(store: ClassStore) -> None:
    ada = joined(store, "Ada")
    task = opened(store, "Maze", 1.0).id
    store.tasks.hand_in(task, ada, "a", "first", 2.0)
    assert store.tasks.graded(task, ada) is None
    assert not store.tasks.grade(task, ada, 1.5, b"{}", b"rooms of an older hand-in")
    assert store.tasks.grade(task, ada, 2.0, b"{}", b"rooms")
    assert store.tasks.graded(task, ada) == HandInGraded("a", "first", b"{}", b"rooms")
    store.tasks.hand_in(task, ada, "a", "second", 3.0)
    assert store.tasks.graded(task, ada) is None
    store.tasks.grade(task, ada, 3.0, b"{}")
    assert store.tasks.graded(task, ada) == HandInGraded("a", "second", b"{}", b"")


def test_there_is_a_limit_of_tasks(store: ClassStore, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(task_store, "MAX_TASKS", 1)
    opened(store, "Maze", 1.0)
    assert store.tasks.open("Pits", None, 2.0) is None
    assert store.tasks.tasks() == [Task(1, "Maze", 1.0)]
