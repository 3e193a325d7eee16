"""
Tasks of a running class: what the board and each pupil see of them, and hand-ins on their way to the store.

The store has all that must last; here is the same without the texts, so that showing it does not read the disk.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import msgspec

from ..wire.page.room_tests import TestedRoom
from .lesson_checks import lesson_of
from .messages import board_messages as b
from .messages import pupil_messages as p
from .messages.check_messages import CheckAll, CheckResult
from .messages.message_fields import Refused
from .program_fingerprint import fingerprint, source_of
from .rooms_tried import pack_rooms, rooms_of
from .store.class_store import ClassStore
from .store.store_thread import StoreThread
from .store.task_store import HandIn, HandInGraded, HandInKept, Task

__all__ = ["ClassTasks"]

_SHOWN_ON_BOARD = 30
"""Tasks that the board shows, with all their hand-ins; the export has all."""


class ClassTasks:
    """
    The tasks of an open class.

    Args:
        store: the open class, read once.
        thread: where the store is called from then on.
        today: s since 1970.
    """

    def __init__(self, store: ClassStore, thread: StoreThread, today: Callable[[], float]) -> None:
        self._thread = thread
        self.today = today
        self._tasks = {task.id: task for task in store.tasks.tasks()}
        # By task and pupil, oldest first.
        self._hand_ins = {(one.task, one.pupil): one for one in store.tasks.hand_ins()}

    def reload(self, hand_ins: list[HandIn]) -> None:
        """Take over the hand-ins that are stored now, oldest first: they belong to other pupils than before."""
        self._hand_ins = {(one.task, one.pupil): one for one in hand_ins}

    # Pupils

    def of_pupil(self, pupil: int) -> p.OwnTasks | None:
        """What a pupil sees; ``None`` if there is nothing to see."""
        now = self.today()
        shown = [
            self._own(task, self._hand_ins.get((task.id, pupil)), now)
            for task in self._tasks.values()
            if task.is_open(now) or (task.id, pupil) in self._hand_ins
        ]
        return p.OwnTasks(shown) if shown or self._tasks else None

    @staticmethod
    def _own(task: Task, found: HandIn | None, now: float) -> p.OwnTask:
        left = None if task.deadline is None else max(0.0, task.deadline - now)
        handed_in = None if found is None else p.OwnHandIn(found.at, found.name, found.comment)
        return p.OwnTask(task.id, task.title, task.is_open(now), task.deadline, left, handed_in)

    async def hand_in(self, pupil: int, request: p.HandIn) -> bool:
        """
        Store a hand-in; returns whether the task was open.

        Raises:
            StoreError: the disk is full or broken; nothing was changed.
        """
        now = self.today()
        task = self._tasks.get(request.task)
        if task is None or not task.is_open(now):
            return False

        lesson = lesson_of(request.text)

        def store_it(store: ClassStore) -> str:
            # In the thread of the store: a long program takes a while to read.
            made = fingerprint(source_of(request.text))
            store.tasks.hand_in(request.task, pupil, request.name, request.text, now, made, lesson)
            return made

        made = await self._thread.call(store_it)
        # The comment may have changed meanwhile. The newest hand-in is the last one of the dictionary.
        before = self._hand_ins.pop((request.task, pupil), None)
        comment = "" if before is None else before.comment
        self._hand_ins[request.task, pupil] = HandIn(
            request.task, pupil, now, request.name, comment, made, lesson=lesson
        )
        return True

    # The board

    def shown(self) -> b.BoardTasks:
        """The newest tasks as the board shows them now."""
        now = self.today()
        tasks = {
            task.id: b.BoardTask(
                task.id, task.title, task.opened, task.deadline, task.is_open(now), [], bool(task.check)
            )
            for task in list(self._tasks.values())[-_SHOWN_ON_BOARD:]
        }
        alike_in = {task: self.alike(task) for task in tasks}
        for one in self._hand_ins.values():
            if one.task in tasks:
                alike = [pupil for pupil in alike_in[one.task].get(one.fingerprint, []) if pupil != one.pupil]
                tasks[one.task].handed_in.append(
                    b.HandedIn(one.pupil, one.at, one.name, one.comment, alike, one.lesson)
                )
        return b.BoardTasks(list(tasks.values()))

    def alike(self, task: int) -> dict[str, list[int]]:
        """The pupils who handed in for a task, by the fingerprints of their programs."""
        found: dict[str, list[int]] = {}
        for one in self._hand_ins.values():
            if one.task == task and one.fingerprint:
                found.setdefault(one.fingerprint, []).append(one.pupil)
        return found

    async def open(self, request: b.OpenTask) -> Refused | None:
        """Begin a task and end the one before; what is returned says why not."""
        now = self.today()
        title = request.title.strip()
        if not title:
            return Refused("request")
        if request.deadline is not None and request.deadline <= now:
            return Refused("deadline")
        opened = await self._thread.call(lambda store: store.tasks.open(title, request.deadline, now))
        if opened is None:
            return Refused("tasks")
        self._tasks = {task.id: _closed(task, now) for task in self._tasks.values()} | {opened.id: opened}
        return None

    async def close(self, task: int) -> None:
        """End a task."""
        now = self.today()
        if task not in self._tasks:
            return
        await self._thread.call(lambda store: store.tasks.close(task, now))
        self._tasks[task] = _closed(self._tasks[task], now)

    async def comment(self, request: b.Comment) -> bool:
        """Set the comment on a hand-in; returns whether there is one."""
        key = request.task, request.pupil
        if key not in self._hand_ins:
            return False
        text = request.text.strip()
        await self._thread.call(lambda store: store.tasks.comment(request.task, request.pupil, text))
        self._hand_ins[key] = replace(self._hand_ins[key], comment=text)
        return True

    async def keep_check(self, request: CheckAll) -> None:
        """
        Store what a check tries, for the hand-ins that come after it.

        Raises:
            StoreError: the disk is full or broken; nothing was changed.
        """
        encoded = msgspec.json.encode(request)
        await self._thread.call(lambda store: store.tasks.set_check(request.task, encoded))
        self._tasks[request.task] = replace(self._tasks[request.task], check=encoded)

    def newest_check(self, task: int) -> CheckAll | None:
        """The newest check of all hand-ins of a task; ``None`` if there was none."""
        found = self._tasks.get(task)
        return msgspec.json.decode(found.check, type=CheckAll) if found is not None and found.check else None

    async def grade(self, task: int, pupil: int, at: float, result: CheckResult, rooms: Sequence[TestedRoom]) -> None:
        """
        Store the result of the hand-in of that time with all its rooms, unless the pupil has handed in again since.

        Raises:
            StoreError: the disk is full or broken; nothing was changed.
        """
        encoded = msgspec.json.encode(result)
        stored = await self._thread.call(lambda store: store.tasks.grade(task, pupil, at, encoded, pack_rooms(rooms)))
        found = self._hand_ins.get((task, pupil))
        if stored and found is not None and found.at == at:
            self._hand_ins[task, pupil] = replace(found, result=encoded)

    async def graded(self, task: int, pupil: int) -> tuple[HandInGraded, list[TestedRoom]] | None:
        """A hand-in and the rooms in which it was tried, worst first; ``None`` if it was not checked."""

        def read(store: ClassStore) -> tuple[HandInGraded, list[TestedRoom]] | None:
            # In the thread of the store: many rooms take a while to read.
            found = store.tasks.graded(task, pupil)
            return None if found is None else (found, rooms_of(found))

        return await self._thread.call(read)

    def results(self, task: int) -> dict[int, bytes]:
        """The results of a task's hand-ins by pupil, as JSON; empty for one that was not checked."""
        return {one.pupil: one.result for one in self._hand_ins.values() if one.task == task}

    def task(self, task: int) -> Task | None:
        """A task by its number."""
        return self._tasks.get(task)

    async def kept(self, task: int) -> list[HandInKept]:
        """The hand-ins of a task with their texts, in the order in which the pupils joined."""
        return await self._thread.call(lambda store: store.tasks.kept(task))


def _closed(task: Task, now: float) -> Task:
    return replace(task, closed=now if task.closed is None else task.closed)
