"""Runs that go on from a step of the last run: exact repetition, live hands, divergence of a changed program."""

from __future__ import annotations

import random
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from rosy_sim.config import Config
from rosy_sim.run.steps.lockstep import Lockstep
from rosy_sim.web.service import Service
from rosy_sim.web.sessions.page_runs import PageRuns

from .page_client import Message, Page, story

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


class CommandRecorder:
    """Records what programs command, step by step, while they run in this process."""

    def __init__(self, patch: pytest.MonkeyPatch) -> None:
        # Of the newest run.
        self.commands: list[list[object]] = []
        on_step = PageRuns._on_step

        def record(runs: PageRuns, lockstep: Lockstep) -> None:
            if lockstep.settled is not None:
                if lockstep.step == 1:
                    self.commands = []
                self.commands.append([*lockstep.commands, *lockstep.published])
            on_step(runs, lockstep)

        patch.setattr(PageRuns, "_on_step", record)


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


def test_an_earlier_run_is_continued_when_it_is_named(config: Config) -> None:
    async def play(page: Page, _: Service) -> None:
        await begin(page, 1, "drive:0.5", seed=1)
        whole = await walk(page, 1, {}, 0)
        await begin(page, 2, "drive:-0.3", seed=2)
        await walk(page, 2, {}, 0)
        await page.send("reset")
        await begin(page, 3, "drive:0.5", after=40, of=1)
        assert shown(await page.op("frame", run=3, step=40)) == whole[40]
        assert not diverged(page, 3)

    story(play, config)


def test_a_run_that_is_not_kept_is_not_continued(config: Config) -> None:
    async def play(page: Page, _: Service) -> None:
        await begin(page, 1, "drive:0.5", seed=1)
        await walk(page, 1, {}, 0)
        await page.send("run", run=2, source="drive:0.5", after=20, of=7)
        assert "too long ago" in (await page.op("refusal"))["message"]
        assert (await page.ended(2))["ended"] == "stopped"
        # Another room: what was done in the one before cannot be repeated.
        await begin(page, 3, "drive:0.5", seed=1)
        await page.send("world", world="room")
        await page.send("run", run=4, source="drive:0.5", after=20, of=1)
        assert "too long ago" in (await page.op("refusal"))["message"]

    story(play, config)


def test_commands_that_are_no_longer_kept_are_told(config: Config, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("rosy_sim.run.steps.replay._MAX_STEPS", 3)

    async def play(page: Page, _: Service) -> None:
        await begin(page, 1, "drive:0.5", seed=1)
        await walk(page, 1, {}, 0)
        # The program sends a velocity in each fifth step.
        await begin(page, 2, "drive:0.5 say:hi@30", after=50)
        await page.op("frame", run=2, step=50)
        assert [m["time"] for m in page.seen if m["op"] == "uncompared" and m["run"] == 2] == [0.22]
        assert not diverged(page, 2)
        # Before that step there is nothing to tell.
        await begin(page, 3, "drive:0.5", after=10)
        await page.op("frame", run=3, step=10)
        assert not [m for m in page.seen if m["op"] == "uncompared" and m["run"] == 3]

    story(play, config)


LATE_CHANGES = ("", " say:hi@{at}", " led:2@{at}", " sound:4@{at}", " bump", " drive:-0.2")
"""Changes of a program that show late or at once. Of two equal words of a script the last one counts."""


@settings(max_examples=6, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.integers(0, 10_000), st.sampled_from(LATE_CHANGES), st.integers(0, STEPS - 1), st.integers(1, STEPS - 1))
def test_a_branch_is_the_run_of_the_changed_program_with_the_same_hands(
    config: Config, seed: int, change: str, at: int, step: int
) -> None:
    """Up to the first different command it is the run before; the page is told when that is."""
    source, hands = generated(seed)
    changed = source + change.format(at=at)

    async def play(page: Page, recorder: CommandRecorder) -> None:
        await begin(page, 1, source, seed=seed)
        before = await walk(page, 1, hands, 0)
        commands_before = recorder.commands[:STEPS]
        await begin(page, 2, changed, after=step)
        branch = {step: shown(await page.op("frame", run=2, step=step))}
        branch |= await walk(page, 2, {at: acts for at, acts in hands.items() if at > step}, step)
        commands_of_branch = recorder.commands[:STEPS]
        # The changed program with the same seed and all hands, from its start.
        await begin(page, 3, changed, seed=seed)
        whole = await walk(page, 3, hands, 0)
        assert branch == {at: state for at, state in whole.items() if at >= step}
        assert commands_of_branch == recorder.commands[:STEPS]
        # A command of a step shows its effect after that step.
        first = min((at for at in range(STEPS) if commands_before[at] != commands_of_branch[at]), default=STEPS)
        assert {at: whole[at] for at in whole if at <= first} == {at: before[at] for at in before if at <= first}
        assert diverged(page, 2) == ([first / 50] if first < step else [])

    with pytest.MonkeyPatch.context() as patch:
        recorder = CommandRecorder(patch)
        story(lambda page, _: play(page, recorder), config)


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
    monkeypatch.setattr("rosy_sim.run.steps.hands._MAX_ACTIONS", 1)

    async def play(page: Page, _: Service) -> None:
        await begin(page, 1, "drive:0.5", seed=1)
        await page.send("input", lift="both")
        await page.send("input", lower="both")
        await walk(page, 1, {}, 0)
        await page.send("run", run=2, source="drive:0.5", after=20)
        assert "by hand" in (await page.op("refusal"))["message"]
        assert (await page.ended(2))["ended"] == "stopped"

    story(play, config)
