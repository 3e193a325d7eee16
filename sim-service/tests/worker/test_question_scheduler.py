"""Turns of pages at the worker: round-robin, one question each, and a penalty for long ones."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable

from rosy_sim.worker.question_scheduler import QuestionScheduler


class Clock:
    """A clock that stands still."""

    def __init__(self) -> None:
        self.time = 0.0

    def __call__(self) -> float:
        return self.time


class Worker:
    """Questions that are in progress until they are answered by hand."""

    def __init__(self) -> None:
        self.clock = Clock()
        self.scheduler = QuestionScheduler(self.clock)
        self.begun: list[str] = []
        self.answers: dict[str, asyncio.Event] = {}

    def ask(self, page: str, question: str) -> asyncio.Task[None]:
        self.answers[question] = asyncio.Event()
        return asyncio.create_task(self._ask(page, question))

    async def _ask(self, page: str, question: str) -> None:
        async with self.scheduler.turn(page):
            self.begun.append(question)
            await self.answers[question].wait()

    async def answer(self, *questions: str) -> None:
        for question in questions:
            self.answers[question].set()
            await settle()


async def settle() -> None:
    """Let all tasks come as far as they can."""
    for _ in range(10):
        await asyncio.sleep(0)


def play(story: Callable[[Worker], Awaitable[None]]) -> None:
    async def run() -> None:
        await story(Worker())
        for task in asyncio.all_tasks() - {asyncio.current_task()}:
            task.cancel()

    asyncio.run(run())


def test_a_page_has_one_question_in_progress_and_pages_take_turns() -> None:
    async def story(worker: Worker) -> None:
        for question in ("a1", "a2", "a3", "b1", "c1", "b2"):
            worker.ask(question[0], question)
        await settle()
        assert worker.begun == ["a1", "b1"]
        await worker.answer("a1", "b1", "c1", "a2", "b2", "a3")
        assert worker.begun == ["a1", "b1", "c1", "a2", "b2", "a3"]

    play(story)


def test_a_check_and_a_completion_of_a_compile_bomb_leave_the_other_slot_to_others() -> None:
    async def story(worker: Worker) -> None:
        worker.ask("bomber", "check")
        worker.ask("bomber", "completion")
        for i in range(20):
            worker.ask(f"page {i}", f"question {i}")
        await settle()
        for i in range(20):
            await worker.answer(f"question {i}")
        # The first question of the bomber is still in progress.
        assert worker.begun == ["check", *(f"question {i}" for i in range(20))]

    play(story)


def test_pages_whose_questions_took_long_share_one_slot_for_a_while() -> None:
    async def story(worker: Worker) -> None:
        for page in ("x", "y", "z"):
            worker.ask(page, f"{page}1")
            await settle()
            worker.clock.time += 10.0
            await worker.answer(f"{page}1")
        for page in ("x", "y", "z"):
            worker.ask(page, f"{page}2")
        await settle()
        assert worker.begun[3:] == ["x2"]
        # The other slot is there for a page without a penalty, also for one that asked later.
        worker.ask("a", "a1")
        await settle()
        assert worker.begun[3:] == ["x2", "a1"]
        await worker.answer("a1")
        assert worker.begun[3:] == ["x2", "a1"]
        await worker.answer("x2")
        assert worker.begun[3:] == ["x2", "a1", "y2"]
        # The penalty ends.
        worker.clock.time += 61.0
        worker.ask("b", "b1")
        await settle()
        assert worker.begun[3:] == ["x2", "a1", "y2", "z2"]

    play(story)


def test_a_reload_does_not_end_a_penalty() -> None:
    async def story(worker: Worker) -> None:
        worker.scheduler.join("bomber", "10.0.0.7")
        worker.ask("bomber", "bomb 1")
        await settle()
        worker.clock.time += 10.0
        await worker.answer("bomb 1")
        worker.scheduler.leave("bomber", "10.0.0.7")
        # Its pages that open meanwhile share one slot; a page of another address takes the other.
        for page, address in (("again", "10.0.0.7"), ("third", "10.0.0.7"), ("a", "10.0.0.8")):
            worker.scheduler.join(page, address)
            worker.ask(page, f"{page} 1")
        await settle()
        assert worker.begun[1:] == ["again 1", "a 1"]
        # A page that had no penalty of its own leaves that of its address as it is.
        worker.scheduler.leave("a", "10.0.0.8")
        await worker.answer("a 1")
        assert worker.begun[1:] == ["again 1", "a 1"]
        # The penalty ends when the first one would have ended.
        worker.clock.time += 61.0
        worker.scheduler.join("late", "10.0.0.7")
        worker.ask("late", "late 1")
        await settle()
        assert worker.begun[3] == "third 1"
        await worker.answer("third 1")
        assert worker.begun[4] == "late 1"

    play(story)


def test_a_question_that_is_replaced_leaves_its_place() -> None:
    async def story(worker: Worker) -> None:
        for question in ("a1", "b1"):
            worker.ask(question[0], question)
        waiting = worker.ask("c", "c1")
        in_progress = worker.ask("d", "d1")
        await settle()
        waiting.cancel()
        await worker.answer("a1")
        assert worker.begun == ["a1", "b1", "d1"]
        in_progress.cancel()
        await asyncio.gather(waiting, in_progress, return_exceptions=True)
        worker.ask("e", "e1")
        await settle()
        assert worker.begun == ["a1", "b1", "d1", "e1"]

    play(story)


def test_a_question_that_is_cancelled_as_its_turn_comes_hands_the_turn_on() -> None:
    async def story(worker: Worker) -> None:
        for question in ("a1", "b1"):
            worker.ask(question[0], question)
        unlucky = worker.ask("c", "c1")
        worker.ask("d", "d1")
        await settle()
        # In one step of the event loop, before the question has noticed its turn.
        worker.answers["a1"].set()
        asyncio.get_running_loop().call_soon(lambda: asyncio.get_running_loop().call_soon(unlucky.cancel))
        await settle()
        worker.answers["b1"].set()
        await settle()
        assert worker.begun[-1] == "d1"
        await worker.answer("d1")
        worker.ask("c", "c2")
        worker.ask("e", "e1")
        await settle()
        assert worker.begun[-2:] == ["c2", "e1"]

    play(story)
