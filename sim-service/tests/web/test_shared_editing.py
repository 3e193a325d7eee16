"""A program that the teacher and a pupil edit together, over real sockets; and attempts to do so without permission."""

from __future__ import annotations

from typing import Any

import pytest

from rosy_sim.config import Config

from .test_class import Class, Client, in_class, save

TEXT = "f = 0.5"


async def ask(opened: Class, ada: Client, pupil: int) -> tuple[Client, int]:
    """A board that has asked Ada, and the number of its question."""
    await save(ada, TEXT)
    board = await opened.board()
    await board.send("ask-to-share", pupil=pupil, program="p")
    asked = await ada.op("asked-to-share")
    assert (asked["program"], asked["name"]) == ("p", "walk")
    assert await board.op("share-waiting") == {"op": "share-waiting", "pupil": pupil, "program": "p"}
    return board, asked["number"]


async def begin(opened: Class, ada: Client, pupil: int) -> Client:
    """A board that edits Ada's program together with her."""
    board, number = await ask(opened, ada, pupil)
    await ada.send("share", number=number, project="{}", text=TEXT)
    assert await ada.op("shared") == {"op": "shared", "project": None, "text": None}
    assert await board.op("shared") == {"op": "shared", "project": "{}", "text": TEXT}
    return board


async def refused(client: Client, op: str, **fields: Any) -> str:
    await client.send(op, **fields)
    reason: str = (await client.op("refused"))["reason"]
    return reason


def test_both_get_all_changes_in_one_order_and_positions_of_the_other(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        ada, entered = await opened.pupil("Ada")
        board = await begin(opened, ada, entered["pupil"])
        await ada.send("push", version=0, changes=[[4, [3, "1"]], [5, [0, "", "g = 2"]]])
        first = {
            "op": "updates",
            "version": 0,
            "updates": [{"by": "pupil", "changes": [4, [3, "1"]]}, {"by": "pupil", "changes": [5, [0, "", "g = 2"]]}],
        }
        assert await ada.op("updates") == first
        # These changes follow a version that is no longer the newest: they are dropped, and the board sends them again.
        await board.send("push", version=0, changes=[[7, [0, "!"]]])
        await board.send("push", version=2, changes=[[11, [0, "!"]]])
        assert await board.op("updates") == first
        for side in (board, ada):
            second = await side.op("updates")
            assert second["version"] == 2
            assert second["updates"] == [{"by": "teacher", "changes": [11, [0, "!"]]}]
        await ada.send("cursor", version=3, anchor=1, head=2)
        assert await board.op("cursor") == {"op": "cursor", "version": 3, "anchor": 1, "head": 2}
        await board.send("cursor", version=3, anchor=5, head=5)
        assert (await ada.op("cursor"))["head"] == 5

    in_class(config, lesson)


@pytest.mark.parametrize("ending", ["board", "pupil", "board-disconnects", "pupil-disconnects"])
def test_it_ends_when_either_leaves(config: Config, ending: str) -> None:
    async def lesson(opened: Class) -> None:
        ada, entered = await opened.pupil("Ada")
        board = await begin(opened, ada, entered["pupil"])
        leaving, staying = (board, ada) if ending.startswith("board") else (ada, board)
        if ending.endswith("disconnects"):
            await leaving.socket.close()
        else:
            await leaving.send("end-sharing")
            assert (await leaving.op("sharing-over"))["why"] == "ended"
        assert (await staying.op("sharing-over"))["why"] == "ended"
        assert await refused(staying, "push", version=0, changes=[[7, [0, "!"]]]) == "request"

    in_class(config, lesson)


def test_a_pupil_declines_or_the_teacher_withdraws_the_question(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        ada, entered = await opened.pupil("Ada")
        board, number = await ask(opened, ada, entered["pupil"])
        await ada.send("decline", number=number)
        assert (await board.op("sharing-over"))["why"] == "declined"
        assert (await ada.op("sharing-over"))["why"] == "ended"
        # A late answer to it begins nothing.
        await ada.send("share", number=number, project="{}", text=TEXT)
        await ada.op("sharing-over")
        await board.send("ask-to-share", pupil=entered["pupil"], program="p")
        await ada.op("asked-to-share")
        await board.send("end-sharing")
        await ada.op("sharing-over")
        assert "shared" not in [message["op"] for message in board.seen + ada.seen]

    in_class(config, lesson)


def test_the_question_is_on_all_devices_of_the_pupil_until_one_of_them_answers(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        ada, entered = await opened.pupil("Ada")
        board, number = await ask(opened, ada, entered["pupil"])
        tablet = await opened.open()
        await tablet.send("enter", token=entered["token"])
        assert (await tablet.op("asked-to-share"))["number"] == number
        await tablet.send("share", number=number, project="{}", text=TEXT)
        await tablet.op("shared")
        await ada.op("sharing-over")
        # The other device takes no part.
        assert await refused(ada, "push", version=0, changes=[[7, [0, "!"]]]) == "request"
        await ada.send("end-sharing")
        await tablet.send("push", version=0, changes=[[7, [0, "!"]]])
        assert (await board.op("updates"))["updates"][0]["by"] == "pupil"

    in_class(config, lesson)


def test_nobody_edits_without_the_permission_of_the_pupil(config: Config) -> None:
    push = {"version": 0, "changes": [[7, [0, "!"]]]}

    async def lesson(opened: Class) -> None:
        ada, entered = await opened.pupil("Ada")
        ben, _ = await opened.pupil("Ben")
        await save(ben, TEXT)
        board, number = await ask(opened, ada, entered["pupil"])
        # Before the pupil has answered, and from another pupil with the number of the question.
        assert await refused(board, "push", **push) == "request"
        assert await refused(board, "cursor", version=0, anchor=0, head=0) == "request"
        await ben.send("share", number=number, project="{}", text=TEXT)
        assert (await ben.op("sharing-over"))["why"] == "ended"
        await ben.send("decline", number=number)
        await ben.op("sharing-over")
        await ada.send("share", number=number, project="{}", text=TEXT)
        await board.op("shared")
        assert await refused(ben, "push", **push) == "request"
        await ben.send("end-sharing")
        # Requests of the board from a pupil, from a board without the key, and from another board.
        asking = {"pupil": entered["pupil"], "program": "p"}
        assert await refused(ben, "ask-to-share", **asking) == "request"
        locked = await opened.open("board")
        assert await refused(locked, "ask-to-share", **asking) == "key"
        assert await refused(locked, "push", **push) == "key"
        second = await opened.board()
        assert await refused(second, "push", **push) == "request"
        assert await refused(second, "ask-to-share", **asking) == "busy"
        stranger = await opened.open()
        assert await refused(stranger, "share", number=number, project="{}", text=TEXT) == "token"
        # All of that changed nothing.
        await ada.send("push", **push)
        assert (await board.op("updates"))["version"] == 0
        assert "asked-to-share" not in [message["op"] for message in ben.seen]

    in_class(config, lesson)


def test_the_teacher_asks_for_a_program_that_there_is_and_a_pupil_who_is_connected(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        ada, entered = await opened.pupil("Ada")
        await save(ada, TEXT)
        board = await opened.board()
        for pupil, program in ((entered["pupil"], "another"), (99, "p")):
            assert await refused(board, "ask-to-share", pupil=pupil, program=program) == "request"
        await ada.socket.close()
        await board.op("pupils", such=lambda message: not message["pupils"][0]["online"])
        assert await refused(board, "ask-to-share", pupil=entered["pupil"], program="p") == "away"

    in_class(config, lesson)


@pytest.mark.parametrize(
    "changes",
    [
        [8],
        [[8, "x"]],
        [-7],
        [7, ["x"]],
        [7, [0, 1]],
        [7, [0, "a\nb"]],
        [7, [0, "\ud800"]],
        [7, [0, *["x" * 1000] * 401]],
    ],
)
def test_changes_that_are_none_of_the_text_reach_nobody(config: Config, changes: list[Any]) -> None:
    async def lesson(opened: Class) -> None:
        ada, entered = await opened.pupil("Ada")
        board = await begin(opened, ada, entered["pupil"])
        assert await refused(ada, "push", version=0, changes=[changes]) == "request"
        await ada.send("end-sharing")
        await board.op("sharing-over")
        assert "updates" not in [message["op"] for message in board.seen]

    in_class(config, lesson)


def test_a_refused_request_that_is_none_of_editing_together_leaves_it_on(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        ada, entered = await opened.pupil("Ada")
        board = await begin(opened, ada, entered["pupil"])
        assert await refused(ada, "comment-done", comment=99, done=True) == "request"
        assert await refused(ada, "save", program=7) == "request"
        assert await refused(ada, "nonsense") == "request"
        assert await refused(board, "open-program", pupil="x") == "request"
        await ada.socket.send("{")
        assert (await ada.op("refused"))["reason"] == "request"
        await ada.send("push", version=0, changes=[[7, [0, "!"]]])
        for side in (ada, board):
            assert (await side.op("updates"))["version"] == 0
            assert "sharing-over" not in [message["op"] for message in side.seen]

    in_class(config, lesson)


UNREADABLE: list[tuple[str, dict[str, Any]]] = [
    ("push", {"version": 0, "changes": []}),
    ("push", {"version": 0, "changes": [[10**9]]}),
    ("push", {"version": 0, "changes": [[7], "x"]}),
    ("push", {"version": 0, "changes": [[1] * 20_001]}),
    ("push", {"version": 0, "changes": [[7]] * 2001}),
    ("push", {"version": 0, "changes": "<svg onload=alert(1)>"}),
    ("cursor", {"version": 0, "anchor": -1, "head": 10**9}),
    ("cursor", {"version": 0, "anchor": "x", "head": None}),
]


@pytest.mark.parametrize("side", ["pupil", "board"])
def test_hostile_requests_end_it_for_both_and_reach_nobody(config: Config, side: str) -> None:
    async def lesson(opened: Class) -> None:
        ada, entered = await opened.pupil("Ada")
        board = await begin(opened, ada, entered["pupil"])
        sender, other = (ada, board) if side == "pupil" else (board, ada)
        for op, fields in UNREADABLE:
            seen = len(other.seen)
            await sender.send(op, **fields)
            assert (await other.op("sharing-over"))["why"] == "ended"
            assert (await sender.op("refused"))["reason"] == "request"
            assert not {"updates", "cursor"} & {message["op"] for message in other.seen[seen:]}
            await board.send("ask-to-share", pupil=entered["pupil"], program="p")
            number = (await ada.op("asked-to-share"))["number"]
            await ada.send("share", number=number, project="{}", text=TEXT)
            assert (await board.op("shared"))["text"] == TEXT
            await ada.op("shared")

    in_class(config, lesson)


def test_an_answer_that_cannot_be_read_is_none_and_the_question_is_withdrawn(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        ada, entered = await opened.pupil("Ada")
        board, number = await ask(opened, ada, entered["pupil"])
        await ada.send("share", number=number, project="x" * 400_001, text=TEXT)
        assert (await board.op("sharing-over"))["why"] == "ended"
        assert (await ada.op("sharing-over"))["why"] == "ended"
        await ada.op("refused")
        # A pupil who was not asked changes nothing with it.
        ben, _ = await opened.pupil("Ben")
        await board.send("ask-to-share", pupil=entered["pupil"], program="p")
        number = (await ada.op("asked-to-share"))["number"]
        await ben.send("share", number=number, project="x" * 400_001, text=TEXT)
        await ben.op("refused")
        await ada.send("share", number=number, project="{}", text=TEXT)
        await board.op("shared")

    in_class(config, lesson)
