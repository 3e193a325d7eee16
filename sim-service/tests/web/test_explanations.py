"""What a page is told about firings and memory, and its questions why, over a real WebSocket."""

from __future__ import annotations

from rosy_sim.config import Config
from rosy_sim.web.service import Service

from .page_client import Page, story


def test_every_single_step_shows_what_the_program_remembers(config: Config) -> None:
    async def play(page: Page, _: Service) -> None:
        await page.send("run", run=1, source="count")
        await page.send("pause")
        await page.op("state", run=1, state="running")
        for step in range(1, 6):
            await page.send("forward")
            frame = await page.op("frame", run=1, step=step)
            assert frame["memory"] == [{"type": "Memory Int", "value": str(step - 1)}]

    story(play, config)


def test_a_page_that_observes_its_run_gets_the_firings_with_their_times(config: Config) -> None:
    async def play(page: Page, _: Service) -> None:
        await page.send("run", run=1, source="tell")
        await page.send("pause")
        await page.op("state", run=1, state="running")
        await page.send("forward")
        assert "firings" not in await page.op("frame", run=1, step=1)
        await page.send("observe", on=True, frames=True)
        await page.send("forward")
        frame = await page.op("frame", run=1, step=2)
        assert frame["firings"] == [
            {
                "n": 1,
                "function": "f",
                "task": 0,
                "cause": {"by": "tick", "instant": 1},
                "took": [{"from": "time", "value": "Seconds 1"}],
                "gave": [{"to": "command", "value": "Velocity 0.5 0.0", "type": "Velocity"}],
                "time": 0.02,
            }
        ]
        await page.send("observe", on=False)
        await page.send("forward")
        assert "firings" not in await page.op("frame", run=1, step=3)
        await page.send("observe", on=True, frames=True)
        await page.send("run", run=2, source="tell")
        await page.until(lambda m: m["op"] == "frame" and m["run"] == 2 and bool(m.get("firings")))

    story(play, config)


def test_a_page_that_begins_to_show_values_gets_the_latest_firing_of_each_function(config: Config) -> None:
    async def play(page: Page, _: Service) -> None:
        await page.send("observe", on=True)
        await page.send("run", run=1, source="tell")
        await page.send("pause")
        await page.op("state", run=1, state="running")
        for step in range(1, 4):
            await page.send("forward")
            assert "firings" not in await page.op("frame", run=1, step=step)
        await page.send("observe", on=True, frames=True)
        frame = await page.op("frame", run=1, step=3)
        assert [(firing["function"], firing["n"], firing["time"]) for firing in frame["firings"]] == [("f", 2, 0.04)]
        await page.send("forward")
        frame = await page.op("frame", run=1, step=4)
        assert [firing["n"] for firing in frame["firings"]] == [3]

    story(play, config)


def test_a_page_asks_why_and_why_not(config: Config) -> None:
    async def play(page: Page, _: Service) -> None:
        await page.send("why", id=1)
        assert (await page.op("because", id=1))["sentences"] == [{"said": {"id": "run-not-begun"}, "time": 0.0}]
        await page.send("observe", on=True)
        await page.send("run", run=1, source="tell")
        await page.send("pause")
        await page.op("state", run=1, state="running")
        for step in range(1, 4):
            await page.send("forward")
            await page.op("frame", run=1, step=step)
        await page.send("why", id=2, command="Velocity", time=0.02)
        answer = await page.op("because", id=2)
        assert [sentence["said"] for sentence in answer["sentences"]] == [
            {
                "id": "sent",
                "time": 0.02,
                "function": "f",
                "value": "Velocity 0.5 0.0",
                "values": ["Seconds 1"],
            },
            {"id": "ran-tick", "time": 0.02, "function": "f"},
        ]
        assert [(firing["n"], firing["time"]) for firing in answer["path"]] == [(1, 0.02)]
        await page.send("why", id=3, firing=2)
        assert (await page.op("because", id=3))["time"] == 0.04
        await page.send("why", id=4, firing=99)
        assert (await page.op("because", id=4))["sentences"][0]["said"]["id"] == "not-known-before"
        await page.send("whyNot", id=5, function="g", since=0, until=0.1)
        assert (await page.op("because", id=5))["sentences"][0]["said"] == {"id": "not-part", "function": "g"}
        # What came before an observation is not known.
        await page.send("observe", on=False)
        await page.send("forward")
        await page.op("frame", run=1, step=4)
        await page.send("observe", on=True)
        await page.send("forward")
        await page.op("frame", run=1, step=5)
        await page.send("why", id=6, command="Led1")
        [only] = (await page.op("because", id=6))["sentences"]
        assert only["said"] == {"id": "not-known-before", "since": 0.08}

    story(play, config)
