"""The projector over real sockets: it shows the room of one pupil, and tells nothing else of anybody."""

from __future__ import annotations

import json
from typing import Any

from rosy_sim.classroom.messages.check_messages import CheckResult
from rosy_sim.config import Config

from .test_class import Class, Client, in_class, save

PROGRAM = json.dumps({"rosy": 1, "name": "of Ada", "haskell": "main = simulate move", "world": "room"})


async def projector(opened: Class) -> Client:
    client = await opened.open("projector")
    await client.send("unlock", key=opened.key)
    return client


async def in_room(opened: Class, client: Client) -> Client:
    """Gives a pupil a page session, whose room is shown."""
    page = await opened.open("session")
    hello = await page.op("hello")
    await client.send("here", session=hello["session"])
    return page


def test_a_projector_shows_the_pupil_whom_the_teacher_chose(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        ada, entered = await opened.pupil("Ada")
        ben, second = await opened.pupil("Ben")
        await save(ada, PROGRAM)
        page = await in_room(opened, ada)
        await in_room(opened, ben)
        board = await opened.board()
        screen = await projector(opened)
        assert (await screen.op("invitation"))["code"] == opened.code
        assert (await screen.op("projected"))["shows"] is False

        await board.send("project", pupil=entered["pupil"], named=True, program=True)
        shown = await screen.op("projected")
        assert (shown["nickname"], shown["online"], shown["haskell"]) == ("Ada", True, "main = simulate move")
        assert (await screen.op("room"))["world"]["size"]
        before = (await screen.op("frame"))["pose"]
        assert (await board.op("projecting"))["pupil"] == entered["pupil"]

        # The robot is shown where it is.
        await page.send("input", teleport={"x": before["x"] + 0.5, "y": before["y"], "theta": 0})
        await screen.op("frame", such=lambda frame: abs(frame["pose"]["x"] - before["x"] - 0.5) < 0.01)

        # Anonymously, and without the program: nothing that was told says who it is.
        screen.seen.clear()
        await board.send("project", pupil=entered["pupil"])
        anonymous = await screen.op("projected", such=lambda message: message["nickname"] is None)
        assert anonymous["number"] == shown["number"]
        assert anonymous["haskell"] is None
        await page.send("input", teleport={"x": before["x"], "y": before["y"], "theta": 0})
        await screen.op("frame")
        assert "Ada" not in json.dumps(screen.seen)
        assert "simulate" not in json.dumps(screen.seen)

        await board.send("project", pupil=second["pupil"], named=True)
        assert (await screen.op("projected"))["nickname"] == "Ben"
        await board.send("project", pupil=None)
        assert (await screen.op("projected"))["shows"] is False

    in_class(config, lesson)


def test_a_projector_shows_the_standings_of_a_task_when_the_teacher_chooses_it(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        ada, entered = await opened.pupil("Ada")
        await opened.pupil("Ben")
        board = await opened.board()
        screen = await projector(opened)
        await board.send("project", pupil=None, task=1)
        assert (await board.op("refused"))["reason"] == "request"
        await board.send("open-task", title="Slalom")
        await ada.op("tasks", such=lambda m: bool(m["tasks"]))
        await ada.send("hand-in", task=1, name="walk", text="main = simulate move")
        await ada.op("tasks", such=lambda m: m["tasks"][0]["handed_in"] is not None)
        await board.send("project", pupil=None, task=1)
        empty = await screen.op("projected", such=lambda m: m["standings"] is not None)
        assert (empty["shows"], empty["standings"]) == (False, {"title": "Slalom", "rows": []})
        assert (await board.op("projecting"))["task"] == 1

        # A result that is new is shown, without the pupil who has not handed in.
        tasks = opened.service.classroom.tasks if opened.service.classroom is not None else None
        assert tasks is not None
        (kept,) = await tasks.kept(1)
        result = CheckResult(0.0, "maze", 10, 1, 20.0, "", passed=7, time=4.5)
        await tasks.grade(1, kept.pupil, kept.at, result, [])
        shown = await screen.op("projected", such=lambda m: bool(m["standings"]["rows"]))
        assert shown["standings"]["rows"] == [[1, "Ada", 7, 10, 4.5]]

        await board.send("project", pupil=entered["pupil"], task=1)
        assert (await screen.op("projected"))["standings"] is None
        assert (await board.op("projecting"))["task"] is None

    in_class(config, lesson)


def test_a_projector_tells_nothing_without_the_key_and_serves_nothing_else(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        ada, entered = await opened.pupil("Ada")
        await save(ada, PROGRAM)
        board = await opened.board()
        await board.send("project", pupil=entered["pupil"], named=True, program=True)
        await board.op("projecting")
        thief = await opened.open("projector")
        for request, reason in (
            ({"op": "unlock", "key": opened.code}, "key"),
            ({"op": "unlock", "key": ""}, "key"),
            ({"op": "project", "pupil": entered["pupil"]}, "request"),
            ({"op": "open", "pupil": entered["pupil"]}, "request"),
        ):
            await thief.send(**request)
            assert (await thief.op("refused"))["reason"] == reason
        assert {message["op"] for message in thief.seen} == {"refused"}
        # With the key it takes no requests of the board.
        screen = await projector(opened)
        await screen.op("projected")
        for request in ({"op": "open", "pupil": entered["pupil"]}, {"op": "project", "pupil": None}):
            await screen.send(**request)
            assert (await screen.op("refused"))["reason"] == "request"
        assert not [message for message in screen.seen if message["op"] in ("pupils", "program")]

    in_class(config, lesson)


def test_only_the_board_chooses_and_only_pupils_of_the_class(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        ada, entered = await opened.pupil("Ada")
        locked = await opened.open("board")
        board = await opened.board()
        request: dict[str, Any] = {"op": "project", "pupil": entered["pupil"], "named": True}
        for client, reason in ((ada, "request"), (locked, "key")):
            await client.send(**request)
            assert (await client.op("refused"))["reason"] == reason
        await board.send("project", pupil=entered["pupil"] + 1)
        assert (await board.op("refused"))["reason"] == "request"
        screen = await projector(opened)
        assert (await screen.op("projected"))["shows"] is False

    in_class(config, lesson)
