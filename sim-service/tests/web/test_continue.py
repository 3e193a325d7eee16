"""Runs that go on from a step of the last run: exact repetition, live hands, divergence of a changed program."""

from __future__ import annotations

import random
from typing import Any

import pytest

from rosy_sim.config import Config
from rosy_sim.web.app import Service

from .test_app import Message, Page, story

STEPS = 60
"""Steps of the runs that are continued."""

Hands = dict[int, list[dict[str, Any]]]


def generated(seed: int) -> tuple[str, Hands]:
    """A program and hands by step."""
    dice = random.Random(seed)
    source = f"drive:{dice.choice((-0.4, 0.3, 0.7))} turn:{dice.choice((0, 0.5, 1.5))}" + " bump" * dice.randrange(2)
    acts: list[dict[str, Any]] = [
        {"lift": "both"},
        {"lower": "both"},
        {"press": "Button1"},
        {"teleport": {"x": 4.6, "y": 2.0, "theta": 0.1}},
        {"teleport": {"x": 2.2, "y": 1.1, "theta": 1.0}},
    ]
    hands: Hands = {step: [dice.choice(acts)] for step in dice.sample(range(STEPS), 8)}
    return source, hands


async def begin(page: Page, run: int, source: str, **more: Any) -> None:
    await page.send("run", run=run, source=source, **more)
    await page.send("pause")
    await page.op("state", run=run, state="running")


async def walk(page: Page, run: int, hands: Hands, first: int) -> dict[int, Message]:
    """Single steps up to the last, with hands between them; the pose and the channels before each step."""
    seen: dict[int, Message] = {}
    for step in range(first, STEPS):
        for act in hands.get(step, []):
            await page.send("input", **act)
            seen[step] = shown(await page.op("frame", run=run, step=step))
        await page.send("forward")
        seen[step + 1] = shown(await page.op("frame", run=run, step=step + 1))
    return seen


def shown(frame: Message) -> Message:
    return {"pose": frame["pose"], "channels": frame["channels"]}


async def shows(page: Page, run: int, step: int) -> None:
    """Wait for a frame of this step or of a later one: a busy service shows some steps only."""
    await page.until(lambda m: m["op"] == "frame" and m["run"] == run and m["step"] >= step)


def diverged(page: Page, run: int) -> list[float]:
    return [m["time"] for m in page.seen if m["op"] == "diverged" and m["run"] == run]


@pytest.mark.parametrize("seed", range(4))
def test_an_unchanged_program_with_the_same_hands_goes_on_exactly_as_before(seed: int, config: Config) -> None:
    source, hands = generated(seed)
    dice = random.Random(100 + seed)

    async def play(page: Page, _: Service) -> None:
        await begin(page, 1, source, seed=seed)
        whole = await walk(page, 1, hands, 0)
        run = 2
        for step in dice.sample(range(1, STEPS), 3):
            await begin(page, run, source, after=step)
            assert shown(await page.op("frame", run=run, step=step)) == whole[step]
            later = {at: acts for at, acts in hands.items() if at > step}
            again = await walk(page, run, later, step)
            assert again == {at: state for at, state in whole.items() if at > step}
            assert not diverged(page, run)
            # The next one continues this run, which is the same up to its end.
            run += 1

    story(play, config)


def test_it_shows_nothing_before_the_step_that_it_goes_on_from(config: Config) -> None:
    async def play(page: Page, _: Service) -> None:
        source = "drive:0.5 say:hi@5 sound:4@6 tell"
        await begin(page, 1, source, seed=1)
        await walk(page, 1, {}, 0)
        await page.send("run", run=2, source=source, after=40)
        await shows(page, 2, 45)
        frames = [m["step"] for m in page.seen if m["op"] == "frame" and m["run"] == 2]
        assert frames[0] == 40
        assert not [m for m in page.seen if m["op"] in ("said", "sound") and m["run"] == 2]

    story(play, config)


def test_hands_of_the_page_wait_until_the_run_is_live(config: Config) -> None:
    async def play(page: Page, _: Service) -> None:
        await begin(page, 1, "drive:0.5", seed=1)
        await walk(page, 1, {}, 0)
        await page.send("run", run=2, source="drive:0.5", after=50)
        await page.send("pause")
        await page.send("input", teleport={"x": 2.2, "y": 1.1, "theta": 1.0})
        frame = await page.until(lambda m: m["op"] == "frame" and m["run"] == 2 and m["pose"]["y"] == 1.1)
        assert frame["step"] == 50

    story(play, config)


@pytest.mark.parametrize(("changed", "at"), [
    ("drive:0.5 bump", None), ("drive:0.6", 0.0), ("drive:0.5 say:hi@30", 0.6),
])  # fmt: skip
def test_a_changed_program_tells_its_first_other_command(changed: str, at: float | None, config: Config) -> None:
    async def play(page: Page, _: Service) -> None:
        await begin(page, 1, "drive:0.5", seed=1)
        whole = await walk(page, 1, {}, 0)
        await page.send("run", run=2, source=changed, after=50)
        await shows(page, 2, 52)
        assert diverged(page, 2) == ([] if at is None else [at])
        frames = {m["step"]: shown(m) for m in page.seen if m["op"] == "frame" and m["run"] == 2}
        # From there on the page is shown where it drives.
        assert min(frames) == (50 if at is None else round(at * 50) + 5)
        if at is None:
            assert frames[50] == whole[50]

    story(play, config)


def test_not_more_is_repeated_than_there_was(config: Config) -> None:
    async def play(page: Page, _: Service) -> None:
        await begin(page, 1, "drive:0.5", seed=1)
        await walk(page, 1, {}, 0)
        await begin(page, 2, "drive:0.5", after=10_000)
        assert (await page.op("frame", run=2))["step"] == STEPS
        await begin(page, 3, "drive:0.5", after=-3)
        assert [m["step"] for m in page.seen if m["op"] == "frame" and m["run"] == 3] == [0]

    story(play, config)


def test_a_run_that_cannot_be_repeated_is_not_continued(config: Config, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("rosy_sim.run.hands._MAX_ACTIONS", 1)

    async def play(page: Page, _: Service) -> None:
        await begin(page, 1, "drive:0.5", seed=1)
        await page.send("input", lift="both")
        await page.send("input", lower="both")
        await walk(page, 1, {}, 0)
        await page.send("run", run=2, source="drive:0.5", after=20)
        assert "by hand" in (await page.op("refusal"))["message"]
        assert (await page.ended(2))["ended"] == "stopped"

    story(play, config)
