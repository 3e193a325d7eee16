"""The teacher's comments on places in pupils' programs over real sockets, and attempts at those of others."""

from __future__ import annotations

import asyncio
import json
from typing import Any

from rosy_sim.classroom.store.comment_store import MAX_COMMENTS
from rosy_sim.config import Config

from .test_class import Class, in_class, save, teaching

PLACE = {"definition": "f", "piece": "f = 0.5", "start": 4, "end": 7}


def comment(pupil: int, program: str = "p", text: str = "Too fast", **place: Any) -> dict[str, Any]:
    return {"op": "add-comment", "pupil": pupil, "program": program, "text": text, "place": {**PLACE, **place}}


def test_a_comment_reaches_its_pupil_on_each_device_and_the_teacher_sees_that_it_is_done(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        ada, entered = await opened.pupil("Ada")
        await save(ada, "f = 0.5")
        board = await opened.board()
        await board.send("open", pupil=entered["pupil"])
        assert (await board.op("program"))["program"] == "p"
        await board.send(**comment(entered["pupil"]))
        (told,) = (await ada.op("comments"))["comments"]
        assert (told["program"], told["text"], told["place"], told["done"]) == ("p", "Too fast", PLACE, False)

        tablet = await opened.open()
        await tablet.send("enter", token=entered["token"])
        assert (await tablet.op("comments"))["comments"] == [told]
        await tablet.send("comment-done", comment=told["id"], done=True)
        for device in (ada, tablet):
            assert (await device.op("comments"))["comments"] == [{**told, "done": True}]
        shown = await board.op("comments", such=lambda message: message["comments"] == [{**told, "done": True}])
        assert shown["pupil"] == entered["pupil"]
        await board.op("pupils", such=lambda m: (m["pupils"][0]["comments"], m["pupils"][0]["done"]) == (1, 1))

        await board.send("remove-comment", comment=told["id"])
        assert (await ada.op("comments"))["comments"] == []

    in_class(config, lesson)


def test_a_comment_is_there_when_the_service_starts_again(config: Config) -> None:
    async def run() -> None:
        async with teaching(config) as opened:
            ada, entered = await opened.pupil("Ada")
            await save(ada, "f = 0.5")
            board = await opened.board()
            await board.send(**comment(entered["pupil"]))
            await ada.op("comments")
        async with teaching(config) as opened:
            again = await opened.open()
            await again.send("enter", token=entered["token"])
            (told,) = (await again.op("comments"))["comments"]
            assert (told["text"], told["place"]) == ("Too fast", PLACE)

    asyncio.run(run())


def test_a_pupil_neither_sees_nor_changes_comments_of_others(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        ada, entered = await opened.pupil("Ada")
        ben, _ = await opened.pupil("Ben")
        await save(ada, "f = 0.5")
        await save(ben, "f = 0.5")
        board = await opened.board()
        await board.send("open", pupil=entered["pupil"])
        await board.send(**comment(entered["pupil"]))
        (told,) = (await ada.op("comments"))["comments"]
        # A forged number, with and without a forged pupil.
        for forged in ({"comment": told["id"]}, {"comment": told["id"], "pupil": entered["pupil"]}):
            await ben.send("comment-done", done=True, **forged)
            assert (await ben.op("refused"))["reason"] == "request"
        # Requests of the board are none of a pupil's socket, and a board without the key has none.
        locked = await opened.open("board")
        for request in (comment(entered["pupil"]), {"op": "remove-comment", "comment": told["id"]}):
            await ben.send(**request)
            assert (await ben.op("refused"))["reason"] == "request"
            await locked.send(**request)
            assert (await locked.op("refused"))["reason"] == "key"
        stranger = await opened.open()
        await stranger.send("comment-done", comment=told["id"], done=True)
        assert (await stranger.op("refused"))["reason"] == "token"
        assert (await board.op("comments"))["comments"] == [told]
        assert "Too fast" not in json.dumps(ben.seen)

    in_class(config, lesson)


def test_a_comment_needs_a_program_of_the_pupil_and_a_place_in_it(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        ada, entered = await opened.pupil("Ada")
        await save(ada, "f = 0.5")
        board = await opened.board()
        pupil = entered["pupil"]
        for request in (
            comment(pupil, program="another"),
            comment(pupil + 1),
            comment(pupil, text=" "),
            comment(pupil, text="x" * 2001),
            comment(pupil, start=5, end=4),
            comment(pupil, end=8),
            comment(pupil, start=-1),
            comment(pupil, piece="x" * 20_001),
        ):
            await board.send(**request)
            assert (await board.op("refused"))["reason"] == "request"
        # Ends are counted as the page counts: a letter outside of the Basic Multilingual Plane is two.
        await board.send(**comment(pupil, piece="f = 😀", start=4, end=6))
        (told,) = (await ada.op("comments"))["comments"]
        assert told["place"]["piece"] == "f = 😀"

    in_class(config, lesson)


def test_a_pupil_has_a_limited_number_of_comments(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        ada, entered = await opened.pupil("Ada")
        await save(ada, "f = 0.5")
        board = await opened.board()
        for _ in range(MAX_COMMENTS + 1):
            await board.send(**comment(entered["pupil"]))
        assert (await board.op("refused"))["reason"] == "comments"
        await ada.op("comments", such=lambda message: len(message["comments"]) == MAX_COMMENTS)

    in_class(config, lesson)
