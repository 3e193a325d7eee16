"""The service as a page sees it: a real server, a real WebSocket, a scripted worker."""

from __future__ import annotations

import asyncio
import gc
import json
import weakref
from dataclasses import replace
from pathlib import Path
from typing import Any

import httpx
import pymunk
import pytest
from websockets.exceptions import ConnectionClosed, InvalidStatus

from rosy_sim.config import Config
from rosy_sim.version import VERSION
from rosy_sim.web.service import Service

from ..conftest import PATIENCE
from .page_client import Page, opened, serving, story


def _asking(address: str) -> httpx.AsyncClient:
    return httpx.AsyncClient(base_url=f"http://{address}", timeout=PATIENCE)


def test_a_page_is_greeted_with_its_room(config: Config) -> None:
    async def play(page: Page, _: Service) -> None:
        world = await page.op("world")
        assert [m["op"] for m in page.seen] == ["hello", "worker", "world"]
        assert page.seen[0]["protocol"] == 1
        assert world["world"]["size"] == [5, 4]
        frame = await page.op("frame")
        assert (frame["run"], frame["pose"]["x"], frame["pose"]["y"]) == (0, 1.5, 2.0)

    story(play, config)


def test_another_room_is_shown_and_a_bad_one_refused(config: Config) -> None:
    async def play(page: Page, _: Service) -> None:
        await page.op("world")
        await page.send("world", world="pits")
        assert (await page.op("world"))["world"]["name"] == "pits"
        await page.send("world", world={"tiles": ["##"], "start": {"x": 0, "y": 0}})
        assert "floor" in (await page.op("refusal"))["message"]
        await page.send("world", world="../../etc/passwd")
        await page.op("refusal")

    story(play, config)


def test_a_newer_check_replaces_an_older_one(config: Config) -> None:
    async def play(page: Page, _: Service) -> None:
        await page.send("check", id=1, source="slow")
        await page.send("check", id=2, source="refuse")
        checked = await page.op("checked")
        assert checked["id"] == 2
        assert checked["problems"][0]["kind"] == "type-mismatch"

    story(play, config)


def test_the_types_of_pieces_reach_the_page(config: Config) -> None:
    async def play(page: Page, _: Service) -> None:
        await page.send("check", id=1, source="")
        assert (await page.op("checked"))["types"] == {"names": ["IO ()"], "at": [[1, 1, 1, 5, 0]]}

    story(play, config)


def test_a_newer_completion_replaces_an_older_one(config: Config) -> None:
    async def play(page: Page, _: Service) -> None:
        await page.send("complete", id=1, source="slow", line=1, column=1)
        await page.send("complete", id=2, source="", line=3, column=7)
        completed = await page.op("completed")
        assert (completed["id"], completed["expected"]) == (2, "Velocity")
        assert completed["names"] == [{"name": "at3_7", "type": "Velocity", "takes": 0}]

    story(play, config)


def test_a_dead_worker_is_replaced_and_pages_are_told(config: Config) -> None:
    async def play(page: Page, service: Service) -> None:
        await page.send("check", id=1, source="")
        await page.op("checked")
        before = service.worker.pid
        await page.send("check", id=2, source="die")
        await page.op("worker", state="restarting")
        await page.op("worker", state="ready")
        assert service.worker.pid not in (None, before)
        await page.send("check", id=3, source="babble")
        await page.op("worker", state="restarting")

    story(play, config)


def test_pages_are_told_once_why_no_worker_can_start_and_runs_end_with_it(config: Config, tmp_path: Path) -> None:
    executable = tmp_path / "worker"
    executable.write_text("#!/bin/sh\necho a library is missing >&2\n")
    executable.chmod(0o755)

    async def play(page: Page, _: Service) -> None:
        failed = await page.op("worker", state="failed")
        assert "cannot start on this computer" in failed["message"]
        assert failed["sentences"]["message"]["arguments"]["why"] == "a library is missing"
        await page.send("run", run=1, source="")
        (problem,) = (await page.op("state", state="ended"))["problems"]
        assert (problem["kind"], problem["message"]) == ("worker-failed", failed["message"])
        await page.send("check", id=1, source="")
        assert (await page.op("refusal"))["hint"] == failed["message"]

    story(play, replace(config, worker=(str(executable),)))


GARBAGE: list[str | bytes] = [
    "", "{", "null", "[]", "{}", '{"op":1}', '{"op":"fly"}', '{"op":"run"}', '{"op":"run","run":"x","source":1}',
    '{"op":"speed","speed":-1}', '{"op":"speed","speed":"fast"}', '{"op":"input","press":"Button9"}', "[" * 100_000,
    '{"op":"run","run":1,"source":"","speed":1e999}', '{"op":"world","world":17}', b"\xff\xfe", "\x00",
    '{"op":"world","world":' + "[" * 5000 + "]" * 5000 + "}",
]  # fmt: skip


def test_garbage_is_refused_and_changes_nothing(config: Config) -> None:
    async def play(page: Page, _: Service) -> None:
        for text in GARBAGE:
            await page.socket.send(text)
            await page.op("refusal")
        await page.send("run", run=1, source="done@2", speed="max")
        assert (await page.ended(1))["ended"] == "done"

    story(play, config)


def test_a_page_that_reads_nothing_is_let_go_and_harms_nobody(config: Config) -> None:
    config = config.with_limits(replace(config.limits, page_queue=50))

    async def tell() -> None:
        async with (
            serving(config) as (address, service),
            opened(address, max_queue=1, close_timeout=0.1) as deaf,
            opened(address) as page,
        ):
            # Requests that are refused at length, none of which is read.
            await deaf.socket.send(json.dumps({"op": "run", "run": 1, "source": "", "speed": "max"}))
            for _ in range(20_000):
                if len(service.sessions) == 1:
                    break
                try:
                    await deaf.socket.send('{"op":"' + "x" * 5000 + '"}')
                except ConnectionClosed:
                    break
            await page.send("run", run=1, source="done@2", speed="max")
            assert (await page.ended(1))["ended"] == "done"
            async with asyncio.timeout(PATIENCE):
                while len(service.sessions) > 1:
                    await asyncio.sleep(0.01)

    asyncio.run(tell())


def test_a_full_class_says_so(config: Config) -> None:
    config = config.with_limits(replace(config.limits, sessions=1))

    async def tell() -> None:
        async with serving(config) as (address, _), opened(address), opened(address) as second:
            assert "places" in (await second.op("refusal"))["message"]

    asyncio.run(tell())


def test_one_address_does_not_take_the_places_of_the_others(config: Config) -> None:
    config = config.with_limits(replace(config.limits, sessions=4, address_sessions=2))
    there = ("127.0.0.2", 0)

    async def tell() -> None:
        async with serving(config) as (address, service):
            async with opened(address) as first, opened(address) as second, opened(address) as third:
                for page in (first, second):
                    await page.op("hello")
                assert "2 pages open from here" in (await third.op("refusal"))["message"]
                async with opened(address, local_addr=there) as other:
                    await other.op("hello")
            # The places of pages that have left are free again.
            async with asyncio.timeout(PATIENCE):
                while service.sessions:
                    await asyncio.sleep(0.01)
            async with opened(address) as page:
                await page.op("hello")

    asyncio.run(tell())


def pile(count: int) -> dict[str, Any]:
    """A room with movable things that all overlap."""
    boxes = [{"x": 2 + 1e-4 * i, "y": 2, "w": 0.3, "h": 0.3, "movable": True} for i in range(count)]
    return {"name": "pile", "size": [8, 8], "start": {"x": 6, "y": 6, "theta": 0}, "boxes": boxes}


def test_a_room_of_things_on_each_other_is_refused(config: Config) -> None:
    async def play(page: Page, _service: Service) -> None:
        await page.send("world", world=pile(200))
        assert "too many things lie on each other" in (await page.op("refusal"))["message"]
        await page.send("world", world=pile(20))
        assert (await page.until(lambda m: m["op"] == "world" and m["world"]["name"] == "pile"))["op"] == "world"

    story(play, config)


def test_a_room_of_too_many_movable_things_is_refused_before_it_is_built(
    config: Config, monkeypatch: pytest.MonkeyPatch
) -> None:
    async def play(page: Page, _service: Service) -> None:
        places = [(0.5 + 0.8 * (i % 50), 0.5 + 0.9 * (i // 50)) for i in range(2000)]
        rounds = [{"x": x, "y": y, "r": 0.15, "movable": True} for x, y in places]
        start = {"x": 0.9, "y": 41, "theta": 0}
        monkeypatch.setattr(
            "rosy_sim.web.sessions.simulator.room_building.Obstacles", lambda *_: pytest.fail("the room was built")
        )
        await page.send("world", world={"name": "posts", "size": [42, 42], "start": start, "rounds": rounds})
        assert "at most 200 things that can be pushed" in (await page.op("refusal"))["message"]

    story(play, config)


def test_a_room_that_takes_long_to_build_is_built_while_others_are_served(config: Config) -> None:
    side = 120
    rows = ["".join("#" if (x + y) % 2 and (x > 9 or y > 9) else "." for x in range(side)) for y in range(side)]
    start = {"x": 2.5, "y": side / 2 - 2.5, "theta": 0}

    async def tell() -> None:
        async with serving(config) as (address, _), opened(address) as busy, opened(address) as other:
            answers: list[str] = []

            async def tell_world() -> None:
                await busy.until(lambda m: m["op"] == "world" and m["world"]["name"] == "checkerboard")
                answers.append("room")

            await other.op("hello")
            await busy.send("world", world={"name": "checkerboard", "start": start, "tiles": rows})
            built = asyncio.create_task(tell_world())
            await other.send("nonsense")
            await other.op("refusal")
            answers.append("other")
            await built
            assert answers == ["other", "room"]

    asyncio.run(tell())


def test_the_rooms_of_a_page_are_freed_when_it_has_left_without_the_garbage_collector(config: Config) -> None:
    async def tell() -> None:
        async with serving(config) as (address, service):
            gc.collect()
            gc.disable()
            try:
                rooms: list[weakref.ref[pymunk.Space]] = []
                async with opened(address) as page:
                    await page.op("hello")
                    (session,) = service.sessions.values()
                    for name in ("a", "b"):
                        world = {"name": name, "size": [9, 9], "start": {"x": 1, "y": 1, "theta": 0}}
                        await page.send("world", world=world)
                        await page.op("world")
                        # What only the room refers to; a compiled object has no weak references.
                        rooms.append(weakref.ref(session.world.obstacles._space))
                    await page.send("reset")
                    await page.until(lambda m: m["op"] == "frame")
                    del session
                async with asyncio.timeout(PATIENCE):
                    while service.sessions or any(room() is not None for room in rooms):
                        await asyncio.sleep(0.01)
            finally:
                gc.enable()

    asyncio.run(tell())


def test_a_page_that_used_up_its_share_is_read_no_further_and_the_others_are(
    config: Config, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("rosy_sim.web.pacing.reading_pace._MESSAGE_RATE", 1e-6)

    async def tell() -> None:
        async with serving(config) as (address, _), opened(address) as busy:
            await busy.send("nonsense")
            await busy.op("refusal")
            await busy.send("nonsense")
            second = asyncio.create_task(busy.op("refusal"))
            async with opened(address) as other:
                await other.send("nonsense")
                await other.op("refusal")
            assert not second.done()
            second.cancel()
            await asyncio.gather(second, return_exceptions=True)

    asyncio.run(tell())


def test_a_foreign_page_is_kept_out(config: Config) -> None:
    async def tell() -> None:
        async with serving(config) as (address, _):
            with pytest.raises(InvalidStatus):
                async with opened(address, origin="http://elsewhere.example"):
                    pass
            async with opened(address, origin=f"http://{address}") as page:
                await page.op("hello")

    asyncio.run(tell())


def test_the_http_api(config: Config) -> None:
    folder = config.examples / "move"
    folder.mkdir(parents=True)
    (folder / "program.rosy").write_text('{"rosy":1,"haskell":"drive:0.5"}')
    (folder / "README.md").write_text("# Move\n\nDrives ahead.\nFor ever.\n\nMore.\n")

    for name in ("about", "back"):
        (config.examples / name).mkdir()
        (config.examples / name / "program.rosy").write_text("{}")
    config.api_docs.mkdir(parents=True)
    for name, text in (("Rosy", "wait"), ("index", "index")):
        (config.api_docs / f"{name}.html").write_text(text)
    (config.examples / "README.md").write_text(
        "| example | level | shows |\n|---|---|---|\n| `move` | start | x |\n| `back` | react | y |\n"
    )

    async def tell() -> None:
        async with serving(config) as (address, service), _asking(address) as client:
            assert (await client.get("/api/examples")).json() == [
                {"name": "move", "title": "Move", "teaches": "Drives ahead. For ever.", "level": "start"},
                {"name": "back", "title": "back", "teaches": "", "level": "react"},
                {"name": "about", "title": "about", "teaches": "", "level": ""},
            ]
            assert (await client.get("/api/examples/move")).json()["rosy"] == 1
            assert (await client.get("/api/examples/..%2Fmove")).status_code == 404
            assert (await client.get("/api/examples/none")).status_code == 404
            assert (await client.get("/api/examples/none/path")).status_code == 404
            assert (await client.get("/api/examples/about/path")).status_code == 503
            driven = (await client.get("/api/examples/move/path")).json()
            assert driven["world"]["name"] == "room"
            assert driven["path"][-1][0] > driven["path"][0][0] + 1
            assert "room" in (await client.get("/api/worlds")).json()
            assert (await client.get("/api/worlds/maze")).json()["name"] == "maze"
            assert (await client.get("/api/worlds/none")).status_code == 404
            embedded = await client.get("/embed")
            assert (embedded.status_code, embedded.headers["location"]) == (307, "./?embed")
            health = (await client.get("/api/health")).json()
            assert health["version"] == VERSION
            assert (health["worker"], health["sessions"]) == (service.worker.state, 0)
            assert (await client.get("/api-docs/Rosy.html")).text == "wait"
            assert (await client.get("/api-docs/")).text == "index"
            assert (await client.get("/")).status_code == 503

    asyncio.run(tell())
