"""Several robots in one room, as a page has them: a real server and WebSocket, a scripted worker."""

from __future__ import annotations

import asyncio
import math
from dataclasses import replace
from typing import Any

import pytest

from rosy_sim.config import Config, Limits
from rosy_sim.robots.kobuki import KOBUKI
from rosy_sim.web.service import Service

from ..conftest import PATIENCE
from .page_client import Message, Page, story

ROOM = {"size": [8, 6], "start": {"x": 2, "y": 3, "theta": 0}}


def robot(source: str, x: float = 4.0, y: float = 3.0, theta: float = math.pi) -> dict[str, Any]:
    return {"name": "other", "source": source, "x": x, "y": y, "theta": theta}


async def begin(page: Page, source: str, *companions: dict[str, Any], run: int = 1, **more: Any) -> None:
    await page.send("run", run=run, source=source, companions=companions, speed="max", **more)


def others(page: Page) -> list[list[float]]:
    """Where the other robots are, as the page was told last."""
    return next((m["others"] for m in reversed(page.seen) if m["op"] == "frame" and "others" in m), [])


def test_each_robot_drives_by_its_own_program_and_they_bump_into_each_other(config: Config) -> None:
    async def play(page: Page, _: Service) -> None:
        await page.send("world", world=ROOM)
        await begin(page, "drive:0.3", robot("drive:0.3"), robot("drive:0.1", 2, 5, 0), seed=1)
        frame = await page.until(lambda m: m["op"] == "frame" and any(m["channels"]["Bumper"]))
        first, second = others(page)
        assert first[0] - frame["pose"]["x"] == pytest.approx(2 * KOBUKI.body.radius, abs=0.01)
        assert 2.1 < second[0] < frame["pose"]["x"]
        assert second[1:] == [5, 0]

    story(play, config)


def test_another_robot_feels_the_bump_and_drives_back(config: Config) -> None:
    async def play(page: Page, _: Service) -> None:
        await page.send("world", world=ROOM)
        await begin(page, "drive:0.3", robot("drive:0.3 bump"), seed=1)
        # It came from there, and goes back farther than that.
        await page.until(lambda m: m["op"] == "frame" and "others" in m and m["others"][0][0] > 4.5)

    story(play, config)


def test_the_clock_waits_until_all_programs_run_and_they_make_the_same_steps(config: Config) -> None:
    async def play(page: Page, _: Service) -> None:
        await page.send("world", world=ROOM)
        await begin(page, "drive:0.3", robot("drive:0.3", 2, 5, 0), seed=1, paused=True)
        await page.op("state", run=1, state="running")
        for step in range(1, 21):
            await page.send("forward")
            frame = await page.op("frame", run=1, step=step)
            # As far as the first robot: it began with the same step.
            assert others(page)[0][0] == frame["pose"]["x"]

    story(play, config)


def test_what_another_robot_says_and_how_it_ends_is_told_with_its_number(config: Config) -> None:
    async def play(page: Page, _: Service) -> None:
        await page.send("world", world=ROOM)
        await begin(page, "drive:0.1", robot("say:hi@3 error@9"), robot("done@5", 4, 5), seed=1)
        said = await page.op("companion-said")
        assert (said["robot"], said["text"], said["time"]) == (1, "hi", 0.06)
        ended = {m["robot"]: m for m in [await page.op("companion-ended"), await page.op("companion-ended")]}
        assert ended[1]["problem"]["kind"] == "exception"
        assert (ended[2]["problem"], ended[2]["time"]) == (None, 0.1)
        # The run goes on without them.
        now = page.seen[-1].get("step", 0)
        await page.until(lambda m: m["op"] == "frame" and m["step"] > now + 50)

    story(play, config)


@pytest.mark.parametrize(
    ("source", "kind"),
    [
        ("refuse", "type-mismatch"),
        ("hang@4", "stuck"),
        ("mute", "stuck"),
        ("close@4", "died"),
        ("garble@4", "broken-link"),
        ("flood@4", "too-much"),
    ],
)
def test_a_program_that_fails_says_so_and_the_run_goes_on(
    source: str, kind: str, config: Config, impatient: Limits
) -> None:
    async def play(page: Page, _: Service) -> None:
        await page.send("world", world=ROOM)
        await begin(page, "drive:0.3", robot(source, 6, 5), seed=1)
        ended = await page.op("companion-ended", robot=1)
        assert ended["problem"]["kind"] == kind
        await page.until(lambda m: m["op"] == "frame" and m["pose"]["x"] > 3)
        await page.send("stop")
        assert (await page.ended(1))["ended"] == "stopped"

    story(play, config.with_limits(impatient) if kind == "stuck" else config)


@pytest.mark.parametrize("source", ["done@30", "error@30", "close@30"])
def test_the_other_robots_end_with_the_run(source: str, config: Config) -> None:
    async def play(page: Page, service: Service) -> None:
        await page.send("world", world=ROOM)
        await begin(page, source, robot("drive:0.3", 2, 5, 0), robot("slow", 2, 1, 0), seed=1)
        # A companion that never finishes compiling: the clock stands, and Stop works.
        await page.op("state", run=1, state="running")
        await page.send("stop")
        await page.ended(1)
        await begin(page, source, robot("drive:0.3", 2, 5, 0), seed=1, run=2)
        await page.ended(2)
        async with asyncio.timeout(PATIENCE):
            while service.budgets.runs.running:
                await page.send("check", id=1, source="")
                await page.op("checked")
        assert not [m for m in page.seen if m["op"] == "companion-ended"]

    story(play, config)


def test_each_robot_has_a_place_and_one_without_stands_still(config: Config) -> None:
    async def play(page: Page, _: Service) -> None:
        await page.send("world", world=ROOM)
        await begin(page, "drive:0.1", robot("drive:0.1", 2, 5, 0), robot("drive:0.1", 2, 1, 0), seed=1)
        ended = await page.op("companion-ended")
        assert (ended["robot"], ended["problem"]["kind"]) == (2, "no-place")
        await page.until(lambda m: m["op"] == "frame" and "others" in m and m["others"][0][0] > 2.1)
        assert others(page)[1][0] == 2

    story(play, config.with_limits(replace(config.limits, runs=2)))


@pytest.mark.parametrize(
    ("companions", "hint"),
    [([robot("", 2.1, 3)], "no room"), ([robot("", 99, 3)], "no room")],
    ids=["in another one", "outside"],
)
def test_a_robot_that_cannot_stand_where_it_should_is_refused(
    companions: list[dict[str, Any]], hint: str, config: Config
) -> None:
    async def play(page: Page, _: Service) -> None:
        await page.send("world", world=ROOM)
        await begin(page, "drive:0.1", *companions)
        assert hint in (await page.op("refusal"))["message"]
        assert (await page.ended(1))["ended"] == "stopped"

    story(play, config)


def test_more_robots_than_a_run_may_have_are_refused(config: Config) -> None:
    async def play(page: Page, _: Service) -> None:
        await begin(page, "", *[robot("", x, 5) for x in (1, 2, 3, 4)])
        await page.op("refusal")

    story(play, config)


def test_a_run_that_goes_on_from_an_earlier_moment_has_the_same_robots_in_the_same_places(config: Config) -> None:
    async def walk(page: Page, run: int, first: int, last: int) -> dict[int, list[Any]]:
        places = {}
        for step in range(first, last):
            await page.send("forward")
            frame = await page.op("frame", run=run, step=step + 1)
            places[step + 1] = [frame["pose"], others(page)]
        return places

    async def play(page: Page, _: Service) -> None:
        await page.send("world", world=ROOM)
        await begin(page, "drive:0.3 bump", robot("drive:0.3 bump", 2.6, 3), seed=5, paused=True)
        await page.op("state", run=1, state="running")
        walked = await walk(page, 1, 0, 80)
        await page.send("run", run=2, source="drive:0.3 bump", after=40, of=1, paused=True, speed="max")
        frame: Message = await page.op("frame", run=2, step=40)
        assert [frame["pose"], others(page)] == walked[40]
        again = await walk(page, 2, 40, 80)
        assert again == {step: place for step, place in walked.items() if step > 40}

    story(play, config)
