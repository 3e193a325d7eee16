"""
One page's compile bombs beside the checks of other pages, with the real worker: the others' checks are all answered,
and how long they took is printed. ``tests/accounting/test_fair_queue.py`` has the turns without a clock.
"""

from __future__ import annotations

import asyncio
import contextlib
import statistics
import time
from pathlib import Path

import pytest

from rosy_sim.config import discover

from ..web.page_client import Page, opened, serving

pytestmark = [pytest.mark.real, pytest.mark.skipif(not discover().worker, reason="the worker is not built")]

BOMB = (Path(__file__).resolve().parents[3] / "rosy-hs" / "test-worker" / "attacks" / "bomb-types.hs").read_text(
    "utf-8"
)

PAGES, CHECKS = 3, 5


async def bomb(page: Page) -> None:
    """Check and complete a compile bomb, another one as soon as one is answered."""
    number = 0
    while True:
        number += 1
        source = f"{BOMB}\n-- {number}\n"
        await page.send("check", id=number, source=source)
        await page.send("complete", id=number, source=source, line=1, column=8)
        await page.until(lambda message: message["op"] in ("checked", "refusal"))


async def checks(page: Page, name: int) -> list[float]:
    """How long the checks of an innocent page took, s."""
    took = []
    for number in range(CHECKS):
        begun = time.monotonic()
        await page.send("check", id=number, source=f"main = simulate (Velocity 0.{name} 0.{number})\n")
        assert (await page.op("checked", id=number))["problems"] == []
        took.append(time.monotonic() - begun)
    return took


def test_compile_bombs_of_one_page_leave_the_checks_of_others_answered() -> None:
    async def play() -> list[float]:
        async with serving(discover()) as (address, _), contextlib.AsyncExitStack() as stack:
            bomber = await stack.enter_async_context(opened(address))
            await bomber.op("worker", state="ready")
            bombing = asyncio.create_task(bomb(bomber))
            try:
                others = [await stack.enter_async_context(opened(address)) for _ in range(PAGES)]
                found = await asyncio.gather(*(checks(page, number) for number, page in enumerate(others)))
            finally:
                bombing.cancel()
                await asyncio.gather(bombing, return_exceptions=True)
            return [took for page in found for took in page]

    took = asyncio.run(play())
    p95 = statistics.quantiles(took, n=20)[-1]
    print(f"beside compile bombs: {len(took)} checks, median {statistics.median(took):.3f} s, p95 {p95:.3f} s")
    assert len(took) == PAGES * CHECKS
