"""Previews for pages: the run with the same inputs, the newest request, bad requests, and nothing left behind."""

from __future__ import annotations

import contextlib
import os
from dataclasses import replace

import psutil
import pytest

from rosy_sim.config import Config, Limits
from rosy_sim.web.service import Service

from ..conftest import PATIENCE
from ..processes import await_end, below
from .page_client import Message, Page, story

SECONDS = 8.0


async def previewed(page: Page, ident: int, source: str, seconds: float = SECONDS) -> Message:
    await page.send("preview", id=ident, source=source, seconds=seconds)
    return await page.op("previewed", id=ident)


def last_pose(page: Page) -> list[float]:
    pose = next(m["pose"] for m in reversed(page.seen) if m["op"] == "frame" and m["run"] == 1)
    return [pose["x"], pose["y"], pose["theta"]]


def test_a_preview_has_path_pose_and_collisions(config: Config) -> None:
    async def play(page: Page, _: Service) -> None:
        preview = await previewed(page, 1, "drive:0.5")
        assert (preview["ended"], preview["time"], preview["problems"]) == ("time", SECONDS, [])
        assert preview["path"][0] == [0.0, 1.5, 2.0]
        assert [point[1:] for point in preview["path"]] == sorted(point[1:] for point in preview["path"])
        [(touched, x, y)] = preview["collisions"]
        assert (5 < touched < SECONDS, x, y) == (True, preview["path"][-1][1], 2.0)
        assert preview["pose"] == pytest.approx([x, y, 0.0], abs=0.001)
        # The page's own robot has not moved.
        assert not [m for m in page.seen if m["op"] == "frame" and m["pose"]["x"] != 1.5]

    story(play, config)


def test_a_preview_repeats_seed_and_hands_of_the_last_run(config: Config) -> None:
    """Hands come at any moment, also in the middle of a step."""
    source = "drive:0.3 turn:0.4 bump done@400"

    async def play(page: Page, _: Service) -> None:
        await page.send("run", run=1, source=source, seed=7, speed=16)
        await page.op("state", run=1, state="running")
        for n in range(20):
            await page.send("input", lift="left" if n % 2 else "both")
            await page.send("input", lower="both", press="Button0")
            if n == 3:
                await page.send("input", teleport={"x": 2.2, "y": 1.1, "theta": 1.0})
                await page.send("safety", on=True)
            await page.op("frame", run=1)
        await page.ended(1)
        # Afterwards the robot rolls to a stop.
        pose = last_pose(page)
        # Hands put the robot elsewhere between two steps: then there are two frames of one time.
        frames = [(m["time"], m["pose"]) for m in page.seen if m["op"] == "frame" and m["run"] == 1]
        preview = await previewed(page, 1, source, 9)
        assert preview["ended"] == "done"
        assert preview["pose"] == pose
        times = {when for when, _ in frames}
        seen = [point for point in preview["path"] if point[0] in times]
        assert len(seen) > 3
        for when, x, y in seen:
            places = [(pose["x"], pose["y"]) for at, pose in frames if at == when]
            # The path has the place before the hands, and a busy service sends the frame after them only.
            if any(place == pytest.approx((2.2, 1.1), abs=0.0006) for place in places):
                continue
            assert any((x, y) == pytest.approx(place, abs=0.0006) for place in places)
        # After a reset there are no hands to repeat.
        await page.send("reset")
        assert (await previewed(page, 2, source, 9))["pose"] != preview["pose"]

    story(play, config)


def test_a_run_with_more_hands_than_are_recorded_has_no_preview(
    config: Config, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("rosy_sim.run.steps.hands._MAX_ACTIONS", 2)

    async def play(page: Page, _: Service) -> None:
        # A program that is not ready: its hands do not wait for the end of a step.
        await page.send("run", run=1, source="mute", seed=7)
        for side in ("left", "right"):
            await page.send("input", lift=side)
        assert (await previewed(page, 1, "drive:0.1"))["ended"] == "time"
        await page.send("input", lower="both")
        preview = await previewed(page, 2, "drive:0.1")
        assert (preview["ended"], preview["path"]) == ("unrepeatable", [])
        await page.send("run", run=2, source="drive:0.1", seed=7)
        assert (await previewed(page, 3, "drive:0.1"))["ended"] == "time"

    story(play, config)


def test_the_newest_request_wins_at_once(config: Config) -> None:
    async def play(page: Page, service: Service) -> None:
        await previewed(page, 1, "drive:0.1")
        for ident, source in ((2, "hang@5"), (3, "slow"), (4, "drive:0.2"), (5, "drive:0.3")):
            await page.send("preview", id=ident, source=source, seconds=SECONDS)
        await page.op("previewed", id=5)
        assert [m["id"] for m in page.seen if m["op"] == "previewed"] == [1, 5]
        # Beside the process of the answer at most one, which may still be ending what was cancelled.
        assert service.previews.processes <= 2

    # A program that hangs would be waited for much longer than the test.
    story(play, config)


@pytest.mark.parametrize(("source", "ended", "kinds"), [
    ("refuse", "refused", ["type-mismatch"]), ("drive:0.5 error@40", "error", ["exception"]),
    ("close@40", "error", ["died"]), ("drive:0.5 done@50", "done", []), ("hang@9", "stuck", ["stuck"]),
])  # fmt: skip
def test_every_end_is_told(source: str, ended: str, kinds: list[str], config: Config, impatient: Limits) -> None:
    async def play(page: Page, _: Service) -> None:
        preview = await previewed(page, 1, source, 9)
        assert (preview["ended"], [p["kind"] for p in preview["problems"]]) == (ended, kinds)

    story(play, config.with_limits(impatient) if ended == "stuck" else config)


@pytest.mark.parametrize("seconds", [0, -1, 301, 1e300])
def test_a_bad_request_is_refused(seconds: float, config: Config) -> None:
    async def play(page: Page, _: Service) -> None:
        await page.send("preview", id=1, source="drive:0.5", seconds=seconds)
        assert "between" in (await page.op("refusal"))["hint"] or "more than 0" in page.seen[-1]["hint"]

    story(play, config)


def test_goals_are_judged_and_a_run_of_the_page_goes_on(config: Config) -> None:
    room = {"size": [5, 4], "start": {"x": 1, "y": 2, "theta": 0},
            "goals": [{"kind": "reach", "x": 3, "y": 2, "r": 0.3}]}  # fmt: skip

    async def play(page: Page, _: Service) -> None:
        await page.send("world", world=room)
        await page.send("run", run=1, source="drive:0.2", seed=1, speed=1.0)
        await page.op("state", run=1, state="running")
        await page.send("pause")
        preview = await previewed(page, 1, "drive:0.5")
        assert [(goal["kind"], goal["state"]) for goal in preview["goals"]] == [("reach", "done")]
        await page.send("stop")
        assert (await page.ended(1))["ended"] == "stopped"

    story(play, config)


def preview_processes() -> set[int]:
    """Those of the service in this process; their workers start others whenever they prepare a run."""
    found = set()
    for child in psutil.Process().children():
        # One that has ended meanwhile.
        with contextlib.suppress(psutil.NoSuchProcess):
            if "rosy_sim.previews" in child.cmdline():
                found.add(child.pid)
    return found


def test_a_process_that_is_prepared_computes_the_first_preview_and_there_is_no_other(config: Config) -> None:
    async def play(page: Page, service: Service) -> None:
        await page.send("prepare-previews")
        await page.send("prepare-previews")
        preview = await previewed(page, 1, "drive:0.5")
        assert preview["ended"] == "time"
        await page.send("prepare-previews")
        seen = preview_processes()
        await previewed(page, 2, "drive:0.4")
        assert service.previews.processes == len(seen) == 1
        assert preview_processes() == seen

    story(play, config)


def test_without_a_worker_nothing_is_prepared_and_a_preview_says_so(config: Config) -> None:
    async def play(page: Page, service: Service) -> None:
        await page.send("prepare-previews")
        preview = await previewed(page, 1, "drive:0.5")
        assert (preview["ended"], len(preview["problems"])) == ("error", 1)
        assert service.previews.processes == 0

    story(play, replace(config, worker=()))


def test_the_processes_end_with_the_service(config: Config) -> None:
    seen: set[int] = set()

    async def play(page: Page, service: Service) -> None:
        before = below(os.getpid())
        await previewed(page, 1, "drive:0.5")
        await page.send("preview", id=2, source="hang@5", seconds=SECONDS)
        seen.update(below(os.getpid()) - before)
        assert service.previews.processes == 1

    story(play, config)

    assert len(seen) >= 2
    await_end(seen, PATIENCE)
