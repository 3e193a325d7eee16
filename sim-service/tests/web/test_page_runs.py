"""A page's runs in the simulator: start, clock, hands and ends. A real server and WebSocket, a scripted worker."""

from __future__ import annotations

import pytest

from rosy_sim.config import Config, Limits
from rosy_sim.web.service import Service

from .page_client import Page, story


def test_a_program_drives_into_the_wall_and_presses_the_bumper(config: Config) -> None:
    async def play(page: Page, _: Service) -> None:
        await page.send("run", run=1, source="drive:0.5 sound:4@2 say:hi@3 led:2@3", seed=1, speed="max")
        await page.op("state", run=1, state="running")
        assert (await page.op("sound"))["sound"] == 4
        assert (await page.op("said"))["text"] == "hi"
        frame = await page.until(lambda m: m["op"] == "frame" and any(m["channels"]["Bumper"]))
        assert frame["channels"]["Bumper"] == [0, 1, 0]
        assert frame["channels"]["Led1"] == [2]
        assert frame["pose"]["x"] > 4
        # In which frame depends on how many steps go by between two.
        assert "move" in [name for m in page.seen if m["op"] == "frame" for name in m["fired"]]
        await page.send("stop")
        assert (await page.ended(1))["ended"] == "stopped"

    story(play, config)


@pytest.mark.parametrize(
    ("source", "ended", "kind"),
    [
        ("done@9", "done", None),
        ("error@4", "error", "exception"),
        ("hang@4", "stuck", "stuck"),
        ("close@4", "error", "died"),
        ("garble@4", "error", "broken-link"),
        ("flood@4", "error", "too-much"),
        ("lie@4", "error", "broken-link"),
        ("refuse", "refused", "type-mismatch"),
        ("die", "error", "worker-lost"),
    ],
)
def test_every_end_is_told_once(source: str, ended: str, kind: str | None, config: Config, impatient: Limits) -> None:
    config = config.with_limits(impatient) if ended == "stuck" else config

    async def play(page: Page, _: Service) -> None:
        await page.send("run", run=3, source=source, speed="max")
        state = await page.ended(3)
        assert state["ended"] == ended
        assert [p["kind"] for p in state["problems"]] == ([] if kind is None else [kind])
        await page.send("run", run=4, source="done@2", speed="max")
        assert (await page.ended(4))["ended"] == "done"
        assert [m["run"] for m in page.seen if m["op"] == "state" and m["state"] == "ended"] == [3, 4]

    story(play, config)


@pytest.mark.parametrize(
    "source", ["drive:0.5 done@30", "drive:0.5 error@30", "drive:0.5 close@30", "drive:0.5 hang@30"]
)
def test_the_simulated_robot_stands_however_a_program_ends(source: str, config: Config, impatient: Limits) -> None:
    """Its clock stands while a program thinks, and its wheels are at rest a quarter of a second after the end."""

    async def play(page: Page, _: Service) -> None:
        await page.send("run", run=1, source=source, seed=1, speed="max")
        await page.until(lambda m: m["op"] == "frame" and m["channels"]["Velocity"][0] > 0)
        await page.ended(1)
        last = [m for m in page.seen if m["op"] == "frame"][-1]
        if last["channels"]["Velocity"][0] > 0:
            last = await page.until(lambda m: m["op"] == "frame" and m["channels"]["Velocity"][0] == 0)
        # By itself, and not at the wall.
        assert (last["channels"]["Velocity"][0], last["channels"]["Bumper"]) == (0, [0, 0, 0])

    story(play, config.with_limits(impatient) if "hang" in source else config)


@pytest.mark.parametrize("choice", [{"op": "reset"}, {"op": "world", "world": "maze"}], ids=["reset", "room"])
def test_the_clock_of_a_room_begins_at_zero_after_a_run(choice: dict[str, str], config: Config) -> None:
    async def play(page: Page, _: Service) -> None:
        await page.send("run", run=1, source="drive:0.2 done@30", seed=1, speed="max")
        await page.ended(1)
        await page.send(**choice)
        await page.op("world")
        frame = await page.op("frame")
        assert (frame["time"], frame["step"], frame["fired"]) == (0.0, 0, [])

    story(play, config)


def test_what_fired_at_the_end_is_shown(config: Config) -> None:
    async def play(page: Page, _: Service) -> None:
        await page.send("run", run=1, source="done@3", speed="max")
        await page.ended(1)
        assert [name for m in page.seen if m["op"] == "frame" for name in m["fired"]][-1] == "script"

    story(play, config)


def test_stop_works_while_compiling(config: Config) -> None:
    async def play(page: Page, _: Service) -> None:
        await page.send("run", run=1, source="slow")
        await page.op("state", state="compiling")
        await page.send("stop")
        assert (await page.ended(1))["ended"] == "stopped"

    story(play, config)


def test_a_program_that_ignores_stop_is_killed(config: Config) -> None:
    async def play(page: Page, _: Service) -> None:
        await page.send("run", run=1, source="deaf")
        await page.op("state", state="running")
        await page.send("stop")
        assert (await page.ended(1))["ended"] == "stopped"

    story(play, config)


def test_a_new_run_ends_the_old_one_and_starts_where_the_room_says(config: Config) -> None:
    async def play(page: Page, _: Service) -> None:
        await page.send("run", run=1, source="drive:0.7", speed="max")
        await page.until(lambda m: m["op"] == "frame" and m["pose"]["x"] > 2)
        await page.send("run", run=2, source="")
        assert (await page.ended(1))["ended"] == "stopped"
        assert (await page.op("frame", run=2))["pose"]["x"] == 1.5
        await page.op("state", run=2, state="running")

    story(play, config)


def test_reset_puts_everything_back(config: Config) -> None:
    async def play(page: Page, _: Service) -> None:
        await page.send("run", run=1, source="drive:0.7", speed="max")
        await page.until(lambda m: m["op"] == "frame" and m["pose"]["x"] > 2)
        await page.send("reset")
        await page.ended(1)
        await page.op("world")
        assert (await page.op("frame"))["pose"]["x"] == 1.5

    story(play, config)


def test_pause_forward_and_resume(config: Config) -> None:
    async def play(page: Page, _: Service) -> None:
        await page.send("run", run=1, source="drive:0.5", speed=1)
        await page.send("pause")
        await page.op("state", state="running")
        for _step in range(3):
            await page.send("forward")
        first = await page.op("frame", step=3)
        assert first["time"] == 0.06
        await page.send("resume")
        await page.until(lambda m: m["op"] == "frame" and m["step"] > 10)
        await page.send("speed", speed="max")
        await page.until(lambda m: m["op"] == "frame" and m["step"] > 1000)

    story(play, config)


def test_a_run_starts_paused_and_makes_the_steps_that_are_asked_for(config: Config) -> None:
    async def play(page: Page, _: Service) -> None:
        await page.send("run", run=1, source="drive:0.5", speed="max", paused=True)
        await page.op("state", state="running")
        for _step in range(3):
            await page.send("forward")
        assert (await page.op("frame", step=3))["time"] == 0.06
        # Each step has a frame while the clock is stopped: one that was not asked for would come before the answer.
        await page.send("check", id=1, source="drive:0.5")
        assert (await page.until(lambda m: m["op"] in ("checked", "frame")))["op"] == "checked"
        await page.send("forward")
        assert (await page.op("frame"))["step"] == 4

    story(play, config)


def test_hands_reach_the_robot_and_a_hand_in_a_wall_is_refused(config: Config) -> None:
    async def play(page: Page, _: Service) -> None:
        await page.send("input", press="Button1")
        assert (await page.until(lambda m: m["op"] == "frame" and any(m["channels"]["Button"])))["channels"][
            "Button"
        ] == [0, 1, 0]
        await page.send("input", lift="both")
        await page.until(lambda m: m["op"] == "frame" and m["channels"]["Wheel"] == [1, 1])
        await page.send("input", teleport={"x": 3.0, "y": 1.0, "theta": 0.5})
        await page.until(lambda m: m["op"] == "frame" and m["pose"]["x"] == 3.0)
        await page.send("input", teleport={"x": 50, "y": 1.0, "theta": 0.5})
        assert "outside" in (await page.op("refusal"))["message"]

    story(play, config)


def test_goals_and_pushed_boxes_are_shown(config: Config) -> None:
    async def play(page: Page, _: Service) -> None:
        goal = {"kind": "reach", "x": 3, "y": 2, "r": 0.2}
        box = {"x": 2.5, "y": 2, "w": 0.3, "h": 0.3, "movable": True, "mass": 0.5}
        room = {"size": [5, 4], "start": {"x": 1.5, "y": 2}, "goals": [goal], "boxes": [box]}
        await page.send("world", world=room)
        assert (await page.until(lambda m: m["op"] == "frame" and "boxes" in m))["boxes"] == [[2.5, 2.0, 0.0]]
        await page.send("run", run=1, source="drive:0.5", speed="max")
        await page.until(lambda m: m["op"] == "goals" and m["goals"][0]["state"] == "done")
        await page.until(lambda m: m["op"] == "frame" and m["pose"]["x"] > 3.5)
        pushed = [m["boxes"][0][0] for m in page.seen if m.get("boxes")]
        assert pushed == sorted(pushed)
        assert pushed[-1] > 3

    story(play, config)
