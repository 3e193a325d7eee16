"""Tasks of a class over real sockets: handing in, deadlines, comments, and attempts at what is another's."""

from __future__ import annotations

import asyncio
import csv
import io
import json
import time
import zipfile
from dataclasses import replace
from pathlib import Path
from typing import Any

import httpx
import pytest

from rosy_sim.classroom.store import task_store
from rosy_sim.config import Config
from rosy_sim.rooms.generation.families import Family
from rosy_sim.rooms.room_test import RoomTest, try_rooms, worst_first
from rosy_sim.rooms.trial_pool import TrialPool
from rosy_sim.worker.background_process import WorkerSetup
from rosy_sim.world.properties import read_properties

from ..conftest import PATIENCE
from ..processes import await_end
from .test_class import Class, Client, Message, in_class, save, teaching
from .test_room_tests import trial_processes, wait_for


async def own_tasks(client: Client, *, opened: bool) -> list[Message]:
    """The tasks of a pupil's page once the newest one is open or has ended."""
    shown = await client.op("tasks", such=lambda m: bool(m["tasks"]) and m["tasks"][-1]["open"] is opened)
    return list(shown["tasks"])


async def handed_in(board: Client, count: int) -> Message:
    """The newest task on the board once so many have handed in."""
    shown = await board.op("tasks", such=lambda m: bool(m["tasks"]) and len(m["tasks"][-1]["handed_in"]) == count)
    task: Message = shown["tasks"][-1]
    return task


async def hand_in(client: Client, text: str, task: int = 1, **more: Any) -> Message:
    await client.send("hand-in", task=task, name="walk", text=text, **more)
    return await client.op(
        "tasks", "not-handed-in", "refused", such=lambda m: m["op"] != "tasks" or bool(m["tasks"][-1]["handed_in"])
    )


def test_a_pupil_hands_in_again_until_the_teacher_ends_the_task(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        board = await opened.board()
        ada, entered = await opened.pupil("Ada")
        await board.send("open-task", title="  Through the maze ")
        (task,) = await own_tasks(ada, opened=True)
        assert (task["title"], task["deadline"], task["left"], task["handed_in"]) == (
            "Through the maze",
            None,
            None,
            None,
        )
        before = time.time()
        await hand_in(ada, "one")
        (own,) = (await hand_in(ada, "two"))["tasks"]
        assert before <= own["handed_in"]["at"] <= time.time()
        shown = await handed_in(board, 1)
        assert [(one["pupil"], one["name"]) for one in shown["handed_in"]] == [(entered["pupil"], "walk")]
        await board.send("open-hand-in", task=1, pupil=entered["pupil"])
        assert (await board.op("program"))["text"] == "two"
        await board.send("close-task", task=1)
        await own_tasks(ada, opened=False)
        late = await hand_in(ada, "three")
        assert (late["op"], late["reason"]) == ("not-handed-in", "late")
        await board.send("open-hand-in", task=1, pupil=entered["pupil"])
        assert (await board.op("program"))["text"] == "two"

    in_class(config, lesson)


def test_the_service_decides_when_the_deadline_has_passed(config: Config, monkeypatch: pytest.MonkeyPatch) -> None:
    async def lesson(opened: Class) -> None:
        board = await opened.board()
        ada, _ = await opened.pupil("Ada")
        deadline = time.time() + 3600
        await board.send("open-task", title="Maze", deadline=deadline)
        (task,) = await own_tasks(ada, opened=True)
        assert task["deadline"] == deadline
        assert 3500 < task["left"] <= 3600
        monkeypatch.setattr(task_store.Task, "is_open", lambda task, now: now + 3600 < task.deadline)
        assert (await hand_in(ada, "one"))["reason"] == "late"
        assert (await ada.op("tasks"))["tasks"] == []

    in_class(config, lesson)


def test_a_task_without_a_title_or_with_an_impossible_deadline_is_refused(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        board = await opened.board()
        await board.send("open-task", title="Maze", deadline=time.time() - 1)
        assert (await board.op("refused"))["reason"] == "deadline"
        await board.send("open-task", title="Maze", deadline=1e300)
        assert (await board.op("refused"))["reason"] == "request"
        await board.send("open-task", title="  ")
        assert (await board.op("refused"))["reason"] == "request"

    in_class(config, lesson)


def test_a_comment_reaches_its_pupil_only_also_later(config: Config) -> None:
    async def run() -> None:
        async with teaching(config) as opened:
            board = await opened.board()
            ada, entered = await opened.pupil("Ada")
            ben, _ = await opened.pupil("Ben")
            await board.send("open-task", title="Maze")
            await own_tasks(ada, opened=True)
            await hand_in(ada, "of Ada")
            await board.send("comment", task=1, pupil=entered["pupil"], text=" Look at the corner. ")
            (task,) = (await ada.op("tasks"))["tasks"]
            assert task["handed_in"]["comment"] == "Look at the corner."
            await hand_in(ben, "of Ben")
            assert "corner" not in str(ben.seen)
            await board.send("close-task", task=1)
            await own_tasks(ben, opened=False)
        # The service starts again.
        async with teaching(config) as opened:
            again = await opened.open()
            await again.send("enter", token=entered["token"])
            (task,) = (await again.op("tasks"))["tasks"]
            assert (task["open"], task["handed_in"]["comment"]) == (False, "Look at the corner.")

    asyncio.run(run())


def test_a_pupil_hands_in_for_no_other_and_reaches_no_request_of_the_board(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        board = await opened.board()
        ada, entered = await opened.pupil("Ada")
        ben, _ = await opened.pupil("Ben")
        await board.send("open-task", title="Maze")
        await own_tasks(ada, opened=True)
        await hand_in(ada, "of Ada")
        # The identifier of another pupil, forged into the request, is not read.
        await own_tasks(ben, opened=True)
        await hand_in(ben, "of Ben", pupil=entered["pupil"])
        await board.send("open-hand-in", task=1, pupil=entered["pupil"])
        assert (await board.op("program"))["text"] == "of Ada"
        for op in ("open-hand-in", "comment", "close-task", "open-task"):
            await ben.send(op, task=1, pupil=entered["pupil"], text="hi", title="Mine")
            assert (await ben.op("refused", "program"))["reason"] == "request"
        assert (await hand_in(ben, "x", task=2))["reason"] == "late"
        thief = await opened.open()
        assert (await hand_in(thief, "x"))["reason"] == "token"
        locked = await opened.open("board")
        await locked.send("open-task", title="Mine")
        assert (await locked.op("refused"))["reason"] == "key"
        assert "of Ada" not in str(ben.seen)

    in_class(config, lesson)


def test_a_class_without_a_task_shows_none(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        ada, _ = await opened.pupil("Ada")
        await save(ada, "one")
        assert [message["op"] for message in ada.seen] == ["class", "entered", "saved"]

    in_class(config, lesson)


def test_the_board_marks_programs_that_are_alike_and_gets_them_all(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        board = await opened.board()
        ada, first = await opened.pupil("Ada")
        ben, second = await opened.pupil("=Ben")
        cleo, _ = await opened.pupil("Cleo")
        await opened.pupil("Dora")
        await board.send("open-task", title="Maze")
        for client, text in (
            (ada, "f x = x"),
            (ben, "-- mine\ng y =\n  y"),
            (cleo, "f x = 1"),
        ):
            await own_tasks(client, opened=True)
            await hand_in(client, text)
        task = await handed_in(board, 3)
        assert [one["alike"] for one in task["handed_in"]] == [[second["pupil"]], [first["pupil"]], []]
        await board.send("comment", task=1, pupil=first["pupil"], text="@all: good")
        await ada.op("tasks")

        async with httpx.AsyncClient(base_url=f"http://{opened.address}", timeout=PATIENCE) as http:
            for key in ("", opened.code):
                refused = await http.get("/api/hand-ins/1", headers={"X-Rosy-Key": key})
                assert refused.status_code == 403
                assert b"f x" not in refused.content
            allowed = {"X-Rosy-Key": opened.key}
            assert (await http.get("/api/hand-ins/2", headers=allowed)).status_code == 404
            answer = await http.get("/api/hand-ins/1", headers=allowed)
        with zipfile.ZipFile(io.BytesIO(answer.content)) as archive:
            assert archive.read("001 Ada.rosy") == b"f x = x"
            assert archive.namelist() == ["001 Ada.rosy", "002 _Ben.rosy", "003 Cleo.rosy", "hand-ins.csv"]
            rows = list(csv.DictReader(io.StringIO(archive.read("hand-ins.csv").decode("utf-8-sig"))))
        # What a spreadsheet would take for a formula is a text.
        assert [row["pupil"] for row in rows] == ["Ada", "'=Ben", "Cleo", "Dora"]
        assert [row["alike"] for row in rows] == ["'=Ben", "Ada", "", ""]
        assert (rows[0]["comment"], rows[0]["program"], rows[3]["handed in"]) == ("'@all: good", "walk", "")

    in_class(config, lesson)


CHECK: Message = {
    "task": 1, "family": "own", "rooms": 2, "seed": 3, "seconds": 20, "properties": "never-pushes 1 s",
}  # fmt: skip


async def results(board: Client, count: int) -> dict[int, Message]:
    """The results of the pupils once there are so many."""
    found: dict[int, Message] = {}
    while len(found) < count:
        shown = await board.op("result", such=lambda m: m["result"] is not None)
        found[shown["pupil"]] = shown["result"]
    return found


def project(source: str, world: str = "room") -> str:
    return json.dumps({"rosy": 1, "name": "walk", "haskell": source, "world": world})


async def three_hand_ins(opened: Class, board: Client) -> list[tuple[Client, int]]:
    """Programs that push against a wall, do nothing, and do not compile."""
    await board.send("open-task", title="Maze")
    pupils = []
    for nickname, text in (("Ada", project("drive:0.5")), ("Ben", project("done@1")), ("Cleo", project("refuse"))):
        client, entered = await opened.pupil(nickname)
        await own_tasks(client, opened=True)
        await hand_in(client, text)
        pupils.append((client, entered["pupil"]))
    return pupils


def test_the_board_checks_all_hand_ins_in_rooms_and_opens_the_worst_one(config: Config) -> None:
    async def run() -> None:
        async with teaching(config) as opened:
            board = await opened.board()
            (ada, first), (ben, second), (_, third) = await three_hand_ins(opened, board)
            await board.send("show-results", task=1)
            await board.send("check-all", **CHECK)
            found = await results(board, 3)
            assert (await board.op("checking", such=lambda m: m["task"] is None))["done"] == 0
            assert (found[first]["passed"], found[second]["passed"], found[third]["passed"]) == (0, 2, 0)
            assert [found[pupil]["fault"] for pupil in (first, second, third)] == [None, None, "compile"]
            assert found[third]["problems"][0]["message"]
            worst = found[first]["worst"]
            assert [finding["state"] for finding in worst["findings"]] == ["failed"]
            # Room 1 is the room that was handed in.
            assert worst["room"] in (1, 2)
            assert len(worst["path"]) >= 2

            await board.send("show-rooms", task=1, pupil=first)
            tried = await board.op("rooms")
            assert (tried["pupil"], tried["after"], tried["rooms"][0]) == (first, 0, worst)
            assert sorted(one["room"] for one in tried["rooms"]) == [1, 2]
            for one in tried["rooms"]:
                await board.send("open-run", task=1, pupil=first, room=one["room"])
                shown = await board.op("run")
                assert (shown["room"], shown["text"]) == (one["room"], project("drive:0.5"))
                assert (shown["world"], shown["seed"]) == (one["world"], one["seed"])
            # Not compiled, never there, and a room that was not tried; the first two have no rooms either.
            for pupil, room in ((third, 1), (99, 1), (first, 3)):
                await board.send("show-rooms", task=1, pupil=pupil)
                await board.send("open-run", task=1, pupil=pupil, room=room)
                assert (await board.op("run"))["text"] is None
            assert {one["pupil"] for one in board.seen if one["op"] == "rooms"} == {first}

            async with httpx.AsyncClient(base_url=f"http://{opened.address}", timeout=PATIENCE) as http:
                answer = await http.get("/api/hand-ins/1", headers={"X-Rosy-Key": opened.key})
            with zipfile.ZipFile(io.BytesIO(answer.content)) as archive:
                rows = list(csv.DictReader(io.StringIO(archive.read("hand-ins.csv").decode("utf-8-sig"))))
            assert [(row["passed"], row["rooms"]) for row in rows] == [("0", "2"), ("2", "2"), ("0", "2")]
            assert "pushed" in rows[0]["failure"]
            assert (rows[1]["failure"], rows[1]["tested for"]) == ("", "never-pushes 1 s; own, seed 3, 20 s")
            assert rows[2]["failure"].startswith("does not compile: ")

            # Another hand-in takes the result away; the others stay, and pupils see none.
            await hand_in(ben, project("drive:0.5"))
            assert (await board.op("result"))["result"] is None
            assert "worst" not in str(ada.seen) + str(ben.seen)
            # Only this one is checked; the others keep their results of two rooms.
            await board.send("check-new", task=1)
            (again,) = (await results(board, 1)).items()
            assert (again[0], again[1]["rooms"], again[1]["properties"]) == (second, 2, CHECK["properties"])
            await board.op("checking", such=lambda m: m["task"] is None)
            await hand_in(ada, project("drive:0.5"))
        # The service starts again, and knows what the last check of all has tried.
        async with teaching(config) as opened:
            board = await opened.board()
            assert (await board.op("tasks"))["tasks"][0]["checked"]
            await board.send("show-results", task=1)
            assert {pupil: one["rooms"] for pupil, one in (await results(board, 2)).items()} == {second: 2, third: 2}
            await board.send("check-new", task=1)
            (last,) = (await results(board, 1)).items()
            assert (last[0], last[1]["rooms"], last[1]["seed"]) == (first, 2, CHECK["seed"])
            await board.send("check-new", task=9)
            assert (await board.op("refused"))["reason"] == "request"

    asyncio.run(run())


def test_a_check_is_the_report_of_the_command_line(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        board = await opened.board()
        ((_, first), *_) = await three_hand_ins(opened, board)
        await board.send("show-results", task=1)
        await board.send("check-all", **{**CHECK, "family": "obstacles", "rooms": 4})
        found = (await results(board, 3))[first]

        test = RoomTest(Family("obstacles"), 4, 3, 20.0, read_properties("never-pushes 1 s"))
        with TrialPool(WorkerSetup.of(config), 2) as pool:
            trials = pool.program(test.task("drive:0.5"))
            report = await asyncio.to_thread(try_rooms, test, trials, lambda _: None)
        worst = worst_first(report.outcomes)[0]
        assert (found["passed"], found["worst"]["room"], found["worst"]["seed"], found["worst"]["time"]) == (
            report.passed,
            worst.room,
            worst.seed,
            worst.time,
        )

    in_class(config, lesson)


def test_a_hand_in_of_a_lesson_is_checked_as_the_lesson_checks_it(config: Config) -> None:
    """The ring of the first lesson is reached at 0.4 m/s and not at 0.2; a program of no lesson has no such check."""
    sources = {"Ada": "drive:0.4", "Ben": "drive:0.2", "Cleo": "refuse", "Dora": "drive:0.4"}

    async def lesson(opened: Class) -> None:
        board = await opened.board()
        await board.send("open-task", title="Ring")
        pupils = {}
        for nickname, source in sources.items():
            client, entered = await opened.pupil(nickname)
            await own_tasks(client, opened=True)
            room = {"name": "lesson hello-robot", "size": [5, 3]} if nickname != "Dora" else "room"
            await hand_in(client, json.dumps({"rosy": 1, "name": "ring", "haskell": source, "world": room}))
            pupils[nickname] = entered["pupil"]
        task = await handed_in(board, 4)
        assert [one["lesson"] for one in task["handed_in"]] == ["hello-robot"] * 3 + [""]
        await board.send("show-results", task=1)
        await board.send("check-all", **{**CHECK, "family": "lesson", "rooms": 1, "properties": ""})
        all_found = await results(board, 4)
        found = {nickname: all_found[pupil] for nickname, pupil in pupils.items()}
        assert {nickname: one["fault"] for nickname, one in found.items()} == {
            "Ada": None,
            "Ben": None,
            "Cleo": "compile",
            "Dora": "lesson",
        }
        assert found["Ada"]["passed"] == found["Ada"]["rooms"]
        assert found["Ada"]["unmet"] == []
        assert found["Ben"]["passed"] == 0
        [unmet] = found["Ben"]["unmet"]
        assert "ring" in unmet["en"]
        assert "Ring" in unmet["de"]

    in_class(replace(config, examples=Path(__file__).resolve().parents[3] / "examples"), lesson)


def test_a_check_is_cancelled_and_leaves_no_process(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        board = await opened.board()
        pupil, _ = await opened.pupil("Ada")
        await board.send("open-task", title="Maze")
        await own_tasks(pupil, opened=True)
        # A program that hangs: the check would last for a minute.
        await hand_in(pupil, project("hang@5"))
        for ended_by in ("board", "service"):
            await board.send("check-all", **CHECK)
            await asyncio.to_thread(wait_for, lambda: len(trial_processes()) >= 3)
            processes = trial_processes()
            if ended_by == "board":
                await board.send("cancel-check")
                await board.op("checking", such=lambda m: m["task"] is None)
                await asyncio.to_thread(await_end, processes, PATIENCE)
            left.append(processes)

    left: list[set[int]] = []
    in_class(config, lesson)
    await_end(left[-1], PATIENCE)


@pytest.mark.parametrize(
    ("changed", "reason"),
    [
        ({"properties": "flies"}, "rooms"), ({"family": "room"}, "rooms"), ({"family": "room", "world": {}}, "rooms"),
        ({"rooms": 0}, "request"), ({"rooms": 201}, "request"), ({"seconds": 1e9}, "request"),
        ({"family": "caves"}, "request"), ({"task": 7}, "request"), ({"seed": -1}, "request"),
    ],
)  # fmt: skip
def test_a_check_that_is_impossible_is_refused(config: Config, changed: Message, reason: str) -> None:
    async def lesson(opened: Class) -> None:
        board = await opened.board()
        await board.send("open-task", title="Maze")
        await board.send("check-all", **{**CHECK, **changed})
        assert (await board.op("refused"))["reason"] == reason

    in_class(config, lesson)


def test_a_hand_in_whose_room_cannot_be_used_is_named_and_the_others_are_checked(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        board = await opened.board()
        await board.send("open-task", title="Maze")
        found = []
        for nickname, text in (("Ada", project("done@1", "nowhere")), ("Ben", "done@1")):
            client, entered = await opened.pupil(nickname)
            await own_tasks(client, opened=True)
            await hand_in(client, text)
            found.append(entered["pupil"])
        await board.send("show-results", task=1)
        await board.send("check-all", **CHECK)
        shown = await results(board, 2)
        assert [(shown[pupil]["fault"], shown[pupil]["passed"]) for pupil in found] == [("room", 0), (None, 2)]

    in_class(config, lesson)


def test_a_pupil_reaches_no_result(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        board = await opened.board()
        ((ada, _), (_, second), _) = await three_hand_ins(opened, board)
        await board.send("show-results", task=1)
        await board.send("check-all", **CHECK)
        await results(board, 3)
        for op in ("check-all", "cancel-check", "show-results", "show-rooms", "open-run"):
            await ada.send(op, **{**CHECK, "pupil": second, "room": 1})
            assert (await ada.op("refused", "result", "rooms", "run"))["reason"] == "request"

    in_class(config, lesson)
