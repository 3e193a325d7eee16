"""The roster of a running class over real sockets: what the board changes, and what the pupils' pages are told."""

from __future__ import annotations

import asyncio

from rosy_sim.config import Config

from .test_class import Class, Client, Message, in_class, save, teaching


async def nicknames(board: Client, *expected: str) -> Message:
    """Wait until the board shows these pupils."""
    return await board.op("pupils", such=lambda m: [one["nickname"] for one in m["pupils"]] == list(expected))


async def enters(opened: Class, **fields: str) -> Message:
    client = await opened.open()
    await client.send("resume" if "words" in fields else "enter", **fields)
    return await client.op("entered", "refused")


def test_a_removed_pupil_is_told_stays_out_and_comes_back_when_the_teacher_says_so(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        ada, entered = await opened.pupil("Ada")
        await save(ada, "one")
        await opened.pupil("Ben")
        board = await opened.board()
        await nicknames(board, "Ada", "Ben")
        await board.send("remove-pupils", pupils=[entered["pupil"], 99])
        assert (await ada.op("refused"))["reason"] == "removed"
        door = await board.op("door")
        assert [(one["id"], one["nickname"]) for one in door["removed"]] == [(entered["pupil"], "Ada")]
        assert door["removed"][0]["until"] - door["removed"][0]["at"] == 30 * 86_400
        # What the page sent before it knew has no answer: it is not a page whose token is unknown.
        await ada.send("save", program="p", name="w", text="x", reason="run", mark="m", base=0)
        await ada.send("enter", token=entered["token"])
        assert (await ada.op("entered", "refused", "saved"))["reason"] == "removed"
        assert (await enters(opened, code=opened.code, words=entered["words"]))["reason"] == "removed"
        await board.send("restore-pupil", pupil=entered["pupil"])
        await nicknames(board, "Ada", "Ben")
        assert [one["name"] for one in (await enters(opened, token=entered["token"]))["programs"]] == ["walk"]
        await board.send("restore-pupil", pupil=entered["pupil"])
        assert (await board.op("refused"))["reason"] == "request"

    in_class(config, lesson)


def test_a_removed_pupil_stays_out_after_a_new_start_and_can_join_as_another(config: Config) -> None:
    async def run() -> None:
        async with teaching(config) as opened:
            ada, entered = await opened.pupil("Ada")
            board = await opened.board()
            await board.send("remove-pupils", pupils=[entered["pupil"]])
            await ada.op("refused")
            await ada.send("join", code=opened.code, nickname="Ada")
            assert (await ada.op("entered"))["pupil"] != entered["pupil"]
        async with teaching(config) as opened:
            assert (await enters(opened, token=entered["token"]))["reason"] == "removed"

    asyncio.run(run())


def test_a_locked_door_lets_in_those_of_the_class_only_also_after_a_new_start(config: Config) -> None:
    async def run() -> None:
        async with teaching(config) as opened:
            _, entered = await opened.pupil("Ada")
            board = await opened.board()
            await board.send("lock-door", locked=True)
            assert (await board.op("door"))["locked"] is True
        async with teaching(config) as opened:
            board = await opened.board()
            assert (await board.op("door"))["locked"] is True
            stranger = await opened.open()
            await stranger.send("join", code=opened.code, nickname="Eve")
            assert (await stranger.op("refused"))["reason"] == "locked"
            # One who does not know the code learns nothing of the door.
            await stranger.send("join", code="wrong", nickname="Eve")
            assert (await stranger.op("refused"))["reason"] == "code"
            assert (await enters(opened, token=entered["token"]))["op"] == "entered"
            assert (await enters(opened, code=opened.code, words=entered["words"]))["op"] == "entered"
            await board.send("lock-door", locked=False)
            await board.op("door", such=lambda m: not m["locked"])
            await stranger.send("join", code=opened.code, nickname="Eve")
            await stranger.op("entered")

    asyncio.run(run())


def test_a_class_list_adds_pupils_and_says_which_names_it_did_not_take(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        await opened.pupil("Ada")
        board = await opened.board()
        await board.send("add-pupils", nicknames=[" Ben ", "ADA", "-", "x" * 25, "Cleo", "cleo"], language="de")
        added = await board.op("pupils-added")
        assert added["added"] == 2
        assert [(one["nickname"], one["reason"]) for one in added["refused"]] == [
            ("ADA", "taken"),
            ("-", "nickname-empty"),
            ("x" * 25, "nickname-long"),
            ("cleo", "taken"),
        ]
        shown = await nicknames(board, "Ada", "Ben", "Cleo")
        words = shown["pupils"][1]["words"]
        assert (await enters(opened, code=opened.code, words=words))["nickname"] == "Ben"

    in_class(config, lesson)


def test_a_pupil_is_told_the_new_name(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        ada, entered = await opened.pupil("Ada")
        await opened.pupil("Ben")
        board = await opened.board()
        for nickname, reason in (("ben", "taken"), ("\u202e", "nickname-letters")):
            await board.send("rename-pupil", pupil=entered["pupil"], nickname=nickname)
            assert (await board.op("refused"))["reason"] == reason
        await board.send("rename-pupil", pupil=entered["pupil"], nickname="Ada L.")
        assert (await ada.op("renamed"))["nickname"] == "Ada L."
        await nicknames(board, "Ada L.", "Ben")
        assert (await enters(opened, token=entered["token"]))["nickname"] == "Ada L."
        await board.send("rename-pupil", pupil=99, nickname="Cleo")
        assert (await board.op("refused"))["reason"] == "request"

    in_class(config, lesson)


def test_the_pages_of_two_entries_go_on_as_one_pupil(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        ada, first = await opened.pupil("Ada")
        twin, second = await opened.pupil("Ada 2")
        await save(ada, "one", program="a")
        await save(twin, "two!", program="b")
        await twin.send("hand", up=True)
        board = await opened.board()
        await board.send("open-task", title="Maze")
        task = (await twin.op("tasks"))["tasks"][0]["id"]
        await twin.send("hand-in", task=task, name="maze", text="main = simulate move")
        await twin.op("tasks", such=lambda m: m["tasks"][0]["handed_in"] is not None)
        for pupil, into in ((second, second), (second, {"pupil": 99}), ({"pupil": 99}, first)):
            await board.send("merge-pupils", pupil=pupil["pupil"], into=into["pupil"])
            assert (await board.op("refused"))["reason"] == "request"
        await board.send("merge-pupils", pupil=second["pupil"], into=first["pupil"])
        for page in (ada, twin):
            entered = await page.op("entered")
            assert (entered["pupil"], entered["nickname"], entered["token"]) == (first["pupil"], "Ada", None)
            assert {one["id"] for one in entered["programs"]} == {"a", "b"}
        assert (await save(twin, "three", program="c"))["op"] == "saved"
        (shown,) = (await nicknames(board, "Ada"))["pupils"]
        assert "hand" in shown["needs"]
        shown = await board.op("tasks", such=lambda m: bool(m["tasks"]) and bool(m["tasks"][0]["handed_in"]))
        assert [one["pupil"] for one in shown["tasks"][0]["handed_in"]] == [first["pupil"]]
        for token in (first["token"], second["token"]):
            again = await enters(opened, token=token)
            assert {one["id"] for one in again["programs"]} == {"a", "b", "c"}

    in_class(config, lesson)
