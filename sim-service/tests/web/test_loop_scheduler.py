"""Turns of pages on the event loop, on a loop whose clock is moved by work and by waiting only."""

from __future__ import annotations

import asyncio
import itertools
import selectors
from collections.abc import Callable, Coroutine, Iterator
from typing import Any

import pytest

from rosy_sim.web.pacing.loop_scheduler import LoopScheduler, PageTurns


class Clock:
    """The time, s, for the loop and as the processor time of its thread."""

    def __init__(self) -> None:
        self.time = 0.0
        self.computed = 0.0

    def compute(self, seconds: float) -> None:
        self.time += seconds
        self.computed += seconds


class Selector(selectors.SelectSelector):
    """Moves the clock to the next timer instead of waiting for it."""

    def __init__(self, clock: Clock) -> None:
        super().__init__()
        self._clock = clock

    def select(self, timeout: float | None = None) -> list[tuple[selectors.SelectorKey, int]]:
        self._clock.time += timeout or 0.0
        return super().select(0)


class Loop(asyncio.SelectorEventLoop):
    def __init__(self, clock: Clock) -> None:
        super().__init__(Selector(clock))
        self._clock = clock

    def time(self) -> float:
        return self._clock.time


class Service:
    """Pages whose messages take a given time."""

    def __init__(self) -> None:
        self.clock = Clock()
        self.scheduler = LoopScheduler(lambda: self.clock.computed, lambda: self.clock.time)
        # The messages that were served, by the name of their page, and when.
        self.served: list[tuple[str, float]] = []

    async def serve(self, page: str, address: str, messages: int, seconds: float) -> None:
        turns = PageTurns(self.scheduler, address)
        for _ in range(messages):
            async with turns.turn():
                self.clock.compute(seconds)
                self.served.append((page, self.clock.time))

    def order(self) -> str:
        return "".join(page for page, _ in self.served)


def play(story: Callable[[Service], Coroutine[Any, Any, None]]) -> None:
    service = Service()
    with asyncio.Runner(loop_factory=lambda: Loop(service.clock)) as runner:
        runner.run(story(service))


def test_the_pages_of_an_address_take_turns() -> None:
    async def story(service: Service) -> None:
        await asyncio.gather(*(service.serve(page, "school", 3, 0.01) for page in "abc"))
        # The first one asks again before the others ask at all.
        assert service.order() == "aabcabcbc"

    play(story)


def test_addresses_take_turns_however_many_pages_they_have() -> None:
    async def story(service: Service) -> None:
        attackers = [service.serve("x", "attacker", 2, 0.01) for _ in range(50)]
        await asyncio.gather(*attackers, service.serve("o", "other", 4, 0.01))
        assert service.order()[:9] == "xxoxoxoxo"

    play(story)


def test_fifty_pages_of_an_address_have_a_quarter_of_the_loop_and_another_waits_for_one_message_at_most() -> None:
    waits: list[float] = []

    async def story(service: Service) -> None:
        attackers = asyncio.gather(*(service.serve("x", "attacker", 1000, 0.05) for _ in range(50)))
        await asyncio.sleep(10)
        for _ in range(100):
            asked = service.clock.time
            await service.serve("o", "other", 1, 0.001)
            waits.append(service.clock.time - asked)
            await asyncio.sleep(0.1)
        attackers.cancel()
        attacked = 0.05 * service.order().count("x")
        assert 0.2 < attacked / service.clock.time < 0.35
        assert max(waits) < 0.06

    play(story)


def test_a_page_that_opens_again_has_no_new_share() -> None:
    async def story(service: Service) -> None:
        for _ in range(100):
            # Each is another page of the address.
            await service.serve("x", "attacker", 1, 0.05)
        assert service.clock.time > 15

    play(story)


def test_others_are_served_after_two_milliseconds_of_turns() -> None:
    # When the turns of iterations of the loop were over.
    looks: list[int] = []

    async def story(service: Service) -> None:
        async def look() -> None:
            while True:
                looks.append(len(service.served))
                await asyncio.sleep(0)

        looking = asyncio.create_task(look())
        await asyncio.gather(*(service.serve(str(page), str(page), 20, 0.001) for page in range(40)))
        looking.cancel()
        assert max(after - before for before, after in itertools.pairwise(looks)) <= 2
        assert len(service.served) == 800

    play(story)


def test_a_long_computation_is_done_in_pieces() -> None:
    async def story(service: Service) -> None:
        def pieces() -> Iterator[None]:
            for _ in range(1000):
                service.clock.compute(0.0005)
                yield

        computation = asyncio.create_task(PageTurns(service.scheduler, "attacker").complete(pieces()))
        await asyncio.sleep(0)
        await service.serve("o", "other", 1, 0.0)
        assert service.clock.computed < 0.02
        await computation
        assert service.clock.computed >= 0.5

    play(story)


def test_a_page_that_goes_takes_no_turn_with_it() -> None:
    async def story(service: Service) -> None:
        pages = [asyncio.create_task(service.serve(page, "school", 1, 0.01)) for page in "abcd"]
        await asyncio.sleep(0)
        # Of these one has its turn already.
        pages[1].cancel()
        pages[2].cancel()
        await asyncio.gather(*pages, return_exceptions=True)
        assert service.order() == "ad"
        await service.serve("e", "school", 1, 0.01)
        assert service.order() == "ade"

    play(story)


def test_the_time_of_a_message_that_was_refused_counts() -> None:
    async def story(service: Service) -> None:
        turns = PageTurns(service.scheduler, "attacker")
        try:
            async with turns.turn():
                service.clock.compute(0.3)
                raise ValueError
        except ValueError:
            assert turns.spent > 0.3
        await service.serve("o", "other", 1, 0.0)
        assert service.clock.time < 0.31

    play(story)


def test_a_busy_machine_makes_turns_dearer_and_one_that_stands_still_does_not() -> None:
    async def story(service: Service) -> None:
        async def spent(computed: float, passed: float) -> float:
            turns = PageTurns(service.scheduler, "school")
            async with turns.turn():
                service.clock.compute(computed)
                service.clock.time += passed
            return turns.spent

        assert 0.02 < await spent(0.01, 0.01) < 0.021
        assert 0.04 < await spent(0.01, 60.0) < 0.041

    play(story)


def test_a_message_whose_service_waits_has_a_turn_until_then_and_is_charged_for_the_rest() -> None:
    async def story(service: Service) -> None:
        turns = PageTurns(service.scheduler, "attacker")

        async def store() -> str:
            service.clock.compute(0.01)
            await asyncio.sleep(1)
            service.clock.compute(2)
            return "stored"

        attacked = asyncio.create_task(turns.serve(store()))
        await asyncio.sleep(0.5)
        # Others are served while it waits.
        await service.serve("o", "other", 1, 0.001)
        assert not attacked.done()
        assert await attacked == "stored"
        assert turns.spent > 2
        # A quarter of the time: the next turn comes some 6 s later.
        before = service.clock.time
        await service.serve("x", "attacker", 1, 0.001)
        assert service.clock.time - before > 5

    play(story)


def test_a_message_that_fails_or_is_cancelled_ends_as_it_would_without_turns() -> None:
    async def story(service: Service) -> None:
        turns = PageTurns(service.scheduler, "page")
        ended: list[str] = []

        async def fail() -> None:
            raise ValueError("at once")

        async def fail_later() -> None:
            await asyncio.sleep(1)
            raise ValueError("later")

        async def wait() -> None:
            try:
                await asyncio.sleep(100)
            finally:
                ended.append("cancelled")

        for work, words in ((fail(), "at once"), (fail_later(), "later")):
            with pytest.raises(ValueError, match=words):
                await turns.serve(work)
        waiting = asyncio.create_task(turns.serve(wait()))
        await asyncio.sleep(1)
        waiting.cancel()
        # One whose turn has not come.
        await service.scheduler.begin("busy")
        early = asyncio.create_task(turns.serve(wait()))
        await asyncio.sleep(1)
        early.cancel()
        await asyncio.wait([waiting, early])
        assert waiting.cancelled()
        assert early.cancelled()
        assert ended == ["cancelled"]
        service.scheduler.end("busy", 0.0)
        await service.serve("o", "page", 1, 0.001)

    play(story)
