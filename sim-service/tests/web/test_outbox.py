"""Outbox of a page: what waits for a page that reads slowly, and in which order it is written."""

from __future__ import annotations

import asyncio

import msgspec

from rosy_sim.web.sessions.outbox import Outbox
from rosy_sim.wire.firing import Cause
from rosy_sim.wire.link_messages import MemoryValue
from rosy_sim.wire.page import FiringShown, Frame, Said
from rosy_sim.wire.telemetry import PoseShown, Shown


def test_firings_are_not_lost_with_a_frame_that_a_slow_page_never_gets() -> None:
    def frame(step: int) -> Frame:
        firing = FiringShown(step, "f", 0, Cause("tick"), time=step / 50)
        return Frame(
            step / 50, PoseShown(0, 0, 0), {}, [], [], run=1, step=step, firings=[firing] if step != 2 else None
        )

    async def tell() -> None:
        outbox = Outbox(10)
        for step in (1, 2, 3):
            outbox.put(frame(step))
        last = await outbox.get()
        assert isinstance(last, Frame)
        assert [firing.n for firing in last.firings or []] == [1, 3]

    asyncio.run(tell())


def test_memory_and_channels_are_not_lost_with_a_frame_that_a_slow_page_never_gets() -> None:
    def frame(step: int, memory: list[MemoryValue] | None, **channels: Shown) -> Frame:
        return Frame(step / 50, PoseShown(0, 0, 0), channels, [], [], run=1, step=step, memory=memory)

    async def tell() -> None:
        outbox = Outbox(10)
        outbox.put(frame(1, [MemoryValue("Memory Int", "1")], Led1=[2], Led2=[1]))
        outbox.put(frame(2, [MemoryValue("Memory Int", "2")]))
        outbox.put(frame(3, None, Led1=[3]))
        assert await outbox.get() == frame(3, [MemoryValue("Memory Int", "2")], Led1=[3], Led2=[1])

    asyncio.run(tell())


def test_each_event_has_its_time_in_a_frame_that_takes_those_of_others_along() -> None:
    def frame(step: int, sensed: list[str], times: list[float] | None) -> Frame:
        return Frame(step / 50, PoseShown(0, 0, 0), {}, [], sensed, run=1, step=step, times=times)

    async def tell() -> None:
        outbox = Outbox(10)
        outbox.put(frame(1, ["Bumper"], [0.02]))
        outbox.put(frame(2, [], None))
        outbox.put(frame(3, ["Button", "Wheel"], [0.04, 0.06]))
        assert await outbox.get() == frame(3, ["Bumper", "Button", "Wheel"], [0.02, 0.04, 0.06])

    asyncio.run(tell())


def test_a_page_that_does_not_read_gets_the_latest_frame_of_a_robot_and_of_its_twin() -> None:
    def frame(run: int, step: int) -> Frame:
        return Frame(step / 50, PoseShown(0, 0, 0), {}, [f"f{step}"], [], run=run, step=step)

    async def tell() -> None:
        outbox = Outbox(10)
        for step in range(50):
            outbox.put(frame(1, step))
            outbox.put(frame(2, step))
        assert not outbox.overflowed.is_set()
        found = [await outbox.get(), await outbox.get()]
        every = [f"f{step}" for step in range(50)]
        assert found == [msgspec.structs.replace(frame(run, 49), fired=every) for run in (1, 2)]

    asyncio.run(tell())


def test_answers_reach_a_page_in_order_also_when_some_are_written_at_once() -> None:
    def said(text: str) -> Said:
        return Said(0.0, text, run=1)

    async def tell() -> None:
        outbox = Outbox(10)
        sent: list[str] = []
        is_reading = False

        def write(text: bytes) -> bool:
            if is_reading:
                sent.append(msgspec.json.decode(text)["text"])
            return is_reading

        outbox.write_with(write)
        # Nothing waits to send yet, so nothing may go before what is to be sent first.
        is_reading = True
        outbox.put(said("1"))
        first = await outbox.get()
        # The first one has been taken and may not have been sent.
        outbox.put(said("2"))
        assert isinstance(first, Said)
        sent.append(first.text)
        second = await outbox.get()
        assert isinstance(second, Said)
        sent.append(second.text)
        waiting = asyncio.create_task(outbox.get())
        await asyncio.sleep(0)
        outbox.put(said("3"))
        assert sent == ["1", "2", "3"]
        assert not waiting.done()
        # A page that does not read has its answers stored.
        is_reading = False
        outbox.put(said("4"))
        is_reading = True
        outbox.put(said("5"))
        assert sent == ["1", "2", "3"]
        rest = [await waiting, await outbox.get()]
        assert [answer.text for answer in rest if isinstance(answer, Said)] == ["4", "5"]

    asyncio.run(tell())
