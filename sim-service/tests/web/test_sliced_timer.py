"""The timer that counts slices: a pause of the process uses up one of them."""

from __future__ import annotations

import asyncio
from collections.abc import Callable

import pytest

from rosy_sim.web.pacing.sliced_timer import SlicedTimer


class Loop(asyncio.SelectorEventLoop):
    """Has a clock that the test moves on."""

    now = 0.0

    def time(self) -> float:
        return self.now

    def passes(self, seconds: float) -> None:
        """Time passes at once, as when the process stands still; then whatever is due is called."""
        self.now += seconds
        self.run_until_complete(_turn())


async def _turn() -> None:
    for _ in range(3):
        await asyncio.sleep(0)


@pytest.fixture
def ended() -> list[str]:
    return []


def with_loop(play: Callable[[Loop], None]) -> None:
    loop = Loop()
    try:
        play(loop)
    finally:
        loop.close()


def test_it_calls_back_once_when_its_time_is_over(ended: list[str]) -> None:
    def play(loop: Loop) -> None:
        SlicedTimer(loop, 10.0, lambda: ended.append("over"))
        for _ in range(9):
            loop.passes(1.0)
        assert ended == []
        loop.passes(1.0)
        loop.passes(10.0)
        assert ended == ["over"]

    with_loop(play)


def test_a_pause_uses_up_one_slice(ended: list[str]) -> None:
    def play(loop: Loop) -> None:
        SlicedTimer(loop, 10.0, lambda: ended.append("over"))
        loop.passes(1000.0)
        for _ in range(8):
            loop.passes(1.0)
        assert ended == []
        loop.passes(1.0)
        assert ended == ["over"]

    with_loop(play)


def test_a_cancelled_one_does_not_call_back(ended: list[str]) -> None:
    def play(loop: Loop) -> None:
        timer = SlicedTimer(loop, 10.0, lambda: ended.append("over"))
        loop.passes(5.0)
        timer.cancel()
        for _ in range(20):
            loop.passes(1.0)
        assert ended == []

    with_loop(play)
